"""Followers and inputs that are not in the same scene or view layer: what is shown is right wherever one looks."""

import bpy
import numpy as np
import pytest

from animated import curves_of
from support import part, splinecore as sc, vertices

api = part('api')


def curve(name="Profile", collection=None):
    return api.new_shape(name, sc.NurbsCurve(1, [0, 0, 1, 1], [(1, 0, 0), (2, 0, 1)]), collection)


def home(name, scene=None):
    found = bpy.data.collections.new(name)
    (scene or bpy.context.scene).collection.children.link(found)
    return found


def move_points(ob, by):
    value = api.value(ob)
    api.set_value(ob, value.with_points(value.points + by))
    bpy.context.view_layer.update()


def go(scene=None, layer=None):
    """Look at another scene or view layer, as a user does."""
    window = bpy.context.window
    if scene:
        window.scene = scene
    if layer:
        window.view_layer = layer
    bpy.context.view_layer.update()


def end_of(made):
    """The largest x of what an extruded profile shows."""
    return float(vertices(made.data)[:, 0].max())


def is_right(made, x):
    value = api.value(made)
    return np.isclose(value.points[..., 0].max(), x) and np.isclose(end_of(made), x) and not api.problem(made)


@pytest.fixture
def other():
    return bpy.data.scenes.new("Other")


def only_in(ob, collection):
    for each in ob.users_collection:
        each.objects.unlink(ob)
    collection.objects.link(ob)
    bpy.context.view_layer.update()


def test_a_follower_in_another_scene_follows_an_input_of_this_one(other):
    profile = curve()
    made = api.extrude(profile)
    only_in(made, other.collection)
    move_points(profile, (1, 0, 0))
    go(other)
    assert is_right(made, 3.0)


def test_an_input_in_another_scene_is_followed_from_this_one(other):
    profile = curve()
    made = api.extrude(profile)
    only_in(profile, other.collection)
    move_points(profile, (1, 0, 0))
    assert is_right(made, 3.0)
    go(other)
    move_points(profile, (1, 0, 0))
    go(bpy.data.scenes["Scene"])
    assert is_right(made, 4.0)


def test_an_input_moved_in_another_scene_is_followed(other):
    profile = curve()
    made = api.extrude(profile)
    only_in(profile, other.collection)
    profile.location.x = 2.0
    bpy.context.view_layer.update()
    assert is_right(made, 4.0)
    go(other)
    profile.location.x = 5.0
    bpy.context.view_layer.update()
    go(bpy.data.scenes["Scene"])
    assert is_right(made, 7.0)


def test_an_input_whose_parent_moves_in_another_scene_is_followed(other):
    profile, parent = curve(), bpy.data.objects.new("Parent", None)
    other.collection.objects.link(parent)
    profile.parent = parent
    made = api.extrude(profile)
    only_in(profile, other.collection)
    go(other)
    parent.location.x = 5.0
    bpy.context.view_layer.update()
    go(bpy.data.scenes["Scene"])
    assert is_right(made, 7.0)


def test_both_in_another_scene_changed_by_a_script_from_this_one(other):
    profile = curve()
    made = api.extrude(profile)
    only_in(profile, other.collection)
    only_in(made, other.collection)
    move_points(profile, (1, 0, 0))
    profile.location.x = 1.0
    bpy.context.view_layer.update()
    go(other)
    assert is_right(made, 4.0)


@pytest.mark.parametrize('excluded', ("profile", "made", "both"))
@pytest.mark.parametrize('by', ("points", "place"))
def test_view_layers_that_leave_some_of_them_out(excluded, by):
    scene, (a, b) = bpy.context.scene, (home("A"), home("B"))
    profile = curve(collection=a)
    made = api.make('extrude', profile, collection=b)
    layer = scene.view_layers.new("Second")
    first = scene.view_layers[0]
    for collection, names in ((a, ("profile", "both")), (b, ("made", "both"))):
        layer.layer_collection.children[collection.name].exclude = excluded in names
    go(layer=layer)
    if by == "points":
        move_points(profile, (1, 0, 0))
    else:
        profile.location.x = 1.0
        bpy.context.view_layer.update()
    if excluded == "profile":
        assert is_right(made, 3.0)
    go(layer=first)
    assert is_right(made, 3.0)


def test_a_chain_over_three_scenes(other):
    third = bpy.data.scenes.new("Third")
    profile = curve()
    middle = api.extrude(profile)
    last = api.offset(middle, 0.5)
    only_in(middle, other.collection)
    only_in(last, third.collection)
    before = api.value(last).points
    move_points(profile, (1, 0, 0))
    go(third)
    assert np.allclose(api.value(last).points, before + (1, 0, 0), atol=1e-6) and not api.problem(last)
    go(other)
    assert is_right(middle, 3.0)


def test_scenes_at_other_frames_show_what_their_frame_says(other):
    profile = curve()
    for frame, x in ((1, 0.0), (11, 10.0)):
        profile.location.x = x
        profile.keyframe_insert('location', frame=frame)
    curves_of(profile.animation_data.action)[0].keyframe_points[0].interpolation = 'LINEAR'
    made = api.extrude(profile)
    for ob in (profile, made):
        other.collection.objects.link(ob)
    bpy.context.scene.frame_set(1)
    other.frame_set(11)
    go(other)
    assert is_right(made, 12.0)
    go(bpy.data.scenes["Scene"])
    assert is_right(made, 2.0)


def left_out():
    """An input that this view layer leaves out, and a shape that is made from it and shown."""
    profile = curve(collection=home("A"))
    made = api.extrude(profile)
    bpy.context.view_layer.layer_collection.children["A"].exclude = True
    bpy.context.view_layer.update()
    return profile, made


def test_a_driver_that_was_taken_away_comes_back():
    """As clearing the animation of a mesh takes it."""
    profile, made = left_out()
    made.data.animation_data_clear()
    move_points(profile, (1, 0, 0))
    profile.location.x = 1.0
    assert api.update() == {} and is_right(made, 4.0)


def test_a_render_of_another_scene_shows_its_frame(other, tmp_path):
    profile = curve()
    for frame, x in ((1, 0.0), (11, 10.0)):
        profile.location.x = x
        profile.keyframe_insert('location', frame=frame)
    bpy.context.scene.frame_set(1)
    made = api.extrude(profile)
    for ob in (profile, made):
        other.collection.objects.link(ob)
    other.camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    other.collection.objects.link(other.camera)
    render, other.cycles.samples, other.cycles.use_denoising = other.render, 1, False
    render.engine, render.resolution_x, render.resolution_y, render.filepath = 'CYCLES', 8, 8, str(tmp_path / "f")
    other.frame_start = other.frame_end = 11
    seen = []
    def look(*_):
        seen.append(end_of(made))
    bpy.app.handlers.render_post.append(look)
    try:
        bpy.ops.render.render(scene="Other", animation=True)
    finally:
        bpy.app.handlers.render_post.remove(look)
    assert np.allclose(seen, [12.0])
    bpy.context.view_layer.update()
    assert api.update() == {} and is_right(made, 2.0)
