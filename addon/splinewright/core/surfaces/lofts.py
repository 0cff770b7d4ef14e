"""Lofts: what each of their inputs is as a section, in which order they lie, and how a loft begins and ends."""

from typing import NamedTuple

import numpy as np

from ..base import decimals
from ..base.failures import AboutInputs, Refusal, about_items
from ..base.library import sc
from ..base.words import listed, phrase
from ..joints import patch_joints
from ..verbs import patch_curves, verbs
from . import sections

#: Surfaces with which a loft goes on, by how it begins or ends.
_ALONG_SURFACE = ('G1', 'G2')
#: A section that lies so near to a line, as a part of its size, has no plane.
_STRAIGHT = 1e-6
#: What is said of its two ends.
_LACKS_SURFACE = {'start': "the start is to continue a surface: add one to the list, before the first curve",
                  'end': "the end is to continue a surface: add one to the list, after the last curve"}
_LACKS_SECTION = {'start': "the start has no section beside it to go to", 'end': "the end has no section beside it to go to"}
_IS_CURVE = {'start': "{} is a curve: only a start in a point can be round", 'end': "{} is a curve: only an end in a point can be round"}
_CONTINUES = {'start': "the start continues {}: choose free, or its tangent planes or curvatures",
              'end': "the end continues {}: choose free, or its tangent planes or curvatures"}


class End(NamedTuple):
    """How a loft begins, or ends."""

    how: str                            # 'free', 'normal', 'round', 'G1' or 'G2'
    strength: float


class Section(NamedTuple):
    """What an input is."""

    number: int                         # of the input, from 0
    curve: object = None                # a curve that the loft goes through
    point: np.ndarray | None = None     # (3,): where it comes to a point
    patches: tuple = ()                 # a surface, from a side of which it goes on
    is_turned: bool = False

    @property
    def taken(self):
        """As splinecore.build.loft takes it."""
        return self.curve if self.point is None else self.point

    @property
    def points(self):
        """(n, 3): where it lies."""
        if self.point is not None:
            return self.point[None]
        if self.curve is not None:
            return sections.samples(self.curve)[:-1 if sections.is_closed(self.curve) else None]
        return np.concatenate([sections.samples(side) for side in map(_curve_of, _sides(self.patches))])


def section(definition, number, one_curve, is_turned=False):
    """The Section that a Definition, or a sections.Point, is. one_curve: gives the one curve of a Definition. Raises Refusal."""
    if isinstance(definition, sections.Point):
        return Section(number, point=np.array(definition.place))
    if not definition.has_curves:
        return Section(number, patches=tuple(verbs.pieces_of(definition)))
    curve = one_curve(definition)
    nurbs = curve.to_nurbs()
    if not np.ptp(nurbs.points, axis=0).any() and np.all(nurbs.weights):
        return Section(number, point=nurbs.points[0])
    return Section(number, curve=curve, is_turned=is_turned)


def order(found):
    """The order in which Sections lie one behind the other, as numbers from 0: surfaces before or after all others."""
    inner = [i for i, one in enumerate(found) if not one.patches]
    row = [inner[i] for i in sections.in_a_row([found[i].taken for i in inner])] if inner else []
    before, after = [], []
    for i, one in enumerate(found):
        if not one.patches:
            continue
        gaps = [_gap(one.points, found[row[at]].points) for at in (0, -1)] if row else [0.0, 0.0]
        is_first = not before and (bool(after) or gaps[0] <= gaps[1])
        (before if is_first else after).append(i)
    return before + row + after


def loft(found, start, end, is_aligned, is_matched, **options):
    """(the splinecore Approximation of a loft of Sections, what there is to say). start, end: an End. Raises Refusal or an error of
    the library."""
    _require_order(found)
    inner = [one for one in found if not one.patches]
    curves = [one for one in inner if one.curve is not None]
    if not curves:
        raise Refusal("it has no curve to go through")
    _require_one_kind(curves)
    more, sides = {}, []
    for name, how, at in (('start', start, 0), ('end', end, -1)):
        if not found[at].patches:
            more.update(_leaving(inner, at, how, name))
            continue
        neighbor = _neighbor(found[at], inner[at], how, name)
        more[f'{name}_neighbor'] = neighbor
        sides += [inner[at]] if _is_side_of(inner[at], neighbor) else []
    inner = [one for one in inner if not any(one is side for side in sides)]
    corners = 'matched' if is_matched else 'free'
    with about_items(sections=[one.number for one in inner]):
        made = sc.build.loft([one.taken for one in inner], align=is_aligned, turned=[one.is_turned for one in inner], corners=corners,
                             **more, **options)
    told = [_unmatched(inner, is_aligned) if is_matched else "", calmed_in_words(made.followed)]
    return made, ", ".join(filter(None, told))


def calmed_in_words(part):
    """With which part of its strengths a surface follows others, or "" where that is all of it."""
    return "" if part == 1 else phrase("it follows surfaces with {part} of the strength: with more it would shoot out",
                                       part=decimals.text_of(part, 2))


def _require_order(found):
    for place, one in enumerate(found):
        if 0 < place < len(found) - 1 and one.curve is None:
            raise AboutInputs("{} is a surface between other sections: only the first and the last one may be" if one.patches else
                              "{} is a point between other sections: only the first and the last one may be", one.number)


def _require_one_kind(curves):
    are_closed = [sections.is_closed(one.curve) for one in curves]
    if len(set(are_closed)) > 1:
        raise AboutInputs("{} is closed and {} is open: a loft takes one kind or the other", curves[are_closed.index(True)].number,
                          curves[are_closed.index(False)].number)


def _unmatched(inner, is_aligned):
    """Why corners are not matched, or ""."""
    curves = [one for one in inner if one.curve is not None]
    counts = sc.build.corner_counts([one.curve for one in curves], align=is_aligned)
    if len(set(counts)) < 2:
        return ""
    told = [_corners([one.number + 1 for one, own in zip(curves, counts) if own == count], count) for count in sorted(set(counts), key=counts.index)]
    return phrase("corners are not matched: {told}", told=listed(told))


def _corners(numbers, count):
    """How many corners sections of these numbers have."""
    words = ",\u00a0".join(map(str, numbers))       # one part of the sentence, which is taken apart at commas
    if not count:
        return phrase("section {numbers} has none", numbers=words) if len(numbers) == 1 else phrase("sections {numbers} have none", numbers=words)
    if len(numbers) == 1:
        return phrase("section {numbers} has {count} corners", one="section {numbers} has {count} corner", numbers=words, count=count)
    return phrase("sections {numbers} have {count} corners", one="sections {numbers} have {count} corner", numbers=words, count=count)


def _leaving(inner, at, end, name):
    """What splinecore.build.loft gets for an end without a surface."""
    if end.how == 'free':
        return {}
    own, beside = inner[at], inner[1 if at == 0 else -2] if len(inner) > 1 else None
    if end.how in _ALONG_SURFACE:
        raise Refusal(_LACKS_SURFACE[name])
    if beside is None:
        raise Refusal(_LACKS_SECTION[name])
    if end.how == 'round':
        if own.point is None:
            raise AboutInputs(_IS_CURVE[name], own.number)
        return {f'{name}_flat': (_toward(own, beside), end.strength)}
    way = _toward(own, beside)
    return {f'{name}_tangent': (way if at == 0 else -way) * end.strength}


def _toward(own, beside):
    """The unit normal of the plane of a Section, or where that is a point of the one beside it, on the side of that."""
    of = own if own.point is None else beside
    if of.point is not None:
        raise Refusal("two points follow each other: there is nothing between them")
    there = beside.points.mean(axis=0) - own.points.mean(axis=0)
    _, spread, axes = np.linalg.svd(of.points - of.points.mean(axis=0))
    if not spread[1] > _STRAIGHT * spread[0]:
        raise AboutInputs("{} is straight: it has no plane from which a loft could leave at right angles", of.number)
    return axes[2] * (-1.0 if axes[2] @ there < 0.0 else 1.0)


def _neighbor(surface, beside, end, name):
    """As splinecore.build.loft takes it."""
    if end.how in ('normal', 'round'):
        raise AboutInputs(_CONTINUES[name], surface.number)
    sides = _sides(surface.patches)
    if not sides:
        raise AboutInputs("{} has no open side to continue", surface.number)
    patch, side = min(sides, key=lambda pair: _gap(beside.points, sections.samples(_curve_of(pair))))
    if beside.curve is not None and sections.is_closed(beside.curve) != sections.is_closed(_curve_of((patch, side))):
        raise AboutInputs("{} and the side of {} beside it are not both closed, or both open", beside.number, surface.number)
    return (patch, side, 'G0' if end.how == 'free' else end.how, end.strength)


def _is_side_of(one, neighbor):
    """Whether a Section is the side that a loft continues, which takes its place then."""
    if one.curve is None:
        return False
    side = _curve_of(neighbor[:2])
    apart = max(side.nearest(sections.samples(one.curve)).distances.max(), one.curve.nearest(sections.samples(side)).distances.max())
    return apart <= 1e-6 * sections.size_of([one.curve])


def _sides(patches):
    return [(patch, side) for patch in patches for side in patch_joints.SIDES if not patch_curves.side_of(patch, side)[1]]


def _curve_of(pair):
    return patch_curves.side_of(*pair)[0].to_nurbs()


def _gap(points, others):
    """The mean distance of points to the nearest of others."""
    return float(np.linalg.norm(points[:, None] - others[None], axis=-1).min(axis=1).mean())
