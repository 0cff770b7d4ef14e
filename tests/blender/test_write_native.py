"""Our values as Blender's own curves and surfaces: the same shape, the fewest new points, nothing else touched."""

import bpy
import numpy as np
import pytest

import blender_objects
from geometry import dense, farthest, mesh_points, signed_volume
from support import part, scene_state, splinecore as sc

native = part('core.native.native')
forms = part('core.native.native_forms')
write_native = part('bridge.native.write_native')
read_native = part('bridge.native.read_native')
Direction, Flags = native.Direction, native.Flags
TOLERANCE = 2e-5
SURFACE_TOLERANCE = 1e-4


def written(value, steps=8):
    """The curve object that a value becomes, and the measured deviation."""
    ob = blender_objects.curve_object()
    return ob, write_native.write_curves(ob.data, write_native.plan(value), steps)


def written_surface(value, steps=(6, 5)):
    data, deviation = write_native.new_surface(bpy.context, "surface", write_native.plan(value), steps)
    ob = bpy.data.objects.new("surface", data)
    bpy.context.collection.objects.link(ob)
    return ob, deviation


def assert_same_shape(ob, curves):
    """Blender draws nothing that is not ours, and leaves out nothing of ours."""
    lines = [dense(curve) for curve in curves]
    drawn = blender_objects.evaluated_vertices(ob)
    size = np.abs(np.concatenate(lines)).max()
    assert all(min(farthest([point], line) for line in lines) < TOLERANCE * size for point in drawn)
    for spline in ob.data.splines:
        spline.resolution_u = 200
    ob.data.update_tag()
    drawn = blender_objects.evaluated_vertices(ob)
    assert all(np.linalg.norm(drawn - point, axis=1).min() < 0.05 * size for line in lines for point in line[::50])


def points(*shape, seed=1):
    return np.random.default_rng(seed).uniform(-1, 1, (*shape, 3))


def weights(*shape, seed=2):
    return np.random.default_rng(seed).uniform(0.5, 2, shape)


@pytest.mark.parametrize('flags', native.ALL_FLAGS, ids=str)
@pytest.mark.parametrize('degree', range(1, 6))
def test_knots_that_blender_has_keep_every_point(degree, flags):
    for count in (degree + 1, 2 * degree + 2, 3 * degree, 3 * degree + 1):
        direction = Direction(count, degree, flags)
        if count <= degree or not native.is_valid_curve(direction) or native.used_count(direction) != count:
            continue
        knots = native.periodic_knots(direction) if flags.cyclic else native.plain_knots(direction)
        curve = sc.NurbsCurve(degree, knots * 0.3 - 7, points(count), weights(count), periodic=flags.cyclic)
        ob, deviation = written(curve)
        spline, = ob.data.splines
        assert len(spline.points) == count and spline.order_u == degree + 1 and spline.use_cyclic_u == flags.cyclic
        assert deviation < TOLERANCE
        again = read_native.read(ob).value
        assert np.array_equal(again.points, curve.points.astype(np.float32))
        assert len(again.knots) == len(curve.knots) and np.allclose((again.knots - again.domain[0]) / np.ptp(again.domain),
                           (curve.knots - curve.domain[0]) / np.ptp(curve.domain), atol=1e-12)
        assert write_native.plan(curve).notes == []
        assert_same_shape(ob, [curve])


CURVES = {
    'other knots': sc.NurbsCurve(3, [0, 0, 0, 0, 0.3, 0.4, 1, 1, 1, 1], points(6), weights(6)),
    'unclamped': sc.NurbsCurve(2, [0, 0.5, 2, 3, 3.1, 4, 7, 9], points(5), weights(5)),
    'one span, unclamped': sc.NurbsCurve(3, [0, 0.5, 0.6, 2, 3, 3.1, 4, 7], points(4)),
    'double knot': sc.NurbsCurve(4, [0] * 5 + [1, 1, 2] + [5] * 5, points(8), weights(8)),
    'negative weights throughout': sc.NurbsCurve(2, [0, 0, 0, 1, 1, 1], points(3), [-1, -2, -1]),
    'other periodic knots': sc.NurbsCurve(3, [0, 1, 1.5, 4, 5, 6], points(5), weights(5), periodic=True),
    'periodic, few points': sc.NurbsCurve(3, [0, 1, 2, 3], points(3), periodic=True),
    'periodic, one span': sc.NurbsCurve(2, [0, 0, 2], points(2), weights(2), periodic=True),
    'double periodic knot': sc.NurbsCurve(2, [0, 1, 1, 2, 3], points(4), weights(4), periodic=True),
    'a point at infinity': sc.BezierCurve([(1, 0), (0, 1), (-1, 0)], [1, 0, 1]),
    'negative weight': sc.BezierCurve([(1, 0), (0.5, 1), (-1, 0)], [1, -0.5, 1]),
    'nearly through infinity': sc.BezierCurve([(1, 0), (0.5, 1), (-1, 0)], [1, -0.95, 1]),
    'full circle': sc.NurbsCurve(5, [0] * 6 + [1] * 6, [(0, -1, 0), (4, -1, 0), (2, 3, 0), (-2, 3, 0), (-4, -1, 0), (0, -1, 0)],
                                 [5, 1, 1, 1, 1, 5]),
    'spread weights': sc.NurbsCurve(2, [0, 0, 0, 0.2, 1, 1, 1], points(4), [1e-3, 1, 1e3, 1]),
    'degree 1, other knots': sc.NurbsCurve(1, [0, 0, 1, 5, 5], points(3)),
    'Bezier of degree 1': sc.BezierCurve(points(2)),
    'Bezier of degree 63': sc.BezierCurve(np.linspace((0, 0, 0), (1, 2, 3), 64) + 0.1 * points(64)),
}


@pytest.mark.parametrize('curve', CURVES.values(), ids=CURVES)
def test_other_curves_are_the_same_shape(curve):
    ob, deviation = written(curve)
    spline, = ob.data.splines
    assert spline.type == 'NURBS' and not spline.valid_message(0)
    assert all(point.weight > 0 for point in spline.points)
    assert spline.use_cyclic_u == getattr(curve, 'periodic', False)
    assert deviation < TOLERANCE
    assert_same_shape(ob, [curve])


@pytest.mark.parametrize('flags', [flags for flags in native.ALL_FLAGS if flags.cyclic], ids=str)
def test_a_closed_curve_of_one_step_is_no_polygon_of_its_points(flags):
    """Which it would be at Blender's resolution 1, from 4.2 to 4.5."""
    direction = Direction(6, 3, flags)
    curve = sc.NurbsCurve(3, native.periodic_knots(direction), points(6), weights(6), periodic=True)
    ob, _ = written(curve, steps=1)
    assert_same_shape(ob, [curve])


def test_what_blender_holds_otherwise_is_told():
    plain, other = CURVES['Bezier of degree 1'], CURVES['other knots']
    assert write_native.plan([plain, plain]).notes == []
    note, = write_native.plan([plain, other, other]).notes
    assert note.startswith("2 pieces have knots or weights that Blender cannot hold")


@pytest.mark.parametrize('closed', (False, True))
def test_a_hermite_chain_is_a_bezier_spline_with_its_handles(closed):
    places, tangents = points(5), points(5, 2, seed=3)
    if closed:
        places[-1], tangents[-1] = places[0], tangents[0]
    chain = sc.HermiteCurve(places, tangents, [0, 2, 3, 3.5, 7])
    ob, deviation = written(chain)
    spline, = ob.data.splines
    assert spline.type == 'BEZIER' and spline.use_cyclic_u is closed and len(spline.bezier_points) == 5 - closed
    assert deviation < TOLERANCE
    assert spline.bezier_points[1].handle_left_type == 'FREE'
    assert np.allclose(spline.bezier_points[1].handle_right, places[1] + tangents[1, 1] / 3, atol=1e-6)
    assert np.allclose(spline.bezier_points[1].handle_left, places[1] - tangents[1, 0] * 2 / 3, atol=1e-6)
    outer = spline.bezier_points[0].handle_left, spline.bezier_points[-1].handle_right
    if not closed:
        assert np.allclose(outer, (places[0] - tangents[0, 0] * 2 / 3, places[-1] + tangents[-1, 1] * 3.5 / 3), atol=1e-6)
    assert_same_shape(ob, [chain])


def test_chains_that_blender_made_come_back_as_they_were():
    bpy.ops.curve.primitive_bezier_circle_add()
    source = bpy.context.object
    value = read_native.read(source).value
    ob, deviation = written(value)
    for a, b in zip(source.data.splines[0].bezier_points, ob.data.splines[0].bezier_points):
        for name in ('co', 'handle_left', 'handle_right'):
            assert np.allclose(getattr(a, name), getattr(b, name), atol=1e-7)
    assert read_native.read(ob).value == value
    assert {point.handle_left_type for point in ob.data.splines[0].bezier_points} == {'ALIGNED'}, "smooth joints stay so"


def test_a_cubic_bezier_curve_is_a_bezier_spline_and_a_rational_one_is_not():
    curve = sc.BezierCurve(points(4), [2, 2, 2, 2])
    ob, deviation = written(curve)
    assert ob.data.splines[0].type == 'BEZIER' and deviation < TOLERANCE
    assert_same_shape(ob, [curve])
    ob, _ = written(curve.with_weights([1, 2, 1, 1]))
    assert ob.data.splines[0].type == 'NURBS'


def test_a_curve_that_its_knots_break_is_several_splines():
    curve = sc.NurbsCurve(2, [0, 0, 0, 1, 1, 1, 2, 2, 2], points(6))
    ob, deviation = written(curve)
    assert len(ob.data.splines) == 2 and deviation < TOLERANCE
    starts = [spline.points[0].co.xyz for spline in ob.data.splines]
    assert np.allclose(starts, curve.points[[0, 3]], atol=1e-7)


def test_a_closed_curve_that_its_knots_break_is_open():
    curve = sc.NurbsCurve(2, [0, 1, 1, 1, 2, 3], points(5), periodic=True)
    ob, deviation = written(curve)
    assert len(ob.data.splines) == 2 and not any(spline.use_cyclic_u for spline in ob.data.splines)
    assert deviation < TOLERANCE


def test_a_patch_that_its_knots_break_is_several_splines():
    patch = sc.NurbsPatch((1, 2), ([0, 0, 1, 1], [0, 0, 0, 1, 1, 1, 2, 2, 2]), points(2, 6))
    ob, deviation = written_surface(patch)
    assert [(s.point_count_v, s.point_count_u) for s in ob.data.splines] == [(2, 3), (2, 3)]
    assert deviation < SURFACE_TOLERANCE
    assert np.allclose([s.points[0].co.xyz for s in ob.data.splines], patch.points[0, [0, 3]], atol=1e-7)


def test_a_closed_patch_that_its_knots_break_is_open():
    patch = sc.NurbsPatch((2, 1), ([0, 1, 1, 1, 2, 3], [0, 0, 1, 1]), points(5, 2), periodic=(True, False))
    ob, deviation = written_surface(patch)
    assert len(ob.data.splines) == 2 and not any(s.use_cyclic_u or s.use_cyclic_v for s in ob.data.splines)
    assert deviation < SURFACE_TOLERANCE


def test_several_curves_are_splines_of_one_object_in_their_order():
    curves = [CURVES['other knots'], sc.BezierCurve(points(4)), CURVES['double periodic knot'], CURVES['Bezier of degree 1']]
    ob, deviation = written(curves)
    assert [spline.type for spline in ob.data.splines] == ['NURBS', 'BEZIER', 'NURBS', 'NURBS']
    assert deviation < TOLERANCE
    assert_same_shape(ob, curves)


REFUSED = {
    'pole inside': (sc.BezierCurve([(1, 0), (0, 1), (-1, 0)], [1, -2, 1]), "passes through infinity"),
    'pole at a joint': (sc.BezierCurve([(1, 0), (0, 1), (-1, 0)], [1, -1, 1]), "passes through infinity"),
    'end at infinity': (sc.BezierCurve([(1, 0), (0, 1), (-1, 0)], [0, 1, 1]), "passes through infinity"),
    'too close': (sc.BezierCurve([(1, 0), (0.5, 1), (-1, 0)], [1.1, -0.9999999999, 1 / 1.1]), "infinity"),
    'degree': (sc.BezierCurve(np.random.default_rng(1).uniform(size=(65, 3))), "degree is 64"),
    'far': (sc.BezierCurve([(0, 0), (1e39, 0)]), "farther away"),
    'weights': (sc.BezierCurve([(0, 0), (1, 1)], [1, 1e-60]), "closer to infinity"),
    'patch': (sc.BezierPatch(np.random.default_rng(1).uniform(size=(2, 2, 3)), [[1, 1], [1, -1]]), "passes through infinity"),
    'second of two': ([sc.BezierCurve([(0, 0), (1, 1)]), sc.BezierCurve([(0, 0), (1, 1)], [1, -1])], "piece 2: it passes"),
}


@pytest.mark.parametrize('value, said', REFUSED.values(), ids=REFUSED)
def test_what_blender_cannot_hold_is_refused_with_a_sentence(value, said):
    before = scene_state()
    with pytest.raises(ValueError, match=said):
        write_native.plan(value)
    assert scene_state() == before


def patch(degrees, counts, knots, periodic=(False, False), seed=1):
    return sc.NurbsPatch(degrees, knots, points(*counts, seed=seed), weights(*counts), periodic=periodic)


def uniform(count, degree):
    return np.arange(count + degree + 1.0)


PATCHES = {
    'uniform': patch((3, 2), (5, 4), (uniform(5, 3), uniform(4, 2))),
    'clamped and other': patch((2, 3), (4, 6), ([0, 0, 0, 1, 2, 2, 2], [0, 0, 0, 0, 0.3, 0.4, 1, 1, 1, 1])),
    'other both': patch((2, 1), (4, 3), ([0, 0.2, 0.3, 1, 2, 5, 6], [0, 0, 1, 5, 5])),
    'tube': patch((3, 1), (6, 2), (uniform(6, 0), [0, 0, 1, 1]), (True, False)),
    'torus': patch((2, 3), (5, 6), (uniform(5, 0), uniform(6, 0)), (True, True)),
    'other torus': patch((2, 3), (3, 4), ([0, 1, 3, 4], [0, 0.5, 1, 4, 5]), (True, True)),
    'tube of few points': patch((1, 3), (2, 3), ([0, 0, 1, 1], [0, 1, 2, 3]), (False, True)),
    'bilinear': sc.BezierPatch(points(2, 2)),
    'Bezier 1 x 2': sc.BezierPatch(points(2, 3), weights(2, 3)),
    'Bezier 4 x 1': sc.BezierPatch(points(5, 2)),
    'Hermite': sc.HermitePatch(points(3, 4), points(3, 4, seed=5), points(3, 4, seed=6), points(3, 4, seed=7)),
    'points at infinity': sc.BezierPatch(points(2, 3), [[1, 0, 1], [1, 0, 1]]),
    'negative weight': sc.BezierPatch(points(3, 3), [[1, 1, 1], [1, -0.5, 1], [1, 1, 1]]),
}


def shown_by(value, steps=30):
    """Vertices and faces of our own mesh."""
    mesh = bpy.data.meshes.new("ours")
    mesh.splinewright.set_resolution(steps, steps)
    mesh.splinewright.value = value
    return mesh


@pytest.mark.parametrize('value', PATCHES.values(), ids=PATCHES)
def test_a_patch_is_the_same_surface_and_looks_the_same_way(value):
    ob, deviation = written_surface(value, (20, 20))
    assert ob.type == 'SURFACE' and deviation < SURFACE_TOLERANCE
    spline, = ob.data.splines
    assert not spline.valid_message(0) and not spline.valid_message(1)
    ours = shown_by(value)
    drawn = ob.evaluated_get(bpy.context.evaluated_depsgraph_get()).to_mesh()
    cloud, drawn_points = mesh_points(ours), mesh_points(drawn)
    assert max(np.linalg.norm(cloud - point, axis=1).min() for point in drawn_points[::10]) < 0.15
    assert max(np.linalg.norm(drawn_points - point, axis=1).min() for point in cloud[::20]) < 0.1
    theirs, wanted = (np.array([signed_volume(mesh, apex) for apex in 3 * np.eye(3)]) for mesh in (drawn, ours))
    assert np.abs(theirs - wanted).max() < 0.1 * np.abs(wanted).max()


def test_a_direction_that_blender_has_keeps_its_points_beside_one_that_it_has_not():
    ob, _ = written_surface(PATCHES['clamped and other'])
    spline, = ob.data.splines
    assert (spline.point_count_u, spline.point_count_v) == (3 * 3 + 1, 4), "Blender's u is our v"


def test_many_patches_are_one_surface_in_their_order():
    patches = [sc.BezierPatch(points(*counts, seed=i)) for i, counts in enumerate(
        ((4, 4), (4, 4), (4, 4), (2, 2), (2, 2), (2, 3), (3, 2), (4, 4), (5, 2)))]
    ob, deviation = written_surface(sc.PatchSet.from_patches(patches, merge=False))
    assert deviation < SURFACE_TOLERANCE
    assert [(s.point_count_v, s.point_count_u) for s in ob.data.splines] == [p.points.shape[:2] for p in patches]
    again = read_native.read(ob).value
    for i, source in enumerate(patches):
        assert np.allclose(again[i].evaluate(*np.array(again[i].domain).mean(1)), source.evaluate(0.5, 0.5), atol=1e-6)


def test_the_teapot_is_32_splines():
    value = part('core.shape.starters').teapot()
    ob, deviation = written_surface(value, (4, 4))
    assert len(ob.data.splines) == 32 and deviation < 1e-5
    assert np.array_equal(read_native.read(ob).pieces[7].points, value[7].points.astype(np.float32))


def test_writing_a_surface_leaves_selection_active_object_and_scene_alone():
    first = blender_objects.curve_object()
    second = blender_objects.curve_object()
    hidden = blender_objects.curve_object()
    hidden.hide_set(True)
    first.select_set(True)
    bpy.context.view_layer.objects.active = second
    before = scene_state()
    data, _ = write_native.new_surface(bpy.context, "surface", write_native.plan(PATCHES['torus']), (4, 4))
    assert bpy.context.view_layer.objects.active == second and bpy.context.selected_objects == [first]
    assert hidden.hide_get() and bpy.context.mode == 'OBJECT'
    bpy.data.curves.remove(data)
    assert scene_state() == before


def test_a_surface_is_not_written_in_edit_mode_and_nothing_is_left_behind():
    bpy.ops.mesh.primitive_cube_add()
    bpy.ops.object.mode_set(mode='EDIT')
    before = scene_state()
    with pytest.raises(ValueError, match="leave the present mode"):
        write_native.new_surface(bpy.context, "surface", write_native.plan(PATCHES['torus']), (4, 4))
    assert bpy.context.mode == 'EDIT_MESH'
    bpy.ops.object.mode_set(mode='OBJECT')
    assert scene_state() == before


def test_a_surface_is_written_where_an_object_alone_is_in_local_view():
    window = bpy.context.window
    area = next(area for area in window.screen.areas if area.type == 'VIEW_3D')
    region = next(region for region in area.regions if region.type == 'WINDOW')
    bpy.ops.mesh.primitive_cube_add()
    with bpy.context.temp_override(window=window, area=area, region=region):
        bpy.ops.view3d.localview()
        assert area.spaces.active.local_view
        _, deviation = written_surface(PATCHES['Bezier 1 x 2'])
    assert deviation < SURFACE_TOLERANCE
