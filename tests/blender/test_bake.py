"""Bake Animation: what followed moves the same by itself, where Splinewright is missing, too; and the way back."""

import json
import re
import subprocess
import textwrap
from pathlib import Path

import bpy
import numpy as np
import pytest

from animated import animate, evaluated, follow_object, in_scene, native_path, rise
from layouts import drawn
from shapes import activate, add, op, require_exact, shown
from support import corner_normals, part

baking, follow, recipes, shape, starters, store = (part(name) for name in (
    'bridge.edit.baking', 'bridge.follow.follow', 'bridge.recipes.recipes', 'bridge.shape.shape', 'core.shape.starters', 'bridge.data.store'))
bake = bpy.ops.splinewright.bake_animation
FIRST, LAST = 3, 9


def bending_path():
    """A curve that rises and bends."""
    source = native_path()
    rise(source)
    source.shape_key_add(name="Basis")
    source.shape_key_add(name="Bent").data[2].co.y += 2
    animate(source.data.shape_keys, 'key_blocks["Bent"].value', {1: 0.0, 11: 1.0})
    bpy.context.scene.frame_set(1)
    return source


def curve():
    ob = follow_object(bending_path())
    ob.data.bevel_depth = 0.1
    return ob


def mesh():
    source = bending_path()
    source.location.x = 5
    animate(source, 'location', {1: 5.0, 11: 8.0}, index=0)
    activate(source)
    assert op(bpy.ops.splinewright.add_revolve, axis='z') == {'FINISHED'}
    ob = bpy.context.object
    ob.data.splinewright.set_resolution(3, 3)
    ob.data.materials.append(bpy.data.materials.new("glaze"))
    return ob


def keyed_mesh():
    assert op(bpy.ops.splinewright.add_torus) == {'FINISHED'}
    ob = bpy.context.object
    ob.data.splinewright.set_resolution(3, 3)
    animate(ob.data, 'splinewright_parameters.torus_radius', {1: 1.0, 11: 2.0})
    animate(ob.data, 'splinewright_parameters.torus_tube_radius', {1: 0.1, 11: 0.7})
    return ob


MAKERS = pytest.mark.parametrize('make', (curve, mesh, keyed_mesh))


def bake_it(*obs, **settings):
    activate(*obs)
    assert op(bake, **{'frame_start': FIRST, 'frame_end': LAST, **settings}) == {'FINISHED'}


def live(ob, frames=range(FIRST, LAST + 1)):
    """{frame: points} of what a shape shows as long as it follows."""
    found = {}
    for frame in frames:
        bpy.context.scene.frame_set(frame)
        found[frame] = evaluated(ob)
    return found


def size_of(points):
    return np.ptp(np.concatenate(list(points.values())), axis=0).max()


@MAKERS
def test_a_baked_shape_moves_as_it_did(make):
    ob = make()
    before = live(ob)
    bpy.context.scene.frame_set(2)
    bake_it(ob)
    assert bpy.context.scene.frame_current == 2
    for frame, points in before.items():
        bpy.context.scene.frame_set(frame)
        assert np.abs(evaluated(ob) - points).max() < 1e-5 * size_of(before), frame
    for outside, end in ((1, FIRST), (20, LAST)):
        bpy.context.scene.frame_set(outside)
        assert np.abs(evaluated(ob) - before[end]).max() < 1e-5 * size_of(before)
    bpy.context.scene.frame_set(4, subframe=0.5)
    assert np.abs(evaluated(ob) - (before[4] + before[5]) / 2).max() < 1e-4 * size_of(before), "between frames"


@pytest.mark.parametrize('mode', ('AUTOMATIC', 'TOLERANCE', 'ANGLE', 'BOTH'))
def test_a_surface_with_as_many_faces_as_it_needs_is_baked_with_those_of_the_frame_that_needs_the_most(mode):
    ob = keyed_mesh()
    ob.data.materials.append(bpy.data.materials.new("glaze"))
    ob.data.splinewright.mode = mode
    counts = {}
    for frame in range(FIRST, LAST + 1):
        bpy.context.scene.frame_set(frame)
        counts[frame] = len(ob.data.polygons)
    bpy.context.scene.frame_set(2)
    assert len(set(counts.values())) > 1
    bake_it(ob)
    assert len(ob.data.polygons) == max(counts.values()) and list(ob.data.materials) == [bpy.data.materials["glaze"]]
    for frame in counts:
        bpy.context.scene.frame_set(frame)
        points, along = evaluated(ob).astype(float), (frame - 1) / 10
        ring = np.hypot(points[:, 0], points[:, 1]) - (1 + along)
        assert np.abs(np.hypot(ring, points[:, 2]) - (0.1 + 0.6 * along)).max() < 1e-5


CHILD = """
import bpy, json, sys
assert not hasattr(bpy.types.Mesh, 'splinewright')
scene, name, found = bpy.context.scene, sys.argv[sys.argv.index('--') + 1], {}
def points(depsgraph):
    ob = bpy.data.objects[name].evaluated_get(depsgraph)
    if ob.type == 'MESH':
        return [list(vertex.co) for vertex in ob.data.vertices]
    splines = ob.to_curve(depsgraph, apply_modifiers=True).splines
    return [list(point.co)[:3] for spline in splines for point in spline.points]
class Engine(bpy.types.RenderEngine):
    bl_idname, bl_label = 'TEST', "Test"
    def render(self, depsgraph):
        found[depsgraph.scene.frame_current] = points(depsgraph)
bpy.utils.register_class(Engine)
scene.render.engine, scene.frame_start, scene.frame_end = 'TEST', 3, 9
bpy.ops.render.render(animation=True)
print("FOUND", json.dumps(found))
"""


@MAKERS
def test_a_file_with_baked_shapes_renders_right_where_the_addon_is_missing(make, tmp_path):
    ob = make()
    before = live(ob)
    bake_it(ob)
    scene = bpy.context.scene
    scene.camera = in_scene("camera", bpy.data.cameras.new("camera"))
    scene.render.resolution_x = scene.render.resolution_y = 8
    scene.render.filepath = str(tmp_path / "frame")
    path, script = tmp_path / "baked.blend", tmp_path / "child.py"
    bpy.ops.wm.save_as_mainfile(filepath=str(path))
    script.write_text(CHILD)
    done = subprocess.run([bpy.app.binary_path, '--background', '--factory-startup', str(path), '--python-exit-code', '1',
                           '--python', str(script), '--', ob.name], capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stdout + done.stderr
    found = json.loads(next(line for line in done.stdout.splitlines() if line.startswith("FOUND"))[6:])
    assert {int(frame) for frame in found} == set(before)
    for frame, points in found.items():
        assert np.abs(np.array(points) - before[int(frame)]).max() < 1e-5 * size_of(before), frame


def test_baked_shapes_move_where_their_file_is_linked(tmp_path):
    asset = bpy.data.collections.new("asset")
    bpy.context.scene.collection.children.link(asset)
    ob = mesh()
    before = live(ob)
    bake_it(ob)
    bpy.context.scene.collection.objects.unlink(ob)
    asset.objects.link(ob)
    name = ob.name
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "asset.blend"))
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
    with bpy.data.libraries.load(str(tmp_path / "asset.blend"), link=True) as (_, wanted):
        wanted.collections = ["asset"]
    bpy.context.scene.collection.children.link(wanted.collections[0])
    for frame, points in before.items():
        bpy.context.scene.frame_set(frame)
        assert np.abs(evaluated(bpy.data.objects[name]) - points).max() < 1e-5 * size_of(before)


def test_normals_turn_with_what_is_baked():
    ob = keyed_mesh()
    ob.data.splinewright.set_resolution(8, 8)
    bpy.context.scene.frame_set(FIRST)
    bake_it(ob)
    for frame in (FIRST, LAST):
        bpy.context.scene.frame_set(frame)
        of_mesh = bpy.data.meshes.new_from_object(ob.evaluated_get(bpy.context.evaluated_depsgraph_get()))
        radius = 1.0 + 0.1 * (frame - 1)
        assert largest_angle(corner_normals(of_mesh), exact_torus_normals(of_mesh, radius)) < (0.5 if frame == FIRST else 6)


def largest_angle(a, b):
    return np.degrees(np.arccos(np.clip((a.astype(float) * b).sum(1), -1, 1)).max())


def exact_torus_normals(mesh, radius):
    places = np.array([vertex.co for vertex in mesh.vertices])
    rims = places * (1, 1, 0)
    rims *= radius / np.linalg.norm(rims, axis=1)[:, None]
    normals = places - rims
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    return normals[[loop.vertex_index for loop in mesh.loops]]


def test_what_a_user_put_on_a_shape_stays():
    ob = mesh()
    ob.modifiers.new("thick", 'SOLIDIFY')
    materials, layers = list(ob.data.materials), [layer.name for layer in ob.data.uv_layers]
    child = in_scene("child", None)
    child.parent = ob
    bake_it(ob)
    assert list(ob.data.materials) == materials and [layer.name for layer in ob.data.uv_layers] == layers
    assert ob.modifiers[0].name == "thick" and child.parent == ob
    assert not store.has_definition(ob.data) and not recipes.has(ob.data)
    assert not any(recipes.WATCHED == driver.data_path for driver in getattr(ob.data.animation_data, 'drivers', ()))


@MAKERS
def test_live_again_is_the_way_back(make):
    ob = make()
    before = live(ob)
    data, name = ob.data, ob.name
    bpy.context.scene.frame_set(2)
    known = {kind: set(getattr(bpy.data, kind)) for kind in ('meshes', 'curves', 'actions', 'objects', 'shape_keys')}
    bake_it(ob)
    bpy.context.scene.frame_set(8)
    activate(ob)
    assert "frames 3 to 9" in drawn() and "Remove Baked Animation" in drawn()
    assert op(bpy.ops.splinewright.unbake) == {'FINISHED'}
    assert ob.data == data
    assert {kind: set(getattr(bpy.data, kind)) for kind in known} == known, "something was left behind"
    for frame, points in before.items():
        bpy.context.scene.frame_set(frame)
        assert np.array_equal(evaluated(bpy.data.objects[name]), points)
        require_exact(ob)


def test_the_way_back_goes_through_a_file(tmp_path):
    ob = curve()
    before, name = live(ob), ob.name
    bake_it(ob)
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "baked.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "baked.blend"))
    bpy.context.scene.frame_set(5)
    activate(bpy.data.objects[name])
    assert op(bpy.ops.splinewright.unbake) == {'FINISHED'}
    bpy.context.view_layer.update()
    assert np.array_equal(evaluated(bpy.data.objects[name]), before[5])
    require_exact(bpy.data.objects[name])


def test_bake_and_live_again_are_undone_and_redone():
    ob = curve()
    name = ob.name
    before = live(ob)
    bpy.context.scene.frame_set(5)
    bpy.ops.ed.undo_push(message="before")
    bake_it(ob)
    activate(bpy.data.objects[name])
    op(bpy.ops.splinewright.unbake)

    def require(is_baked):
        ob = bpy.data.objects[name]
        assert baking.is_baked(ob.data) == is_baked
        bpy.context.view_layer.update()
        assert np.abs(evaluated(ob) - before[bpy.context.scene.frame_current]).max() < 1e-5

    require(False)
    for step, is_baked in ((bpy.ops.ed.undo, True), (bpy.ops.ed.undo, False), (bpy.ops.ed.redo, True), (bpy.ops.ed.redo, False)):
        step()
        require(is_baked)


def test_linked_duplicates_are_baked_together_and_a_copy_of_what_is_baked_has_a_way_back_of_its_own():
    ob = curve()
    twin = in_scene("twin", ob.data)
    bake_it(ob)
    assert twin.data == ob.data
    copy = in_scene("copy", ob.data.copy())
    for each in (ob, copy):
        activate(each)
        assert op(bpy.ops.splinewright.unbake) == {'FINISHED'}
    assert twin.data == ob.data != copy.data
    assert all(follow.problem(each.data) == "" and shape.has_shape(each) for each in (ob, copy))


def test_a_follower_of_what_is_baked_is_baked_with_it_or_neither():
    first = curve()
    second = follow_object(first)
    before = live(second)
    activate(first)
    with pytest.raises(RuntimeError, match="bake both together"):
        op(bake)
    assert shape.has_shape(first)
    bake_it(first, second)
    for frame, points in before.items():
        bpy.context.scene.frame_set(frame)
        assert np.abs(evaluated(second) - points).max() < 1e-5 * size_of(before)


def test_a_step_bakes_fewer_keys_and_is_straight_between_them():
    ob = curve()
    before = live(ob)
    bake_it(ob, frame_step=3)
    assert [block.name for block in ob.data.shape_keys.key_blocks] == ["Frame 3", "Frame 6", "Frame 9"]
    for frame, expected in ((3, before[3]), (9, before[9]), (4, before[3] + (before[6] - before[3]) / 3)):
        bpy.context.scene.frame_set(frame)
        assert np.abs(evaluated(ob) - expected).max() < 1e-5 * size_of(before)


def test_the_range_is_that_of_the_scene_where_it_is_not_given():
    scene = bpy.context.scene
    scene.frame_start, scene.frame_end = 4, 6
    ob = curve()
    activate(ob)
    assert op(bake) == {'FINISHED'} and baking.frames(ob.data) == "4 to 6"
    op(bpy.ops.splinewright.unbake)
    scene.use_preview_range, scene.frame_preview_start, scene.frame_preview_end = True, 5, 8
    assert op(bake) == {'FINISHED'} and baking.frames(ob.data) == "5 to 8"


def with_other_patches():
    """A turn that has more spans by every quarter."""
    ob = mesh()
    ob.data.splinewright.mode = 'AUTOMATIC'
    animate(ob.data, 'splinewright_parameters.revolve_sweep', {1: 0.3, 11: 6.0})
    return ob


def with_keyed_resolution():
    ob = curve()
    animate(ob.data, 'splinewright.resolution_u', {1: 2, 9: 8})
    return ob


def touched():
    ob = mesh()
    ob.data.vertices[0].co.z += 1
    return ob


def still():
    return add(starters.nurbs_curve(3, 6, 'CLAMPED'))


@pytest.mark.parametrize('make, settings, words', (
    (with_other_patches, {}, "other patches, or other ones that meet"), (with_keyed_resolution, {}, "not keyed"),
    (touched, {}, "changed by hand"), (still, {}, "does not change"), (curve, {'frame_end': 2}, "before the first")))
def test_what_cannot_be_baked_is_refused_and_nothing_changes(make, settings, words):
    ob = make()
    bpy.context.scene.frame_set(7)
    data, before = ob.data, shown(ob).copy()
    blocks = [len(getattr(bpy.data, kind)) for kind in ('meshes', 'curves', 'actions', 'objects')]
    activate(ob)
    with pytest.raises(RuntimeError, match=words):
        op(bake, **{'frame_start': FIRST, 'frame_end': LAST, **settings})
    assert ob.data == data and bpy.context.scene.frame_current == 7 and np.array_equal(shown(ob), before)
    assert [len(getattr(bpy.data, kind)) for kind in ('meshes', 'curves', 'actions', 'objects')] == blocks


def test_what_would_not_fit_is_refused_before_a_frame_is_shown(monkeypatch):
    ob = curve()
    monkeypatch.setattr(baking, '_MOST', 1000)
    monkeypatch.setattr(baking, '_recorded', None)
    activate(ob)
    with pytest.raises(RuntimeError, match="would take"):
        op(bake)


def test_a_way_back_that_is_gone_is_said():
    ob = curve()
    bake_it(ob)
    original = ob.data[baking.KEY]['original']
    bpy.data.curves.remove(original)
    activate(ob)
    with pytest.raises(RuntimeError, match="not there any more"):
        op(bpy.ops.splinewright.unbake)
    for damage in (1, "text", {}, [1.0]):
        ob.data[baking.KEY] = damage
        drawn()
        if bpy.ops.splinewright.unbake.poll():
            with pytest.raises(RuntimeError, match="not there any more"):
                op(bpy.ops.splinewright.unbake)


def test_baked_shapes_cost_nothing_and_say_nothing_at_frame_changes(monkeypatch):
    ob = curve()
    bake_it(ob)
    results = []
    monkeypatch.setattr(part('bridge.follow.recipe_results'), 'result', lambda *_: results.append(1))
    for frame in (3, 5, 8):
        bpy.context.scene.frame_set(frame)
    assert not results


def test_baking_of_many_frames_is_exact_to_the_last():
    ob = follow_object(bending_path())
    ob.data.splinewright.resolution_u = 1
    rise(bpy.data.objects["NurbsPath"])
    bake_it(ob, frame_start=1, frame_end=100)
    for frame in (1, 37, 99, 100):
        bpy.context.scene.frame_set(frame)
        assert np.abs(evaluated(ob)[:, 2] - (frame - 1)).max() < 1e-4


def test_what_the_page_on_farms_says_bakes_a_film(tmp_path):
    """The lines that examples/farm.md gives to blender --python-expr."""
    page = (Path(__file__).resolve().parents[2] / "examples/farm.md").read_text()
    lines = re.search(r'--python-expr "\n(.*?)"\n', page, re.S)[1]
    ob = curve()
    exec(textwrap.dedent(lines).replace("/tmp/film-baked.blend", (tmp_path / "film.blend").as_posix()), {})
    assert baking.is_baked(ob.data) and (tmp_path / "film.blend").exists()
