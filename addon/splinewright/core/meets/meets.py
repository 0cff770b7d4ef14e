"""Where curves and surfaces meet: points and curves (lecture row S18)."""

from itertools import combinations
from typing import NamedTuple

import numpy as np

from ..base.failures import Refusal

#: Sections of patches side by side lie no farther apart than so many tolerances where they are one.
TOGETHER = 4.0


class Found(NamedTuple):
    """Where shapes meet."""

    points: np.ndarray          # (n, 3)
    curves: list                # of splinecore values


def among(shapes, tolerance, with_themselves, told=lambda done: None, cancel=None):
    """The Found of shapes, lists of curves or of patches in one space.

    Curves of one shape count as others where with_themselves is so, and with themselves. told: called with how many
    pairs of shapes are done. Raises Refusal where nothing meets, or an error of the library.
    """
    points, curves = [], []
    pairs = list(combinations(range(len(shapes)), 2))
    for done, (i, j) in enumerate(pairs, 1):
        for a in shapes[i]:
            for b in shapes[j]:
                _gather(a, b, tolerance, points, curves, cancel)
        told(done)
    if with_themselves:
        for shape in shapes:
            _gather_inner(shape, tolerance, points, curves, cancel)
    rows = np.unique(np.concatenate([np.empty((0, 3)), *points]), axis=0)
    if not len(rows) and not curves:
        raise Refusal("nothing meets")
    return Found(rows, each_once(curves, TOGETHER * tolerance))


def _is_curve(value):
    return hasattr(value, 'intersections')


def _gather(a, b, tolerance, points, curves, cancel):
    if _is_curve(b) and not _is_curve(a):
        a, b = b, a
    if _is_curve(a):
        found = a.intersections(b, cancel=cancel) if _is_curve(b) else a.patch_intersections(b, cancel=cancel)
        points.append(found.points.reshape(-1, 3))
        curves += [a.part(*_of_one(stretch, _is_curve(b))) for stretch in found.overlaps]
        return
    found = a.sections(b, tolerance=tolerance, cancel=cancel)
    points.append(found.points.reshape(-1, 3))
    curves += found.curves


def _of_one(stretch, is_of_two):
    """The start and end of a stretch on the first curve."""
    return tuple(map(float, stretch[0] if is_of_two else stretch))


def _gather_inner(shape, tolerance, points, curves, cancel):
    for a, b in combinations(shape, 2):
        if _is_curve(a):
            _gather(a, b, tolerance, points, curves, cancel)
    for curve in filter(_is_curve, shape):
        points.append(curve.self_intersections(cancel=cancel).points.reshape(-1, 3))


#: Places of a curve that are looked for on another one.
_LOOKS = 9


def each_once(curves, near):
    """Curves without those that lie on another one: a side that two patches share is a section of both."""
    kept = []
    for curve in sorted(curves, key=lambda each: -np.ptp(each.bounding_box(), axis=0).max()):
        places = curve.evaluate(np.linspace(*curve.domain, _LOOKS))
        if not any(_is_within(places, other, near) and (other.nearest(places).distances <= near).all() for other in kept):
            kept.append(curve)
    return kept


def _is_within(places, curve, near):
    """Whether places may lie on a curve: in its box."""
    low, high = curve.bounding_box()
    return bool((places >= low - near).all() and (places <= high + near).all())
