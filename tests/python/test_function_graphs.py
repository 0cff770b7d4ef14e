"""Graphs of basis functions, as the lectures draw them: against exact fractions, closed forms and SciPy."""

import itertools
from fractions import Fraction

import numpy as np
import pytest
from scipy.interpolate import CubicSpline

import splinecore as sc
from addon_core import core
from exact_splines import share

functions = core("formulas.functions")
FAILURES = core("base.failures")
RNG = np.random.default_rng(7)


def cox_de_boor(i, degree, knots, u):
    """N_{i,p}(u) by its definition, from spans that are open on the right."""
    if degree == 0:
        return Fraction(int(knots[i] <= u < knots[i + 1]))
    return (share(u, knots[i], knots[i + degree]) * cox_de_boor(i, degree - 1, knots, u)
            + share(-u, -knots[i + degree + 1], -knots[i + 1]) * cox_de_boor(i + 1, degree - 1, knots, u))


KNOTS = {
    'steps': (0, [0, 1, 2, 3, 4, 5]), 'steps with an empty span': (0, [0, 1, 1, 2.5]), 'hats': (1, [0, 1, 2, 3]),
    'the lecture on N02': (2, [0, 1, 2, 3]), 'doubled': (2, [0, 0, 1, 1, 3, 3]), 'clamped': (3, [0, 0, 0, 0, 1, 3, 4, 4, 4, 4]),
    'torn': (2, [0, 0, 0, 1, 1, 1, 2, 2, 2]), 'six inner knots': (5, [0] * 6 + [1, 2, 3, 4, 5, 6] + [7] * 6),
    'merged': (5, [0] * 6 + [1, 6, 6, 6, 6, 6] + [7] * 6), 'far and narrow': (3, [1e6, 1e6 + 1e-3, 1e6 + 2e-3, 1e6 + 5, 1e6 + 6, 1e6 + 7]),
    'nine': (9, list(range(12))), 'more copies than count': (1, [0, 0, 0, 1, 2, 2, 2, 2, 3, 3, 3]), 'fourfold in degree 2': (2, [0, 1, 1, 1, 1, 2, 3, 3]),
}


def random_knots(degree):
    inner = np.sort(RNG.choice([RNG.uniform(-3, 5), RNG.integers(0, 4)], 1)[0] + RNG.choice([0.0, 0.5, 1.0, 2.0], RNG.integers(1, 6)).cumsum())
    ends = RNG.integers(1, degree + 2, 2)
    knots = np.concatenate([np.full(ends[0], inner[0] - 1.0), inner, np.full(ends[1], inner[-1] + 0.25)])
    values, copies = np.unique(knots, return_counts=True)
    return np.repeat(values, np.minimum(copies, degree + 1))


def at_inside(first, last):
    return np.linspace(first, last, 23)[1:-1]


def require_graphs(family, value_of, bound=1e-12):
    """Every function where it is not zero, and no part of it elsewhere."""
    units = np.eye(len(family.names))
    for i, name in enumerate(family.names):
        for graph in family.graph(units[i]):
            u = at_inside(*graph.domain)
            points = graph.evaluate(u)
            size = np.abs(family.places).max()
            assert np.allclose(points[:, 0], u, rtol=0, atol=4e-16 * size + 1e-12 * np.ptp(family.places)), name
            assert not points[:, 2].any() and np.allclose(points[:, 1], [float(value_of(i, each)) for each in u], rtol=0, atol=bound), name


@pytest.mark.parametrize('name', KNOTS)
def test_b_splines_are_those_of_cox_and_de_boor(name):
    degree, knots = KNOTS[name]
    exact = [Fraction(knot) for knot in knots]
    family = functions.of_knots(degree, knots)
    assert family.names == tuple(f"N_{{{i},{degree}}}" for i in range(len(knots) - degree - 1))
    require_graphs(family, lambda i, u: cox_de_boor(i, degree, exact, Fraction(u)), 1e-9 if name == 'far and narrow' else 1e-13)
    for i in range(len(family.names)):
        wanted = [(knots[i], knots[i + degree + 1])] if knots[i] < knots[i + degree + 1] else []
        assert family.supports(i) == wanted


@pytest.mark.parametrize('seed', range(200))
def test_random_knots(seed):
    degree = seed % 6
    knots = random_knots(degree)
    if len(knots) < degree + 2:
        knots = np.append(knots, knots[-1] + np.arange(1, degree + 3))
    exact = [Fraction(float(knot)) for knot in knots]
    family = functions.of_knots(degree, knots)
    require_graphs(family, lambda i, u: cox_de_boor(i, degree, exact, Fraction(float(u))), 1e-12)


def test_bernstein_and_hermite_are_the_polynomials_of_the_lectures():
    require_graphs(functions.bernstein(4), lambda i, u: [1, 4, 6, 4, 1][i] * u**i * (1 - u)**(4 - i))
    assert [graph.evaluate([0.5])[0, 1] for graph in functions.bernstein(0).graph([1.0])] == [1.0]
    family = functions.hermite([0, 1])
    assert family.names == ("H_{0}", "H_{2}", "H_{1}", "H_{3}") and family.is_point == (True, False, True, False)
    closed = (lambda u: 2 * u**3 - 3 * u**2 + 1, lambda u: u**3 - 2 * u**2 + u, lambda u: -2 * u**3 + 3 * u**2, lambda u: u**3 - u**2)
    require_graphs(family, lambda i, u: closed[i](u))


def test_hermite_functions_of_a_chain_have_a_value_or_a_slope_at_one_node():
    nodes = np.array([0, 0.5, 2, 7.0])
    family = functions.hermite(nodes)
    for i, j in itertools.product(range(8), range(4)):
        (graph,) = family.graph(np.eye(8)[i])
        value, slope = graph.derivatives([nodes[j]], 1)[0]
        assert value[1] == pytest.approx(i == 2 * j, abs=1e-14) and slope[1] / slope[0] == pytest.approx(i == 2 * j + 1, abs=1e-13)


@pytest.mark.parametrize('nodes', ([0, 1], [0, 1, 2, 3, 4], [-2, 0, 0.1, 3], [1e3, 1e3 + 1, 1e3 + 4]))
def test_lagrange_is_the_product_and_natural_splines_are_those_of_scipy(nodes):
    require_graphs(functions.lagrange(nodes), lambda i, u: np.prod([(u - x) / (nodes[i] - x) for x in nodes if x != nodes[i]]), 1e-10)
    units = np.eye(len(nodes))
    if len(nodes) > 2:
        require_graphs(functions.natural(nodes), lambda i, u: CubicSpline(nodes, units[i], bc_type='natural')(u), 1e-12)


def curves():
    points = RNG.uniform(-1, 1, (9, 3))
    yield sc.NurbsCurve(3, [0, 0, 0, 0, 1, 3, 4, 4, 4, 4], points[:6], RNG.uniform(0.5, 2, 6))
    yield sc.NurbsCurve(3, [0, 1, 2, 2.5, 4, 5, 6], points[:6], periodic=True)
    yield sc.NurbsCurve(3, [0, 1, 2, 3.5], points[:3], periodic=True)
    yield sc.NurbsCurve(2, [0, 1, 1, 3.5, 4], points[:4], periodic=True)
    yield sc.BezierCurve(points[:5])
    yield sc.HermiteCurve(points[:4], points[4:8], [0, 1, 3, 3.5])


@pytest.mark.parametrize('curve', curves(), ids=lambda curve: f"{type(curve).__name__} {len(curve.points)}")
def test_a_curve_is_the_sum_of_its_points_by_its_functions(curve):
    """With weights those of numerator and denominator are summed."""
    family = functions.of_curve(curve)
    if isinstance(curve, sc.HermiteCurve):
        rows = np.stack([np.column_stack([curve.points, np.ones(4)]), np.column_stack([curve.tangents[:, 1], np.zeros(4)])], 1).reshape(-1, 4)
    else:
        weights = curve.weights if curve.weights is not None else np.ones(len(curve.points))
        rows = np.column_stack([curve.points * np.asarray(weights)[:, None], weights])
    u = at_inside(*curve.domain)
    found = np.zeros((len(u), 4))
    for column in range(4):
        (graph,) = family.graph(rows[:, column])
        found[:, column] = graph.evaluate(u)[:, 1]
    assert np.allclose(found[:, :3] / found[:, 3:], curve.evaluate(u), rtol=0, atol=1e-12)


def family_of(kind):
    return {'knots': lambda: functions.of_knots(2, [0, 1, 2, 3, 3, 4, 6, 7]), 'bernstein': lambda: functions.bernstein(3),
            'hermite': lambda: functions.hermite([0, 1, 3]), 'lagrange': lambda: functions.lagrange([0, 1, 2, 4]),
            'natural': lambda: functions.natural([0, 1, 2, 4])}[kind]()


@pytest.mark.parametrize('kind', ('knots', 'bernstein', 'hermite', 'lagrange', 'natural'))
def test_sums_and_stacks_end_at_one(kind):
    family = family_of(kind)
    first, last = (2, 4) if kind == 'knots' else (family.places[0], family.places[-1])
    scale = 5.0 / np.ptp(family.places)
    inside = (np.linspace(first, last, 30)[1:-1] - family.places[0]) * scale
    top = [graph for graph in functions.picture(family, 'stacked', 5.0, 2.0, False)][-1]
    total = [graph for graph in functions.picture(family, 'sum', 5.0, 2.0, False) if graph.name == functions.SUM]
    for graph in (top, *total):
        points = graph.curve.evaluate(np.linspace(*graph.curve.domain, 400))
        on = points[(points[:, 0] > inside[0]) & (points[:, 0] < inside[-1])]
        assert len(on) > 20 and np.allclose(on[:, 1], 2.0, rtol=0, atol=1e-11)
    stacked = functions.picture(family, 'stacked', 5.0, 2.0, False)
    assert len(stacked) == sum(functions.of_points(family) > 0)


def test_a_picture_has_its_size_axes_and_names():
    family = functions.of_knots(1, [1, 2, 2, 4])
    graphs = functions.picture(family, 'functions', 6.0, 3.0, True)
    assert [graph.name for graph in graphs[:2]] == ["N_{0,1}", "N_{1,1}"]
    assert [graph.name for graph in graphs[2:]] == [functions.AXIS] * 2 + ["tick 1", "tick 2", "tick 4", "tick 1"]
    points = np.concatenate([graph.curve.points for graph in graphs])
    assert points[:, 0].max() == 6.0 and points[:, 1].max() == 3.0
    assert {graph.curve.points[0, 0] for graph in graphs if graph.name.startswith(functions.TICK)} >= {0.0, 2.0, 6.0}


@pytest.mark.parametrize('degree, knots, wanted', ((3, range(8), (3, 4)), (2, [0, 0, 0, 1, 2, 2, 2], (0, 2)), (0, [1, 2, 5], (1, 5)), (2, [0, 1, 2, 3], None),
                                                   (2, [0, 1, 1, 1, 2], None)))
def test_the_domain_is_where_functions_add_up_to_1(degree, knots, wanted):
    family = functions.of_knots(degree, list(knots))
    assert family.domain == wanted
    parts = [part.curve for part in functions.picture(family, 'functions', np.ptp(list(knots)), 3.0, False, True) if part.name == functions.DOMAIN]
    if wanted is None:
        assert parts == []
        return
    corners = np.concatenate([part.points for part in parts])
    assert len(parts) == 4 and corners.min(axis=0).tolist() == [wanted[0] - knots[0], 0, 0] and corners.max(axis=0).tolist() == [wanted[1] - knots[0], 3, 0]
    u = at_inside(*wanted)
    assert np.allclose([sum(float(cox_de_boor(i, degree, [Fraction(knot) for knot in knots], Fraction(each))) for i in range(len(family.names))) for each in u], 1)
    assert [part.name for part in functions.picture(functions.hermite([1, 2, 4]), 'functions', 1.0, 1.0, False, True)].count(functions.DOMAIN) == 4


def test_functions_that_are_zero_are_named():
    family = functions.of_knots(0, [0, 1, 1, 2])
    assert functions.zero_functions(family) == ["N_{1,0}"]
    assert [graph.name for graph in functions.picture(family, 'functions', 1, 1, False)] == ["N_{0,0}", "N_{2,0}"]


@pytest.mark.parametrize('make, said', (
    (lambda: functions.of_knots(3, [0, 1, 2, 3]), "4 knots have no function of degree 3: at least 5 are needed"),
    (lambda: functions.of_knots(1, [0, 2, 1]), "must not decrease"), (lambda: functions.of_knots(1, [0, np.nan, 1]), "must not decrease"),
    (lambda: functions.of_knots(1, [1, 1, 1]), "all knots are equal"),
    (lambda: functions.of_knots(1, range(2000)), "1000 are the most"), (lambda: functions.lagrange([0]), "at least 2"),
    (lambda: functions.natural([0, 1, 1]), "must increase"), (lambda: functions.hermite([]), "at least 2")))
def test_what_makes_no_functions_is_refused(make, said):
    with pytest.raises(FAILURES.Refusal, match=said):
        make()


@pytest.mark.parametrize('size', (1e-150, 1e-6, 1e150))
@pytest.mark.parametrize('degree', (0, 1, 5, 9))
def test_pictures_do_not_depend_on_the_unit_of_knots(size, degree):
    knots = np.cumsum([0, 1, 0, 2, 0.5, 1, 1, 1, 3, 0, 1, 2, 1.0])
    for one, other in zip(*(functions.picture(functions.of_knots(degree, scale * knots), 'sum', 2.0, 1.0, True) for scale in (1.0, size))):
        assert np.allclose(one.curve.points, other.curve.points, rtol=0, atol=1e-12)


def test_the_highest_degree_and_many_functions_are_drawn():
    family = functions.of_knots(255, np.r_[np.zeros(256), np.ones(256)])
    (graph,) = family.graph(np.ones(256))
    assert np.allclose(graph.evaluate(np.linspace(0, 1, 9))[:, 1], 1.0, rtol=0, atol=1e-12)
    assert len(functions.picture(functions.of_knots(3, range(400)), 'functions', 1.0, 1.0, False)) == 396
