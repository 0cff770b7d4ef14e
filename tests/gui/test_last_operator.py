"""What a real window shows of the last operator: its panel, presets, its name in Undo History."""

import ctypes
import os
import sys
import tempfile
from pathlib import Path
from types import SimpleNamespace

import bpy

sys.path.insert(0, str(Path(__file__).parent))
from window import View, empty_file, into_net, opened_browser, out_of_net, redrawn, run, save_picture, select_points, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])
FOLDER = Path(tempfile.mkdtemp())


def last():
    return bpy.context.window_manager.operators[-1]


def value():
    return bpy.data.objects["NURBS Patch"].data.splinewright.value


def again(view):
    """Do the last operator again, as its panel does after a change."""
    with view.override():
        bpy.ops.ed.undo_redo()
        bpy.ops.ed.undo_push(message=getattr(bpy.types, last().bl_idname).bl_label)
    yield from redrawn()


def undo_steps():
    """The names of the undo steps, which Blender tells to its standard output only."""
    path = FOLDER / "steps.txt"
    sys.stdout.flush()
    ctypes.CDLL(None).fflush(None)
    kept = os.dup(1)
    with open(path, 'w') as file:
        os.dup2(file.fileno(), 1)
        bpy.context.window_manager.print_undo_steps()
        ctypes.CDLL(None).fflush(None)
    os.dup2(kept, 1)
    os.close(kept)
    return [line.split("name='")[1][:-1] for line in path.read_text().splitlines() if "name='" in line]


def add_patch(view):
    empty_file()
    bpy.data.orphans_purge()            # names are free again
    with view.override():
        bpy.ops.splinewright.add_nurbs_patch('EXEC_DEFAULT', True, count_v=5)
        bpy.ops.view3d.view_selected()
    view.move(420, 420)
    yield from redrawn()


def knots_of_another_axis(view):
    yield from add_patch(view)
    before = value()
    with view.override():
        bpy.ops.splinewright.set_knots('INVOKE_DEFAULT', True)
    yield from redrawn()
    view.press('RET')
    yield from until(lambda: last().bl_idname == 'SPLINEWRIGHT_OT_set_knots', "the end of the dialog")
    assert last().properties.knots == "0 0 0 0 1 2 3 3 3 3"
    last().properties.knots = "0 0 0 0 1 1.5 3 3 3 3"
    yield from again(view)
    assert value().knots[0].tolist() == [0, 0, 0, 0, 1, 1.5, 3, 3, 3, 3]
    last().properties.axis = 'V'
    yield from again(view)
    assert last().properties.knots == "0 0 0 0 1 2 2 2 2", "the panel shows the knots of the axis before"
    assert value() == before, "the change of the axis before stays"
    last().properties.knots = "0 0 0 0 0.5 2 2 2 2"
    yield from again(view)
    assert value().knots[1].tolist() == [0, 0, 0, 0, 0.5, 2, 2, 2, 2] and value().knots[0].tolist() == before.knots[0].tolist()
    assert undo_steps()[-1] == "Edit Knots"
    print("knots", flush=True)


def said(view):
    """What Blender has reported, as the status bar shows it: it keeps that for its Info editor."""
    area = next(area for area in view.window.screen.areas if area.type == 'DOPESHEET_EDITOR')
    area.type = 'INFO'
    yield from redrawn()
    with bpy.context.temp_override(window=view.window, area=area, region=next(part for part in area.regions if part.type == 'WINDOW')):
        bpy.ops.info.select_all(action='SELECT')
        bpy.ops.info.report_copy()
    area.type = 'DOPESHEET_EDITOR'
    return bpy.context.window_manager.clipboard


def results_of_changes(view):
    yield from add_patch(view)
    with view.override():
        bpy.ops.splinewright.raise_degree('INVOKE_DEFAULT', True)
    yield from redrawn()
    for times, count in ((3, 75), (2, 60)):
        last().properties.times = times
        yield from again(view)
        reports = yield from said(view)
        assert reports.endswith(f"\nElevated the degree of NURBS Patch: 30 points became {count}\n"), reports
    last().properties.times = 1
    last().properties.piece = 4
    yield from again(view)
    reports = yield from said(view)
    assert "piece" in reports.splitlines()[-1] or "1 patch" in reports.splitlines()[-1], reports
    print("results", flush=True)


def preset_of(operator, name, override):
    """The path of a preset of the present settings, made as the button + does."""
    from bl_operators.presets import AddPresetOperator as adding
    folder = Path(bpy.utils.user_resource('SCRIPTS', path=f"presets/{adding.operator_path(operator.bl_idname)}", create=True))
    path = folder / f"{name}.py"
    try:
        with override():
            bpy.ops.wm.operator_preset_add('EXEC_DEFAULT', name=name, operator=operator.bl_idname)
    except RuntimeError as error:
        # Blender 4.3 with Python 3.13, as Debian has it, makes no presets of any operator.
        assert "name 'op' is not defined" in str(error) and bpy.app.version < (4, 4, 0), error
        names = adding.preset_values.fget(SimpleNamespace(operator=operator.bl_idname))
        settings = [f"{name} = {getattr(operator.properties, name[3:])!r}\n" for name in names]
        path.write_text("import bpy\nop = bpy.context.active_operator\n" + "".join(settings))
    return path


def rebuilt_and_faired(view):
    """Of curves and patches: the panel does it anew from what was before, undo takes it back, redo does it again."""
    for adds, name, setting, values in (
            ('add_interpolating', 'rebuild', 'count_u', (6, 9)), ('add_interpolating', 'fair', 'tolerance', (0.5, 0.25)),
            ('add_nurbs_patch', 'rebuild', 'count_u', (5, 7)), ('add_nurbs_patch', 'fair', 'tolerance', (0.5, 0.25))):
        empty_file()
        with view.override():
            getattr(bpy.ops.splinewright, adds)('EXEC_DEFAULT', True)
            if adds == 'add_interpolating':
                bpy.ops.splinewright.make_editable('EXEC_DEFAULT', True)
        view.move(420, 420)
        yield from redrawn()
        before = bpy.context.object.data.splinewright.value
        with view.override():
            assert getattr(bpy.ops.splinewright, name)('INVOKE_DEFAULT', True) == {'FINISHED'}
        yield from redrawn()
        for number in values:
            setattr(last().properties, setting, number)
            yield from again(view)
            of_patch = adds == 'add_nurbs_patch' and name == 'rebuild'
            wanted = getattr(before, name)(*(((number, 10), (3, 3)) if of_patch else (number,))).value
            assert bpy.context.object.data.splinewright.value == wanted
        view.press('Z', ctrl=True)
        yield from redrawn()
        assert bpy.context.object.data.splinewright.value != wanted
        view.press('Z', ctrl=True, shift=True)
        yield from redrawn()
        assert bpy.context.object.data.splinewright.value == wanted
        print(name, flush=True)


def presets(view):
    yield from add_patch(view)
    with view.override():
        bpy.ops.splinewright.raise_degree('INVOKE_DEFAULT', True)
    yield from redrawn()
    last().properties.direction, last().properties.times = 'V', 3
    yield from again(view)
    assert value().degree == (3, 6)
    panel = view._region('HUD')
    view.move(panel.x + panel.width // 2, panel.y + panel.height // 2)
    yield from redrawn()
    view.press('LEFTMOUSE')
    yield from until(lambda: panel.height > 60, "the open panel of the last operator")
    yield from redrawn()
    save_picture(OUTPUT / "last-operator-presets.png")
    path = preset_of(last(), "Thrice", view.override)
    text = path.read_text()
    assert "op.times = 3" in text and "op.direction = 'V'" in text and "piece" not in text, text
    last().properties.direction, last().properties.times = 'U', 1
    yield from again(view)
    assert value().degree == (4, 3)
    with view.override():
        bpy.ops.script.execute_preset('EXEC_DEFAULT', filepath=str(path), menu_idname="WM_MT_operator_presets")
    yield from again(view)
    assert value().degree == (3, 6), "the preset restores nothing"
    print("presets", flush=True)


def presets_of_files(view):
    """In the file browser; the file's name stays."""
    yield from add_patch(view)
    path = FOLDER / "patch.bpt"
    with view.override():
        bpy.ops.splinewright.export_bpt('INVOKE_DEFAULT', True, filepath=str(path), flip=True)
    there = yield from opened_browser()
    operator = there['area'].spaces.active.active_operator
    save_picture(OUTPUT / "last-operator-browser.png")
    preset = preset_of(operator, "Flipped", lambda: bpy.context.temp_override(**there))
    assert "op.flip = True" in preset.read_text() and "path" not in preset.read_text(), preset.read_text()
    operator.properties.flip = False
    with bpy.context.temp_override(**there):
        bpy.ops.script.execute_preset('EXEC_DEFAULT', filepath=str(preset), menu_idname="WM_MT_operator_presets")
    assert operator.properties.flip and Path(operator.properties.filepath) == path
    with bpy.context.temp_override(**there):
        bpy.ops.file.execute('INVOKE_DEFAULT')
    yield from until(path.exists, "the exported file")
    print("presets of files", flush=True)


def names_of_steps(view):
    """Of what is typed in the sidebar, too, where Blender shows what the field says."""
    view = View()
    yield from add_patch(view)
    view.open_sidebar()
    yield from view.show_tab("NURBS", (1045, 538))
    view.move(420, 420)
    yield from redrawn()
    view.press('TAB')
    yield from into_net()
    select_points(12)
    yield from redrawn()
    save_picture(OUTPUT / "last-operator-sidebar.png")
    yield from view.go_to_field("numbers")
    for key, text in (('RET', ""), ('TWO', "2"), ('RET', "")):      # the field is opened, typed into and left
        view.press(key, text=text)
        yield from redrawn()
    yield from until(lambda: value().points[2, 2, 0] == 2, "the number that was typed")
    with view.override():
        bpy.ops.splinewright.point_to_infinity('EXEC_DEFAULT', True)
    view.move(420, 420)
    yield from redrawn()
    view.press('TAB')
    yield from out_of_net()
    names = undo_steps()
    assert any(name.startswith("X: ") for name in names), names
    assert {"Add NURBS Patch", "Edit Control Points", "Move to Infinity", "Finish Editing"} <= set(names), names
    print("names", flush=True)


def steps():
    view = View()
    for part_of_it in (results_of_changes, rebuilt_and_faired, knots_of_another_axis, presets, presets_of_files, names_of_steps):
        yield from part_of_it(view)
    print("the last operator is shown as it should be:", bpy.app.version_string, flush=True)


run(steps())
