"""How far points lie from exact curves and patches, from places on these that are near: Newton's method, damped."""

from typing import NamedTuple

import numpy as np

from ..verbs.patch_verbs import Along
from .lines import ends_of

#: Steps in every span of a sample, at most.
_STEPS = 32
#: Steps of Newton's method: of few the distances of most points are exact, of all those of every one.
FEW, ALL = 4, 24
#: What shortens the square of a distance by so small a part of it is no step, nor what does by so little, in units of
#: the size of all.
_STILL, _NOTHING = 1e-15, 1e-31
#: A damped step has at least this much; below the least there is none.
_DAMPED, _LEAST_DAMPED = 1e-3, 1e-6
#: Of a matrix that cannot be inverted this part of its size is added.
_RIDGE = 1e-14
#: Samples so near to each other, as a part of the size of all, are one place; of one so many others are known at most.
_ONE_PLACE, _OTHERS = 1e-6, 3


class Samples(NamedTuple):
    """Points on pieces, and the triangles between them; of a curve's lines the last two corners are one."""

    points: np.ndarray                  # (n, 3)
    triangles: np.ndarray               # (t, 3)
    owners: np.ndarray                  # (n,): the numbers of their pieces
    places: np.ndarray                  # (n, k): parts of the domain
    others: np.ndarray                  # (n, _OTHERS): those of the same place where a piece ends, -1 where there is none


def samples(pieces, most):
    """The Samples of curves, or of patches, with about a given number of triangles, or one for every span where those are more."""
    axes = [_axes(piece) for piece in pieces]
    spans = sum(int(np.prod([len(ends_of(along)) - 1 for along in each])) for each in axes)
    room = most / max(spans, 1)
    steps = int(np.clip(np.sqrt(room / 2) if len(axes[0]) == 2 else room, 1, _STEPS))
    found, triangles, count = [], [], 0
    for number, (piece, each) in enumerate(zip(pieces, axes)):
        points, places, between = _sampled(piece, [_parts(along, steps) for along in each])
        found.append((points, places, np.full(len(points), number)))
        triangles.append(count + between)
        count += len(points)
    points, places, owners = map(np.concatenate, zip(*found))
    triangles = np.concatenate(triangles)
    is_whole = np.isfinite(points[triangles]).all((1, 2))
    return Samples(points, triangles[is_whole], owners, places, _others(points, places))


def distances(pieces, known, hits, feet, points, rounds=ALL):
    """(n,): how far points (n, 3) lie from the pieces whose Samples are known.

    hits, feet: of each point the nearest triangle of the samples, and the place on it. rounds: steps of the method.
    """
    size = extent(known.points)[1]
    corners = known.triangles[hits]
    shares = _shares(known.points[corners], feet)
    starts = (shares[..., None] * known.places[corners]).sum(1)
    found, ends = _nearest(pieces, known.owners[corners[:, 0]], starts, points, size, rounds)
    is_at_end = ((ends <= 0.0) | (ends >= 1.0)).any(1)
    off = np.abs(known.places[corners] - ends[:, None]).max(-1) + (known.others[corners, 0] < 0)
    beside = known.others[corners[np.arange(len(corners)), off.argmin(1)]]
    for column in range(_OTHERS):
        again = np.flatnonzero(is_at_end & (beside[:, column] >= 0))
        if len(again):
            other = beside[again, column]
            better, _ = _nearest(pieces, known.owners[other], known.places[other], points[again], size, rounds)
            found[again] = np.fmin(found[again], better)
    return found


def extent(points):
    """(the middle of points (n, 3), how far the farthest coordinate is from it): of those that are finite."""
    finite = points[np.isfinite(points).all(1)]
    if not len(finite):
        return np.zeros(3), 1.0
    low, high = finite.min(0), finite.max(0)
    middle = low + (high - low) / 2
    return middle, float(np.abs(finite - middle).max()) or 1.0


def _axes(piece):
    return (Along(piece, 'u'), Along(piece, 'v')) if hasattr(piece, 'isocurve') else (piece,)


def _parts(along, steps):
    """Of the domain: where spans end, and a given number of steps between."""
    ends = ends_of(along)
    ends = (ends - ends[0]) / (ends[-1] - ends[0])
    inner = ends[:-1, None] + np.arange(steps) / steps * np.diff(ends)[:, None]
    return np.append(inner.ravel(), 1.0)


def _sampled(piece, parts):
    """(points, places, triangles)."""
    at = [start + part * (end - start) for part, (start, end) in zip(parts, _domain(piece))]
    if len(parts) == 1:
        first = np.arange(len(parts[0]) - 1)
        return piece.evaluate(at[0], at_infinity='nan'), parts[0][:, None], np.stack([first, first + 1, first + 1], -1)
    points = piece.evaluate_grid(*at, at_infinity='nan').reshape(-1, 3)
    places = np.stack(np.meshgrid(*parts, indexing='ij'), -1).reshape(-1, 2)
    number = np.arange(len(points)).reshape(len(parts[0]), len(parts[1]))
    a, b, c, d = (each.ravel() for each in (number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:]))
    return points, places, np.concatenate([np.stack([a, b, c], -1), np.stack([a, c, d], -1)])


def _domain(piece):
    """((start, end),) or a pair of them."""
    return piece.domain if hasattr(piece, 'isocurve') else (piece.domain,)


def _others(points, places):
    """Samples.others."""
    found = np.full((len(points), _OTHERS), -1)
    middle, size = extent(points)
    at_end = np.flatnonzero(((places == 0.0) | (places == 1.0)).any(1) & np.isfinite(points).all(1))
    rounded = np.round((points[at_end] - middle) / (size * _ONE_PLACE))
    _, place = np.unique(rounded, axis=0, return_inverse=True)
    order = np.argsort(place.ravel(), kind='stable')
    at_end, place = at_end[order], place.ravel()[order]
    for column in range(_OTHERS):
        # One of so many at a place sees the next ones, and after the last the first.
        first = np.searchsorted(place, place)
        count = np.searchsorted(place, place, 'right') - first
        there = column + 1 < count
        next_ = first + (np.arange(len(place)) - first + column + 1) % count
        found[at_end[there], column] = at_end[next_[there]]
    return found


def _shares(corners, feet):
    """(n, 3): the shares that corners (n, 3, 3) have in places on their triangles, which may be lines."""
    a, b = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    size = np.abs(corners - corners[:, :1]).max((1, 2), initial=0.0)
    with np.errstate(all='ignore'):
        a, b, to = (each / size[:, None] for each in (a, b, feet - corners[:, 0]))
        aa, ab, bb, ta, tb = ((x * y).sum(1) for x, y in ((a, a), (a, b), (b, b), (to, a), (to, b)))
        over = aa * bb - ab * ab
        is_flat = ~(over > 1e-12 * aa * bb)
        s = np.where(is_flat, np.where(aa >= bb, ta / aa, 0.0), (bb * ta - ab * tb) / over)
        t = np.where(is_flat, np.where(aa >= bb, 0.0, tb / bb), (aa * tb - ab * ta) / over)
    shares = np.nan_to_num(np.stack([1.0 - s - t, s, t], -1), nan=0.0, posinf=0.0, neginf=0.0).clip(0.0, 1.0)
    total = shares.sum(1, keepdims=True)
    return np.where(total > 0.0, shares / np.where(total > 0.0, total, 1.0), 1 / 3)


def _nearest(pieces, owners, starts, points, size, rounds):
    """(how far points lie from the places that Newton's method finds from starts, these places)."""
    found, ends = np.empty(len(points)), np.empty_like(starts)
    for number in np.unique(owners):
        here = owners == number
        found[here], ends[here] = _newton(pieces[number], starts[here], points[here] / size, size, rounds)
    return found * size, ends


def _newton(piece, at, points, size, rounds):
    """The same of one piece, in units of size."""
    at, damping = at.clip(0.0, 1.0), np.zeros(len(at))
    jet = _jet(piece, at, points, size)
    going = np.arange(len(at))
    for _ in range(rounds):
        away, first, second = (rows[going] for rows in jet)
        gradient = (first * away[:, None]).sum(-1)
        trial = (at[going] + _step(at[going], gradient, away, first, second, damping[going])).clip(0.0, 1.0)
        gain = ((at[going] - trial) * gradient).sum(1)
        moves = gain > _STILL * (away * away).sum(1) + _NOTHING
        going, trial = going[moves], trial[moves]
        if not len(going):
            break
        new = _jet(piece, trial, points[going], size)
        is_nearer = (new[0] ** 2).sum(1) < (jet[0][going] ** 2).sum(1)
        taken = going[is_nearer]
        at[taken] = trial[is_nearer]
        for rows, fresh in zip(jet, new):
            rows[taken] = fresh[is_nearer]
        eased = damping[taken] / 10
        damping[taken] = np.where(eased < _LEAST_DAMPED, 0.0, eased)
        refused = going[~is_nearer]
        damping[refused] = np.maximum(10 * damping[refused], _DAMPED)
    return np.linalg.norm(jet[0], axis=1), at


def _step(at, gradient, away, first, second, damping):
    """(n, k): what leads nearer; where a border is in the way, along it."""
    plain = first @ first.swapaxes(1, 2)
    bent = plain + (second * away[:, None, None]).sum(-1)
    is_cup = (bent[:, 0, 0] > 0.0) & (np.linalg.det(bent) > 0.0)
    matrix = np.where(is_cup[:, None, None], bent, plain)
    stays = ((at <= 0.0) & (gradient > 0.0)) | ((at >= 1.0) & (gradient < 0.0))
    matrix = np.where(stays[:, :, None] | stays[:, None, :], 0.0, matrix)
    gradient = np.where(stays, 0.0, gradient)
    size = np.abs(matrix).max((1, 2))
    size = np.where(size > 0.0, size, 1.0)
    diagonal = np.einsum('nkk->nk', matrix)
    ridge = np.where(stays, size[:, None], damping[:, None] * diagonal + _RIDGE * size[:, None])
    whole = matrix + ridge[..., None] * np.eye(matrix.shape[1])
    is_known = np.isfinite(whole).all((1, 2)) & np.isfinite(gradient).all(1)
    whole = np.where(is_known[:, None, None], whole, np.eye(matrix.shape[1]))
    return -np.linalg.solve(whole, np.where(is_known[:, None], gradient, 0.0)[..., None])[..., 0]


def _jet(piece, at, points, size):
    """[from points to places on a piece (n, 3), the derivatives there (n, k, 3), the second ones (n, k, k, 3)], by parts
    of the domain."""
    domain = _domain(piece)
    widths = np.array([end - start for start, end in domain])
    where = [start + part * width for part, (start, _), width in zip(at.T, domain, widths)]
    found = piece.derivatives(*where, 2, at_infinity='nan') / size
    if len(widths) == 1:
        return [found[:, 0] - points, found[:, 1:2] * widths[0], found[:, 2][:, None, None] * widths[0] ** 2]
    first = np.stack([found[:, 1, 0], found[:, 0, 1]], 1) * widths[:, None]
    second = np.stack([np.stack([found[:, 2, 0], found[:, 1, 1]], 1), np.stack([found[:, 1, 1], found[:, 0, 2]], 1)], 1)
    return [found[:, 0, 0] - points, first, second * np.multiply.outer(widths, widths)[..., None]]
