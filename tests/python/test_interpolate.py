"""Curves through points: against dense solutions with functions of Cox and de Boor, closed forms and scipy."""

import numpy as np
import pytest

import splinecore as sc
from splinecore import fit

RNG = np.random.default_rng(17)


def walk(count, dimensions=3):
    return np.cumsum(RNG.uniform(0.2, 1.0, (count, dimensions)) * RNG.choice([-1, 1], (count, dimensions)), 0)


def function_row(knots, degree, u, order, at_end):
    """All functions of a clamped vector, or derivatives of them, by the recursions."""
    if order > 0:
        lower = function_row(knots, degree - 1, u, order - 1, at_end)
        row = []
        for i in range(len(knots) - degree - 1):
            ends = knots[i + degree] - knots[i], knots[i + degree + 1] - knots[i + 1]
            row.append(degree * ((lower[i] / ends[0] if ends[0] else 0.0) - (lower[i + 1] / ends[1] if ends[1] else 0.0)))
        return np.array(row)
    if degree == 0:
        held = [a < u <= b if at_end else a <= u < b for a, b in zip(knots, knots[1:])]
        return np.array(held, float)
    lower = function_row(knots, degree - 1, u, 0, at_end)
    row = []
    for i in range(len(knots) - degree - 1):
        ends = knots[i + degree] - knots[i], knots[i + degree + 1] - knots[i + 1]
        row.append((u - knots[i]) / ends[0] * lower[i] if ends[0] else 0.0)
        row[-1] += (knots[i + degree + 1] - u) / ends[1] * lower[i + 1] if ends[1] else 0.0
    return np.array(row)


def dense(curve, conditions):
    """The control points that these (parameter, order, value) decide."""
    end = curve.knots[-1]
    rows = [function_row(curve.knots, curve.degree, u, order, u == end) for u, order, _ in conditions]
    return np.linalg.solve(np.array(rows), np.array([value for _, _, value in conditions]))


def check_dense(curve, conditions, rtol=1e-9):
    wanted = dense(curve, conditions)
    np.testing.assert_allclose(curve.points, wanted, rtol=0, atol=rtol * np.abs(wanted).max())


@pytest.mark.parametrize('degree', range(1, 10))
@pytest.mark.parametrize('parameters', ['uniform', 'chordal', 'centripetal'])
@pytest.mark.parametrize('closed', [False, True])
def test_it_passes_through_its_points(degree, parameters, closed):
    points = walk(30)
    curve, error = fit.interpolate(points, degree, parameters, closed=closed)
    steps = np.linalg.norm(np.diff(np.concatenate([points, points[:1]]) if closed else points, axis=0), axis=1)
    u = np.concatenate([[0.0], np.cumsum({'uniform': steps**0, 'chordal': steps, 'centripetal': steps**0.5}[parameters])])
    found = curve.evaluate(u[:30])
    assert error < 1e-10 * np.abs(points).max()
    assert np.linalg.norm(found - points, axis=1).max() <= error + 1e-14 * np.abs(curve.points).max()
    assert (curve.degree, curve.periodic) == (degree, closed)
    assert len(curve.points) == 30
    if not closed:
        u[-1] = curve.knots[-1]
        check_dense(curve, [(at, 0, point) for at, point in zip(u, points)])


@pytest.mark.parametrize('degree', [1, 3, 5, 7, 9])
def test_closed_curves_have_knots_at_their_points(degree):
    points = walk(17)
    u = np.concatenate([[0.0], np.cumsum(RNG.uniform(0.5, 1.5, 17))])
    curve = fit.interpolate(points, degree, u, closed=True).value
    np.testing.assert_array_equal(curve.knots, u)
    for order in range(degree):
        before, after = (curve.derivatives(u[3], order, side=side)[order] for side in ('left', 'right'))
        np.testing.assert_allclose(before, after, rtol=0, atol=1e-9 * np.abs(after).max())


@pytest.mark.parametrize('degree', range(1, 10))
@pytest.mark.parametrize('parameters', ['uniform', 'chordal', 'centripetal', 'given'])
def test_averaged_knots_are_those_of_the_book(degree, parameters):
    """The NURBS Book, eq. 9.8: u[j + p] is the mean of the p parameters from the j-th on."""
    points = walk(15)
    steps = np.linalg.norm(np.diff(points, axis=0), axis=1)**{'uniform': 0, 'centripetal': 0.5}.get(parameters, 1)
    u = np.concatenate([[0.0], np.cumsum(steps if parameters != 'given' else RNG.uniform(0.1, 2, 14))])
    curve = fit.interpolate(points, degree, parameters if parameters != 'given' else u).value
    inner = [sum(u[j:j + degree]) / degree for j in range(1, 15 - degree)]
    np.testing.assert_allclose(curve.knots, [u[0]] * (degree + 1) + inner + [u[-1]] * (degree + 1), rtol=1e-14, atol=0)


@pytest.mark.parametrize('degree', [1, 3, 4, 5, 7])
def test_closed_curves_on_knots_of_ones_own(degree):
    """One period of them: beside the points for odd degrees, half-way between them for even ones."""
    u = np.concatenate([[0.0], np.cumsum(RNG.uniform(0.8, 1.2, 14))])
    knots = u.copy()
    knots[1:-1] += RNG.uniform(-0.1, 0.1, 13) - (0.4 if degree % 2 == 0 else 0.0)
    shape = sc.NurbsCurve(degree, knots, RNG.normal(size=(14, 3)), periodic=True)
    points = shape.evaluate(u[:-1])
    curve, error = fit.interpolate(points, degree, u, knots, closed=True)
    assert curve.periodic and error < 1e-12
    np.testing.assert_array_equal(curve.knots, knots)
    np.testing.assert_allclose(curve.points, shape.points, rtol=0, atol=1e-8)
    assert np.linalg.norm(curve.evaluate(u[:-1]) - points, axis=1).max() < 1e-12


@pytest.mark.parametrize('count', [4, 5, 6, 7, 8, 20])
@pytest.mark.parametrize('degree', [1, 2, 3])
def test_few_points_close(count, degree):
    angles = np.arange(count) * 2 * np.pi / count
    points = np.stack([np.cos(angles), np.sin(angles)], 1)
    curve, error = fit.interpolate(points, degree, 'uniform', closed=True)
    assert error < 1e-14
    radii = np.linalg.norm(curve.points[:, :2], axis=1)
    np.testing.assert_allclose(radii, radii[0], rtol=1e-13)


@pytest.mark.parametrize('degree', range(1, 10))
def test_a_spline_of_the_same_knots_comes_back(degree):
    inner = np.sort(RNG.uniform(0.0, 1.0, 12))
    knots = np.concatenate([np.zeros(degree + 1), inner, np.ones(degree + 1)])
    shape = sc.NurbsCurve(degree, knots, RNG.normal(size=(12 + degree + 1, 3)))
    u = np.array([knots[i + 1:i + degree + 1].mean() for i in range(12 + degree + 1)])
    curve = fit.interpolate(shape.evaluate(u), degree, u, knots).value
    np.testing.assert_allclose(curve.points, shape.points, rtol=0, atol=1e-8)


@pytest.mark.parametrize('degree', range(1, 10))
def test_polynomials_are_kept(degree):
    u = (np.arange(25) + RNG.uniform(0.0, 0.5, 25)) / 25
    coefficients = RNG.normal(size=(degree + 1, 3))
    points = np.stack([np.polyval(coefficients[:, axis], u) for axis in range(3)], 1)
    for ends in ('averaged', 'not_a_knot'):
        curve = fit.interpolate(points, degree, u, ends=ends).value
        at = np.linspace(u[0], u[-1], 50)
        wanted = np.stack([np.polyval(coefficients[:, axis], at) for axis in range(3)], 1)
        np.testing.assert_allclose(curve.evaluate(at), wanted, rtol=0, atol=1e-9)


@pytest.mark.parametrize('degree', [3, 5, 7, 9])
def test_natural_ends_have_no_higher_derivatives(degree):
    points = walk(20)
    u = np.arange(20.0)
    curve = fit.interpolate(points, degree, u, ends='natural').value
    np.testing.assert_array_equal(curve.knots[degree:-degree], u)
    conditions = [(at, 0, point) for at, point in zip(u, points)]
    for order in range((degree + 1) // 2, degree):
        for end in (0.0, 19.0):
            conditions.append((end, order, np.zeros(3)))
            largest = np.abs(curve.derivatives(np.linspace(0, 19, 99), order)[:, order]).max()
            assert np.abs(curve.derivatives(end, order)[order]).max() < 1e-8 * largest
    check_dense(curve, conditions)


def test_the_natural_cubic_bends_least():
    points, u = walk(15), np.arange(15.0)
    natural = fit.interpolate(points, 3, u, ends='natural').value

    def energy(curve):
        at = np.linspace(0, 14, 14_001)
        return (curve.derivatives(at, 2)[:, 2]**2).sum()

    assert energy(natural) < energy(fit.interpolate(points, 3, u).value)
    assert energy(natural) < energy(fit.interpolate(points, 3, u, ends='not_a_knot').value)


@pytest.mark.parametrize('degree', range(2, 10))
@pytest.mark.parametrize('first, last', [(1, 1), (0, 1), (2, 1), (2, 2), (4, 4)])
def test_derivatives_at_the_ends(degree, first, last):
    if max(first, last) >= degree:
        return
    points, u = walk(14), np.concatenate([[0.0], np.cumsum(RNG.uniform(0.5, 1.5, 13))])
    start, end = RNG.normal(size=(first, 3)), RNG.normal(size=(last, 3))
    curve, error = fit.interpolate(points, degree, u, start=start, end=end)
    assert error < 1e-9
    conditions = [(at, 0, point) for at, point in zip(u, points)]
    conditions += [(u[0], k + 1, value) for k, value in enumerate(start)]
    conditions += [(u[-1], k + 1, value) for k, value in enumerate(end)]
    check_dense(curve, conditions, 1e-7)
    for at, values in ((u[0], start), (u[-1], end)):
        found = curve.derivatives(at, max(len(values), 1))
        np.testing.assert_allclose(found[1:len(values) + 1], values, rtol=0, atol=1e-6 * np.abs(found).max())
    if degree % 2 == 1 and first == last == (degree - 1) // 2:
        np.testing.assert_array_equal(curve.knots[degree:-degree], u)


@pytest.mark.parametrize('closed', [False, True])
@pytest.mark.parametrize('degree', range(2, 8))
@pytest.mark.parametrize('which', ['some', 'all'])
def test_tangents_at_points(degree, closed, which):
    points, u = walk(12), np.concatenate([[0.0], np.cumsum(RNG.uniform(0.5, 1.5, 12 if closed else 11))])
    tangents = RNG.normal(size=(12, 3))
    if which == 'some':
        tangents[[0, 1, 3, 4, 5, 8, 11]] = np.nan
    curve, error = fit.interpolate(points, degree, u, tangents=tangents, closed=closed)
    given = ~np.isnan(tangents[:, 0])
    assert error < 1e-8
    found = curve.derivatives(u[:12][given], 1)[:, 1]
    np.testing.assert_allclose(found, tangents[given], rtol=0, atol=1e-7 * np.abs(curve.points).max())


@pytest.mark.parametrize('scale', [1e-150, 1e-30, 1.0, 1e30, 1e150])
@pytest.mark.parametrize('ends', ['averaged', 'natural', 'not_a_knot', 'closed'])
@pytest.mark.parametrize('count', [16, 150])
def test_it_does_not_depend_on_the_scale(scale, ends, count):
    points = walk(count)
    options = {'closed': True} if ends == 'closed' else {'ends': ends}
    exact = 2.0**round(np.log2(scale))
    near, far = (fit.interpolate(points * factor, **options).value for factor in (1.0, exact))
    np.testing.assert_allclose(far.points, near.points * exact, rtol=1e-12, atol=1e-12 * exact)
    u = np.arange(count + 1.0 if ends == 'closed' else float(count))
    near, far = (fit.interpolate(points, 3, u * factor, **options).value for factor in (1.0, exact))
    np.testing.assert_allclose(far.points, near.points, rtol=0, atol=1e-12)
    np.testing.assert_allclose(far.knots, near.knots * exact, rtol=1e-15)


@pytest.mark.parametrize('degree', [3, 5, 7, 9])
def test_natural_splines_of_the_fewest_points(degree):
    """They are polynomials of degree (degree - 1) / 2."""
    count = (degree + 1) // 2
    u, coefficients = np.arange(float(count)), RNG.normal(size=(count, 2))
    points = np.stack([np.polyval(coefficients[:, axis], u) for axis in range(2)], 1)
    curve = fit.interpolate(points, degree, u, ends='natural').value
    at = np.linspace(0, count - 1, 30)
    wanted = np.stack([np.polyval(coefficients[:, axis], at) for axis in range(2)], 1)
    np.testing.assert_allclose(curve.evaluate(at)[:, :2], wanted, rtol=0, atol=1e-9 * np.abs(wanted).max())


@pytest.mark.parametrize('degree', range(1, 8))
@pytest.mark.parametrize('least', [1e-6, 1e-10, 1e-12])
def test_closed_curves_with_very_uneven_steps(degree, least):
    points = walk(24)
    for _ in range(10):
        u = np.concatenate([[0.0], np.cumsum(10.0**RNG.uniform(np.log10(least), 0, 24))])
        try:
            curve, error = fit.interpolate(points, degree, u, closed=True)
        except sc.InvalidShape as refused:
            assert degree >= (2 if least < 1e-10 else 3) and 'rounding leaves the shape' in str(refused)
        else:
            assert error < 1e-12 * np.abs(curve.points).max()


def test_far_from_the_origin_points_keep_their_digits():
    points = walk(50) + 1e8
    curve, error = fit.interpolate(points)
    assert error < 1e-7


@pytest.mark.parametrize('closed', [False, True])
@pytest.mark.parametrize('degree', [1, 2, 3, 5])
def test_steps_of_many_sizes(degree, closed):
    steps = 10.0**RNG.uniform(-3 if degree < 5 else -1, 3 if degree < 5 else 1, 40)
    points = np.cumsum(steps[:, None] * np.array([[0.6, 0.8, 0.0]]), 0)[:39]
    curve, error = fit.interpolate(points, degree, np.concatenate([[0.0], np.cumsum(steps)])[:40 if closed else 39],
                                   closed=closed)
    assert error < 1e-9 * np.abs(curve.points).max()


@pytest.mark.parametrize('ends', ['averaged', 'natural', 'not_a_knot'])
def test_many_points_are_passed(ends):
    angles = np.linspace(0, 300, 100_000)
    points = np.stack([np.cos(angles), np.sin(angles), 0.01 * angles], 1)
    curve, error = fit.interpolate(points, ends=ends)
    assert error < 1e-13
    middles = 0.5 * (angles[1000:-1001] + angles[1001:-1000])
    u = np.linalg.norm(np.diff(points, axis=0), axis=1).cumsum()
    found = curve.evaluate(0.5 * (u[999:-1001] + u[1000:-1000]))
    np.testing.assert_allclose(np.linalg.norm(found[:, :2], axis=1), 1.0, atol=1e-8)
    np.testing.assert_allclose(found[:, 2], 0.01 * middles, atol=1e-8)


def test_as_scipy():
    interpolate = pytest.importorskip('scipy.interpolate', reason='python3-scipy is not installed')
    points, u = walk(40), np.concatenate([[0.0], np.cumsum(RNG.uniform(0.5, 1.5, 39))])
    at = np.linspace(u[0], u[-1], 500)

    def compare(curve, other):
        wanted = other(at)
        np.testing.assert_allclose(curve.evaluate(at), wanted, rtol=0, atol=1e-12 * np.abs(wanted).max())

    for ends in ('not_a_knot', 'natural'):
        kind = interpolate.CubicSpline(u, points, bc_type=ends.replace('_', '-'))
        compare(fit.interpolate(points, 3, u, ends=ends).value, kind)
    slopes = RNG.normal(size=(2, 3))
    clamped = interpolate.CubicSpline(u, points, bc_type=((1, slopes[0]), (1, slopes[1])))
    compare(fit.interpolate(points, 3, u, start=slopes[0], end=slopes[1]).value, clamped)
    closed = interpolate.CubicSpline(np.append(u, u[-1] + 1), np.concatenate([points, points[:1]]), bc_type='periodic')
    compare(fit.interpolate(points, 3, np.append(u, u[-1] + 1), closed=True).value, closed)
    for degree in (1, 2, 3, 4, 5):
        if degree % 2 == 1:
            curve = fit.interpolate(points, degree, u, ends='not_a_knot').value
            compare(curve, interpolate.make_interp_spline(u, points, degree))
        averaged = fit.interpolate(points, degree, u).value
        compare(averaged, interpolate.make_interp_spline(u, points, degree, t=averaged.knots))


@pytest.mark.parametrize('count', [5, 6, 20, 34, 35, 36, 37, 38, 39, 67, 68, 69, 70, 133, 400, 515, 516, 517, 518, 519, 523, 531, 1030])
@pytest.mark.parametrize('ends', ['not_a_knot', 'natural', 'clamped'])
def test_cubics_with_knots_at_their_points_as_scipy(count, ends):
    interpolate = pytest.importorskip('scipy.interpolate', reason='python3-scipy is not installed')
    points, u = walk(count), np.concatenate([[0.0], np.cumsum(RNG.uniform(0.5, 1.5, count - 1))])
    if ends == 'clamped':
        slopes = RNG.normal(size=(2, 3))
        found = fit.interpolate(points, 3, u, start=slopes[0], end=slopes[1])
        wanted = interpolate.CubicSpline(u, points, bc_type=((1, slopes[0]), (1, slopes[1])))
    else:
        found = fit.interpolate(points, 3, u, ends=ends)
        wanted = interpolate.CubicSpline(u, points, bc_type=ends.replace('_', '-'))
    at = np.linspace(u[0], u[-1], 5 * count)
    size = np.abs(wanted(at)).max()
    np.testing.assert_allclose(found.value.evaluate(at), wanted(at), rtol=0, atol=1e-12 * size)
    left = np.linalg.norm(found.value.evaluate(u) - points, axis=1).max()
    assert max(left, found.error) <= 4e-15 * size and abs(left - found.error) <= 4e-15 * size


@pytest.mark.parametrize('least', [1e-3, 1e-8, 1e-14])
@pytest.mark.parametrize('ends', ['not_a_knot', 'natural'])
def test_cubics_with_knots_at_their_points_at_steps_of_many_sizes(ends, least):
    for count in (20, 70, 300):
        points, steps = walk(count), 10 ** RNG.uniform(np.log10(least), 0, count - 1)
        u = np.concatenate([[0.0], np.cumsum(steps)])
        try:
            found = fit.interpolate(points, 3, u, ends=ends)
        except sc.InvalidShape as refused:
            assert least < 1e-3, refused
            continue
        size = np.abs(found.value.points).max()
        left = np.linalg.norm(found.value.evaluate(u) - points, axis=1).max()
        assert found.error <= 1e-6 * np.abs(points).max() and abs(left - found.error) <= 1e-14 * size


BAD = [
    (dict(points=[[0, 0, 0]]), 'points has 1 rows'),
    (dict(points=[[0, 0], [1, 0], [2, 0]]), '3 conditions are too few for degree 3'),
    (dict(points=[[0, 0], [1, 0], [1, 0], [2, 0], [3, 0]]), r'points\[2\] is too close to points\[1\]'),
    (dict(points=[[0, 0], [1, np.nan], [1, 0], [2, 0], [3, 0]]), r'points\[1\]'),
    (dict(degree=0), 'degree = 0'),
    (dict(degree=300), 'degree = 300'),
    (dict(parameters=[0, 1, 1, 2, 3, 4]), r'parameters\[2\]'),
    (dict(parameters=[0, 2, 1, 2.5, 3, 4]), r'parameters\[2\]'),
    (dict(parameters=[0, 1, 2]), 'parameters'),
    (dict(parameters='chord'), "parameters = 'chord'"),
    (dict(knots=[0, 0, 0, 0, 1, 1, 1, 1]), '4 control points; 6 conditions'),
    (dict(parameters=range(6), knots=[0, 0, 0, 0, 0.1, 0.2, 5, 5, 5, 5]), r'parameters\[\d\] = .*too many lie between'),
    (dict(parameters=range(6), knots=[0, 0, 0, 0, 1, 2, 4, 4, 4, 4]), r'parameters\[4\]'),
    (dict(ends='free'), "ends = 'free'"),
    (dict(ends='natural', degree=2), 'odd degree'),
    (dict(ends='natural', start=[1, 0]), 'natural'),
    (dict(ends='not_a_knot', tangents=np.ones((6, 2))), 'not-a-knot'),
    (dict(closed=True, start=[1, 0]), 'closed curve has no ends'),
    (dict(closed=True, ends='natural'), 'closed curve has no ends'),
    (dict(closed=True, degree=7), 'too few for degree 7'),
    (dict(start=[[1, 0]] * 4), '4 derivatives at an end'),
    (dict(start=[np.inf, 0]), 'start'),
    (dict(tangents=[[1, 0]]), 'tangents has 1 rows for 6 points'),
    (dict(tangents=np.full((6, 2), np.inf)), 'tangents'),
    (dict(tangents=np.ones((6, 2)), degree=1), 'degree 1 takes no tangents'),
    (dict(tangents=np.ones((6, 2)), start=[1, 0]), 'given twice'),
    (dict(points=[[0, 0], [1, 0]], degree=5, ends='natural'), 'degree 5 need at least 3 points, not 2'),
    (dict(points=[[0, 0], [1, 0], [2, 1]], degree=7, ends='natural'), 'degree 7 need at least 4 points, not 3'),
    (dict(points=RNG.normal(size=(300, 3)), degree=100), 'rounding leaves the shape'),
    (dict(closed=True, degree=2, parameters=range(7), knots=range(7)), 'rounding leaves the shape|do not determine'),
    (dict(closed=True, parameters=[0, 1, 2, 3, 4, 5, 1000], knots=range(7)), 'return after 1000, .* knots is 6'),
    (dict(closed=True, parameters=np.linspace(-1, 1, 7) * 1.7e308, degree=2), 'overflow'),
    (dict(points=np.array([[1, 0], [-1, 1], [1, 1], [-1, 0], [1, 1]]) * 1.7e308, parameters=range(5)), 'too large'),
    (dict(tangents=[[np.nan, np.nan, 5]] * 6, points=np.arange(18.0).reshape(6, 3)**2), 'tangents'),
]


@pytest.mark.parametrize('wrong, sentence', BAD, ids=lambda value: value if isinstance(value, str) else '')
def test_what_cannot_be_is_refused(wrong, sentence):
    points = wrong.pop('points', [[0, 0], [1, 0], [1, 1], [2, 1], [3, 0], [4, 1]])
    with pytest.raises(sc.InvalidShape, match=sentence):
        fit.interpolate(points, **wrong)
