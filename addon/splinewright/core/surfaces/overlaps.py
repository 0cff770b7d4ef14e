"""Where surfaces that were made cross themselves, in words: nothing is refused for that, but it is to be told. Of rails and of thick
surfaces are sampled all over, so that anything much smaller than the gaps between samples is not seen."""

import itertools

import numpy as np

from ..base import decimals
from ..base.library import sc
from ..base.words import phrase

#: Of what differs by rounding, as a part of the size.
_SAME = 1e-9
#: Places in a span, along a rail and round it, at which a surface is looked at.
_ALONG, _ROUND = 24, 12
#: Of a side of a thick surface, in each of its spans; and how much nearer to the surface than its distance it is to come.
_ACROSS, _NEARER = 4, 0.99
#: Of so many places each is looked at.
_MOST = 4000


def of_profile(curves, way, cancel=None):
    """Of what curves make that move along a way (3,): where they cross themselves or each other, seen along it."""
    flat = [_seen_along(curve, way) for curve in curves]
    for number, (curve, seen) in enumerate(zip(curves, flat), 1):
        at, problem = _told(lambda: _met(seen.self_intersections(cancel=cancel), curve, curve, way))
        if at or problem:
            yield _of_itself(_named(number, len(curves)), at, problem)
    for (i, a), (k, b) in itertools.combinations(enumerate(flat), 2):
        if _are_apart(a, b):
            continue
        at, problem = _told(lambda: _met(a.intersections(b, cancel=cancel), curves[i], curves[k], way))
        if at or problem:
            both = phrase("curves {i} and {k} of {count}", i=i + 1, k=k + 1, count=len(curves))
            yield (phrase("{both} cross at u = {first} and u = {second}: so do the surfaces",
                          both=both, first=_text(at[0]), second=_text(at[1])) if at
                   else phrase("whether {both} cross is not told: {problem}", both=both, problem=problem))
            return


def _told(find):
    """(the overlap, or None, why that is unknown)."""
    try:
        return find(), ""
    except (sc.InvalidShape, sc.ToleranceNotReached) as error:
        return None, str(error)


def _named(number, count):
    return "the curve" if count == 1 else phrase("curve {number} of {count}", number=number, count=count)


def _of_itself(whose, at, problem):
    if problem:
        return phrase("whether {whose} crosses itself is not told: {problem}", whose=whose, problem=problem)
    return phrase("{whose} crosses itself at u = {first} and u = {second}: so does the surface",
                  whose=whose, first=_text(at[0]), second=_text(at[1]))


def _seen_along(curve, way):
    """A curve on a plane at right angles to a way."""
    along = np.asarray(way, dtype=np.float64) / (np.linalg.norm(way) or 1.0)
    return curve.to_nurbs().transformed(np.column_stack([np.eye(3) - np.outer(along, along), np.zeros(3)]))


def _met(found, first, second, way):
    """(parameter, parameter) of the first place where curves cross as they are seen, and are no farther from each other along the
    way than that is long; or None."""
    length = np.linalg.norm(way)
    for (a, b), is_touch in zip(found.parameters, found.touches):
        height = abs((first.to_nurbs().evaluate(b if first is second else a) - second.to_nurbs().evaluate(a if first is second else b))
                     @ way) / (length or 1.0)
        if not is_touch and height <= length * (1.0 - _SAME):
            return float(a), float(b)
    return None


def _are_apart(a, b):
    low, high = zip(*((one.points.min(axis=0), one.points.max(axis=0)) for one in (a, b)))
    return bool((np.maximum(*low) > np.minimum(*high)).any())


def of_turned(curves, through, direction, sweep, cancel=None):
    """Of the surface that curves make around an axis: where they cross it, or themselves."""
    for number, curve in enumerate(curves, 1):
        whose = _named(number, len(curves))
        at = _crosses_axis(curve.to_nurbs(), through, direction) if abs(sweep) > np.pi else None
        if at is not None:
            yield phrase("{whose} crosses the axis at u = {u}: the surface goes through itself", whose=whose, u=_text(at))
        at, problem = _told(lambda: _first_crossing(curve.self_intersections(cancel=cancel)))
        if at or problem:
            yield _of_itself(whose, at, problem)


def _first_crossing(found):
    return next(((float(a), float(b)) for (a, b), is_touch in zip(found.parameters, found.touches) if not is_touch), None)


def _crosses_axis(curve, through, direction):
    """The parameter at which a curve in a plane with an axis goes over to its other side, or None."""
    along = np.asarray(direction) / np.linalg.norm(direction)

    def away(at):
        from_axis = curve.evaluate(at) - through
        return from_axis - np.multiply.outer(from_axis @ along, along)

    at = _places(curve.knots, curve.domain, _ALONG)
    places = away(at)
    size = np.abs(places).max()
    side = places @ places[np.linalg.norm(places, axis=1).argmax()]
    if not size > 0.0 or np.linalg.matrix_rank(places, tol=_SAME * size * len(places)) > 1:
        return None
    side[np.abs(side) <= _SAME * size * size] = 0.0
    known = np.flatnonzero(side)
    changes = [(at[i], at[k]) for i, k in zip(known[:-1], known[1:]) if side[i] * side[k] < 0.0]
    if not changes:
        return None
    low, high = changes[0]
    first = away(low)
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if away(middle) @ first > 0.0 else (low, middle)
    return 0.5 * (low + high)


def of_rail(patch, rail):
    """Of what sections make that move along a rail, v along it: where that bends so much that they go back."""
    (start, end), domain = rail.domain, patch.domain
    v = _places(rail.knots, rail.domain, _ALONG)
    along = rail.derivatives(v, 1)[:, 1]
    places = domain[1][0] + (v - start) / (end - start) * (domain[1][1] - domain[1][0])
    u = _places(patch.knots[0], domain[0], _ROUND)
    grid_u, grid_v = np.meshgrid(u, places, indexing='ij')
    jets = patch.derivatives(grid_u.ravel(), grid_v.ravel(), 1, at_infinity='nan')[:, 0, 1].reshape(len(u), len(v), 3)
    forward = np.einsum('ijk,jk->ij', jets, along)
    back = forward < -_SAME * np.nanmax(np.abs(forward))
    if back.any():
        i = int(np.nanargmin(np.where(back, forward, np.inf).min(axis=0)))
        bend = float(rail.curvature([v[i]])[0])
        radius = phrase(" with a radius of {bend}", bend=decimals.text_of(1.0 / bend)) if bend > 0.0 else ""
        yield phrase("the curve bends{radius} at u = {text}: the surface folds there", radius=radius, text=_text(v[i]))


def of_thick(patch, other, distance):
    """Of a side at a distance from a patch, along its normals: where that passes through another part of the space between them."""
    patch, other = patch.to_nurbs(), other.to_nurbs()
    at = [_places(knots, domain, _ACROSS) for knots, domain in zip(other.knots, other.domain)]
    step = 1 + len(at[0]) * len(at[1]) // _MOST
    grid_u, grid_v = (grid.ravel()[::step] for grid in np.meshgrid(*at, indexing='ij'))
    points = other.evaluate_grid(*at).reshape(-1, 3)[::step]
    nearest = patch.nearest(points)
    for i in np.argsort(nearest.distances):
        if not nearest.distances[i] < _NEARER * abs(distance):
            return
        foot = nearest.parameters[i]
        away = points[i] - patch.evaluate(*foot)
        normal = patch.evaluate_grid_with_normals([foot[0]], [foot[1]])[1].ravel()
        if (away @ normal) * distance > 0.0:
            yield (phrase("at u = {u}, v = {v} it comes as near as {distance} to another part of the surface: it goes "
                          "through itself there",
                          u=_text(grid_u[i]), v=_text(grid_v[i]), distance=decimals.text_of(nearest.distances[i])))
            return


def _places(knots, domain, count):
    """Parameters in all spans: a given number in each, and fewer where there are many."""
    ends = np.unique(np.clip(knots, *domain))
    count = max(2, min(count, _MOST // (8 * len(ends))))
    return np.unique(np.concatenate([np.linspace(a, b, count + 1) for a, b in zip(ends[:-1], ends[1:])]))


def _text(number):
    return decimals.text_of(float(number))
