"""Caps for the open ends of shapes of patches (lecture row S20)."""

import numpy as np

from ..base.failures import Refusal
from ..base.library import sc
from ..shape import places, sewing
from ..verbs import verbs
from . import caps_in_caps
from .caps_in_caps import Capped

#: Which open ends are closed.
ENDS = {'ALL': "all of them", 'SHORTEST': "the shortest one", 'LONGEST': "the longest one"}


def capped(definition, ends, cancel=None):
    """The Capped definition of patches, in which open ends have caps that share their points. ends: one of ENDS. Raises Refusal or
    an error of the library."""
    if definition.has_curves:
        raise Refusal("it is made of curves: a surface is needed")
    before = verbs.pieces_of(definition)
    patches = [patch.to_nurbs() for patch in before]
    found = sc.build.open_ends(patches)
    if not found:
        raise Refusal("it has no open end")
    if _is_flat(patches):
        raise Refusal("it lies in one plane: a cap would lie on it")
    rings = caps_in_caps.rings_of(patches, found)
    whole = [end for end in found if not any(end in ring.ends for ring in rings)]
    groups = [*([end] for end in whole), *(list(ring.ends) for ring in rings)]
    groups.sort(key=lambda group: sum(patches[i].boundary(side).length(tolerance=1e-6) for i, side in group[0]))
    chosen = {'ALL': groups, 'SHORTEST': groups[:1], 'LONGEST': groups[-1:]}[ends]
    own = [ring for ring in rings if list(ring.ends) in chosen]
    if own and all(ring.is_simple for ring in own):
        try:
            return caps_in_caps.capped(definition, before, patches, chosen, rings, cancel)
        except Refusal:
            pass
    return _with_caps(definition, before, patches, [[side for end in group for side in end] for group in chosen], cancel)


def _with_caps(definition, before, patches, chosen, cancel):
    made, bend = sc.build.cap(patches, chosen, cancel=cancel)
    after, parents, lie, is_turned = _parts_of(made, patches)
    if len(after) == len(before) and not is_turned:
        after = list(before)
    count, beside = len(after), chosen[0][0][0]
    after += made[count:]
    parents += [beside] * (len(made) - count)
    lie += [places.Place((), ())] * (len(made) - count)
    joined = [(i, k) for i in range(len(after)) for k in range(max(i + 1, count), len(after))]
    joined += [(i, i + 1) for i in range(count - 1) if parents[i] == parents[i + 1]]
    changed = verbs.Changed(sewing.sewn(definition, after, parents, joined), tuple(parents), 0.0, tuple(lie))
    return Capped(changed, len(chosen), bend, is_turned)


def _is_flat(patches):
    points = np.concatenate([patch.points.reshape(-1, 3) for patch in patches])
    spread = np.linalg.svd(points - points.mean(axis=0), compute_uv=False)
    return bool(spread[2] <= 1e-9 * spread[0])


def _parts_of(made, patches):
    """(the patches as they are made, the numbers of those they came of, their core.shape.places.Places, whether some are turned): each is
    whole or cut in parts."""
    after, parents, lie, are_turned = [], [], [], False
    at = 0
    for number, patch in enumerate(patches):
        is_turned = not _are_parts(made[at], patch)
        are_turned = are_turned or is_turned
        first = made[at].reversed('u') if is_turned else made[at]
        axis = 'u' if first.domain[0] != patch.domain[0] or first.periodic[0] != patch.periodic[0] else 'v'
        (start, end), origin = patch.domain['uv'.index(axis)], first.domain['uv'.index(axis)][0]
        length, reached = end - start, origin
        while reached < origin + length * (1.0 - 1e-9):
            part = made[at].reversed('u') if is_turned else made[at]
            low, high = part.domain['uv'.index(axis)]
            stretches = places.opened(places.WHOLE, (origin - start) / length) if origin != start else places.WHOLE
            stretches = places.cut(stretches, (low - origin) / length, min(1.0, (high - origin) / length))
            if high - low >= length * (1.0 - 1e-9):
                stretches = places.WHOLE
            place = places.Place(stretches, places.WHOLE) if axis == 'u' else places.Place(places.WHOLE, stretches)
            if is_turned:
                place = place._replace(u=places.reversed_(place.u))
            after.append(made[at])
            parents.append(number)
            lie.append(place)
            reached, at = high, at + 1
    return after, parents, lie, are_turned


def _are_parts(part, patch):
    """Whether a patch lies where a part of its domain does on another one."""
    u, v = (0.37 * start + 0.63 * end for start, end in part.domain)
    (start, end), period = patch.domain[0], patch.domain[0][1] - patch.domain[0][0]
    there = u if start <= u <= end else u - period
    if not start <= there <= end:
        return False
    size = abs(patch.points[..., :3]).max()
    return bool(abs(part.evaluate(u, v) - patch.evaluate(there, v)).max() <= 1e-9 * size)
