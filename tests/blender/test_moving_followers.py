"""Shapes that are made from others are moved, copied and scaled like any other object."""

import bpy
import numpy as np
import pytest
from mathutils import Matrix, kdtree

from shapes import activate, require_exact
from support import part, splinecore as sc, vertices

follow, placing, recipes, shape, store = (part(name) for name in (
    'bridge.follow.follow', 'bridge.recipes.placing', 'bridge.recipes.recipes', 'bridge.shape.shape', 'bridge.data.store'))


def ring(height, radius=1.0, name="ring"):
    angles = np.linspace(0.0, 2.0 * np.pi, 8, endpoint=False)
    points = np.c_[radius * np.cos(angles), radius * np.sin(angles), 0.0 * angles]
    curve = sc.NurbsCurve(3, np.arange(9.0), points, periodic=True)
    return placed(curve, (0.3, -0.2, height), name)


def placed(value, location, name="curve"):
    ob = bpy.data.objects.new(name, shape.new_data(name, value, (12, 12)))
    bpy.context.scene.collection.objects.link(ob)
    ob.location = location
    bpy.context.view_layer.update()
    return ob


def made(operator, *inputs, **settings):
    for ob in bpy.context.selected_objects:
        ob.select_set(False)
    for ob in reversed(inputs):
        ob.select_set(True)
        bpy.context.view_layer.objects.active = ob
    assert getattr(bpy.ops.splinewright, operator)('EXEC_DEFAULT', True, **settings) == {'FINISHED'}
    return bpy.context.object


def loft():
    rings = [ring(height, radius) for height, radius in ((0.0, 1.0), (1.0, 0.6), (2.5, 1.3))]
    ob = made('add_loft', *rings)
    ob.data.splinewright.mode = 'COUNT'
    return ob, rings


def seen(ob):
    """What a user sees of a shape: its vertices in the world."""
    bpy.context.view_layer.update()
    return vertices(ob.data) @ np.array(ob.matrix_world)[:3, :3].T + np.array(ob.matrix_world)[:3, 3]


def require_near(a, b, tolerance=2e-6):
    assert a.shape == b.shape and np.abs(a - b).max() <= tolerance * max(1.0, np.abs(b).max())


def under(points, matrix):
    matrix = np.array(matrix)
    return points @ matrix[:3, :3].T + matrix[:3, 3]


def move(step, *objects):
    for ob in objects:
        ob.matrix_world = step @ ob.matrix_world
    bpy.context.view_layer.update()


STEPS = (Matrix.Translation((2.0, -1.0, 0.5)), Matrix.Rotation(0.7, 4, (1.0, 2.0, -1.0)), Matrix.Scale(2.5, 4),
         Matrix.Scale(-1.0, 4, (1.0, 0.0, 0.0)), Matrix.Scale(3.0, 4, (0.0, 0.0, 1.0)),
         Matrix.Translation((1e4, 0.0, 0.0)) @ Matrix.Rotation(2.0, 4, 'X'))


@pytest.mark.parametrize('step', STEPS)
def test_what_is_moved_alone_moves_and_keeps_every_digit(step):
    ob, rings = loft()
    before, definition = seen(ob), store.read(ob.data).pool.copy()
    move(step, ob)
    require_near(seen(ob), under(before, step))
    assert np.array_equal(store.read(ob.data).pool, definition)
    require_exact(ob)


@pytest.mark.parametrize('step', (*STEPS[:3], STEPS[5]))
def test_what_is_moved_with_all_its_inputs_moves_once(step):
    ob, rings = loft()
    before, definition = seen(ob), store.read(ob.data).pool.copy()
    for _ in range(3):
        move(step, ob, *rings)
        before = under(before, step)
        require_near(seen(ob), before, 1e-5)
        assert np.allclose(store.read(ob.data).pool, definition, rtol=0.0, atol=1e-12)
    assert not placing.is_away(ob.data, ob)


def test_what_is_mirrored_with_all_its_inputs_is_mirrored():
    ob, rings = loft()
    box = under(seen(ob), STEPS[3]).min(axis=0), under(seen(ob), STEPS[3]).max(axis=0)
    move(STEPS[3], ob, *rings)
    assert np.allclose((seen(ob).min(axis=0), seen(ob).max(axis=0)), box, atol=0.02)


def test_inputs_are_followed_where_the_shape_was_moved_to():
    ob, rings = loft()
    step = STEPS[1]
    other, others = loft()
    move(step, ob)
    for one in (rings[1], others[1]):
        one.scale *= 1.7
        one.location.x += 0.4
    bpy.context.view_layer.update()
    require_near(seen(ob), under(seen(other), step), 1e-5)
    assert placing.is_away(ob.data, ob)


def test_all_moved_after_the_shape_alone_keeps_what_lies_between_them():
    ob, rings = loft()
    move(STEPS[0], ob)
    before = seen(ob)
    move(STEPS[1], ob, *rings)
    require_near(seen(ob), under(before, STEPS[1]), 1e-5)


def test_a_common_parent_moves_it_once():
    ob, rings = loft()
    parent = bpy.data.objects.new("parent", None)
    bpy.context.scene.collection.objects.link(parent)
    for one in (ob, *rings):
        one.parent = parent
    before = seen(ob)
    parent.location, parent.rotation_euler, parent.scale = (1, 2, 3), (0.3, 0.2, 0.1), (2, 2, 2)
    bpy.context.view_layer.update()
    require_near(seen(ob), under(before, parent.matrix_world), 1e-5)


def test_inputs_that_are_children_of_their_result_move_with_it_and_are_followed():
    ob, rings = loft()
    for one in rings:
        one.parent, one.matrix_parent_inverse = ob, ob.matrix_world.inverted()
    before = seen(ob)
    move(STEPS[1], ob)
    require_near(seen(ob), under(before, STEPS[1]), 1e-5)
    rings[2].location.z += 1.0
    assert np.abs(seen(ob) - under(before, STEPS[1])).max() > 0.5


def test_a_revolved_vase_moves_whole_and_its_profile_moves_its_wall():
    points = np.array([(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.7, 0.0, 1.0), (1.2, 0.0, 2.0)])
    profile = placed(sc.NurbsCurve(3, [0, 0, 0, 0, 1, 1, 1, 1], points), (0.0, 0.0, 0.0))
    ob = made('add_revolve', profile)
    before = seen(ob)
    move(STEPS[0], ob)
    require_near(seen(ob), under(before, STEPS[0]))
    profile.location.x += 0.5
    bpy.context.view_layer.update()
    size = np.ptp(seen(ob)[:, 0])
    assert abs(size - np.ptp(before[:, 0]) - 1.0) < 1e-4


def test_a_copy_is_moved_apart_and_goes_on_following():
    ob, rings = loft()
    activate(ob)
    bpy.ops.object.duplicate('EXEC_DEFAULT', True)
    copy = bpy.context.object
    assert copy != ob and copy.data != ob.data
    move(STEPS[0], copy)
    require_near(seen(copy), under(seen(ob), STEPS[0]))
    rings[1].scale *= 2.0
    bpy.context.view_layer.update()
    require_near(seen(copy), under(seen(ob), STEPS[0]), 1e-5)


def test_a_copy_with_its_inputs_follows_the_copied_ones():
    ob, rings = loft()
    for one in (ob, *rings):
        one.select_set(True)
    bpy.ops.object.duplicate('EXEC_DEFAULT', True)
    copy = next(one for one in bpy.context.selected_objects if one.type == 'MESH')
    inputs = recipes.read_inputs(copy.data)
    assert not set(inputs) & set(rings)
    before = seen(ob)
    move(STEPS[0], copy, *inputs)
    require_near(seen(copy), under(before, STEPS[0]), 1e-5)
    inputs[1].scale *= 2.0
    bpy.context.view_layer.update()
    require_near(seen(ob), before)
    assert np.abs(seen(copy) - under(before, STEPS[0])).max() > 0.1


def test_linked_copies_are_one_shape_in_several_places():
    ob, rings = loft()
    activate(ob)
    bpy.ops.object.duplicate('EXEC_DEFAULT', True, linked=True)
    copy = bpy.context.object
    assert copy.data == ob.data
    before = seen(ob)
    move(STEPS[1], copy)
    require_near(seen(ob), before)
    require_near(seen(copy), under(before, STEPS[1]))


def test_a_result_has_no_scale_of_its_own():
    rings = [ring(height) for height in (0.0, 1.0, 2.0)]
    for one in rings:
        one.scale = (17.0, 17.0, 17.0)
    bpy.context.view_layer.update()
    ob = made('add_loft', *rings)
    assert np.allclose(ob.scale, 1.0)
    assert np.allclose(np.ptp(vertices(ob.data), axis=0), np.ptp(seen(ob), axis=0), rtol=1e-5)
    assert np.ptp(seen(ob)[:, 0]) > 20.0
    extruded = made('add_extrude', rings[0])
    assert np.allclose(extruded.scale, 1.0) and np.ptp(seen(extruded)[:, 0]) > 20.0


def test_it_may_stay_on_its_inputs_and_move_freely_again():
    ob, rings = loft()
    before = seen(ob)
    activate(ob)
    assert bpy.ops.splinewright.set_moving('EXEC_DEFAULT', True, how='WITH_INPUTS') == {'FINISHED'}
    move(STEPS[1], ob)
    require_near(seen(ob), before, 1e-5)
    assert bpy.ops.splinewright.set_moving('EXEC_DEFAULT', True, how='FREELY') == {'FINISHED'}
    require_near(seen(ob), before, 1e-5)
    move(STEPS[0], ob)
    require_near(seen(ob), under(before, STEPS[0]), 1e-5)
    assert bpy.ops.splinewright.set_moving('EXEC_DEFAULT', True, how='WITH_INPUTS') == {'FINISHED'}
    require_near(seen(ob), before, 1e-5)


def test_a_shape_of_an_older_file_stays_on_its_inputs():
    ob, rings = loft()
    before = seen(ob)
    placing.stop(ob.data)
    move(STEPS[0], ob)
    require_near(seen(ob), before, 1e-5)


def test_what_was_moved_goes_on_after_saving_and_opening(tmp_path):
    ob, rings = loft()
    name, ring_name = ob.name, rings[1].name
    move(STEPS[0], ob)
    before = seen(ob)
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "moved.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "moved.blend"))
    ob = bpy.data.objects[name]
    require_near(seen(ob), before)
    bpy.data.objects[ring_name].location.z += 0.2
    bpy.context.view_layer.update()
    assert 0.01 < np.abs(seen(ob) - before).max() < 0.5
    move(STEPS[1], ob, *recipes.read_inputs(ob.data))
    assert follow.problem(ob.data) == ""


def test_a_measured_shape_keeps_its_distances_where_all_is_scaled():
    plane = placed(sc.BezierPatch([[(0, 0, 0), (2, 0, 0)], [(0, 2, 0), (2, 2, 0)]]), (1.0, 0.0, 0.0))
    ob = made('add_offset_surface', plane, distance=0.25)
    assert abs(np.abs(seen(ob)[:, 2]).max() - 0.25) < 1e-6
    move(Matrix.Scale(3.0, 4), plane)
    assert abs(np.abs(seen(ob)[:, 2]).max() - 0.25) < 1e-6


def test_undo_of_a_move_and_redo():
    ob, rings = loft()
    name = ob.name
    before = seen(ob)
    bpy.ops.ed.undo_push(message="before")
    bpy.data.objects[name].location.x += 2.0
    bpy.context.view_layer.update()
    bpy.ops.ed.undo_push(message="moved")
    bpy.ops.ed.undo()
    require_near(seen(bpy.data.objects[name]), before)
    bpy.ops.ed.redo()
    require_near(seen(bpy.data.objects[name]), before + (2.0, 0.0, 0.0))


def test_a_damaged_place_is_said():
    ob, rings = loft()
    ob.data[recipes.KEY]['place'] = [1.0, 2.0]
    rings[0].location.z -= 1.0
    bpy.context.view_layer.update()
    assert "damaged" in follow.problem(ob.data)


@pytest.mark.parametrize('is_free', (True, False))
def test_apply_leaves_what_is_seen_and_it_goes_on_following(is_free):
    ob, rings = loft()
    if not is_free:
        placing.stop(ob.data)
    move(Matrix.Translation((1.0, 2.0, 3.0)) @ Matrix.Rotation(0.5, 4, 'X') @ Matrix.Scale(2.0, 4), ob)
    before = seen(ob)
    activate(ob)
    bpy.ops.object.transform_apply(location=True, rotation=True, scale=True)
    assert np.allclose(ob.matrix_world, np.eye(4), atol=1e-6)
    require_near(seen(ob), before, 1e-5)
    assert follow.problem(ob.data) == "" and not shape.is_touched(ob.data)
    rings[1].scale *= 1.5
    changed = seen(ob)
    assert 0.1 < np.abs(changed - before).max()
    move(STEPS[0], ob)
    require_near(seen(ob), under(changed, STEPS[0]) if is_free else changed, 1e-5)
    require_exact(ob)


PROFILE = sc.BezierCurve(np.array([(0.3, 0, 0), (1.2, 0, 0), (0.4, 0, 1.2), (0.9, 0, 2)], float))
BOWL = sc.BezierPatch([[(x, y, 1.0 - 0.2 * x * x + 0.1 * y) for y in (0.0, 1.0, 2.0)] for x in (0.0, 0.7, 1.4, 2.0)])
#: Where axes, planes, directions and lengths count beside the inputs.
WITH_NUMBERS = {**dict.fromkeys(('revolve', 'extrude', 'pipe', 'about', 'offset'), PROFILE),
                **dict.fromkeys(('mirror', 'planes', 'thickened', 'extended_surface'), BOWL)}


def nearest_distance(a, b):
    def reach(points, others):
        tree = kdtree.KDTree(len(others))
        for i, other in enumerate(others):
            tree.insert(other, i)
        tree.balance()
        return max(tree.find(point)[2] for point in points)
    return max(reach(a, b), reach(b, a))


def seen_points(ob):
    bpy.context.view_layer.update()
    points = vertices(ob.data) if ob.type == 'MESH' else shape.points_of(ob.data)
    return under(points, ob.matrix_world)


@pytest.mark.parametrize('step', (STEPS[0] @ STEPS[1] @ STEPS[2], STEPS[3], STEPS[4]))
@pytest.mark.parametrize('kind', WITH_NUMBERS)
def test_apply_keeps_what_axes_planes_and_lengths_mean(kind, step):
    source = placed(WITH_NUMBERS[kind], (2.0, 1.0, 0.0))
    ob = made(f'add_{kind}', source)
    source.hide_set(False)
    other = made(f'add_{kind}', source)
    for each in (ob, other):
        each.data.splinewright.mode = 'COUNT'
    for _ in range(2):
        move(step, ob)
        move(step, other)
        activate(ob)
        bpy.ops.object.transform_apply(location=True, rotation=True, scale=True)
        assert np.allclose(ob.matrix_world, np.eye(4), atol=1e-6)
        assert follow.problem(ob.data) == "" and not shape.is_touched(ob.data)
        assert nearest_distance(seen_points(ob), seen_points(other)) < 1e-4
    require_exact(ob)
    before = seen_points(ob)
    source.scale = 1.2, 1.2, 1.5
    source.location.x += 0.2
    assert nearest_distance(seen_points(ob), before) > 0.01
    assert nearest_distance(seen_points(ob), seen_points(other)) < 1e-4


def test_what_was_only_applied_is_not_away_from_its_inputs():
    source = placed(PROFILE, (2.0, 1.0, 0.0))
    ob = made('add_revolve', source)
    axis = part('ui.axis_overlay')
    line = axis.line_of(ob)
    activate(ob)
    bpy.ops.object.transform_apply(location=True, rotation=True, scale=True)
    bpy.context.view_layer.update()
    assert not placing.is_away(ob.data, ob) and np.allclose(axis.line_of(ob), line, atol=1e-5)
    move(STEPS[1], ob)
    assert placing.is_away(ob.data, ob) and np.allclose(axis.line_of(ob), under(line, STEPS[1]), atol=0.1)
