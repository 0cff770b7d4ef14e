"""Rows more and less of one patch along one axis, as Blender's Edit Mode adds and removes them.

Every edit gives an Edited: the patch, and of each row that its net has then, in order, the row of control points.
"""

from typing import NamedTuple

import numpy as np

from ..base.failures import Refusal
from ..base.library import sc
from ..verbs.patch_verbs import Along
from . import knot_steps


class Edited(NamedTuple):
    """A patch, of each row of its net along an axis (0 or 1) the row of control points, and how far it lies from what it
    was."""

    patch: object
    axis: int
    order: np.ndarray
    error: float = 0.0


def started(patch, axis):
    """A patch before its edits along an axis."""
    return Edited(patch, axis, np.arange(patch.points.shape[axis]))


def appended(edited, points, weights, at_start):
    """One more row (k, 3), (k,) beyond a border; the others stay where they are."""
    patch, axis = edited.patch.to_nurbs(), edited.axis
    if at_start:
        return _turned(appended(_turned(edited._replace(patch=patch)), points, weights, False))
    longer = knot_steps.longer(patch.knots[axis], patch.degree[axis])
    patch = _with(patch, axis, patch.degree[axis], longer,
                  np.concatenate([patch.points, np.expand_dims(points, axis)], axis),
                  np.concatenate([patch.weights, np.expand_dims(weights, axis)], axis))
    return edited._replace(patch=patch, order=np.append(edited.order, len(edited.order)))


def inserted(edited, gaps, is_mirrored=False):
    """New rows, of each gap (place, fractions) after the row at a place of the order, at these fractions of the way to the
    next: the shape stays.

    is_mirrored: the fractions are told from the next row backwards, as a patch beside this one has them.
    """
    patch, order = edited.patch.to_nurbs(), edited.order
    if is_mirrored and is_periodic(edited):
        gaps = [(place, [1.0 - fraction for fraction in fractions[::-1]]) for place, fractions in gaps]
    elif is_mirrored:
        gaps = [(len(order) - 2 - place, fractions) for place, fractions in gaps[::-1]]
        return _turned(inserted(_turned(edited._replace(patch=patch)), gaps))
    steps = [(int(order[place]), fraction) for place, fractions in gaps for fraction in fractions]
    refined = knot_steps.inserted(Along(patch, 'uv'[edited.axis]), steps).patch
    at = np.repeat([place + 1 for place, _ in gaps], [len(fractions) for _, fractions in gaps])
    wanted = np.insert(order.astype(float), at, np.nan)
    return edited._replace(patch=refined, order=_matched(edited, refined, wanted))


def removed(edited, place):
    """Without the row at a place of the order: at a border the patch ends earlier, elsewhere the shape stays as near as a
    patch with a row less can."""
    patch, axis, order = edited.patch, edited.axis, edited.order
    if len(order) <= 2:
        raise Refusal("a patch needs two rows of points")
    if not is_periodic(edited):
        if place == 0:
            return _turned(removed(_turned(edited), len(order) - 1))
        if place == len(order) - 1:
            return edited._replace(patch=_ended_earlier(patch, axis), order=order[:-1])
    averages = knot_steps.averages(Along(patch.to_nurbs(), 'uv'[axis]))
    found = knot_steps.without_a_knot(Along(patch, 'uv'[axis]), averages[order[place]])
    fewer = found.value.patch
    wanted = np.delete(order.astype(float), place)
    return edited._replace(patch=fewer, order=_matched(edited, fewer, wanted), error=edited.error + found.error)


def is_periodic(edited):
    """Whether rows close around, from the last to the first."""
    return bool(getattr(edited.patch, 'periodic', (False, False))[edited.axis])


def _matched(edited, after, wanted):
    """Of each row of the net its control points now; wanted: as of knot_steps.matched()."""
    if not is_periodic(edited):
        return np.arange(len(wanted))
    before, after = (np.moveaxis(patch.points, edited.axis, 0) for patch in (edited.patch, after))
    return knot_steps.matched(before, after, wanted)


def _ended_earlier(patch, axis):
    """Without the last row: what appended() undoes."""
    count = patch.points.shape[axis] - 1
    points, weights = (np.take(rows, range(count), axis) for rows in (patch.points, patch.weights))
    if isinstance(patch, sc.BezierPatch):
        return sc.BezierPatch(points, weights)
    return _with(patch, axis, *knot_steps.earlier(Along(patch, 'uv'[axis])), points, weights)


def _turned(edited):
    """The other way round; the parameters change their signs, and so keep their digits."""
    patch, axis = edited.patch, edited.axis
    points, weights = np.flip(patch.points, axis), np.flip(patch.weights, axis)
    if isinstance(patch, sc.BezierPatch):
        patch = sc.BezierPatch(points, weights)
    else:
        patch = _with(patch, axis, patch.degree[axis], 0.0 - patch.knots[axis][::-1], points, weights)
    return edited._replace(patch=patch, order=len(edited.order) - 1 - edited.order[::-1])


def _with(patch, axis, degree, knots, points, weights):
    """A NURBS patch with another degree and other knots along an axis, and other points."""
    degrees, both = list(patch.degree), list(patch.knots)
    degrees[axis], both[axis] = degree, knots
    return sc.NurbsPatch(tuple(degrees), tuple(both), points, weights, patch.periodic)
