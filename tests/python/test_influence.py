"""What a control point moves: against curves and patches of which it was moved; and the draftsman's spline with its energy."""

import numpy as np
import pytest

import splinecore as sc
from addon_core import core

definitions, ducks, influence = core("shape.definition"), core("formulas.ducks"), core("formulas.influence")
recipes = core("recipes.table").RECIPES
Refusal = core("base.failures").Refusal
RANDOM = np.random.default_rng(31)


def points(*size):
    return RANDOM.uniform(-2, 2, (*size, 3))


CURVES = {
    'Bezier': sc.BezierCurve(points(5), [1, 2, 0.5, 1, 3]),
    'clamped': sc.NurbsCurve(3, [0, 0, 0, 0, 1, 2, 2, 3, 4, 4, 4, 4], points(8), RANDOM.uniform(0.5, 2, 8)),
    'unclamped': sc.NurbsCurve(2, np.cumsum(RANDOM.uniform(0.2, 1, 9)), points(6)),
    'periodic': sc.NurbsCurve(3, np.cumsum(RANDOM.uniform(0.2, 1, 9)), points(8), periodic=True),
    'short periodic': sc.NurbsCurve(3, [0, 1, 2.5, 3, 4], points(4), periodic=True),
    'Hermite': sc.HermiteCurve(points(4), points(4), [0, 1, 3, 4]),
}


def with_points(shape, others):
    """The shape with other points; derivatives of Hermite ones stay."""
    if isinstance(shape, sc.HermiteCurve):
        return sc.HermiteCurve(others, shape.tangents, shape.parameters)
    if isinstance(shape, sc.HermitePatch):
        return sc.HermitePatch(others, shape.tangents_u, shape.tangents_v, shape.twists, parameters=shape.parameters)
    return shape.with_points(others)


def moved(curve, index):
    """Whether each of some parameters moves with a point."""
    u = np.linspace(*curve.to_nurbs().domain, 801)
    others = curve.points.copy()
    others[index] += (0.3, 0.7, 0.9)
    return u, np.abs(with_points(curve, others).evaluate(u) - curve.evaluate(u)).max(axis=1) > 1e-9


@pytest.mark.parametrize('name', CURVES)
def test_the_part_of_a_curve_is_what_moves(name):
    curve = CURVES[name]
    for index in range(len(curve.points)):
        found = influence.of_curves(definitions.from_value(curve), 1, index, 0.05)
        parts = [part.curve for part in found.parts if part.name == influence.INFLUENCE]
        u, does_move = moved(curve, index)
        is_in = np.zeros(len(u), bool)
        for part in parts:
            start, end = part.domain
            is_in |= (u >= start - 1e-9) & (u <= end + 1e-9)
            inside = np.linspace(start, end, 21)
            assert np.allclose(part.evaluate(inside), curve.to_nurbs().evaluate(inside), rtol=0, atol=1e-10)
        assert not (does_move & ~is_in).any() and (is_in & ~does_move).sum() <= 14 * len(parts)
        assert found.share == pytest.approx(sum(part.length() for part in parts) / curve.to_nurbs().length(), rel=1e-9)
        assert found.parts[-1].name == f"mark P_{{{index}}}"


def test_a_share_by_hand():
    line = sc.NurbsCurve(1, [0, 0, 1, 2, 3, 4, 4], [(i, 0, 0) for i in range(5)])
    shares = [influence.of_curves(definitions.from_value(line), 1, i, 0.0).share for i in range(5)]
    assert shares == pytest.approx([0.25, 0.5, 0.5, 0.5, 0.25])


def test_a_point_that_pieces_share_moves_them_all():
    chain = CURVES['clamped'].to_bezier()
    definition = definitions.from_value(chain)
    found = influence.of_curves(definition, 1, 3, 0.0)
    shared = [piece for piece in definition.pieces if definition.pieces[0].indices[3] in piece.indices]
    assert len(found.parts) == len(shared) >= 1


def test_a_curve_that_runs_to_infinity_has_no_share():
    found = influence.of_curves(definitions.from_value(sc.BezierCurve([(0, 0, 0), (1, 1, 0), (2, 0, 0)], [1, -1, 1])), 1, 1, 0.0)
    assert found.share is None and len(found.parts) == 1


PATCHES = {
    'Bezier': sc.BezierPatch(points(3, 4)),
    'NURBS': sc.NurbsPatch((3, 2), ([0, 0, 0, 0, 1, 2, 3, 3, 3, 3], [0, 0, 0, 1, 2, 2, 2]), points(6, 4), RANDOM.uniform(0.5, 2, (6, 4))),
    'periodic': sc.NurbsPatch((2, 3), ([0, 0, 0, 1, 2, 2, 2], np.arange(8.0)), points(4, 7), periodic=(False, True)),
    'Hermite': sc.HermitePatch(points(3, 3), points(3, 3), points(3, 3), points(3, 3), parameters=([0, 1, 2], [0, 2, 3])),
}


@pytest.mark.parametrize('name', PATCHES)
def test_the_rectangle_of_a_patch_is_what_moves(name):
    patch = PATCHES[name]
    nurbs = patch.to_nurbs()
    (u0, u1), (v0, v1) = nurbs.domain
    u, v = np.linspace(u0, u1, 41), np.linspace(v0, v1, 41)
    for index in np.ndindex(patch.points.shape[:2]):
        found = influence.of_patches(definitions.from_value(patch), 1, index, 0.0)
        others = patch.points.copy()
        others[index] += 1.0
        does_move = np.abs(with_points(patch, others).evaluate_grid(u, v) - patch.evaluate_grid(u, v)).max(axis=-1) > 1e-9
        is_in = np.zeros(does_move.shape, bool)
        for part in (each.curve for each in found.parts):
            (a, b), (c, d) = part.domain
            is_in |= np.outer((u >= a - 1e-9) & (u <= b + 1e-9), (v >= c - 1e-9) & (v <= d + 1e-9))
            inside = np.linspace(a, b, 5), np.linspace(c, d, 5)
            assert np.allclose(part.evaluate_grid(*inside), nurbs.evaluate_grid(*inside), rtol=0, atol=1e-9)
        assert not (does_move & ~is_in).any()
        assert (is_in & ~does_move).sum() <= 6 * 41 * len(found.parts)
        assert found.share == pytest.approx(sum(each.curve.area() for each in found.parts) / nurbs.area(), rel=1e-6)


def test_parts_of_a_surface_lie_on_both_sides():
    plane = sc.BezierPatch([[(0, 0, 0), (0, 2, 0)], [(2, 0, 0), (2, 2, 0)]])
    found = influence.of_patches(definitions.from_value(plane), 1, (0, 0), 0.25)
    assert sorted(float(part.curve.points[0, 0, 2]) for part in found.parts) == [-0.25, 0.25] and found.share == 1.0


def test_what_is_not_there_is_refused():
    for piece, index, message in ((2, 0, "no piece 2"), (1, 5, "no control point 5: the last one is 4")):
        with pytest.raises(Refusal, match=message):
            influence.of_curves(definitions.from_value(CURVES['Bezier']), piece, index, 0.1)
    with pytest.raises(Refusal, match="no control point 1, 4: the last one is 2, 3"):
        influence.of_patches(definitions.from_value(PATCHES['Bezier']), 1, (1, 4), 0.1)


def test_the_energy_of_a_circle_is_its_angle_over_its_radius():
    u = np.linspace(0, np.pi, 400)
    arc, _ = sc.fit.interpolate(np.column_stack([2 * np.cos(u), 2 * np.sin(u), 0 * u]), 5)
    assert ducks.energy(arc) == pytest.approx(np.pi / 2, rel=1e-6)
    assert ducks.energy(sc.NurbsCurve(1, [0, 0, 1, 2, 2], [(0, 0, 0), (1, 0, 0), (2, 0, 0)]).elevate(2)) == 0.0


def test_energy_of_a_parabola_by_its_closed_form():
    curve = sc.BezierCurve([(0, 0), (0.5, 0), (1, 1)]).to_nurbs()
    u = np.linspace(0, 1, 200001)
    values = 4.0 / (1 + 4 * u ** 2) ** 2.5
    expected = float(((values[1:] + values[:-1]) / 2).sum() * (u[1] - u[0]))
    assert ducks.energy(curve) == pytest.approx(expected, rel=1e-9)


@pytest.mark.parametrize('spacing', ('uniform', 'centripetal', 'chordal'))
def test_the_strip_is_the_natural_spline_straight_beyond_its_ducks(spacing):
    places = points(6)
    parts, energy = ducks.picture(places, spacing, 0.05, 0.4)
    strip = parts[0].curve
    start, end = strip.domain
    assert np.allclose(strip.derivatives([start, end], 2)[:, 2], 0.0, atol=1e-8)
    assert [part.name for part in parts[:3]] == ["strip", "end", "end"] and energy > 0.0
    for part, u in zip(parts[1:3], (start, end)):
        assert np.linalg.norm(np.diff(part.curve.points, axis=0)) == pytest.approx(0.4)
        along = np.diff(part.curve.points, axis=0)[0]
        assert np.linalg.norm(np.cross(along, strip.derivatives([u], 1)[0, 1])) <= 1e-9
    assert [part.name for part in parts[3:-1]] == [f"mark D_{{{i}}}" for i in range(6)] and parts[-1].name == f"mark E = {energy:.4g}"


def test_few_ducks_and_those_at_one_place():
    parts, energy = ducks.picture(points(2), 'chordal', 0.05, 0.0)
    assert energy == pytest.approx(0.0, abs=1e-20) and parts[0].curve.degree == 3
    with pytest.raises(Refusal, match="two ducks or more"):
        ducks.picture(points(1), 'chordal', 0.05, 0.0)
    with pytest.raises(sc.Error):
        ducks.picture(np.zeros((4, 3)), 'chordal', 0.05, 0.0)
    with pytest.raises(Refusal, match="at one place"):
        ducks.picture(np.zeros((2, 3)), 'chordal', 0.05, 0.0)


@pytest.mark.parametrize('size', (1e-6, 1.0, 1e6, 1e100))
@pytest.mark.parametrize('narrow', (1e-2, 1e-4, 1e-6))
def test_the_energy_of_both_narrow_bends_counts(narrow, size):
    """Of a strip there and almost back: half of the energy is on each side of the middle duck, as that is symmetrical."""
    strip = ducks.strip(size * np.array([(0, 0, 0), (1, narrow / 2, 0), (0, narrow, 0)]), 'uniform')
    middle = sum(strip.domain) / 2.0
    whole = ducks.energy(strip)
    parts = [ducks.energy(part) for part in strip.split(middle)]
    assert parts == pytest.approx([whole / 2.0] * 2, rel=1e-6) and whole * size * narrow ** 2 == pytest.approx(16.0, rel=1e-2)


def test_energy_of_many_ducks_is_that_of_all_spans():
    strip = ducks.strip(points(9), 'uniform')
    nodes, weights = np.polynomial.legendre.leggauss(30)
    places = np.linspace(*strip.domain, 8 * 200 + 1)
    u = (places[1:] + places[:-1])[:, None] / 2 + np.diff(places)[:, None] / 2 * nodes
    _, first, second = strip.derivatives(u.ravel(), 2).transpose(1, 0, 2)
    values = (np.cross(first, second) ** 2).sum(1) / (first ** 2).sum(1) ** 2.5
    assert ducks.energy(strip) == pytest.approx((np.diff(places) / 2 * (values.reshape(u.shape) @ weights)).sum(), rel=1e-8)


def test_a_strip_that_turns_back_has_no_finite_energy():
    parts, energy = ducks.picture(np.array([(0.0, 0, 0), (1, 0, 0), (0, 0, 0)]), 'chordal', 0.05, 0.0)
    assert energy == np.inf and parts[-1].name == "mark E = infinite"


@pytest.mark.parametrize('offset', (0.0, 1e3, 1e6, 1e8))
def test_the_energy_does_not_depend_on_the_place(offset):
    places = points(6)
    assert ducks.energy(ducks.strip(places + offset, 'chordal')) == pytest.approx(ducks.energy(ducks.strip(places, 'chordal')), rel=1e-5)
    line = ducks.strip(np.linspace((0, 0, 0), (3, 0.3, 1), 5) + offset, 'chordal')
    assert ducks.energy(line) < 1e-9


def test_end_derivatives_and_typed_knots_of_interpolating_splines():
    recipe = recipes['interpolating']
    places = points(5)
    made = recipe.make(places, **{**recipe.defaults, 'start_derivative': "1 2 3", 'end_derivative': "0, -4, 0"}).value
    assert np.allclose(made.derivatives([0.0, 1.0], 1)[:, 1], [(1, 2, 3), (0, -4, 0)], rtol=0, atol=1e-9) and len(made.points) == 7
    made = recipe.make(places, **{**recipe.defaults, 'knots': 'typed', 'knot_values': "0 0 0 0 0.4 1 1 1 1"}).value
    assert made.knots.tolist() == [0, 0, 0, 0, 0.4, 1, 1, 1, 1]
    for settings, message in (({'start_derivative': "1 2"}, "has 2 numbers"), ({'end_derivative': "a b c"}, "\"a\" is not a number")):
        with pytest.raises(Refusal, match=message):
            recipe.make(places, **{**recipe.defaults, **settings})
    with pytest.raises(sc.Error):
        recipe.make(places, **{**recipe.defaults, 'knots': 'typed', 'knot_values': "0 0 0 0 1 1 1"})


def test_orthogonal_projection_leaves_nothing_of_the_functions():
    recipe = recipes['projection']
    made = recipe.make(np.empty((0, 3)), **{**recipe.defaults, 'x': "t", 'y': "exp(t)", 'z': "abs(t - 0.3)", 'start': -1.0, 'end': 2.0})
    curve = made.value
    nodes, weights = np.polynomial.legendre.leggauss(40)
    knots = np.unique(np.append(curve.knots, 0.3))
    total = np.zeros((len(curve.points), 3))
    for a, b in zip(knots, knots[1:]):
        u = (a + b) / 2 + (b - a) / 2 * nodes
        left = curve.evaluate(u) - np.column_stack([u, np.exp(u), np.abs(u - 0.3)])
        total += (b - a) / 2 * np.einsum('k,ki,kj->ij', weights, curve.knot_vector.functions(u), left)
    assert np.abs(total).max() < 1e-8 and 0.0 < made.error < 0.5
    with pytest.raises(Refusal, match="last t"):
        recipe.make(np.empty((0, 3)), **{**recipe.defaults, 'start': 1.0, 'end': 1.0})
