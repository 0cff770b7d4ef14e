"""The target of a pull: the points of a net in Edit Mode, which its shape follows, or a shape in Object Mode."""

import numpy as np

from ...core.base.failures import Refusal
from ...core.joints import held_bounds
from ...core.net import exact_net
from ..cage import net_object
from ..data import held, store
from ..recipes import recipes
from ..shape import shape
from . import live, selection

_FARTHEST = float(np.finfo(np.float32).max)


class HeldShape:
    """A shape whose definition is another at every step."""

    def __init__(self, ob):
        recipes.require_free(ob.data)
        self._data = ob.data
        self.definition = store.read(ob.data)
        self._seams = held.read(ob.data, self.definition)
        self.lost = ""                  # what does not hold as smoothly as it is to

    def show(self, definition):
        led = set(np.flatnonzero((definition.pool != self.definition.pool).any(1)).tolist())
        kept = held_bounds.kept(definition, self._seams, led, self.definition.pool)
        shape.set_definition(self._data, kept.definition)
        self.lost = held_bounds.sentence(kept.lost)

    def put_back(self):
        shape.set_definition(self._data, self.definition)

    #: In the end a definition is shown as at every step.
    write = show


class HeldNet:
    """A net in Edit Mode. Raises Refusal where the shape has not what the net shows."""

    def __init__(self, ob):
        owner = net_object.shape_of(ob)
        if owner is None:
            raise Refusal("the shape of this net was deleted, or is in no scene")
        recipes.require_free(owner.data)
        live.sync_from_cage(ob)
        if live.problem(ob):
            raise Refusal(live.problem(ob))
        current = live.session(ob.data)
        self._ob, self._net, self._weights = ob, current.net, current.state.weights
        self._start = self._now = current.state.positions
        self.definition = exact_net.read(current.net, current.state)
        self._first = self._positions(self.definition)
        self._types = selection.handle_types(ob)

    @property
    def lost(self):
        return live.session(self._ob.data).lost

    def show(self, definition):
        """In single precision, as a drag in Edit Mode does."""
        self._place(selection.place, self._target(definition))

    def put_back(self):
        self._place(selection.place, self._start)
        selection.give_handle_types(self._ob, self._types)

    def write(self, definition):
        """With all digits, and the shape is up to date."""
        self._place(selection.move, self._target(definition))
        live.sync_from_cage(self._ob)
        if live.problem(self._ob):
            raise Refusal(live.problem(self._ob))

    def _target(self, definition):
        """(n, 3): where the vertices go; those that stay are where they were, to the last digit."""
        positions = self._positions(definition)
        if not (np.abs(positions) <= _FARTHEST).all():
            raise Refusal("a control point would lie farther away than Blender's Edit Mode reaches (3.4e38)")
        return np.where((positions == self._first).all(1)[:, None], self._start, positions)

    def _positions(self, definition):
        net = net_object.net_of(definition)
        if not np.array_equal(net.origins, self._net.origins):
            raise Refusal("the net is of another time than its shape: use Reload Control Points first")
        return net.positions

    def _place(self, how, target):
        vertices = np.flatnonzero((target != self._now).any(1))
        how(self._ob, self._net, vertices, np.column_stack([target, self._weights])[vertices])
        self._now = target
