"""The self-test: it passes, says what it tried, changes nothing, and tells of what fails."""

import bpy
import pytest

from support import part, scene_state, splinecore as sc

core, bridge = part('core.base.self_test'), part('bridge.edit.self_test')


def test_it_passes_and_says_what_it_tried(capsys):
    before = scene_state()
    assert bpy.ops.splinewright.self_test() == {'FINISHED'}
    said = capsys.readouterr().out
    print(said)
    assert said.count("passed  ") == bridge.COUNT and "FAILED" not in said
    for words in (sc.__version__, sc.__instruction_set__, bpy.app.version_string, "as on every system", "Blender's own NURBS surfaces"):
        assert words in said
    assert scene_state() == before


def test_results_hold_something_of_every_part():
    kinds = {array.dtype.kind for array in core.results()}
    assert kinds == {'f', 'i'} and sum(array.size for array in core.results()) > 20_000


@pytest.mark.parametrize('name', ["DIGESTS", "_CURVE_TOLERANCE", "_SURFACE_TOLERANCE"])
def test_what_fails_is_named(capsys, monkeypatch, name):
    if name == "DIGESTS":
        monkeypatch.setattr(core, name, dict.fromkeys(core.DIGESTS, "0" * 16))
    else:
        monkeypatch.setattr(bridge, name, 0.0)
    with pytest.raises(RuntimeError, match="Failed: .*All of it is in the clipboard"):
        bpy.ops.splinewright.self_test()
    assert capsys.readouterr().out.count("FAILED  ") == 1


def test_in_edit_mode_surfaces_are_left_out(capsys):
    bpy.ops.mesh.primitive_cube_add()
    bpy.ops.object.mode_set(mode='EDIT')
    try:
        assert bpy.ops.splinewright.self_test() == {'FINISHED'}
        assert capsys.readouterr().out.count("passed  ") == bridge.COUNT - 1
        assert bpy.context.mode == 'EDIT_MESH'
    finally:
        bpy.ops.object.mode_set(mode='OBJECT')
