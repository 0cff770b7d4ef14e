"""Frame changes and renders: followers are right in each, whichever scene, view layer, animation or other add-on."""

import subprocess
from contextlib import contextmanager

import bpy
import numpy as np
import pytest

from animated import animate, coverage, follow_object, height, in_cycles, in_scene, native_path, rendered, rise
from shapes import activate
from support import ADDON, part

follow, placing, recipes, store = (part(name) for name in ('bridge.follow.follow', 'bridge.recipes.placing', 'bridge.recipes.recipes', 'bridge.data.store'))
FRAMES = (1, 4, 7)


def expected(frames=FRAMES):
    """What height() gives of what rises."""
    return {frame: pytest.approx(frame - 1, abs=1e-5) for frame in frames}


def first(seen):
    return {frame: looks[0] for frame, looks in seen.items()}


def rising_follower():
    source = native_path()
    rise(source)
    bpy.context.scene.frame_set(1)
    return source, follow_object(source)


CHILD = """
import addon_utils, bpy, sys
name, frames = sys.argv[sys.argv.index('--') + 1], (3, 9)
assert addon_utils.enable(name) is not None and hasattr(bpy.types.Mesh, 'splinewright')
scene, ob = bpy.context.scene, bpy.data.objects["source Exact"]
def height(depsgraph):
    data = ob.evaluated_get(depsgraph).data
    return sum(point.co[2] for point in data.splines[0].points) / len(data.splines[0].points)
class Engine(bpy.types.RenderEngine):
    bl_idname, bl_label = 'TEST', "Test"
    def render(self, depsgraph):
        print("HEIGHT", depsgraph.scene.frame_current, height(depsgraph))
bpy.utils.register_class(Engine)
scene.render.engine, scene.frame_start, scene.frame_end, scene.frame_step = 'TEST', 3, 9, 6
WORK
"""


@pytest.mark.parametrize('work', (
    "bpy.ops.render.render(animation=True)",
    "for frame in frames:\n    scene.frame_set(frame)\n    print('HEIGHT', frame, height(bpy.context.evaluated_depsgraph_get()))",
    "for frame in frames:\n    scene.frame_current = frame\n    bpy.ops.render.render()"), ids=('render', 'frame_set', 'stills'))
def test_an_addon_that_is_enabled_after_the_file_was_opened_in_background_follows_at_once(work, tmp_path):
    source, ob = rising_follower()
    source.name, ob.name = "source", "source Exact"
    bpy.context.scene.camera = in_scene("camera", bpy.data.cameras.new("camera"))
    bpy.context.scene.render.resolution_x = bpy.context.scene.render.resolution_y = 8
    bpy.context.scene.render.filepath = str(tmp_path / "frame")
    path, script = tmp_path / "moving.blend", tmp_path / "child.py"
    bpy.ops.wm.save_as_mainfile(filepath=str(path))
    script.write_text(CHILD.replace("WORK", work))
    done = subprocess.run([bpy.app.binary_path, '--background', '--factory-startup', str(path), '--python-exit-code', '1',
                           '--python', str(script), '--', ADDON], capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stdout + done.stderr
    seen = [line.split()[1:] for line in done.stdout.splitlines() if line.startswith("HEIGHT")]
    assert {int(frame): float(height) for frame, height in seen} == expected((3, 9)), done.stdout + done.stderr


def by_keys(source):
    rise(source)


def by_a_parent(source):
    source.parent = in_scene("parent", None)
    rise(source.parent)
    return source.parent


def by_a_constraint(source):
    target = in_scene("target", None)
    source.constraints.new('COPY_LOCATION').target = target
    rise(target)
    return target


def by_a_hook(source):
    hook = source.modifiers.new("hook", 'HOOK')
    hook.object = in_scene("handle", None)
    hook.vertex_indices_set(range(5))
    rise(hook.object)
    return hook.object


@pytest.mark.parametrize('move', (by_keys, by_a_parent, by_a_constraint, by_a_hook))
def test_what_is_followed_is_followed_where_it_is_hidden(move):
    source = native_path()
    other = move(source)
    bpy.context.scene.frame_set(1)
    ob = follow_object(source)
    for each in filter(None, (source, other)):
        each.hide_render = True
    assert first(rendered(lambda graph: height(ob, graph), FRAMES)) == expected()
    for each in filter(None, (source, other)):
        each.hide_viewport = True
    bpy.context.scene.frame_set(21)
    assert height(ob) == pytest.approx(20)
    assert first(rendered(lambda graph: height(ob, graph), FRAMES)) == expected()


def test_followers_of_older_files_follow_what_is_hidden_from_when_they_are_opened_on(tmp_path):
    source, ob = rising_follower()
    ob.data.animation_data_clear()
    del ob.data[recipes.KEY]['watched']
    source.name, ob.name, source.hide_render = "source", "source Exact", True
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "older.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "older.blend"))
    ob = bpy.data.objects["source Exact"]
    assert first(rendered(lambda graph: height(ob, graph), FRAMES)) == expected()


def test_what_watches_an_input_goes_with_the_recipe_and_shows_nowhere_else():
    source, ob = rising_follower()
    activate(ob)
    assert ob.data.animation_data.drivers and bpy.ops.splinewright.make_editable() == {'FINISHED'}
    assert ob.data.animation_data is None
    bpy.ops.surface.primitive_nurbs_surface_surface_add()
    patches = follow_object(bpy.context.object)
    patches.data.animation_data.drivers[0].driver       # there is one
    activate(patches)
    assert bpy.ops.splinewright.to_native() == {'FINISHED'}


def test_what_changed_while_the_addon_was_off_is_followed_when_it_is_on_again():
    source, ob = rising_follower()
    source.animation_data_clear()
    part('ui').unregister()
    source.location.z = 5
    bpy.context.view_layer.update()
    part('ui').register()
    other = in_scene("other", None)
    other.location.x = 1
    bpy.context.view_layer.update()
    assert height(ob) == pytest.approx(5)


def chain():
    """A follower of a follower, the shapes of which come before what they follow in the order of their names."""
    source, second = rising_follower()
    second.name, second.data.name = "b", "b"
    third = follow_object(second)
    third.name, third.data.name = "a", "a"
    return source, second, third


def test_followers_of_followers_are_right_in_every_frame_of_views_and_renders():
    source, second, third = chain()
    placing.stop(second.data)
    animate(second, 'location', {1: 0.0, 101: -50.0}, index=2)      # its own space sinks by half, and it stays where it is
    bpy.context.scene.frame_set(1)
    for frame in (5, 2, 9):
        bpy.context.scene.frame_set(frame)
        assert height(third) == pytest.approx(frame - 1, abs=1e-5)
        assert height(second) == pytest.approx(1.5 * (frame - 1), abs=1e-5)
    assert first(rendered(lambda graph: height(third, graph), FRAMES)) == expected()
    assert height(third) == pytest.approx(8, abs=1e-5), "the render put the frame back, and the shape with it"


def test_a_scene_that_no_window_shows_renders_right_and_leaves_the_shapes_of_the_other_alone():
    here = bpy.context.scene
    _, ob = rising_follower()
    here.frame_set(50)
    there = bpy.data.scenes.new("there")
    bpy.context.window.scene = there
    _, other = rising_follower()
    bpy.context.window.scene = here
    seen = rendered(lambda graph: (height(other, graph), height(ob)), FRAMES, there)
    assert {frame: looks[0][0] for frame, looks in seen.items()} == expected()
    assert [looks[0][1] for looks in seen.values()] == [pytest.approx(49)] * 3, "this scene is at another frame"
    there.frame_set(21)
    assert np.allclose(store.read(other.data).pool[:, 2], 20) and height(ob) == pytest.approx(49)


def test_every_view_layer_renders_right():
    _, ob = rising_follower()
    scene = bpy.context.scene
    collection = bpy.data.collections.new("apart")
    scene.collection.children.link(collection)
    collection.objects.link(ob)
    scene.collection.objects.unlink(ob)
    with_it, without = scene.view_layers[0], scene.view_layers.new("without")
    without.layer_collection.children["apart"].exclude = True
    scene.view_layers.new("again")
    seen = rendered(lambda graph: (graph.view_layer.name, height(ob, graph)), FRAMES)
    for frame, looks in seen.items():
        heights = dict(looks)
        assert len(heights) == 3
        assert heights[with_it.name] == heights["again"] == expected()[frame]


def test_a_follower_that_was_left_out_of_the_view_layer_is_right_when_it_comes_back():
    _, ob = rising_follower()
    scene = bpy.context.scene
    collection = bpy.data.collections.new("apart")
    scene.collection.children.link(collection)
    collection.objects.link(ob)
    scene.collection.objects.unlink(ob)
    layer = bpy.context.view_layer.layer_collection.children["apart"]
    layer.exclude = True
    scene.frame_set(31)
    layer.exclude = False
    bpy.context.view_layer.update()
    assert height(ob) == pytest.approx(30)


def test_a_follower_in_a_collection_that_is_only_instanced_moves_in_views_and_renders():
    source, ob = rising_follower()
    scene = bpy.context.scene
    collection = bpy.data.collections.new("asset")
    for each in (source, ob):
        collection.objects.link(each)
        scene.collection.objects.unlink(each)
    instance = in_scene("instance", None)
    instance.instance_type, instance.instance_collection = 'COLLECTION', collection
    bpy.context.view_layer.update()
    scene.frame_set(11)
    assert height(ob) == pytest.approx(10) and follow.problem(ob.data) == ""
    assert first(rendered(lambda graph: height(ob, graph), FRAMES)) == expected()


def test_strips_of_the_nonlinear_animation_are_followed():
    source, ob = rising_follower()
    animation = source.animation_data
    strip = animation.nla_tracks.new().strips.new("rise", 11, animation.action)
    animation.action = None
    assert strip.frame_start == 11
    bpy.context.scene.frame_set(16)
    assert height(ob) == pytest.approx(5)
    assert first(rendered(lambda graph: height(ob, graph), (11, 14))) == {11: pytest.approx(0), 14: pytest.approx(3)}


def test_a_driver_on_what_is_followed_is_followed_when_what_drives_it_moves():
    source = native_path()
    ob = follow_object(source)
    lever = in_scene("lever", None)
    driver = source.driver_add('location', 2).driver
    variable = driver.variables.new()
    variable.targets[0].id, variable.targets[0].data_path = lever, 'location.x'
    driver.expression = f"{variable.name} * 2"
    lever.location.x = 3
    bpy.context.view_layer.update()
    assert height(ob) == pytest.approx(6)
    animate(lever, 'location', {1: 0.0, 101: 50.0}, index=0)
    assert first(rendered(lambda graph: height(ob, graph), FRAMES)) == expected()


@contextmanager
def handler_of_another_addon(name, function, is_first):
    chain = getattr(bpy.app.handlers, name)
    chain.insert(0, function) if is_first else chain.append(function)
    try:
        yield
    finally:
        chain.remove(function)


@pytest.mark.parametrize('is_first', (True, False), ids=('before', 'after'))
@pytest.mark.parametrize('name', ('frame_change_pre', 'frame_change_post'))
def test_what_another_addon_moves_when_the_frame_changes_is_followed_whoever_came_first(name, is_first):
    source = native_path()
    ob = follow_object(source)

    def move(scene, *_):
        source.location.z = scene.frame_current - 1

    with handler_of_another_addon(name, move, is_first):
        for frame in (5, 3):
            bpy.context.scene.frame_set(frame)
            assert height(ob) == pytest.approx(frame - 1)
        assert first(rendered(lambda graph: height(ob, graph), FRAMES)) == expected()


def test_a_render_that_goes_on_from_the_frame_before_is_right_beside_other_addons(tmp_path):
    """Cycles with persistent data looks at what Blender says that has changed."""
    bpy.ops.surface.primitive_nurbs_surface_surface_add(radius=8)
    source = bpy.context.object
    follow_object(source)
    source.hide_render = True
    bpy.ops.mesh.primitive_plane_add(size=1)
    animate(bpy.context.object, 'location', {2: 0.0, 3: 40.0}, index=0)
    in_cycles(bpy.context.scene)
    bpy.context.scene.render.use_persistent_data = True
    animate(source, 'location', {1: 0.0, 2: 40.0, 3: 40.0, 4: 0.0}, index=0)
    with handler_of_another_addon('frame_change_post', lambda *_: None, True):
        assert np.allclose(coverage(tmp_path, (1, 2, 3, 4)), (1, 0.25, 0, 1), atol=0.05)
