"""Pieces that come of one curve and become one again, and images of curves in perspective."""

import bpy
import numpy as np
import pytest

from curves import curves_of, run, value_of
from shapes import activate, add, require_exact
from support import part, splinecore as sc

KINDS = ('cubic', 'rational cubic', 'quintic', 'semicircle', 'hermite', 'nurbs', 'periodic')


@pytest.mark.parametrize('tolerance', (0.5, 0.01))
@pytest.mark.parametrize('kind', KINDS)
def test_parts_are_flat_and_are_the_curve(kind, tolerance):
    ob = add(value_of(kind))
    run('split', where='FLAT', tolerance=tolerance)
    parts = curves_of(ob)
    for part in parts:
        points = part.evaluate(np.linspace(0, 1, 33))
        chord = points[-1] - points[0]
        along = chord / max(np.linalg.norm(chord), 1e-300)
        offsets = points - points[0]
        across = offsets - np.clip(offsets @ along, 0, np.linalg.norm(chord))[:, None] * along
        assert np.linalg.norm(across, axis=1).max() <= tolerance
    ends = np.array([part.points[[0, -1]] for part in parts])
    assert np.allclose(ends[1:, 0], ends[:-1, 1], rtol=0, atol=1e-12)
    assert np.array_equal(ends[0, 0], value_of(kind).to_bezier()[0].points[0])
    require_exact(ob)


@pytest.mark.parametrize('seed', range(10))
def test_a_chain_of_arcs_is_the_b_spline_again_that_it_came_from(seed):
    """S8: a cubic B-spline of any knots, its Bezier arcs, and its polygon again."""
    random = np.random.default_rng(seed)
    count = int(random.integers(5, 12))
    inner = np.cumsum(random.uniform(0.5, 2.0, count - 3))
    knots = np.concatenate([np.zeros(4), inner[:-1], np.full(4, inner[-1])])
    curve = sc.NurbsCurve(3, knots, random.uniform(-5, 5, (count, 3)))
    ob = add(curve)
    run('to_bezier')
    assert len(curves_of(ob)) == count - 3
    run('join_pieces')
    again = ob.data.splinewright.value
    assert len(again.points) == count
    assert np.allclose(again.points, curve.points, rtol=0, atol=1e-9)
    ratio = np.array(again.knots) / again.knots[-1] - knots / knots[-1]
    assert np.abs(ratio).max() < 1e-12
    require_exact(ob)


def test_pieces_are_found_whatever_their_order_and_direction_and_the_rest_stays():
    arcs = sc.NurbsCurve(3, range(12), np.random.default_rng(3).uniform(-5, 5, (8, 3))).to_bezier()
    alone = sc.BezierCurve([(20, 0, 0), (21, 0, 0), (21, 1, 0)])
    ob = add([arcs[2], alone, arcs[0].reversed(), arcs[4], arcs[1], arcs[3].reversed()])
    run('join_pieces')
    joined, rest = ob.data.splinewright.value
    assert rest == alone and joined.degree == 3 and len(joined.points) == 8
    ends = {tuple(np.round(joined.points[i], 9)) for i in (0, -1)}
    assert ends == {tuple(np.round(arcs[0].points[0], 9)), tuple(np.round(arcs[4].points[-1], 9))}


def test_a_corner_stays_a_corner():
    ob = add([sc.BezierCurve([(0, 0, 0), (1, 0, 0)]), sc.BezierCurve([(1, 0, 0), (1, 1, 0)])])
    run('join_pieces')
    joined = ob.data.splinewright.value
    assert np.array_equal(joined.points, [(0, 0, 0), (1, 0, 0), (1, 1, 0)])
    bpy.ops.ed.undo_push(message="joined")
    assert len(joined.joints()) == 1


def test_a_closed_chain_is_one_curve_that_make_periodic_takes():
    ob = add(sc.NurbsCurve(3, np.arange(8.0), np.random.default_rng(5).uniform(-5, 5, (7, 3)), periodic=True))
    run('to_bezier')
    run('join_pieces')
    run('make_periodic')
    assert ob.data.splinewright.value.periodic and len(ob.data.splinewright.value.points) == 7


def test_pieces_that_do_not_meet_are_refused_with_a_word():
    ob = add([sc.BezierCurve([(0, 0, 0), (1, 0, 0)]), sc.BezierCurve([(5, 0, 0), (6, 1, 0)])])
    before = ob.data.splinewright.value
    with pytest.raises(RuntimeError, match="no two ends"):
        run('join_pieces')
    run('join_pieces', tolerance=4.0)
    assert not isinstance(ob.data.splinewright.value, list) and len(before) == 2


@pytest.mark.parametrize('kind', KINDS)
def test_the_image_in_perspective_is_that_of_every_point(kind):
    curve, eye = value_of(kind), np.array([1.0, -2.0, 30.0])
    ob = add(curve)
    run('project_curve', eye=eye)
    image = ob.data.splinewright.value
    assert image.is_rational
    u = np.linspace(*curve.domain, 31)[1:-1]
    points = curve.evaluate(u)
    rays = points - eye
    expected = eye + rays * (eye[2] / (eye[2] - points[:, 2:]))
    assert np.allclose(image.evaluate(u), expected, rtol=0, atol=1e-12 * np.abs(expected).max())
    require_exact(ob)


def test_an_eye_in_the_plane_of_the_image_is_refused():
    ob = add(value_of('cubic'))
    before = ob.data.splinewright.value
    with pytest.raises(RuntimeError, match="the eye lies in the plane"):
        run('project_curve', eye=(1, 2, 0))
    assert ob.data.splinewright.value == before


def test_several_shapes_are_seen_from_one_eye():
    curve, eye = value_of('cubic'), np.array([1.0, -2.0, 30.0])
    first, second = add(curve, "first"), add(curve, "second")
    first.location.x = 10.0
    bpy.context.view_layer.update()
    activate(second, first)
    run('project_curve', eye=eye)
    u = np.linspace(0, 1, 9)[1:-1]
    for ob, shift in ((second, 0.0), (first, 10.0)):
        points = curve.evaluate(u) + (shift, 0, 0)
        expected = eye + (points - eye) * (eye[2] / (eye[2] - points[:, 2:])) - (shift, 0, 0)
        assert np.allclose(ob.data.splinewright.value.evaluate(u), expected, rtol=0, atol=1e-5)
