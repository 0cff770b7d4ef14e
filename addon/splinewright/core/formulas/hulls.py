"""Convex hulls of the control points of curves and patches, and what neighboring ones have in common (S12, S13)."""

from itertools import combinations, pairwise, product

import numpy as np

from ..base.failures import Refusal
from . import convex, signs
from .functions import Part

#: Most hulls of a picture, and most points of one.
MOST, MOST_POINTS = 300, 2000
#: Most intersections.
MOST_PAIRS = 600


def groups(shapes, by_spans):
    """[[(n, 4)]]: for each curve or patch the homogeneous points that act on a span after the other, or all of them. Raises Refusal for too
    many."""
    found = [_groups(shape.to_nurbs(), by_spans) for shape in shapes]
    count, most = sum(map(len, found)), max(len(rows) for each in found for rows in each)
    if count > MOST:
        raise Refusal("these are {count} hulls: {most} are the most", count=count, most=MOST)
    if most > MOST_POINTS:
        raise Refusal("a hull of {count} points: {most_points} are the most", count=most, most_points=MOST_POINTS)
    return found


def neighbors(shapes, found, by_spans):
    """For each of groups() the pairs of its hulls that are neighbors: of spans that meet; of whole shapes see whole()."""
    return [_neighboring_spans(shape.to_nurbs(), len(each)) if by_spans else [] for shape, each in zip(shapes, found)]


def whole(found, are_curves):
    """(groups() of whole shapes as one group, its pairs of neighbors): each curve and the next one, patches that share a border."""
    rows = [each[0] for each in found]
    if are_curves:
        return [rows], [[*pairwise(range(len(rows)))]]
    points = [set(map(tuple, each.tolist())) for each in rows]
    return [rows], [[(i, j) for i, j in combinations(range(len(rows)), 2) if len(points[i] & points[j]) > 1]]


def picture(found, show, radius, neighboring):
    """(the Parts "hull 0", "hull 1", …, and "intersection" of neighbors; a warning or ""). show: 'hulls', 'intersections' or
    'both'; radius: of crosses where something is a point; neighboring: for each of the groups the pairs of hulls that are neighbors. Raises
    Refusal where nothing is drawn."""
    hulls = [[_hull(rows) for rows in rows_of_one] for rows_of_one in found]
    shown = []
    if show != 'intersections':
        numbered = enumerate(one for each in hulls for one in each)
        shown += [part for i, one in numbered if one is not None for part in _drawn(f"hull {i}", one, radius)]
    if show != 'hulls':
        pairs = [(each[i], each[j]) for each, numbers in zip(hulls, neighboring) for i, j in numbers]
        if len(pairs) > MOST_PAIRS:
            raise Refusal("these are {count} pairs of neighboring hulls: {most_pairs} are the most", count=len(pairs), most_pairs=MOST_PAIRS)
        common = [convex.intersection(*pair) for pair in pairs if None not in pair]
        shown += [part for one in common if one is not None for part in _drawn("intersection", one, radius)]
    if not shown:
        why = "no two neighboring hulls have a point in common" if show == 'intersections' else "all hulls are points: a marker with a radius shows them"
        raise Refusal(why)
    weights = np.concatenate([rows[:, 3] for each in found for rows in each])
    return shown, "weights are not all above 0: the shape may leave its hulls" if (weights <= 0.0).any() else ""


def _groups(shape, by_spans):
    rows = shape.homogeneous_points
    if not by_spans:
        return [rows.reshape(-1, 4)]
    whole = shape.unrolled()
    rows = whole.homogeneous_points
    if rows.ndim == 2:
        return [rows[span - whole.degree:span + 1] for span in _spans(whole.knots, whole.degree)]
    spans = product(*map(_spans, whole.knots, whole.degree))
    return [rows[i - whole.degree[0]:i + 1, j - whole.degree[1]:j + 1].reshape(-1, 4) for i, j in spans]


def _spans(knots, degree):
    """Numbers of the knots at which the spans of the domain begin that are not empty."""
    return [i for i in range(degree, len(knots) - degree - 1) if knots[i] < knots[i + 1]]


def _hull(rows):
    """Of the points that are not at infinity; None where all are."""
    finite = rows[rows[:, 3] != 0.0]
    return convex.hull(finite[:, :3] / finite[:, 3:]) if len(finite) else None


def _neighboring_spans(shape, count):
    """Pairs of numbers: along a curve, along both parameters of a patch."""
    if shape.homogeneous_points.ndim == 2:
        return _in_row(range(count), shape.periodic)
    unrolled = shape.unrolled()
    across = len(_spans(unrolled.knots[1], unrolled.degree[1]))
    numbers = np.arange(count).reshape(-1, across)
    return [pair for rows, is_closed in ((numbers.T, shape.periodic[0]), (numbers, shape.periodic[1])) for row in rows for pair in _in_row(row, is_closed)]


def _in_row(numbers, is_closed):
    numbers = [int(number) for number in numbers]
    return [*pairwise(numbers)] + ([(numbers[-1], numbers[0])] if is_closed and len(numbers) > 2 else [])


def _drawn(name, one, radius):
    if one.rank == 0:
        return [Part(name, part.curve) for part in signs.cross("", one.corners[0], radius)]
    return [Part(name, signs.polyline(one.corners[trail])) for trail in _trails(one.edges)]


def _trails(edges):
    """Numbers of corners along lines that have each edge once."""
    following = {}
    for a, b in edges:
        following.setdefault(a, []).append(b)
        following.setdefault(b, []).append(a)
    for start in sorted(following, key=lambda corner: len(following[corner]) % 2 == 0):
        while following[start]:
            trail = [start]
            while following[trail[-1]]:
                here, other = trail[-1], following[trail[-1]].pop()
                following[other].remove(here)
                trail.append(other)
            yield trail
