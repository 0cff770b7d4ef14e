"""What a net says in one moment: its points, where they are, and what of it cannot be taken.

Points that were there count whatever else befell the net: those that are gone, or say nothing that can be shown, stay
as the shape has them, and strays are passed over. Both is said.
"""

from dataclasses import dataclass, replace
from typing import Callable, NamedTuple

import numpy as np

from ..base.failures import Refusal
from ..base.words import phrase
from . import exact_net, strays
from .exact_net import Exact


class ChangedNet(Refusal):
    """The net does not tell any more which of its points is which."""


@dataclass(frozen=True, eq=False)
class Present:
    """All m points that Blender holds of a net, strays among them. A handle is a point."""

    numbers: np.ndarray                 # (m,) vertices of the net, as they are written on the points; -1 for none
    positions: Callable                 # gives (m, 3) float32
    weights: Callable                   # gives (m,) float32, or None where they were lost
    links: Callable                     # gives pairs (k, 2) of points that are connected
    void: np.ndarray = None             # (m,) bool: says nothing, as a handle that leads to a new point
    computed: np.ndarray = None         # (m,) bool: handles that Blender places itself, by its rounding elsewhere each time


class Reading(NamedTuple):
    """The state of a net's vertices, and in words what the shape does not take and what was passed over."""

    state: Exact
    slots: np.ndarray                   # (n,) of each vertex the slot among those present, or -1
    problem: str
    note: str
    extra: int                          # how many of those present are passed over


def _are_typed(positions, typed):
    """(n,) bool: which vertices lie where a typed number says."""
    found = np.zeros(len(positions), bool)
    for number, *position, _ in typed:
        found[int(number)] |= bool((positions[int(number)] == np.array(position, np.float32)).all())
    return found


def slots(net, present):
    """(n,) of each vertex of a net the slot of its point among those present, or -1."""
    return strays.chosen(present.numbers, len(net.rows), present.links, net.neighbors)


def read(net, present, typed, last):
    """The Reading of the present vertices. typed: as of exact_net.exact(); last: a function that gives a Net of the points
    as the shape has them, asked only where some cannot be read."""
    found = slots(net, present)
    there = found >= 0
    positions = _at(found, there, present.positions(), net.single)
    if present.computed is not None:
        is_there = np.zeros(len(found), bool)
        is_there[there] = present.computed[found[there]]
        is_there &= (np.abs(positions - net.single) <= net.rounding).all(1) & ~_are_typed(positions, typed)
        positions[is_there] = net.single[is_there]
    weights_now = present.weights()
    weights = net.single_weights.copy() if weights_now is None else _at(found, there, weights_now, net.single_weights)
    is_zero = net.are_points & (weights == 0) & (net.weights != 0)
    is_wild = ~(exact_net.in_rows(np.isfinite(positions)) & np.isfinite(weights))
    lost = ~there | is_wild
    if present.void is not None:
        lost[there] |= present.void[found[there]]
    lost_weight = lost | is_zero | (weights_now is None)
    is_any_lost = lost_weight.any()
    if is_any_lost:
        positions[lost], weights[lost_weight] = net.single[lost], net.single_weights[lost_weight]
    state = exact_net.exact(net, positions, weights, typed)
    if is_any_lost:
        state = _as_last(state, net, last(), lost, lost_weight)
    problem = _problem(len(found), int((~there).sum()), len(present.numbers) >= len(found), is_wild.any(),
                       is_zero.any(), weights_now is None)
    extra = len(present.numbers) - int(there.sum())
    return Reading(state, found, problem, note(extra, present.void is not None), extra)


def _at(slots, there, present, otherwise):
    """A new array of the present values at slots, and of the former ones where a slot is missing."""
    if there.all():
        return present[slots]
    result = otherwise.copy()
    result[there] = present[slots[there]]
    return result


def _as_last(state, net, last, lost, lost_weight):
    """A state with what was lost as the shape has it."""
    positions = np.where(lost[:, None], last.positions, state.positions)
    weights = np.where(lost_weight, last.weights, state.weights)
    return replace(state, positions=positions, weights=weights,
                   kept=np.where(lost, (positions == net.positions).all(1), state.kept),
                   kept_weights=np.where(lost_weight, weights == net.weights, state.kept_weights))


def _problem(count, gone, are_others_there, is_wild, is_zero, has_no_weights):
    if gone and are_others_there:
        return (phrase("{gone} of {count} points of the net were replaced, or given another tilt or radius: the shape has them "
                       "where they were",
                       gone=gone, count=count))
    if gone:
        return phrase("the net has lost points ({gone} of {count}): the shape has them where they were", gone=gone, count=count)
    if has_no_weights:
        return "the net has lost the weights of its points: the shape keeps them as they were"
    if is_wild:
        return "a point of the net is not finite: the shape has it where it was"
    if is_zero:
        return "a weight of 0 would take the point out of the shape: weights are above or below 0"
    return ""


def note(extra, is_void=False):
    """The message about a number of strays, and of handles that lead to them."""
    if not extra:
        return ""
    if is_void:
        return phrase("{count} points are not of this net: the shape does not take them, nor does it take handles that lead to new ones",
                      one="{count} point is not of this net: the shape does not take it, nor does it take handles that lead to new ones",
                      count=extra)
    return phrase("{count} points are not of this net: the shape does not take them",
                  one="{count} point is not of this net: the shape does not take it", count=extra)
