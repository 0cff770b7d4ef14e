"""How finely a shape is shown can be changed while its net is out, and Edit Mode's undo takes it back."""

import bpy
import numpy as np
import pytest

from layouts import sidebar
from shapes import VALUES, add, enter, first_point, leave, move, op, require_exact, select, shown
from support import part, splinecore as sc

editing, live, settings_number, panels, shape = (part(name) for name in (
    'ui.editing', 'bridge.net.live', 'bridge.cage.settings_number', 'ui.panels', 'bridge.shape.shape'))

NAMES = ('nurbs patch', 'teapot', 'nurbs', 'cubic', 'hermite', 'many curves')


def settings():
    return bpy.data.objects["shape"].data.splinewright


def push(message="resolution"):
    """What Blender does when a field of a panel was changed."""
    bpy.ops.ed.undo_push(message=message)


def state():
    """Resolution, exact value and what is shown; the shape is what its definition and settings say."""
    editing.sweep()
    ob = bpy.data.objects["shape"]
    require_exact(ob)
    assert not shape.is_touched(ob.data) and ob.data.splinewright.problem == ""
    value = ob.data.splinewright.value
    texts = [piece.dumps() for piece in value] if isinstance(value, list) else value.dumps()
    return settings().resolution_u, texts, shown(ob).tolist()


@pytest.mark.parametrize('name', NAMES)
def test_the_shape_follows_a_resolution_at_once_and_its_definition_stays(name):
    ob = add(VALUES[name]())
    enter()
    before = state()
    settings().resolution_u = 7
    after = state()
    assert after[0] == 7 and after[1] == before[1] and len(after[2]) > len(before[2])
    leave()
    assert state() == after


@pytest.mark.parametrize('name', NAMES)
def test_undo_and_redo_take_it_back_and_forth_among_moves_and_across_the_border(name):
    add(VALUES[name]())
    held = enter()
    select(held, first_point(held))
    ladder = [state()]
    move(0, 0, 0.5)
    ladder.append(state())
    settings().resolution_u = 7
    push()
    ladder.append(state())
    move(0, 0, 0.5)
    ladder.append(state())
    settings().resolution_u = 5
    push()
    ladder.append(state())
    for expected in ladder[-2::-1]:
        bpy.ops.ed.undo()
        assert state() == expected
    for expected in ladder[1:]:
        bpy.ops.ed.redo()
        assert state() == expected
    leave()
    assert state() == ladder[-1] and bpy.context.mode == 'OBJECT'
    for expected in ladder[::-1]:
        bpy.ops.ed.undo()
        assert state() == expected and bpy.context.mode.startswith('EDIT')
    for expected in [*ladder[1:], ladder[-1]]:
        bpy.ops.ed.redo()
        assert state() == expected
    assert bpy.context.mode == 'OBJECT'


def test_all_settings_of_faces_come_back():
    ob = add(part('core.shape.starters').nurbs_patch((3, 3), (5, 5), ('CLAMPED', 'PERIODIC')))
    enter()
    seen = [state()]
    for name, value in (('tolerance', 0.05), ('mode', 'TOLERANCE'), ('mode', 'BOTH'), ('angle', 0.1), ('sharp_angle', 0.5)):
        setattr(settings(), name, value)
        push()
        seen.append(state())
    assert settings().mode == 'BOTH' and len({len(points) for _, _, points in seen}) > 2
    for expected in seen[-2::-1]:
        bpy.ops.ed.undo()
        assert state() == expected
    assert settings().mode == 'COUNT' and np.isclose(settings().angle, np.radians(15)) and settings().tolerance != 0.05
    leave()
    require_exact(bpy.data.objects[ob.name])


def test_the_reach_of_a_curve_that_runs_to_infinity_comes_back():
    add(sc.BezierCurve([(0, 0), (0, 1), (1, 0)], [1, 1, 0]))
    enter()
    before = state()
    assert "reach" in sidebar(bpy.context).props
    settings().reach = 20.5
    push()
    assert state()[2] != before[2]
    bpy.ops.ed.undo()
    assert state() == before and settings().reach == 10
    leave()


def test_a_drag_goes_on_with_the_new_faces():
    add(VALUES['nurbs patch']())
    held = enter()
    select(held, first_point(held))
    settings().resolution_u = 9
    for _ in range(2):
        move(0, 0, 0.5)
        state()
    live.finalize(bpy.data.objects["shape"].data)
    assert state()[0] == 9


def test_faces_that_are_too_many_are_refused_in_words_and_undo_takes_the_wish_back():
    add(VALUES['bezier patch']())
    enter()
    before = state()
    settings().set_resolution(4096, 4096)
    push()
    fine = np.array(before[2], np.float32)
    assert "2^22" in settings().problem and np.array_equal(shown(bpy.data.objects["shape"]), fine)
    assert any("2^22" in text for text in sidebar(bpy.context).texts)
    bpy.ops.ed.undo()
    assert state() == before
    bpy.ops.ed.redo()
    assert "2^22" in settings().problem and np.array_equal(shown(bpy.data.objects["shape"]), fine)
    bpy.ops.ed.undo()
    assert state() == before
    leave()


def test_a_mesh_changed_by_hand_is_not_overwritten():
    ob = add(VALUES['nurbs patch']())
    enter()
    ob.data.vertices[3].co.z += 2
    changed = shown(ob).copy()
    settings().resolution_u = 7
    push()
    assert "changed by hand" in settings().problem and np.array_equal(shown(ob), changed)
    bpy.ops.ed.undo()
    ob = bpy.data.objects["shape"]
    assert shape.is_touched(ob.data) and np.array_equal(shown(ob), changed)


@pytest.mark.parametrize('operator', ('add_catmull_rom', 'add_polynomial'))
def test_a_recipe_stays_a_recipe(operator):
    op(getattr(bpy.ops.splinewright, operator))
    bpy.context.object.name = "shape"
    push("name")
    held = enter()
    before = state()
    layout = sidebar(bpy.context)
    assert "mode" in layout.props
    settings().resolution_u = 40
    push()
    assert state()[2] != before[2]
    bpy.ops.curve.select_all(action='SELECT')
    push("select")
    move(0, 0, 1)
    moved = state()
    assert moved[0] == 40 and part('bridge.recipes.recipes').has_points(bpy.data.objects["shape"].data)
    for _ in range(2):
        bpy.ops.ed.undo()
    assert state()[0] == 40
    bpy.ops.ed.undo()
    assert state() == before
    leave()


def test_the_panel_of_the_net_shows_the_settings_and_the_knots():
    add(VALUES['nurbs patch']())
    enter()
    layout = sidebar(bpy.context)
    assert {"mode", "resolution_u", "resolution_v", "sharp_angle"} <= set(layout.props)
    assert "splinewright.set_knots" in layout.operators


def test_more_settings_than_there_are_marks_forget_the_oldest():
    add(VALUES['nurbs patch']())
    held = enter()
    session = live.session(held.data)
    numbers = [session.number_of(('COUNT', i)) for i in range(settings_number.COUNT + 10)]
    assert len(set(numbers)) == settings_number.COUNT and max(numbers) < 1024
    assert session.number_of(('COUNT', settings_number.COUNT + 9)) == numbers[-1]
    assert session.settings(numbers[-1], None) == ('COUNT', settings_number.COUNT + 9)
    for i in (100, settings_number.COUNT, settings_number.COUNT + 5):
        assert session.settings(numbers[i], None) == ('COUNT', i)


def test_nets_that_were_opened_with_their_file_take_the_settings_as_they_are(tmp_path):
    add(VALUES['nurbs patch']())
    enter()
    settings().resolution_u = 7
    push()
    path = str(tmp_path / "net.blend")
    part('bridge.data.file_state').state.sessions.clear()        # as after loading
    live.sync_from_cage(bpy.context.object)
    assert state()[0] == 7
    bpy.ops.wm.save_as_mainfile(filepath=path)
    bpy.ops.wm.open_mainfile(filepath=path)
    assert state()[0] == 7
