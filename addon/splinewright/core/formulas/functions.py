"""Graphs of basis functions (S2, S4, S5, S6, S14): of B-splines, Bernstein, Hermite, Lagrange and natural cubic splines.

A family knows the graph of any combination of its functions: (u, value, 0) as curves on its interval. Graphs are exact; those of
Lagrange and natural splines within rounding.
"""

import math
from itertools import pairwise
from typing import Callable, NamedTuple

import numpy as np

from ..base.failures import Refusal
from ..base.library import sc

#: Most functions of a family.
MOST = 1000
#: What the parts of a picture that are no functions are called.
AXIS, TICK, SUM, DOMAIN = "axis", "tick", "sum", "domain"


class Family(NamedTuple):
    """Functions of one parameter."""

    names: tuple                        # of each function, as TeX has it: N_{0,3}
    places: np.ndarray                  # growing: knots or nodes, each once, that the axis marks
    graph: Callable                     # (coefficients (n,)) -> curves (u, value, 0) over all of its interval
    supports: Callable                  # (number) -> the intervals (first, last) on which a function is not zero
    is_point: tuple = ()                # whether each function weighs a point: those add up to 1; () for all
    domain: tuple | None = ()           # (first, last) where they add up to 1; () for all of the interval, None for nowhere


class Part(NamedTuple):
    """A curve of a picture, and what it is."""

    name: str
    curve: object


def of_knots(degree, knots):
    """The Family of the B-spline basis functions N_{i,p} on all of its knots. Raises Refusal for knots that make none."""
    knots = np.asarray(knots, dtype=np.float64)
    count = len(knots) - degree - 1
    _require_knots(degree, knots, count)
    names = tuple(f"N_{{{i},{degree}}}" for i in range(count))

    graph = _steps(knots) if degree == 0 else _splines(degree, knots)
    domain = (knots[degree], knots[count]) if knots[degree] < knots[count] else None
    return Family(names, np.unique(knots), graph, lambda i: _interval(knots[i], knots[i + degree + 1]), domain=domain)


def of_curve(curve):
    """The Family by which a curve is the sum of its points: of a Bezier curve Bernstein's, of a chain Hermite's, else B-splines.
    Raises Refusal."""
    if isinstance(curve, sc.BezierCurve):
        return bernstein(curve.degree)
    if isinstance(curve, sc.HermiteCurve):
        return hermite(curve.parameters)
    return _periodic(curve) if curve.periodic else of_knots(curve.degree, curve.knots)


def _periodic(curve):
    """On the domain: a function that crosses the seam is there in two parts."""
    degree, count, (start, end) = curve.degree, len(curve.points), curve.domain
    unrolled = curve.unrolled()
    knots, numbers = np.array(unrolled.knots), np.arange(len(unrolled.points)) % count
    if count > MOST:
        raise Refusal("these are {count} functions: {most} are the most", count=count, most=MOST)
    averages = sc.basis.KnotVector(degree, knots).greville

    def graph(coefficients):
        whole = sc.NurbsCurve(degree, knots, _points(averages, np.asarray(coefficients)[numbers]))
        return [whole.part(start, end)]

    def supports(i):
        found = [(max(knots[j], start), min(knots[j + degree + 1], end)) for j in np.flatnonzero(numbers == i)]
        found = sorted(each for each in found if each[0] < each[1])
        return [(start, end)] if any(b[0] < a[1] for a, b in zip(found, found[1:])) else found
    names = tuple(f"N_{{{i},{degree}}}" for i in range(count))
    return Family(names, np.unique(knots[(knots >= start) & (knots <= end)]), graph, supports)


def _interval(first, last):
    """In a list; none where it is empty."""
    return [(first, last)] if first < last else []


def _require_knots(degree, knots, count):
    if count < 1:
        raise Refusal("{count} knots have no function of degree {degree}: at least {least} are needed",
                      "{count} knot has no function of degree {degree}: at least {least} are needed",
                      count=len(knots), degree=degree, least=degree + 2)
    if count > MOST:
        raise Refusal("these are {count} functions: {most} are the most", count=count, most=MOST)
    if not np.isfinite(knots).all() or (np.diff(knots) < 0).any():
        raise Refusal("knots must not decrease")
    if knots[0] == knots[-1]:
        raise Refusal("all knots are equal: there is no interval between them")


def _steps(knots):
    """Graphs of degree 0: a segment on each span that is not empty."""
    def graph(coefficients):
        spans = [(knots[i], knots[i + 1], value) for i, value in enumerate(coefficients) if knots[i] < knots[i + 1]]
        return [line((first, value), (last, value), (first, last)) for first, last, value in spans]
    return graph


def _splines(degree, knots):
    """Graphs on all knots: both ends are filled up to degree + 1 copies, by functions that have no part. Functions that are zero, on more
    copies of a knot than that, are left out."""
    is_there = knots[:-degree - 1] < knots[degree + 1:]
    values, copies = np.unique(knots, return_counts=True)
    before, after = (max(degree + 1 - int(copies[end]), 0) for end in (0, -1))
    filled = np.concatenate([np.full(before, knots[0]), np.repeat(values, np.minimum(copies, degree + 1)), np.full(after, knots[-1])])
    averages = sc.basis.KnotVector(degree, filled).greville

    def graph(coefficients):
        values = np.concatenate([np.zeros(before), np.asarray(coefficients)[is_there], np.zeros(after)])
        return [sc.NurbsCurve(degree, filled, _points(averages, values))]
    return graph


def bernstein(degree):
    """The Family of the Bernstein polynomials of a degree on [0, 1]."""
    if degree + 1 > MOST:
        raise Refusal("these are {count} functions: {most} are the most", count=degree + 1, most=MOST)
    at = np.linspace(0.0, 1.0, degree + 1)

    def graph(coefficients):
        if degree == 0:
            return [line((0.0, coefficients[0]), (1.0, coefficients[0]))]
        return [sc.BezierCurve(_points(at, coefficients)).to_nurbs()]
    return Family(tuple(f"B_{{{i},{degree}}}" for i in range(degree + 1)), np.array([0.0, 1.0]), graph, lambda i: [(0.0, 1.0)])


def hermite(nodes):
    """The Family of the cubic Hermite functions on nodes: for each node that of its point and that of its derivative."""
    nodes = _require_nodes(nodes, 2)
    if len(nodes) == 2:
        names = ("H_{0}", "H_{2}", "H_{1}", "H_{3}")
    else:
        names = tuple(name for i in range(len(nodes)) for name in (f"H_{{{i}}}", f"T_{{{i}}}"))

    def graph(coefficients):
        slopes = _points(np.ones(len(nodes)), coefficients[1::2])
        return [sc.HermiteCurve(_points(nodes, coefficients[0::2]), slopes, nodes).to_nurbs()]

    def supports(i):
        return [(nodes[max(i // 2 - 1, 0)], nodes[min(i // 2 + 1, len(nodes) - 1)])]
    return Family(names, nodes, graph, supports, tuple(i % 2 == 0 for i in range(len(names))))


def lagrange(nodes):
    """The Family of the Lagrange polynomials of nodes: 1 at one of them, 0 at the others."""
    nodes = _require_nodes(nodes, 2)

    def graph(coefficients):
        return [sc.build.polynomial_through(_points(nodes, coefficients), nodes)]
    return Family(tuple(f"L_{{{i}}}" for i in range(len(nodes))), nodes, graph, lambda i: [(nodes[0], nodes[-1])])


def natural(nodes):
    """The Family of the natural cubic splines that are 1 at one of the nodes and 0 at the others."""
    nodes = _require_nodes(nodes, 3)

    def graph(coefficients):
        return [sc.fit.interpolate(_points(nodes, coefficients), 3, nodes, ends='natural')[0]]
    return Family(tuple(f"s_{{{i}}}" for i in range(len(nodes))), nodes, graph, lambda i: [(nodes[0], nodes[-1])])


def _require_nodes(nodes, least):
    nodes = np.asarray(nodes, dtype=np.float64)
    if len(nodes) < least:
        raise Refusal("{count} nodes are too few: at least {least} are needed", "{count} node is not enough: at least {least} are needed",
                      count=len(nodes), least=least)
    if len(nodes) > MOST:
        raise Refusal("these are {count} functions: {most} are the most", count=len(nodes), most=MOST)
    if not np.isfinite(nodes).all() or not (np.diff(nodes) > 0).all():
        raise Refusal("nodes must increase")
    return nodes


def picture(family, show, width, height, has_axes, has_domain=False):
    """The Parts of a picture of a family: the functions, 'sum' with their sum, 'stacked' each upon the sum of those before.

    The interval is as wide as `width`, the value 1 as high as `height`; it begins at 0. has_domain: whether there is a rectangle on the
    part where functions add up to 1. Raises Refusal where nothing is to be seen.
    """
    shown = _stacked(family) if show == 'stacked' else _single(family)
    if show == 'sum':
        shown += [Part(SUM, curve) for curve in family.graph(of_points(family))]
    if not shown:
        raise Refusal("all functions are zero: their knots coincide")
    start = family.places[0]
    scale = width / (family.places[-1] - start)
    graphs = [Part(name, placed(curve, start, scale, height)) for name, curve in shown]
    return graphs + (_domain(family, scale, height) if has_domain else []) + (_axes(family.places, scale, height) if has_axes else [])


def zero_functions(family):
    """The names of functions that are zero everywhere."""
    return [name for i, name in enumerate(family.names) if not family.supports(i)]


def graphs_of(family, number):
    """The curves (u, value, 0) of one function, where it is not zero."""
    unit = np.eye(len(family.names))[number]
    return [part for support in family.supports(number) for curve in family.graph(unit) for part in _within(curve, *support)]


def _single(family):
    return [Part(name, part) for i, name in enumerate(family.names) for part in graphs_of(family, i)]


def _stacked(family):
    """Of functions that weigh points."""
    wanted, upto, shown = of_points(family), np.zeros(len(family.names)), []
    for i, name in enumerate(family.names):
        upto[i] = wanted[i]
        if wanted[i] and family.supports(i):
            shown += [Part(name, curve) for curve in family.graph(upto.copy())]
    return shown


def of_points(family):
    """(n,): 1 for each function that weighs a point, 0 for others."""
    return np.array(family.is_point or [True] * len(family.names), dtype=np.float64)


def _within(curve, first, last):
    """The part of a graph on an interval, in a list; none where it does not reach into that."""
    start, end = curve.domain
    first, last = max(first, start), min(last, end)
    if first >= last:
        return []
    return [curve if (first, last) == (start, end) else curve.part(first, last)]


def _domain(family, scale, height):
    if family.domain is None:
        return []
    first, last = ((u - family.places[0]) * scale for u in family.domain or family.places[[0, -1]])
    corners = [(first, 0.0), (first, height), (last, height), (last, 0.0), (first, 0.0)]
    return [Part(DOMAIN, line(*leg)) for leg in pairwise(corners)]


def _axes(places, scale, height):
    """The parameter's axis with a tick at each place, and the axis of values at its start with one at 1. Names of ticks end in their
    number."""
    at = (places - places[0]) * scale
    tick = 0.03 * max(at[-1], height)
    exact = digits(places, np.diff(places).min())
    ticks = [(f"{u:.{exact}g}", line((x, -tick), (x, 0.0))) for u, x in zip(places, at)]
    ticks.append(("1", line((-tick, height), (0.0, height))))
    axes = [line((0.0, 0.0), (at[-1], 0.0)), line((0.0, 0.0), (0.0, height))]
    return [Part(AXIS, one) for one in axes] + [Part(f"{TICK} {number}", one) for number, one in ticks]


def digits(values, step):
    """How many tell values that are a step apart, or more, from each other, also far from 0."""
    largest = np.abs(values).max(initial=0.0)
    return 6 if largest == 0.0 else min(17, max(6, math.floor(math.log10(largest)) - math.floor(math.log10(step)) + 2))


def placed(curve, start, scale, height):
    """A graph that begins at 0 instead of a start, as many times as wide and as high."""
    points = curve.points.copy()
    points[:, 0] = (points[:, 0] - start) * scale
    points[:, 1] *= height
    return curve.with_points(points)


def _points(x, y):
    return np.column_stack([x, y, np.zeros(len(x))])


def line(start, end, domain=(0.0, 1.0)):
    """A segment between points of two or three coordinates, over a domain."""
    return sc.NurbsCurve(1, np.repeat(domain, 2), [start, end])
