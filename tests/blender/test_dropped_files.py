"""Several files at once, as the file browser gives them and as they are dropped."""

import bpy
import numpy as np
import pytest

from support import scene_state, splinecore as sc
from test_exchange import GOOD

CURVE = sc.BezierCurve([(0, 0), (1, 1), (2, 0)])
PATCH = sc.BezierPatch(np.arange(12.0).reshape(2, 2, 3) ** 2)
MISSING = "No such file"


@pytest.fixture
def folder(tmp_path):
    (tmp_path / "a.bpt").write_text(GOOD)
    (tmp_path / "b.bpt").write_text(GOOD.replace("1 1 0", "1 1 7"))
    (tmp_path / "bad.bpt").write_text("teapot")
    (tmp_path / "worse.bpt").write_text("0")
    (tmp_path / "curves.json").write_text(sc.dumps([CURVE, PATCH, CURVE]))
    (tmp_path / "patch.spw.json").write_text(PATCH.dumps())
    (tmp_path / "scene.json").write_text('{"asset": {"version": "2.0"}}')
    return tmp_path


def come_in(operator, folder, *names, call='INVOKE_DEFAULT'):
    """As they are dropped: Blender names the first file by its path, too."""
    bpy.ops.ed.undo_push(message="before")
    return operator(call, True, filepath=str(folder / names[0]), directory=str(folder),
                    files=[{'name': name} for name in names])


@pytest.mark.parametrize('call', ('INVOKE_DEFAULT', 'EXEC_DEFAULT'))
def test_each_file_becomes_objects_in_one_step(folder, call, capfd):
    assert come_in(bpy.ops.splinewright.import_bpt, folder, "a.bpt", "b.bpt", call=call) == {'FINISHED'}
    obs = bpy.data.objects
    assert sorted(ob.name for ob in obs) == ["a", "b"]
    assert obs["b"].data.splinewright.value[0].points[1, 1, 2] == 7
    assert set(bpy.context.selected_objects) == {obs["a"], obs["b"]} and bpy.context.object == obs["b"]
    assert "Info: Imported 2 objects of 2 files" in capfd.readouterr().out
    bpy.ops.ed.undo()
    assert not bpy.data.objects


def test_a_dropped_file_asks_nothing(folder):
    assert come_in(bpy.ops.splinewright.import_json, folder, "curves.json") == {'FINISHED'}
    assert sorted(ob.type for ob in bpy.data.objects) == ['CURVE', 'MESH']


def test_a_dropped_file_of_others_is_refused_and_nothing_is_lost(folder):
    bpy.ops.splinewright.add_nurbs_curve()
    chosen, before = bpy.context.object, scene_state()
    with pytest.raises(RuntimeError, match="scene.json: it holds no curves or patches of Splinewright"):
        come_in(bpy.ops.splinewright.import_json, folder, "scene.json")
    assert scene_state() == before and bpy.context.object == chosen and chosen.select_get()


def test_a_file_of_others_among_ours_is_named_and_ours_come_in(folder, capfd):
    assert come_in(bpy.ops.splinewright.import_json, folder, "scene.json", "patch.spw.json") == {'FINISHED'}
    assert "Warning: Imported patch; scene.json: it holds no curves" in capfd.readouterr().out
    assert [ob.name for ob in bpy.data.objects] == ["patch"]


def test_a_bad_one_among_several_is_told_of_and_the_others_come_in(folder, capfd):
    assert come_in(bpy.ops.splinewright.import_bpt, folder, "bad.bpt", "a.bpt", "none.bpt", "b.bpt") == {'FINISHED'}
    assert sorted(ob.name for ob in bpy.data.objects) == ["a", "b"]
    said = capfd.readouterr().out
    assert "Warning: Imported 2 objects of 2 files; bad.bpt: BPT line 1: 'teapot' is not the count" in said
    assert f"none.bpt: {MISSING}" in said


def test_where_all_are_bad_the_scene_is_unchanged(folder):
    before = scene_state()
    with pytest.raises(RuntimeError, match="bad.bpt: BPT line 1.*; worse.bpt: .*count of patches is 0"):
        come_in(bpy.ops.splinewright.import_bpt, folder, "bad.bpt", "worse.bpt")
    assert scene_state() == before


def test_a_file_of_which_the_second_value_cannot_be_shown_brings_nothing(tmp_path):
    far = sc.BezierPatch(1e300 * np.ones((2, 2, 3)))
    (tmp_path / "far.json").write_text(sc.dumps([PATCH, far]))
    (tmp_path / "near.json").write_text(sc.dumps([CURVE]))
    before = scene_state()
    with pytest.raises(RuntimeError, match="far.json"):
        bpy.ops.splinewright.import_json(filepath=str(tmp_path / "far.json"))
    assert scene_state() == before
    come_in(bpy.ops.splinewright.import_json, tmp_path, "far.json", "near.json")
    assert [ob.name for ob in bpy.data.objects] == ["near"] and not bpy.data.meshes


def test_nothing_chosen_is_said(tmp_path):
    with pytest.raises(RuntimeError, match="irectory"):
        bpy.ops.splinewright.import_bpt(directory=str(tmp_path), filepath=str(tmp_path), files=[{'name': ""}])


def test_the_next_call_knows_nothing_of_the_files_before(folder):
    come_in(bpy.ops.splinewright.import_bpt, folder, "a.bpt", "b.bpt")
    assert bpy.ops.splinewright.import_bpt('EXEC_DEFAULT', True, filepath=str(folder / "b.bpt")) == {'FINISHED'}
    assert sorted(ob.name for ob in bpy.data.objects) == ["a", "b", "b.001"]


def test_an_object_has_the_name_of_its_file_though_data_of_that_name_is_left(folder):
    bpy.data.meshes.new("a")
    bpy.ops.splinewright.import_bpt(filepath=str(folder / "a.bpt"))
    assert bpy.context.object.name == "a"


def test_the_resolution_is_that_of_the_settings(folder):
    bpy.ops.splinewright.import_bpt(filepath=str(folder / "a.bpt"), resolution_u=3, resolution_v=2)
    assert len(bpy.context.object.data.polygons) == 6


def test_an_overridden_collection_takes_nothing(tmp_path, folder):
    bpy.context.scene.collection.children.link(bpy.data.collections.new("theirs"))
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "library.blend"))
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
    with bpy.data.libraries.load(str(tmp_path / "library.blend"), link=True) as (_, wanted):
        wanted.collections = ["theirs"]
    linked = wanted.collections[0]
    bpy.context.scene.collection.children.link(linked)
    theirs = linked.override_hierarchy_create(bpy.context.scene, bpy.context.view_layer)
    layer = bpy.context.view_layer
    layer.active_layer_collection = next(child for child in layer.layer_collection.children
                                         if child.collection == theirs)
    before = scene_state()
    for operator, settings in ((bpy.ops.splinewright.import_bpt, {'filepath': str(folder / "a.bpt")}),
                               (bpy.ops.splinewright.add_teapot, {})):
        with pytest.raises(RuntimeError, match="linked from another file"):
            operator(**settings)
    assert scene_state() == before


@pytest.mark.skipif(not hasattr(bpy.types, 'FileHandler'), reason="files are dropped from Blender 4.1 on")
def test_both_kinds_of_files_can_be_dropped_into_a_3d_view():
    for kind, name in ((".bpt", 'bpt'), (".json", 'json')):
        handler = getattr(bpy.types, f"SPLINEWRIGHT_FH_{name}")
        assert handler.bl_file_extensions == kind and handler.bl_import_operator == f"splinewright.import_{name}"
        assert not getattr(handler, 'bl_export_operator', "")     # it would export the active object for a collection
        with bpy.context.temp_override(area=None):
            assert not handler.poll_drop(bpy.context)
