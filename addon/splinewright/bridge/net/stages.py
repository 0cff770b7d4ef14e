"""What a net became each time that it gained or lost points: its stages.

The points carry the numbers of the stage they are of, so that Edit Mode's undo brings that back with them. Stages are kept
beside the net and never go; the first is what the net was made from. This is the one door to the stored data of them.
"""

import hashlib
from dataclasses import dataclass, field, replace

import bpy
import numpy as np

from ...core.base.failures import Refusal
from ...core.net.exact_net import Net
from ...core.shape import definition as definitions
from ..cage import net_object
from ..data import store

_STAGES = 'stages'
#: Whole numbers that float32 holds.
_MOST = 2 ** 24


@dataclass(eq=False)
class Stage:
    """A net, from the number `net.first` on, and how it came about."""

    net: Net
    note: str = ""
    parent: int = 0                     # the first number of the stage before
    origins: np.ndarray = field(default_factory=lambda: np.empty(0, np.int64))      # as of core.net.grown.Grown
    added: np.ndarray = field(default_factory=lambda: np.empty(0, np.int64))
    answers: set = field(default_factory=set)       # digests of what was found in Blender, which this stage came of

    @property
    def end(self):
        """The number after the last."""
        return self.net.first + max(len(self.net.rows), 1)


def stored(data, made_with):
    """{first number: Stage} of a net's data-block. Raises DamagedNet. made_with: the Net that it was made from."""
    found = {0: Stage(made_with)}
    group = net_object.stored(data).get(_STAGES)
    if group is None:
        return found
    if not store.is_group(group):
        raise net_object.damaged("its stages are none")
    for name in group.keys():
        try:
            stage = _decoded(data, int(name), group[name])
        except (Refusal, LookupError, TypeError, ValueError, AttributeError, OverflowError) as error:
            raise net_object.damaged(error) from error
        found[stage.net.first] = stage
    return found


def _decoded(data, first, group):
    definition = store.valid(group['definition'])
    if definition.has_curves != isinstance(data, bpy.types.Curve) or not 0 < first < _MOST or type(group['note']) is not str:
        raise Refusal("a stage of it is none")
    net = replace(net_object.net_of(definition), first=first)
    count = net.point_count
    origins, added = (np.array(group[name], dtype=np.int64) for name in ('origins', 'added'))
    if origins.shape != (count,) or added.ndim != 1 or not ((0 <= added) & (added < count)).all():
        raise Refusal("a stage of it has other points than it should")
    return Stage(net, group['note'], int(group['parent']), origins, added, set(str(group['answers']).split()))


def keep(data, stages):
    """Store those of these Stages that are not stored yet: undo outside of Edit Mode takes away what was stored since."""
    group = data[net_object.KEY].get(_STAGES)
    names = group.keys() if store.is_group(group) else ()
    missing = [stage for first, stage in stages.items() if first and str(first) not in names]
    if missing and not store.is_group(group):
        store.assign(data[net_object.KEY], _STAGES, {})
    for stage in missing:
        _write(data, stage)


def _write(data, stage):
    store.assign(data[net_object.KEY][_STAGES], str(stage.net.first), {
        'definition': store.encoded(stage.net.source), 'note': stage.note, 'parent': stage.parent,
        'origins': stage.origins.tolist(), 'added': stage.added.tolist(), 'answers': " ".join(sorted(stage.answers))})


def at_hand(data, stages):
    """The Stage that most points of a net's data-block are of."""
    if len(stages) == 1:
        return stages[0]
    carried = net_object.kind_of(data).carried(data)
    counts = {first: int(((carried >= first) & (carried < stage.end)).sum()) for first, stage in stages.items()}
    return stages[max(counts, key=lambda first: (counts[first], first))]


def after(stages, parent, grown, answered):
    """The Stage that results from a parent, one that is there already where it is the same.

    answered: the digest of what was found in Blender; the same is answered alike, now and after undo.
    """
    known = next((stage for stage in stages.values() if answered in stage.answers), None)
    if known is None:
        known = next((stage for stage in stages.values() if stage.parent == parent.net.first and stage.net.first
                      and definitions.are_same(stage.net.source, grown.net.source)), None)
    if known is None:
        first = max(stage.end for stage in stages.values())
        net = replace(grown.net, first=first)
        if first + len(net.rows) >= _MOST:
            raise Refusal("too many points were added and removed: leave the net and open it again")
        known = Stage(net, grown.note, parent.net.first, grown.origins, grown.added)
        stages[first] = known
    known.answers.add(answered)
    return known


def digest(data):
    """A key that distinguishes shapes found in Blender."""
    found = hashlib.sha256()
    for part in net_object.kind_of(data).everything(data):
        found.update(part)
    return found.hexdigest()[:32]
