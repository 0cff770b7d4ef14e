"""A net gains and loses points in Blender's Edit Mode, of patches whole rows: net and shape take up what became of them.

The points get the numbers of the stage that results, and but for points that are being appended the places that they
have in it: a knot that was inserted moves its neighbors.
"""

from enum import IntEnum

import numpy as np

from ...core.net import grown, grown_cage, reading
from ..cage import net_object
from ..data.file_state import look_again
from . import stages


class Phase(IntEnum):
    """What happens while a net is read."""

    BUSY = 0                            # an operator may go on moving points by itself
    TOLD = 1                            # Blender tells of what has ended: nothing may be made in a cage
    FREE = 2


def choose(data, current):
    """Let a session take the stage that the points of a net are of. Points that were appended and called off, so that they
    lie where they were copied, are copies again."""
    stages.keep(data, current.stages)
    stage = stages.at_hand(data, current.stages)
    parent = current.stages.get(stage.parent)
    if len(stage.added) and parent is not None:
        runs = _runs(data, stage.net)
        if _is_called_off(stage, runs):
            _write(data, parent.net, [_before(stage, run.numbers) for run in runs], runs)
            stage = parent
    if current.stage is not stage:
        current.take_stage(stage)


def _is_called_off(stage, runs):
    places = {number: tuple(place) for run in runs for number, place in zip(run.numbers.tolist(), run.places.tolist())}
    ends = {origin: number for number, origin in enumerate(stage.origins.tolist()) if number not in stage.added}
    pairs = [(number, ends.get(int(stage.origins[number]))) for number in stage.added.tolist()]
    return all(number in places and places[number] == places.get(end) for number, end in pairs)


def _before(stage, numbers):
    """What points with these numbers were before some were appended."""
    before = np.full(len(numbers), grown.NEW)
    for i, number in enumerate(numbers.tolist()):
        own = grown.copy_of(number) if number < grown.NEW else number
        if number == grown.STRAY:
            before[i] = number
        elif own >= 0:
            is_copy = number < grown.NEW or own in stage.added
            before[i] = grown.copy_of(stage.origins[own]) if is_copy else stage.origins[own]
    return before


def ignore_called_off(data, current):
    """Pass over what was extruded and called off once for all: it stays left out when the one it is of moves away."""
    runs = _runs(data, current.net)
    numbers = _core(current.net).settled(runs)
    if numbers is not None:
        _write(data, current.net, numbers, runs)


def grow(data, current, definition, found, moment):
    """Whether a net that has gained or lost points is of another stage now, which the session has then.

    definition: what the net says by the points that are there; found: the core.net.reading.Reading of them. Where the
    moment is not right, current.is_waiting says that there is something to take up: while an operator is busy rows are
    appended only. Raises Refusal or an error of the library, and nothing has changed, where there is no such shape.
    """
    if not definition.has_curves and not found.extra and (found.slots >= 0).all():
        return False
    kind = net_object.kind_of(data)
    runs = kind.runs(data, current.net, found.slots)
    result = _core(current.net).grow(current.net, definition, runs)
    if result is None:
        return False
    current.is_waiting = moment < _least(definition, result)
    if current.is_waiting:
        return False
    stage = stages.after(current.stages, current.stage, result, stages.digest(data))
    stages.keep(data, current.stages)
    _write(data, stage.net, result.numbers, runs)
    if not len(result.added):
        kind.place(data, stage.net, result.numbers, runs, set(np.flatnonzero(result.origins == grown.NEW).tolist()))
    if result.faces:
        kind.mend(data, result.faces, result.parted)
    current.take_stage(stage)
    return True


def _least(definition, result):
    """The first Phase at which that can be taken up."""
    if definition.has_curves or len(result.added):
        return Phase.BUSY
    return Phase.FREE if result.faces else Phase.TOLD


def _core(net):
    return grown if net.definition.has_curves else grown_cage


def _runs(data, net):
    kind = net_object.kind_of(data)
    return kind.runs(data, net, reading.slots(net, kind.present(data, net)))


def _write(data, net, numbers, runs):
    net_object.kind_of(data).renumber(data, net, numbers, runs)
    look_again(data)
