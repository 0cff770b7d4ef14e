"""A surface of revolution turns about the axis of another object, or an edge, and follows that."""

import bpy
import numpy as np
import pytest
from mathutils import Matrix

from shapes import activate, add, require_exact
from support import part, splinecore as sc
from test_files import reopen, save
from test_surfaces import add_recipe

axis_overlay, follow, placing, recipes, shape = (part(name) for name in (
    'ui.axis_overlay', 'bridge.follow.follow', 'bridge.recipes.placing', 'bridge.recipes.recipes', 'bridge.shape.shape'))
PROFILE = sc.NurbsCurve(2, [0, 0, 0, 1, 1, 1], [(1, 0, 0), (2, 0, 1), (1, 0, 2)], [1, 0.5, 1])
PLACES = (Matrix.Translation((3, 0.5, -1)), Matrix.Rotation(0.6, 4, 'X') @ Matrix.Translation((0, 4, 0)),
          Matrix.Translation((9, 8, 7)) @ Matrix.Rotation(2, 4, (1, 2, 3)) @ Matrix.Scale(2.5, 4))


def empty(name="axis", matrix=Matrix()):
    ob = bpy.data.objects.new(name, None)
    bpy.context.scene.collection.objects.link(ob)
    ob.matrix_world = matrix
    bpy.context.view_layer.update()
    return ob


def revolved(beside=None, place=Matrix(), **settings):
    source = add(PROFILE)
    source.matrix_world = place
    bpy.context.view_layer.update()
    activate(source)
    if beside is not None:
        beside.select_set(True)
    return add_recipe('revolve', **settings)


def require_about(ob, axis, along=2, tolerance=2e-6):
    """That every section of a surface lies as its profile does, as seen along the z of an axis object."""
    bpy.context.view_layer.update()
    value = ob.data.splinewright.value
    there = value.evaluate_grid(*(np.linspace(*domain, 9) for domain in value.domain))
    assert follow.problem(ob.data) == ""
    into = np.array(axis.matrix_world.inverted() @ ob.matrix_world)
    seen = there @ into[:3, :3].T + into[:3, 3]
    radii = np.linalg.norm(np.delete(seen, along, axis=-1), axis=-1)
    size = np.abs(seen).max()
    same = np.ptp(radii, axis=0).max(), np.ptp(radii, axis=1).max()
    heights = np.ptp(seen[..., along], axis=0).max(), np.ptp(seen[..., along], axis=1).max()
    around = int(np.argmin(same))
    assert same[around] <= tolerance * size and heights[around] <= tolerance * size
    require_exact(ob)


@pytest.mark.parametrize('place', PLACES)
def test_an_object_selected_beside_the_profile_is_the_axis_and_the_surface_follows_it(place):
    axis = empty(matrix=place)
    ob = revolved(axis)
    assert recipes.read(ob.data).frames == (axis,) and ob.data.splinewright_parameters.frame == axis
    require_about(ob, axis)
    for other in PLACES:
        axis.matrix_world = other
        require_about(ob, axis)


def test_the_profile_and_the_surface_may_stand_anywhere():
    axis = empty(matrix=PLACES[1])
    ob = revolved(axis, place=PLACES[2])
    require_about(ob, axis)
    placing.stop(ob.data)
    ob.matrix_world = PLACES[0]
    require_about(ob, axis)
    bpy.data.objects["shape"].location.x += 1
    require_about(ob, axis)


@pytest.mark.parametrize('axis, along', (('x', 0), ('y', 1), ('z', 2)))
def test_any_axis_of_the_object_counts_and_the_offset_is_along_its_own(axis, along):
    frame = empty(matrix=PLACES[1])
    ob = revolved(frame, axis=axis)
    require_about(ob, frame, along)
    ob.data.splinewright_parameters.revolve_offset_x = 0.25
    ob.data.splinewright_parameters.revolve_offset_y = -0.5
    beside = empty("beside", PLACES[1] @ Matrix.Translation((0.25, -0.5, 0)))
    require_about(ob, beside, along)


def test_a_scaled_axis_object_has_the_same_axis():
    frame = empty(matrix=PLACES[1] @ Matrix.Diagonal((1, 3, 0.2, 1)))
    require_about(revolved(frame), empty("unscaled", PLACES[1]))


def test_the_panel_gives_and_takes_the_axis_object():
    ob = revolved()
    own = ob.data.splinewright.value
    axis = empty(matrix=PLACES[0])
    ob.data.splinewright_parameters.frame = axis
    require_about(ob, axis)
    ob.data.splinewright_parameters.revolve_sweep = 1.0
    assert recipes.read(ob.data).frames == (axis,)
    require_about(ob, axis)
    ob.data.splinewright_parameters.revolve_sweep = 2 * np.pi
    ob.data.splinewright_parameters.frame = None
    assert recipes.read(ob.data).frames == () and ob.data.splinewright.value == own
    axis.location.x += 1
    bpy.context.view_layer.update()
    assert ob.data.splinewright.value == own


def test_it_follows_an_axis_that_has_keys_and_one_that_is_hidden():
    axis = empty()
    ob = revolved(axis)
    for frame, x in ((1, 0.0), (11, 5.0)):
        axis.location.x = x
        axis.keyframe_insert('location', frame=frame)
    axis.hide_set(True)
    axis.hide_viewport = True
    for frame in (1, 5, 11):
        bpy.context.scene.frame_set(frame)
        require_about(ob, axis)


def test_the_shape_itself_and_its_followers_are_no_axis():
    ob = revolved()
    before = ob.data.splinewright.value
    activate(ob)
    bpy.ops.splinewright.follow_object()
    follower = bpy.context.object
    for wrong in (ob, follower):
        ob.data.splinewright_parameters.frame = wrong
        assert ob.data.splinewright_parameters.frame is None and recipes.read(ob.data).frames == ()
        assert ob.data.splinewright.value == before
    assert "would follow itself" in part('bridge.data.problems').of(ob.data, part('bridge.data.problems').SETTING)


def test_a_flat_axis_object_and_one_that_is_gone_are_said_and_the_shape_stays():
    axis = empty(matrix=PLACES[0])
    ob = revolved(axis)
    before = ob.data.splinewright.value
    axis.scale = (1, 1, 0)
    bpy.context.view_layer.update()
    assert "scale of 0" in follow.problem(ob.data) and ob.data.splinewright.value == before
    bpy.data.objects.remove(axis)
    bpy.context.view_layer.update()
    assert "was deleted" in follow.problem(ob.data) and ob.data.splinewright.value == before
    ob.data.splinewright_parameters.frame = None
    assert follow.problem(ob.data) == "" and ob.data.splinewright.value != before


def test_a_name_that_is_none_is_refused():
    add(PROFILE)
    with pytest.raises(RuntimeError, match="no object named nowhere"):
        add_recipe('revolve', frame="nowhere")
    assert len(bpy.data.objects) == 1


@pytest.mark.parametrize('damage', (5, "text", [1.0, 2.0], {}))
def test_a_damaged_pointer_is_a_sentence(damage):
    ob = revolved(empty())
    ob.data[recipes.KEY]['frame'] = damage
    assert "damaged" in follow.problem(ob.data)
    bpy.data.objects["shape"].location.x += 1
    bpy.context.view_layer.update()
    assert axis_overlay.line_of(ob) is None


def test_files_copies_and_undo_keep_the_axis_object(tmp_path):
    axis = empty(matrix=PLACES[1])
    name = revolved(axis).name
    bpy.ops.ed.undo_push(message="before")
    bpy.data.objects[name].data.splinewright_parameters.frame = None
    bpy.ops.ed.undo_push(message="after")
    bpy.ops.ed.undo()
    require_about(bpy.data.objects[name], bpy.data.objects["axis"])
    save(tmp_path / "axis.blend")
    reopen(tmp_path / "axis.blend")
    ob, axis = bpy.data.objects[name], bpy.data.objects["axis"]
    axis.location.z += 3
    axis.rotation_euler.x += 1
    require_about(ob, axis)
    activate(ob)
    bpy.ops.object.duplicate()
    copy = bpy.context.object
    axis.location.y += 3
    require_about(copy, axis)


def test_the_line_in_the_view_is_the_axis():
    axis = empty(matrix=PLACES[1])
    ob = revolved(axis)
    line = axis_overlay.line_of(ob)
    seen = np.array([axis.matrix_world.inverted() @ part('ui.edge_picking').Vector(end) for end in line])
    assert np.abs(seen[:, :2]).max() < 1e-5 and np.ptp(seen[:, 2]) > 2


def test_an_edge_that_is_picked_is_the_axis_and_takes_it_along():
    ob = revolved()
    bpy.ops.mesh.primitive_cube_add(location=(4, 0, 0))
    cube = bpy.context.object
    activate(ob)
    start, end = (cube.matrix_world @ cube.data.vertices[i].co for i in cube.data.edges[0].vertices)
    bpy.ops.splinewright.axis_from_edge(start=start, end=end, parent=cube.name)
    [axis] = recipes.read(ob.data).frames
    assert axis.parent == cube and recipes.parameters(ob.data)['axis'] == 'z'
    require_about(ob, axis)
    cube.location.y += 2
    cube.rotation_euler.z = 0.5
    bpy.context.view_layer.update()
    there = [cube.matrix_world @ cube.data.vertices[i].co for i in cube.data.edges[0].vertices]
    assert (axis.matrix_world.translation - there[0]).length < 1e-5
    assert ((there[1] - there[0]).normalized() - axis.matrix_world.to_3x3().col[2].normalized()).length < 1e-5
    require_about(ob, axis)


def test_an_edge_without_length_is_refused_and_nothing_is_left():
    ob = revolved()
    before, count = ob.data.splinewright.value, len(bpy.data.objects)
    activate(ob)
    with pytest.raises(RuntimeError, match="no length"):
        bpy.ops.splinewright.axis_from_edge(start=(1, 2, 3), end=(1, 2, 3))
    with pytest.raises(RuntimeError, match="no object named nowhere"):
        bpy.ops.splinewright.axis_from_edge(parent="nowhere")
    assert ob.data.splinewright.value == before and len(bpy.data.objects) == count
    activate(bpy.data.objects["shape"])
    assert not bpy.ops.splinewright.axis_from_edge.poll()
