"""Where on a shape one points, as parameters; the operator itself is tried in a window."""

from types import SimpleNamespace

import bpy
import numpy as np
import pytest

import patches
from curves import value_of
from shapes import activate, add, enter, op
from support import part, splinecore as sc

aiming, insert_here, mesh_layers, picking, surveys = (part(name) for name in (
    'core.verbs.parameter_picking', 'ui.operators.insert_here', 'bridge.mesh.mesh_layers', 'ui.picking', 'bridge.analysis.surveys'))
REGION = SimpleNamespace(width=200, height=100)
VIEW = SimpleNamespace(perspective_matrix=np.diag([1.0, 2.0, 1.0, 1.0]))
CURVES = ('nurbs', 'semicircle', 'periodic', 'closed hermite', 'cubic', 'hyperbola')
PATCHES = ('plain nurbs', 'rational nurbs', 'uniform', 'both periodic', 'bicubic', 'sphere', 'torus')


def curves_of(kind):
    return surveys.pieces_of(add(value_of(kind)).data)


@pytest.mark.parametrize('kind', CURVES)
def test_samples_lie_on_the_curve_from_end_to_end_with_every_knot(kind):
    for curve in curves_of(kind):
        at, points = aiming.samples(curve)
        assert (at[0], at[-1]) == tuple(curve.domain) and (np.diff(at) > 0).all()
        assert np.array_equal(points, curve.evaluate(at, at_infinity='nan'), equal_nan=True)
        inner = part('core.shape.parameters').inner_knots(curve)
        assert np.abs(at[:, None] - inner).min(axis=0, initial=np.inf).max(initial=0) <= 1e-12 * np.abs(curve.domain).max()


@pytest.mark.parametrize('kind', CURVES)
def test_a_parameter_in_the_middle_of_a_span_is_found_from_anywhere_in_it(kind):
    for curve in curves_of(kind):
        start, end = curve.domain
        for first, last in part('core.shape.parameters').spans_of(curve):
            for part_of_span in (0.01, 0.4, 0.99):
                at = start + (end - start) * (first + part_of_span * (last - first))
                middle, = aiming.in_middle(curve, (at,))
                assert middle == pytest.approx(start + (end - start) * (first + last) / 2, rel=1e-12)


@pytest.mark.parametrize('kind', PATCHES)
def test_the_line_of_a_knot_is_the_isocurve_there(kind):
    for patch in surveys.pieces_of(add(patches.value_of(kind)).data):
        (u0, u1), (v0, v1) = patch.domain
        u, v = u0 + 0.3 * (u1 - u0), v0 + 0.8 * (v1 - v0)
        along_v, along_u = aiming.lines(patch, (u, v), 'BOTH')
        assert np.allclose(along_v[[0, -1]], patch.evaluate([u, u], [v0, v1]), rtol=0, atol=1e-12)
        assert np.allclose(along_u[[0, -1]], patch.evaluate([u0, u1], [v, v]), rtol=0, atol=1e-12)
        assert np.array_equal(aiming.lines(patch, (u, v), 'U')[0], along_v) and len(aiming.lines(patch, (u, v), 'U')) == 1
        assert np.array_equal(aiming.lines(patch, (u, v), 'V')[0], along_u)
        assert aiming.of_domain(patch, (0.3, 0.8)) == pytest.approx((u, v))


@pytest.mark.parametrize('kind', PATCHES)
def test_the_parameters_at_a_point_of_a_face_are_those_of_the_surface(kind):
    ob = add(patches.value_of(kind))
    ob.data.splinewright.set_resolution(12, 12)
    pieces = surveys.pieces_of(ob.data)
    size = np.ptp([vertex.co for vertex in ob.data.vertices], axis=0).max()
    for face in list(ob.data.polygons)[::7]:
        number = part('bridge.mesh.mesh_looks').patch_of_face(ob.data, face.index)
        fractions = mesh_layers.parameters_at(ob.data, face.index, face.center)
        u, v = aiming.of_domain(pieces[number - 1], fractions)
        assert np.linalg.norm(pieces[number - 1].evaluate(u, v) - np.array(face.center)) < 0.06 * size


def test_a_mesh_without_parameters_has_none():
    bpy.ops.mesh.primitive_cube_add()
    data = bpy.context.object.data
    assert mesh_layers.parameters_at(data, 0, data.polygons[0].center) is None
    ob = add(patches.value_of('bicubic'))
    assert mesh_layers.parameters_at(ob.data, 10 ** 6, (0, 0, 0)) is None


def test_the_nearest_curve_gives_its_parameter_and_none_that_is_far():
    ob = add([sc.BezierCurve([(-1, y, 0), (1, y, 0)]) for y in (-0.25, 0.0, 0.25)])
    for pixel, number, expected in (((50, 26), 1, 0.25), ((120, 52), 2, 0.6), ((199, 74), 3, 0.995), ((-3, 76), 3, 0.0)):
        found = picking.parameters_at(REGION, VIEW, pixel, [ob], None)
        assert found[:2] == (ob, number) and found[2] == pytest.approx((expected,), abs=1e-9)
    far = SimpleNamespace(width=2000, height=1000)
    assert picking.parameters_at(far, VIEW, (1000, 900), [ob], None) is None
    assert picking.parameters_at(REGION, VIEW, (50, 26), [], None) is None


def test_a_curve_that_runs_to_infinity_is_found_where_it_is_seen():
    ob = add(sc.BezierCurve([(1, 0), (1, 1), (0, 1)], [1, -1, 1]))          # it runs off at u = 0.5
    found = picking.parameters_at(REGION, VIEW, (199, 51), [ob], None)
    assert found[0] == ob and 0 <= found[2][0] < 0.5


def test_shapes_and_nets_can_be_pointed_at_and_what_comes_of_numbers_cannot():
    operator = bpy.ops.splinewright.insert_here
    assert not operator.poll()
    op(bpy.ops.splinewright.add_circle)
    assert not operator.poll()
    with pytest.raises(RuntimeError, match="Apply Construction"):
        operator()
    add(value_of('nurbs'), "curve")
    assert operator.poll()
    enter()
    assert operator.poll()
    bpy.ops.splinewright.leave_net('EXEC_DEFAULT', True)
    bpy.ops.mesh.primitive_cube_add()
    activate(bpy.context.object)
    bpy.ops.object.mode_set(mode='EDIT')
    assert not operator.poll()          # Ctrl+R cuts loops there


def test_the_status_bar_names_what_will_be_inserted():
    aim = part('ui.aim_overlay').Aim
    words = "Knot at {numbers}", "Click: insert"
    assert "Point at the shape" in insert_here._status(None, *words)
    assert "Knot at u = 0.25 " in insert_here._status(aim("a", 1, (0.25,), 'U'), *words)
    assert "Knot at v = 2 " in insert_here._status(aim("a", 1, (0.25, 2.0), 'V'), *words)
    assert "Knot at u = 0.25, v = 2 " in insert_here._status(aim("a", 1, (0.25, 2.0), 'BOTH'), *words)
