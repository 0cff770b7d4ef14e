"""Blender's own curves and surfaces come in as what Blender draws."""

import bpy
import numpy as np
import pytest

import blender_objects
from geometry import farthest, signed_volume
from support import part, splinecore as sc

native = part('core.native.native')
read_native = part('bridge.native.read_native')
measure = part('bridge.native.measure_native')
Direction, Flags = native.Direction, native.Flags
SAMPLING = part('bridge.data.versions').sampling
#: Blender's rounding, relative to the size: see test_against_blender.py.
CURVE_TOLERANCE = 2e-5
SURFACE_TOLERANCE = 1e-4


@pytest.fixture
def curve():
    return blender_objects.curve_object()


def random_net(rng, *shape):
    net = rng.uniform(-1, 1, (*shape, 4))
    net[..., 3] = rng.uniform(0.5, 2, shape)
    return net.astype(np.float32).astype(float)


def directions(degree, flags):
    counts = sorted({2, degree, degree + 1, degree + 2, 2 * degree, 2 * degree + 2, 3 * degree + 1})
    return [Direction(count, degree, flags) for count in counts if count > degree]


def depsgraph():
    bpy.context.view_layer.update()
    return bpy.context.evaluated_depsgraph_get()


@pytest.mark.parametrize('flags', native.ALL_FLAGS, ids=str)
@pytest.mark.parametrize('degree', range(1, 7))
def test_a_nurbs_spline_is_what_blender_draws(curve, degree, flags):
    rng = np.random.default_rng((degree, *flags))
    for direction in directions(degree, flags):
        net = random_net(rng, direction.count)
        blender_objects.set_nurbs_spline(curve, net, direction, 5)
        reading = read_native.read(curve)
        is_valid = native.is_valid_curve(direction)
        parameters = (native.curve_parameters(direction, 5, SAMPLING) if is_valid
                      else np.arange(float(direction.count)))
        ours, blenders = reading.value.evaluate(parameters), blender_objects.evaluated_vertices(curve)
        assert ours.shape == blenders.shape and np.abs(ours - blenders).max() < CURVE_TOLERANCE
        assert reading.value.degree == (degree if is_valid else 1)
        assert reading.value.periodic == flags.cyclic
        ignored = direction.count - native.used_count(direction) if is_valid else 0
        assert bool(ignored) == bool(reading.dropped)
        assert len(reading.value.points) == direction.count - ignored
        assert measure.of_reading(curve, reading) == pytest.approx(
            np.linalg.norm(ours - blenders, axis=1).max(), rel=0.01)
        assert read_native.read(curve, depsgraph()).value == reading.value


def test_what_blender_ignores_is_told(curve):
    blender_objects.set_nurbs_spline(curve, random_net(np.random.default_rng(1), 6),
                                     Direction(6, 3, Flags(endpoint=True, bezier=True)), 3)
    assert read_native.read(curve).dropped == ["2 points at the end of spline 1, which Blender ignores"]


@pytest.mark.parametrize('flags_v', native.ALL_FLAGS, ids=str)
@pytest.mark.parametrize('flags_u', native.ALL_FLAGS, ids=str)
def test_a_surface_is_what_blender_draws_and_looks_the_same_way(flags_u, flags_v):
    rng = np.random.default_rng((*flags_u, *flags_v))
    for degrees in ((1, 2), (3, 2), (2, 5)):
        pair = [next(d for d in directions(degree, flags) if d.count > degree and native.is_valid_surface(d))
                for degree, flags in zip(degrees, (flags_u, flags_v))]
        net = random_net(rng, *(d.count for d in pair))
        ob = blender_objects.surface_object(*net.shape[:2])
        blender_objects.set_surface(ob, net, pair, (3, 2))
        reading = read_native.read(ob)
        u, v = (native.surface_parameters(d, steps) for d, steps in zip(pair, (3, 2)))
        ours = reading.value.evaluate_grid(v, u).swapaxes(0, 1).reshape(-1, 3)
        blenders = blender_objects.evaluated_vertices(ob)
        assert ours.shape == blenders.shape and np.abs(ours - blenders).max() < SURFACE_TOLERANCE
        assert reading.value.periodic == (flags_v.cyclic, flags_u.cyclic)
        assert measure.of_reading(ob, reading) == pytest.approx(np.linalg.norm(ours - blenders, axis=1).max(), rel=0.01)
        blender_objects.remove(ob)


def test_normals_point_the_way_blenders_faces_do():
    for add in (bpy.ops.surface.primitive_nurbs_surface_sphere_add, bpy.ops.surface.primitive_nurbs_surface_torus_add,
                bpy.ops.surface.primitive_nurbs_surface_cylinder_add, bpy.ops.surface.primitive_nurbs_surface_surface_add):
        add()
        ob = bpy.context.object
        faces = ob.evaluated_get(depsgraph()).to_mesh()
        mesh = bpy.data.meshes.new("ours")
        mesh.splinewright.value = read_native.read(ob).value
        assert signed_volume(mesh) == pytest.approx(signed_volume(faces), rel=0.05)
        assert signed_volume(faces) != 0


@pytest.mark.parametrize('handle', ('FREE', 'ALIGNED', 'AUTO', 'VECTOR'))
@pytest.mark.parametrize('cyclic', (False, True), ids=('open', 'cyclic'))
def test_a_bezier_spline_is_a_hermite_chain_of_its_handles(curve, cyclic, handle):
    rng = np.random.default_rng(2)
    for count in (2, 3, 6):
        points = rng.uniform(-1, 1, (count, 3, 3)).astype(np.float32).astype(float)
        made = blender_objects.set_bezier_spline(curve, points, [(handle, handle)] * count, cyclic=cyclic, resolution=7)
        reading = read_native.read(curve)
        chain = reading.value
        assert isinstance(chain, sc.HermiteCurve) and len(chain.points) == count + cyclic
        assert np.array_equal(chain.points[:count], made[:, 1])
        assert np.array_equal(chain.tangents[:count, 0], 3 * (made[:, 1] - made[:, 0]))
        assert np.array_equal(chain.tangents[:count, 1], 3 * (made[:, 2] - made[:, 1]))
        if cyclic:
            assert np.array_equal(chain.points[-1], chain.points[0])
            assert np.array_equal(chain.tangents[-1], chain.tangents[0])
        blenders = blender_objects.evaluated_vertices(curve)
        line = chain.evaluate(np.linspace(0, len(chain.points) - 1, 7 * (len(chain.points) - 1) + 1))
        assert farthest(blenders, line) < CURVE_TOLERANCE
        assert measure.of_reading(curve, reading) < CURVE_TOLERANCE


@pytest.mark.parametrize('cyclic', (False, True))
def test_a_polygon_is_a_curve_of_degree_1_whatever_its_weights_say(curve, cyclic):
    points = random_net(np.random.default_rng(3), 5)
    spline = blender_objects.unset_nurbs_spline(curve, points)
    spline.type, spline.use_cyclic_u = 'POLY', cyclic
    value = read_native.read(curve).value
    assert value.degree == 1 and value.periodic is cyclic and not value.is_rational
    assert np.array_equal(value.evaluate(np.arange(5.0)), points[:, :3])
    assert measure.of_reading(curve, read_native.read(curve)) == 0


def test_several_splines_become_a_list_and_what_shows_nothing_is_told(curve):
    data = curve.data
    for name in "abc":
        data.materials.append(bpy.data.materials.new(name))
    for kind, count, material in (('POLY', 3, 2), ('NURBS', 1, 0), ('BEZIER', 1, 0), ('BEZIER', 2, 1), ('NURBS', 4, 0)):
        spline = data.splines.new(kind)
        points = spline.bezier_points if kind == 'BEZIER' else spline.points
        points.add(count - 1)
        for i, point in enumerate(points):
            point.co = (i, i * i, 0) if kind == 'BEZIER' else (i, i * i, 0, 1)
        spline.material_index = material
    data.splines[4].points[2].co.x = float('nan')
    reading = read_native.read(curve)
    assert [type(piece) for piece in reading.value] == [sc.NurbsCurve, sc.HermiteCurve]
    assert reading.indices == (0, 3) and reading.materials == (2, 1)
    assert reading.dropped == ["spline 2, which is a single point", "spline 3, which is a single point",
                               "spline 5, which has a point that is not finite"]
    assert measure.of_reading(curve, reading) < 1e-6


def test_several_surfaces_become_a_patch_set_and_rows_and_invalid_ones_are_told():
    bpy.ops.surface.primitive_nurbs_surface_torus_add()
    bpy.ops.object.mode_set(mode='EDIT')
    bpy.ops.surface.primitive_nurbs_surface_surface_add()
    bpy.ops.surface.primitive_nurbs_surface_sphere_add()
    bpy.ops.object.mode_set(mode='OBJECT')
    ob = bpy.context.object
    row = ob.data.splines.new('NURBS')
    row.points.add(5)
    count = len(ob.data.splines)
    surface = next(s for s in ob.data.splines if (s.point_count_u, s.point_count_v) == (4, 4))
    surface.use_cyclic_u = surface.use_bezier_u = True      # 4 points do not make closed cubics
    reading = read_native.read(ob)
    assert count == 4 and len(reading.value) == 2 and isinstance(reading.value, sc.PatchSet)
    assert len(reading.dropped) == 2
    assert any("row of points" in words for words in reading.dropped)
    assert any("draws nothing" in words for words in reading.dropped)
    assert measure.of_reading(ob, reading) < 1e-5


def test_an_empty_object_has_no_value(curve):
    assert read_native.read(curve) == (None, (), (), (), [])
    assert measure.of_reading(curve, read_native.read(curve)) is None
    with pytest.raises(ValueError, match="not a curve or surface"):
        read_native.read(bpy.data.objects.new("empty", None))


@pytest.mark.parametrize('weights', ([1, 0, 1, 1, 2], [1, 1, 0, 0, 1], [1, -0.2, 1, 1, 1]))
def test_weights_of_0_and_below_are_what_blender_makes_of_them(curve, weights):
    net = random_net(np.random.default_rng(4), 5)
    net[:, 3] = np.array(weights, np.float32)
    blender_objects.set_nurbs_spline(curve, net, Direction(5, 3, Flags(endpoint=True)), 9)
    reading = read_native.read(curve)
    assert measure.of_reading(curve, reading) < CURVE_TOLERANCE
    assert bool(reading.dropped) == (0 in weights)


@pytest.mark.parametrize('weights', ([0, 0, 0, 0, 0], [0, 1, 1, 1, 1]))
def test_weights_that_leave_nothing_somewhere_are_told(curve, weights):
    net = random_net(np.random.default_rng(5), 5)
    net[:, 3] = weights
    blender_objects.set_nurbs_spline(curve, net, Direction(5, 3, Flags(endpoint=True)), 9)
    reading = read_native.read(curve)
    assert reading.value is None
    assert reading.dropped == ["spline 1, whose weights of 0 leave a part without points"]


def blenders_parameters(spline, theirs):
    if spline.kind == 'BEZIER':
        straight = part('bridge.native.native_splines').straight_segments(theirs)
        return [native.bezier_samples(straight, theirs.use_cyclic_u, theirs.resolution_u)]
    if len(spline.directions) == 1:
        return [native.curve_samples(spline, theirs.resolution_u, SAMPLING)]
    return [native.surface_parameters(d, steps) for d, steps in
            zip(spline.directions, (theirs.resolution_u, theirs.resolution_v))]


def points_at(value, at):
    """Ours at Blender's parameters, in Blender's order."""
    if len(at) == 1:
        return value.evaluate(*at)
    return value.evaluate_grid(at[1], at[0]).swapaxes(0, 1).reshape(-1, 3)


def add_keys(ob):
    """Basis, one key at 0.25 and one relative to that at 0.5."""
    rng = np.random.default_rng(6)
    for name in ("Basis", "A", "B"):
        ob.shape_key_add(name=name, from_mix=False)
    for block in ob.data.shape_keys.key_blocks[1:]:
        for point in block.data:
            move = rng.uniform(-1, 1, 3)
            for field in ('co', 'handle_left', 'handle_right'):
                if hasattr(point, field):
                    setattr(point, field, getattr(point, field) + type(point.co)(move))
    keys = ob.data.shape_keys.key_blocks
    keys["B"].relative_key = keys["A"]
    keys["A"].value, keys["B"].value = 0.25, 0.5
    return keys


def keyed_objects():
    bpy.ops.curve.primitive_bezier_circle_add()
    yield bpy.context.object
    bpy.ops.curve.primitive_nurbs_path_add()
    yield bpy.context.object
    bpy.ops.surface.primitive_nurbs_surface_sphere_add()
    yield bpy.context.object


def test_shape_keys_are_mixed_as_blender_mixes_them():
    for ob in keyed_objects():
        keys = add_keys(ob)
        plain = read_native.read(ob).pieces[0].dumps()
        for change in (lambda: None, lambda: setattr(keys["A"], 'mute', True), lambda: setattr(keys["B"], 'value', 0.0),
                       lambda: setattr(ob, 'active_shape_key_index', 2), lambda: setattr(ob, 'show_only_shape_key', True),
                       lambda: setattr(keys["B"], 'mute', True)):
            change()
            ob.data.update_tag()
            graph = depsgraph()
            drawn = blender_objects.evaluated_vertices(ob)
            for reading in (read_native.read(ob), read_native.read(ob, graph)):
                at = blenders_parameters(reading.splines[0], ob.data.splines[0])
                assert np.abs(points_at(reading.value, at) - drawn).max() < 1e-5
                assert measure.of_reading(ob, reading) < 1e-5
        assert read_native.read(ob).pieces[0].dumps() != plain


def test_a_mix_of_kinds_keeps_its_shape_keys_apart(curve):
    for kind in ('BEZIER', 'POLY', 'NURBS'):
        spline = curve.data.splines.new(kind)
        points = spline.bezier_points if kind == 'BEZIER' else spline.points
        points.add(4)
        for i, point in enumerate(points):
            point.co = (i, i % 2, 0) if kind == 'BEZIER' else (i, i % 2, 0, 1)
    add_keys(curve)
    assert measure.of_reading(curve, read_native.read(curve)) < 1e-5


def test_animated_shape_keys_of_a_surface_are_read_as_evaluated():
    bpy.ops.surface.primitive_nurbs_surface_sphere_add()
    ob = bpy.context.object
    keys = add_keys(ob)
    driver = keys["A"].driver_add('value').driver
    driver.expression = "0.75"
    graph = depsgraph()
    evaluated = ob.evaluated_get(graph).to_mesh()
    expected = np.array([v.co for v in evaluated.vertices])
    reading = read_native.read(ob, graph)
    at = blenders_parameters(reading.splines[0], ob.data.splines[0])
    assert np.abs(points_at(reading.value, at) - expected).max() < 1e-5


def test_absolute_shape_keys_are_read_from_curves_and_refused_on_surfaces():
    for ob in keyed_objects():
        add_keys(ob)
        before = read_native.read(ob).pieces[0]
        keys = ob.data.shape_keys
        keys.use_relative = False
        keys.eval_time = 5
        if ob.type == 'SURFACE':
            for graph in (None, depsgraph()):
                with pytest.raises(ValueError, match="absolute shape keys"):
                    read_native.read(ob, graph)
        else:
            reading = read_native.read(ob)
            assert measure.of_reading(ob, reading) < 1e-5 and reading.value != before


def hooked(ob):
    empty = bpy.data.objects.new("hook", None)
    bpy.context.collection.objects.link(empty)
    hook = ob.modifiers.new("Hook", 'HOOK')
    hook.object = empty
    hook.vertex_indices_set([0, 1, 2])
    empty.location.z = 2
    return hook


def test_hooks_on_curves_are_followed_with_a_depsgraph_only():
    bpy.ops.curve.primitive_nurbs_path_add()
    ob = bpy.context.object
    hooked(ob)
    subdivided = ob.modifiers.new("Wave", 'WAVE')
    still, moved = read_native.read(ob).value, read_native.read(ob, depsgraph()).value
    assert np.allclose(moved.points - still.points, np.outer([1, 1, 1, 0, 0], (0, 0, 2)), atol=1e-6)
    assert read_native.not_followed(ob) == ["the modifier Wave"]
    subdivided.use_apply_on_spline = True
    assert read_native.not_followed(ob) == []


def test_what_is_not_followed_is_named():
    bpy.ops.surface.primitive_nurbs_surface_sphere_add()
    ob = bpy.context.object
    hooked(ob)
    assert read_native.not_followed(ob) == ["the modifier Hook"]
    bpy.ops.curve.primitive_bezier_circle_add()
    ob = bpy.context.object
    assert read_native.not_followed(ob) == []
    ob.data.bevel_depth, ob.data.extrude, ob.data.offset = 0.1, 0.2, 0.3
    ob.data.splines[0].bezier_points[1].tilt = 1
    ob.data.splines[0].bezier_points[1].radius = 2
    ob.modifiers.new("Array", 'ARRAY')
    hooked(ob)
    if ob.modifiers[0].type == 'HOOK':          # Blender 5 puts it first
        ob.modifiers.move(0, 1)
    assert read_native.not_followed(ob) == ["the bevel", "the extrusion", "the offset", "the tilt", "the radius",
                                            "the modifier Array", "the modifier Hook"]
    assert read_native.read(ob, depsgraph()).value == read_native.read(ob).value, "an Array comes before the hook"


@pytest.mark.parametrize('with_keys', (False, True))
def test_in_edit_mode_it_is_what_is_being_edited(with_keys):
    for ob in keyed_objects():
        bpy.context.view_layer.objects.active = ob
        if with_keys:
            add_keys(ob)
            ob.active_shape_key_index = 1
        bpy.ops.object.mode_set(mode='EDIT')
        spline = ob.data.splines[0]
        for point in spline.bezier_points or spline.points:
            point.co.z += 3
            if spline.bezier_points:
                point.handle_left.z += 3
                point.handle_right.z += 3
        ob.data.update_tag()
        graph = depsgraph()
        drawn = blender_objects.evaluated_vertices(ob)
        for reading in (read_native.read(ob), read_native.read(ob, graph)):
            at = blenders_parameters(reading.splines[0], ob.data.splines[0])
            ours = points_at(reading.value, at)
            assert ours.shape == drawn.shape and np.abs(ours - drawn).max() < 1e-5
        bpy.ops.object.mode_set(mode='OBJECT')


def test_reading_and_measuring_leave_nothing_behind():
    bpy.ops.surface.primitive_nurbs_surface_sphere_add()
    ob = bpy.context.object
    add_keys(ob)
    before = [len(getattr(bpy.data, kind)) for kind in ('objects', 'curves', 'meshes', 'shape_keys')]
    measure.of_reading(ob, read_native.read(ob, depsgraph()))
    assert [len(getattr(bpy.data, kind)) for kind in ('objects', 'curves', 'meshes', 'shape_keys')] == before
