"""Caps with holes: open ends within another one, in its plane, are closed with that; a single one by a ring."""

from typing import NamedTuple

from ..base.failures import Refusal
from ..base.library import sc
from ..shape import places, sewing
from ..verbs import verbs
from . import hollow, sections


class Capped(NamedTuple):
    """What became of a definition."""

    changed: verbs.Changed
    count: int                          # of ends that were closed
    bend: float                         # how far a rim is from a plane
    is_turned: bool                     # whether all normals were turned outwards


class Ring(NamedTuple):
    """An open end, and those within it."""

    ends: tuple                         # as splinecore.build.open_ends gives them, the outer one first

    @property
    def patches(self):
        """The numbers of the patches that go around them first."""
        return tuple(end[0][0] for end in self.ends)

    @property
    def is_simple(self):
        """Whether it is of two patches that alone go around its ends."""
        return len(self.ends) == 2 and all(len(end) == 1 for end in self.ends)


def rings_of(patches, ends):
    """The Rings that open ends are. Raises Refusal where rims cross."""
    rims = [_rim(patches, end) for end in ends]
    pairs = {(i, k) for i, inner in enumerate(rims) for k, rim in enumerate(rims) if i != k and hollow.is_within(inner, rim)}
    depths = [sum(i == inner for inner, _ in pairs) for i in range(len(ends))]
    found = []
    for number in (i for i, depth in enumerate(depths) if depth % 2 == 0):
        inside = [inner for inner, rim in pairs if rim == number and depths[inner] == depths[number] + 1]
        if inside:
            found.append(Ring((ends[number], *(ends[i] for i in sorted(inside)))))
    return found


def _rim(patches, end):
    """The closed curve of an open end."""
    curves = [patches[i].boundary(side) for i, side in end]
    joined = sc.build.join_curves(curves, 1e-6 * sections.size_of(curves)) if len(curves) > 1 else curves
    return joined[0]


def capped(definition, before, patches, chosen, rings, cancel=None):
    """The Capped definition in which these groups of ends, of one or of those of a Ring, are closed. Raises Refusal or an error of
    the library."""
    own = [ring for ring in rings if list(ring.ends) in chosen]
    tubes = {}
    for ring in own:
        tubes.setdefault(ring.patches, []).append(ring)
    taken = [number for pair in tubes for number in pair]
    alone = [group[0] for group in chosen if len(group) == 1]
    if len(set(taken)) < len(taken) or any(i in taken for end in alone for i, _ in end):
        raise Refusal("a tube within another does not lie in it from end to end: close its ends one after the other")
    _require_own_sides(definition, taken)
    after, parents, lie, bend, is_turned = list(before), list(range(len(before))), [places.Place()] * len(before), 0.0, False
    joined, made = [], []
    for pair, of_pair in tubes.items():
        found, is_swapped = _hollow(patches, pair, of_pair)
        is_turned = is_turned or found.is_turned
        for number, patch, place in zip(pair, (found.outer, found.inner), found.lies):
            after[number] = patch.swapped().reversed('u') if is_swapped[number] else patch
            lie[number] = _swapped(place) if is_swapped[number] else place
        made += [(pair[0], ring) for ring in found.rings]
    if alone:
        caps, bend = sc.build.cap(patches, alone, cancel=cancel)
        if len(caps) - len(patches) < len(alone) or caps[:len(patches)] != patches:
            raise Refusal("the other open ends are closed by patches that are cut: close those one after the other")
        made += [(alone[0][0][0], cap) for cap in caps[len(patches):]]
    count = len(after)
    joined = [(i, k) for i in range(count) for k in range(count, count + len(made))]
    after += [patch for _, patch in made]
    parents += [parent for parent, _ in made]
    lie += [places.Place((), ())] * len(made)
    changed = verbs.Changed(sewing.sewn(definition, after, parents, joined), tuple(parents), 0.0, tuple(lie))
    return Capped(changed, len(chosen), bend, is_turned)


def _require_own_sides(definition, numbers):
    """Raises Refusal where a tube that gets other knots shares a side with a patch."""
    for number in numbers:
        own = set(definition.pieces[number].indices.ravel().tolist())
        for other, piece in enumerate(definition.pieces):
            if other != number and len(own.intersection(piece.indices.ravel().tolist())) > 1:
                raise Refusal("patch {number} shares a side with patch {other}: a cap with a hole would part them",
                              number=number + 1, other=other + 1)


def _hollow(patches, pair, rings):
    """(the hollow.Hollow of two tubes, whether each was swapped, by its number)."""
    sides = [(ring.ends[0][0][1], ring.ends[1][0][1]) for ring in rings]
    outer, outer_swapped = hollow.around_u(patches[pair[0]], sides[0][0])
    inner, inner_swapped = hollow.around_u(patches[pair[1]], sides[0][1])
    names = [tuple(side.split('_')[1] for side in both) for both in sides]
    if len({own == other for own, other in names}) > 1:
        raise Refusal("a tube within another does not lie in it from end to end: close its ends one after the other")
    is_against = names[0][0] != names[0][1]
    found = hollow.hollow(outer, inner.reversed('v') if is_against else inner, [own for own, _ in names])
    if is_against:
        place = found.lies[1]
        found = found._replace(lies=(found.lies[0], place._replace(v=places.reversed_(place.v))))
    return found, dict(zip(pair, (outer_swapped, inner_swapped)))


def _swapped(place):
    """Of a patch that was made of a swapped one, swapped back, and reversed along u."""
    return places.Place(places.reversed_(place.v), place.u)
