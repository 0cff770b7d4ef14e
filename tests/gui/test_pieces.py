"""Pieces are known by their numbers in the view: shown, picked by a click, asked for in the panel of the last operator."""

import os
import sys
from pathlib import Path

import bpy
from bpy_extras import view3d_utils
from mathutils import Vector

sys.path.insert(0, str(Path(__file__).parent))
from window import View, empty_file, mean_difference, part, redrawn, run, save_picture, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])


def teapot():
    return bpy.data.objects["Teapot"]


def last():
    return bpy.context.window_manager.operators[-1]


def count():
    return len(part('bridge.data.store').read(teapot().data).pieces)


def hovered():
    return part('ui.ui_state').ui_state.hovered


def place_of(view, number, ob=None):
    """Where the middle of a piece is in the window."""
    ob = ob or teapot()
    point = ob.matrix_world @ Vector(part('bridge.analysis.surveys').middles_of(ob.data)[number - 1])
    place = view3d_utils.location_3d_to_region_2d(view.region, view.area.spaces.active.region_3d, point)
    return round(view.region.x + place.x), round(view.region.y + place.y)


def seen_numbers(view):
    with view.override():
        return part('ui.numbers_overlay').shown(bpy.context)


def point_at(view, number, ob=None):
    view.move(*place_of(view, number, ob))
    yield from until(lambda: hovered() == ((ob or teapot()).name, number), f"piece {number} at the mouse")


def visible(view):
    """Numbers of patches that are what is seen at their middles, in the middle of the view."""
    found, picking = [], part('ui.picking')
    for number in range(1, count() + 1):
        x, y = place_of(view, number)
        if 250 < x < 800 and 250 < y < 700:
            with view.override():
                hit = picking.piece_at(view.region, view.region.data, (x - view.region.x, y - view.region.y), [teapot()],
                                       bpy.context.evaluated_depsgraph_get())
            found += [number] if hit == (teapot(), number) else []
    return found


def numbers_are_shown(view):
    plain = save_picture(OUTPUT / "pieces-plain.png")
    assert seen_numbers(view) == []
    teapot().data.splinewright.show_numbers = True
    yield from redrawn()
    shown, = seen_numbers(view)
    assert shown.numbers == tuple(range(1, 33)) and shown.marked == (0, 0)
    numbered = save_picture(OUTPUT / "pieces-numbers.png")
    assert mean_difference(numbered[:, :830], plain[:, :830]) > 0.2
    teapot().data.splinewright.show_numbers = False
    bpy.ops.ed.undo_push(message="numbers")
    print("numbers", flush=True)


def a_piece_is_picked(view):
    first, second = visible(view)[:2]
    with view.override():
        bpy.ops.splinewright.pick_piece('INVOKE_DEFAULT')
    yield from point_at(view, second)
    yield from point_at(view, first)
    save_picture(OUTPUT / "pieces-picking.png")
    view.press('LEFTMOUSE')
    yield from until(lambda: teapot().data.splinewright.piece == first, "the piece that was clicked")
    assert not hovered() and seen_numbers(view) == []
    view.press('Z', ctrl=True)
    yield from until(lambda: teapot().data.splinewright.piece == 0, "no piece after undo")
    view.press('Z', ctrl=True, shift=True)
    yield from until(lambda: teapot().data.splinewright.piece == first, "the piece after redo")
    with view.override():
        bpy.ops.splinewright.pick_piece('INVOKE_DEFAULT', other=True)
    yield from point_at(view, second)
    view.press('ESC')
    yield from until(lambda: not hovered(), "the end of picking")
    assert part('ui.active_shape').of(teapot().data) == (first, 0), "Esc took a piece"
    print("picked", flush=True)


def a_verb_begins_with_it(view):
    first = teapot().data.splinewright.piece
    with view.override():
        bpy.ops.splinewright.split('INVOKE_DEFAULT', True, neighbors=False)
    assert last().properties.piece == first and count() == 33
    yield from redrawn()
    assert seen_numbers(view) == [], "the panel is closed"
    print("begun", flush=True)


def another_is_picked_in_the_panel(view):
    """The eyedropper is at the right end of the last row."""
    panel = view._region('HUD')
    view.move(panel.x + panel.width // 2, panel.y + panel.height // 2)
    yield from redrawn()
    view.press('LEFTMOUSE')
    yield from until(lambda: len(seen_numbers(view)) == 1, "numbers beside the open panel")
    yield from redrawn()
    save_picture(OUTPUT / "pieces-panel.png")
    first = teapot().data.splinewright.piece
    shown, = seen_numbers(view)
    assert shown.numbers.count(first) == 2 and shown.marked == (first,), "both parts are of the patch that was split"
    texts = [shown.text(i) for i in range(count())]
    assert [int(text.split()[0]) for text in texts] == list(range(1, 34)), "each is numbered as it is now"
    assert texts[first].split()[1:] == ["(was", f"{first})"] and texts[first - 1] == str(first), texts
    view.move(panel.x + panel.width - 39, panel.y + 18)
    yield from redrawn()
    view.press('LEFTMOUSE')
    yield from until(lambda: part('ui.ui_state').ui_state.picking, "picking after a click on the eyedropper")
    wanted = next(number for number in visible(view) if shown.numbers[number - 1] != first)
    yield from point_at(view, wanted)
    view.press('LEFTMOUSE')
    yield from until(lambda: last().properties.piece != first, "another number")
    now = last().properties.piece
    assert now == shown.numbers[wanted - 1] and count() == 33
    yield from until(lambda: len(seen_numbers(view)) == 1, "numbers after the operator was done again")
    save_picture(OUTPUT / "pieces-again.png")
    numbers = seen_numbers(view)[0].numbers
    assert numbers.count(now) == 2 and numbers.count(first) == 1, "the old one is split, too"
    view.move(420, 600)
    view.press('Z', ctrl=True)
    yield from until(lambda: count() == 32, "the teapot before the verb")
    assert teapot().data.splinewright.piece == first, "undo goes farther than before the verb"
    view.press('Z', ctrl=True, shift=True)
    yield from until(lambda: count() == 33, "the teapot after the verb")
    print("picked in the panel", flush=True)


def operators_begin_with_pieces(view):
    """As buttons and menus call them, each on the shape as it was before."""
    ob = teapot()
    ob.data.splinewright.piece, ob.data.splinewright.other_piece = 3, 7
    ob.data.materials.append(bpy.data.materials.new("glaze"))
    bpy.ops.ed.undo_push(message="hand")
    for name, setting, expected in (
            ('raise_degree', 'piece', 3), ('to_nurbs', 'piece', 3), ('insert_knot', 'piece', 3),
            ('extract_boundary', 'piece', 3), ('extract_isocurve', 'piece', 3), ('set_patch_material', 'piece', 3),
            ('join_patches', 'first', 3), ('join_patches', 'second', 7)):
        with view.override():
            assert getattr(bpy.ops.splinewright, name)('INVOKE_DEFAULT', True) == {'FINISHED'}, name
            assert getattr(last().properties, setting) == expected, (name, getattr(last().properties, setting))
            bpy.ops.ed.undo()
        yield from redrawn()
    print("patches begun", flush=True)


def curves_are_picked(view):
    empty_file()
    with view.override():
        bpy.ops.splinewright.add_nurbs_curve('EXEC_DEFAULT', True)
        bpy.ops.splinewright.split('EXEC_DEFAULT', True, where='KNOTS')
        bpy.ops.view3d.view_selected()
    yield from redrawn()
    ob = bpy.context.object
    with view.override():
        bpy.ops.splinewright.pick_piece('INVOKE_DEFAULT')
    yield from point_at(view, 3, ob)
    yield from point_at(view, 2, ob)
    save_picture(OUTPUT / "pieces-curves.png")
    view.press('LEFTMOUSE')
    yield from until(lambda: bpy.context.object.data.splinewright.piece == 2, "the curve that was clicked")
    for name, setting in (('raise_degree', 'piece'), ('reverse', 'piece'), ('insert_knot', 'piece'), ('project_curve', 'piece'),
                          ('write_formulas', 'piece'), ('add_basis', 'piece'), ('join_ends', 'first')):
        with view.override():
            assert getattr(bpy.ops.splinewright, name)('INVOKE_DEFAULT', True) == {'FINISHED'}, name
            assert getattr(last().properties, setting) == 2, name
            bpy.ops.ed.undo()
        yield from redrawn()
    print("curves begun", flush=True)


def a_dialog_shows_numbers(view):
    assert seen_numbers(view) == []
    with view.override():
        bpy.ops.splinewright.set_knots('INVOKE_DEFAULT', True)
    yield from until(lambda: len(seen_numbers(view)) == 1, "numbers while Edit Knots is open")
    yield from redrawn()
    save_picture(OUTPUT / "pieces-dialog.png")
    view.press('ESC')
    yield from until(lambda: seen_numbers(view) == [], "no numbers after the dialog")
    print("dialog", flush=True)


def steps():
    view = View()
    empty_file()
    with view.override():
        bpy.ops.splinewright.add_teapot('EXEC_DEFAULT', True)
        bpy.ops.view3d.view_selected()
    view.move(420, 600)
    yield from redrawn()
    for part_of_it in (numbers_are_shown, a_piece_is_picked, a_verb_begins_with_it, another_is_picked_in_the_panel,
                       operators_begin_with_pieces, curves_are_picked, a_dialog_shows_numbers):
        yield from part_of_it(view)
    print("pieces did what they should:", bpy.app.version_string, flush=True)


run(steps())
