"""Verbs of curves that meet others, and of their corners and ends (lecture row S18).

They are as those of core.verbs.verbs. `others` are curves in the same space; cancel: as the library takes it.
"""

import numpy as np

from ..base.failures import Refusal
from ..base.library import sc
from ..shape import definition as definitions
from ..shape import places
from ..shape.traced import bare
from ..verbs import verbs
from . import plane_fit


def fillet_corners(radius, cancel=None):
    return lambda curve: _with_corners(curve, curve.rounded(radius, cancel=cancel))


def chamfer_corners(length, cancel=None):
    return lambda curve: _with_corners(curve, curve.chamfered(length, cancel=cancel))


def _with_corners(curve, made):
    return curve if bare(made) == bare(curve).to_nurbs() else made


def extend(ends, length, how):
    """ends: 'start' and 'end', or one of them."""
    def verb(curve):
        for end in ends:
            curve = curve.extended(length, end, how)
        return curve
    return verb


def extend_to(ends, others, how, cancel=None):
    """Up to where they first meet one of the others."""
    def verb(curve):
        before = curve
        for end in ends:
            curve = curve.extended_to(_but(before, others), end, how, cancel=cancel)
        return curve
    return verb


def trim(parameter, others, cancel=None):
    """Without the part about a parameter, up to where it meets the others."""
    return lambda curve: curve.trimmed(_but(curve, others), _in_domain(curve, parameter), cancel=cancel)


def split_where_met(others, cancel=None):
    """Into parts between where it meets the others, and itself."""
    def verb(curve):
        mine = bare(curve)
        at = [meet[0] for other in _without(mine, others) for meet in meets(mine, other, cancel)]
        at += [parameter for both in mine.self_intersections(cancel=cancel).parameters for parameter in both]
        return curve.parts(at)
    return verb


def meets(curve, other, cancel=None):
    """(n, 2): the parameters at which two curves meet, also at the ends of stretches that they have in common."""
    found = curve.intersections(other, cancel=cancel)
    stretches = found.overlaps.reshape(-1, 2, 2)
    ends = [(a, b) for (of_a, of_b), turned in zip(stretches, found.reversed)
            for a, b in zip(of_a, of_b[::-1] if turned else of_b)]
    return np.concatenate([found.parameters.reshape(-1, 2), np.array(ends).reshape(-1, 2)])


def _without(mine, others):
    """The others, of which the curve itself may be one."""
    return [other for other in others if other is not mine and other != mine]


def _but(curve, others):
    """_without(). Raises Refusal where there are none."""
    found = _without(bare(curve), others)
    if not found:
        raise Refusal("there is no other curve that it could meet")
    return found


def _in_domain(curve, parameter):
    """A parameter as the redo panel has it, in single precision, may be beyond the end by a rounding."""
    return float(np.clip(parameter, *curve.domain))


# What would come of it -----------------------------------------------------------------------------

#: Points of a line that shows it.
_SHOWN = 64


def parts_where_met(curve, others):
    """The parts of a curve that trim() takes away, one of them at a time; [] where it takes none."""
    parts = curve.parts([meet[0] for other in _without(curve, others) for meet in meets(curve, other)])
    return parts if len(parts) > 1 else []


def part_about(parts, curve, parameter):
    """(n, 3): of the part in which a parameter lies; None where there is none. That over a seam has it a turn later."""
    turn = curve.domain[1] - curve.domain[0]
    for part in parts:
        start, end = part.domain
        if start <= parameter <= end or start <= parameter + turn <= end:
            return part.evaluate(np.linspace(start, end, _SHOWN))
    return None


def extension(curve, others, end):
    """(n, 3): what extend_to() adds naturally, or None where it adds nothing."""
    try:
        made = curve.extended_to(_without(curve, others), end)
    except sc.Error:
        return None
    (start, last), (first, final) = curve.domain, made.domain
    return made.evaluate(np.linspace(*((first, start) if end == 'start' else (last, final)), _SHOWN))


# Two curves ----------------------------------------------------------------------------------------


def filleted(definition, first, second, kept, radius, is_joined, cancel=None):
    """The verbs.Changed definition in which two pieces go up to an arc between them, or are one with it.

    first, second: numbers of the pieces, counted from 1. kept: for each which part of it stays, that at its 'start' or 'end', or
    about a parameter. Raises Refusal, or an error of the library.
    """
    def between(a, b, at):
        return sc.build.filleted(a, b, radius, at, plane_fit.normal_of([a, b]), cancel=cancel)
    return _between(definition, first, second, kept, between, is_joined)


def chamfered(definition, first, second, kept, lengths, is_joined, cancel=None):
    """The same with a segment between places at two lengths from where they meet."""
    return _between(definition, first, second, kept,
                    lambda a, b, at: sc.build.chamfered(a, b, lengths, at, cancel=cancel), is_joined)


#: What is kept of a curve lies about its end, as near as this part of its domain.
_AT_END = 1e-6
#: Ends of what a bridge joins differ by rounding alone: as a part of the size.
_ROUNDING = 1e-9


def _between(definition, first, second, kept, between, is_joined):
    curves = verbs.curves_of(definition)
    for number in (first, second):
        verbs.require_piece(curves, number)
    if first == second:
        raise Refusal("two pieces are needed: corners of one are Fillet Corners and Chamfer Corners")
    a, b = curves[first - 1], curves[second - 1]
    made_a, bridge, made_b = between(a, b, tuple(map(_kept_at, (a, b), kept)))
    if is_joined:
        whole = sc.build.join_curves([one for one in (made_a, bridge, made_b) if one is not None], _ROUNDING * _size(a, b))
        return _changed(curves, first - 1, second - 1, whole)
    after = [*curves, bridge]
    after[first - 1], after[second - 1] = made_a, made_b
    # The bridge may have taken a piece whole.
    left = [(one, parent) for one, parent in zip(after, (*range(len(curves)), first - 1)) if one is not None]
    parents = tuple(parent for _, parent in left)
    return verbs.Changed(definitions.from_value([one for one, _ in left]), parents, 0.0,
                         origins=tuple((places.Origin(i),) for i in parents))


def _changed(curves, first, second, whole):
    """With what came of two pieces in place of the former."""
    after, parents = [], []
    for i, curve in enumerate(curves):
        if i == first:
            after += whole
            parents += [first] * len(whole)
        elif i != second:
            after.append(curve)
            parents.append(i)
    return verbs.Changed(definitions.from_value(after[0] if len(after) == 1 else after), tuple(parents), 0.0,
                         origins=tuple((places.Origin(i),) for i in parents))


def _kept_at(curve, end):
    if not isinstance(end, str):
        return _in_domain(curve, end)
    start, last = curve.domain
    return start + _AT_END * (last - start) if end == 'start' else last - _AT_END * (last - start)


def _size(*curves):
    return max(np.abs(np.array(curve.bounding_box())).max() for curve in curves)


def best_kept(definition, first, second):
    """('start' or 'end' of each) of two pieces: of each the longer part from where they meet, or would straight on."""
    curves = verbs.curves_of(definition)
    a, b = curves[first - 1], curves[second - 1]
    found = meets(a, b)
    if len(found):
        return tuple('start' if at - curve.domain[0] > curve.domain[1] - at else 'end' for at, curve in zip(found[0], (a, b)))
    ends = [curve.evaluate(np.array(curve.domain)) for curve in (a, b)]
    gaps = np.linalg.norm(ends[0][:, None] - ends[1][None], axis=-1)
    nearest = np.unravel_index(gaps.argmin(), gaps.shape)
    return tuple('end' if i == 0 else 'start' for i in nearest)
