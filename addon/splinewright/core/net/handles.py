"""Handle types of chains, as Blender has them: where handles are computed from their neighbors, and whether they lie so.

Types are kept as letters, two to a joint: of the handle before it, and of the one after it. A type is kept as long as it is
true of where its handle lies: what moves handles otherwise makes them aligned or free.
"""

from typing import NamedTuple

import numpy as np

from ..base.failures import Refusal
from .curve_net import is_closed, is_plain_cubic

FREE, AUTO, VECTOR, ALIGNED = 'F', 'A', 'V', 'L'
#: What Blender calls them.
NAMES = {FREE: 'FREE', AUTO: 'AUTO', VECTOR: 'VECTOR', ALIGNED: 'ALIGNED'}
LETTERS = {name: letter for letter, name in NAMES.items()}

#: Blender's: an automatic handle is as long as the way to the neighbor by this, and that way counts as so many times the
#: other one at most.
_LENGTH, _MOST = 2.5614, 5.0
#: Directions that cancel each other out to this part of them say nothing.
_NO_DIRECTION = 1e-6
#: A handle that is nearer to where its type has it, as a part of the largest coordinate around, lies there: it is Blender's
#: rounding.
_ROUNDING = 16 * float(np.finfo(np.float32).eps)
#: Parts of a domain that differ by less are one place.
_ONE_PLACE = 1e-9


def automatic(points, closed):
    """(n, 2, 3): where the handles before and after each of the points (n, 3) lie that are of the type AUTO; nan where that
    is not told. Two points or more."""
    scale = _scale_of(points)
    along, lengths = _halfway(points / scale, closed, 1.0 / scale)
    size = np.linalg.norm(along, axis=1)
    with np.errstate(divide='ignore', invalid='ignore'):
        arms = along[:, None] * (lengths * [-1.0, 1.0] / (_LENGTH * size[:, None]))[..., None]
    arms[size < _NO_DIRECTION] = np.nan
    return points[:, None] + scale * arms


def _halfway(points, closed, one):
    """(the sums of the directions to and from the points (n, 3), (n, 2) how far it is, as it counts for handles); `one` is
    the distance 1, which Blender takes for one of 0."""
    before, after = _ways(points, closed)
    lengths = np.stack([np.linalg.norm(before, axis=1), np.linalg.norm(after, axis=1)], 1)
    lengths[lengths == 0.0] = one
    along = after / lengths[:, 1:] + before / lengths[:, :1]
    lengths[:, 0] = np.minimum(lengths[:, 0], _MOST * lengths[:, 1])
    lengths[:, 1] = np.minimum(lengths[:, 1], _MOST * lengths[:, 0])
    return along, lengths


def towards(points, closed):
    """(n, 2, 3): where those of the type VECTOR lie, at a third of the way to the neighbor."""
    before, after = _ways(points, closed)
    return points[:, None] + np.stack([-before, after], 1) / 3.0


def in_line(triples):
    """(n, 2, 3): where the handles of joints (n, 3, 3) lie that are ALIGNED: opposite to the other, as long as they are; nan
    where the other has no direction."""
    scale = _scale_of(triples)
    arms = (triples[:, ::2] - triples[:, 1:2]) / scale
    lengths = np.linalg.norm(arms, axis=2, keepdims=True)
    with np.errstate(divide='ignore', invalid='ignore'):
        turned = -arms[:, ::-1] / lengths[:, ::-1] * lengths
    turned[~(lengths[:, ::-1] > 0.0)[:, :, 0]] = np.nan
    return triples[:, 1:2] + scale * turned


def _ways(points, closed):
    """(n, 3) twice: the ways from the neighbors before, and to those after; at open ends both are one."""
    steps = np.roll(points, -1, 0) - points
    if not closed:
        steps[-1] = steps[-2]
    before = np.roll(steps, 1, 0)
    if not closed:
        before[0] = steps[0]
    return before, steps


def _scale_of(points):
    """A power of two: a number divided by it can be squared and added."""
    return 2.0 ** np.frexp(max(float(np.abs(points).max(initial=0.0)), 1e-300))[1]


def true(triples, letters, closed):
    """Of the letters of joints (n, 3, 3) those that are true. An AUTO handle that lies elsewhere is ALIGNED, if it is in
    line with the other, and a handle of another type FREE."""
    known = _pairs(letters)
    is_automatic, is_vector, is_in_line, is_opposite = _lie(triples, closed)
    found = np.where((known == VECTOR) & ~is_vector, FREE, known)
    is_other = (known == AUTO) & ~is_automatic
    found = np.where(is_other, np.where(is_opposite, ALIGNED, FREE), found)
    is_bent = (found == ALIGNED) & ~is_in_line & (found[:, ::-1] != FREE)
    return "".join(np.where(is_bent, FREE, found).ravel().tolist())


def _lie(triples, closed):
    """(n, 2) bool, four times: which handles of joints lie where AUTO, VECTOR and ALIGNED would have them, but for Blender's
    rounding; and which of the last have a direction."""
    points, scale = triples[:, 1], _scale_of(triples)
    size = np.linalg.norm(_halfway(points / scale, closed, 1.0 / scale)[0], axis=1)
    near = _ROUNDING * _reach(triples, closed)[:, None]
    far = near / np.clip(size, _NO_DIRECTION, 1.0)[:, None]
    aligned, lengths = in_line(triples), np.linalg.norm((triples[:, ::2] - points[:, None]) / scale, axis=2)
    with np.errstate(divide='ignore', invalid='ignore'):
        longer = np.fmax(lengths / lengths[:, ::-1], 1.0)       # a short one says little of the direction

    def lie(places, within):
        with np.errstate(invalid='ignore'):
            return ~(np.abs(triples[:, ::2] - places).max(2) > within)      # nan is anywhere
    is_in_line = lie(aligned, near * longer)
    return (lie(automatic(points, closed), far), lie(towards(points, closed), near), is_in_line,
            is_in_line & np.isfinite(aligned).all(2))


def _reach(triples, closed):
    """(n,): the largest coordinate of each joint and its neighbors."""
    own = np.abs(triples).max((1, 2))
    before, after = np.roll(own, 1), np.roll(own, -1)
    if not closed:
        before[0] = after[-1] = 0.0
    return np.maximum(own, np.maximum(before, after))


# Of a definition ----------------------------------------------------------------------------------------------------


def joints(definition, piece):
    """(n,): at which parts of its domain a piece of a curve has joints with handles; () where it has none."""
    if piece.kind == 'hermite':
        knots = piece.knots[0]
        at = (knots - knots[0]) / (knots[-1] - knots[0])
        return at[:-1] if is_closed(piece) else at
    return np.array([0.0, 1.0]) if is_plain_cubic(definition.pool, piece) else np.empty(0)


def plain(definition, piece):
    """The letters of the joints of a piece of which nothing is said: smooth ones are aligned."""
    if piece.kind != 'hermite':
        return FREE * 2 * len(joints(definition, piece))
    _, incoming, outgoing = piece.indices
    arriving = np.append(incoming[-1:], incoming[1:-1]) if is_closed(piece) else incoming
    return "".join(2 * (ALIGNED if a == b else FREE) for a, b in zip(arriving, outgoing))


def said(definition, types, before):
    """The types of pieces, "" for those of which nothing was said before and that are as plain() says."""
    return tuple("" if not was and letters == plain(definition, piece) else letters
                 for letters, was, piece in zip(types, before, definition.pieces))


def of_net(net, types):
    """(n,) of each vertex of a core.net.exact_net.Net the letter of the handle that it is, "" of others. types: of the
    pieces; missing or wrong types follow from where the handles lie."""
    letters = np.zeros(len(net.rows), '<U1')
    for first, spline in net.chains:
        if types[spline.piece]:
            letters[first:first + 3 * spline.count].reshape(-1, 3)[:, ::2] = _pairs(types[spline.piece])
    return true_of_net(net, letters)


def true_of_net(net, letters):
    """The letters (n,) of the vertices of a net that are true; of handles that have none what they look like."""
    found = letters.copy()
    for first, spline in net.chains:
        last = first + 3 * spline.count
        own = found[first:last].reshape(-1, 3)
        unsaid = np.repeat(np.where(spline.smooth, ALIGNED, FREE)[:, None], 2, 1)
        pairs = np.where(own[:, ::2] == "", unsaid, own[:, ::2])
        own[:, ::2] = _pairs(true(net.positions[first:last].reshape(-1, 3, 3), "".join(pairs.ravel()), spline.closed))
    return found


def of_vertices(net, letters):
    """The types of the pieces of a net, from the letters of its vertices."""
    types = [""] * len(net.source.pieces)
    for first, spline in net.chains:
        types[spline.piece] = "".join(letters[first:first + 3 * spline.count].reshape(-1, 3)[:, ::2].ravel().tolist())
    return tuple(types)


def _pairs(letters):
    return np.array(list(letters)).reshape(-1, 2)


def moved(triple, letters, given):
    """(a joint (3, 3), the letters of its handles) after parts of it were given places: 0 is the handle before, 1 the point,
    which takes its handles along, 2 the handle after. As in Blender: an automatic handle becomes aligned, one that points
    to the neighbor free, and an aligned one turns with the other."""
    after = triple.copy()
    if 1 in given:
        after += given[1] - triple[1]
    near = _ROUNDING * np.abs(after).max()
    sides = [side for side in (0, 2) if side in given and np.abs(given[side] - after[side]).max() > near]
    for side in {0, 2} & set(given):
        after[side] = given[side]
    if not sides:
        return after, letters
    pair = [ALIGNED if letter == AUTO else FREE if letter == VECTOR and side in sides else letter
            for side, letter in zip((0, 2), letters)]
    if len(sides) == 2:
        return after, tuple(true(after[None].repeat(2, 0), "".join(pair) * 2, False)[:2])
    other = 2 - sides[0]
    if pair[other // 2] == ALIGNED and FREE not in pair:
        turned = in_line(after[None])[0, other // 2]
        after[other] = np.where(np.isnan(turned), after[other], turned)
    return after, tuple(pair)


def require_valid(types, definition):
    """Raises Refusal unless these are types of a definition: of each piece a text, "" where nothing is said."""
    if not isinstance(types, tuple) or len(types) != len(definition.pieces):
        raise Refusal("there are others than the shape has pieces")
    for letters, piece in zip(types, definition.pieces):
        if type(letters) is not str or set(letters) - set(NAMES):
            raise Refusal("one is none of the four")
        if letters and not (definition.has_curves and len(letters) == 2 * len(joints(definition, piece))):
            raise Refusal("there are others than the shape has joints")


def fitting(types, definition):
    """The types of pieces as far as the definition has such joints."""
    return tuple(letters if len(letters) == 2 * len(joints(definition, piece)) else ""
                 for letters, piece in zip(types, definition.pieces))


class _Was(NamedTuple):
    """A joint that was, and where it is now; which of its handles lie on the curve."""

    at: float
    letters: str
    on_curve: tuple


def carried(types, before, changed):
    """The types of a core.verbs.verbs.Changed definition, from those of the definition before."""
    if not any(types) or not changed.origins:
        return fitting(types, changed.definition) if len(types) == len(changed.definition.pieces) else ()
    return tuple(_carried_one(types, before, changed.definition, piece, origins)
                 for piece, origins in zip(changed.definition.pieces, changed.origins))


def _carried_one(types, before, definition, piece, origins):
    places = joints(definition, piece)
    known = [was for origin in origins for stretch in origin.stretches
             for was in _on_stretch(before, types[origin.piece], before.pieces[origin.piece], stretch)]
    if not len(places) or not known:
        return ""
    here = [[was for was in known if abs(was.at - place) <= _ONE_PLACE] for place in places]
    return "".join(max(found, key=lambda was: was.on_curve[side]).letters[side] if found else ALIGNED
                   for found in here for side in (0, 1))       # a new joint is in line, or made free later


def _on_stretch(before, letters, piece, stretch):
    """The joints of a piece that lie on a core.shape.places.Stretch."""
    if not letters:
        return []
    pairs = [letters[i:i + 2] for i in range(0, len(letters), 2)]
    places = joints(before, piece)
    if piece.kind == 'hermite' and is_closed(piece):
        places, pairs = np.append(places, 1.0), [*pairs, pairs[0]]
    return [_moved(place, pair, stretch) for place, pair in zip(places, pairs)
            if stretch.start - _ONE_PLACE <= place <= stretch.end + _ONE_PLACE]


def _moved(place, letters, stretch):
    on_curve = place > stretch.start + _ONE_PLACE, place < stretch.end - _ONE_PLACE
    if stretch.first > stretch.last:
        letters, on_curve = letters[::-1], on_curve[::-1]
    return _Was(float(stretch.of(place)), letters, on_curve)
