"""A knot of a shape is moved: the control points stay, and the shape is another at every step."""

from ...core.joints import held as seams_that_hold
from ...core.joints import held_bounds
from ...core.shape import shared_knots
from ...core.verbs import knots, verbs
from ..data import held, store
from ..recipes import recipes
from ..shape import shape


class HeldKnot:
    """A knot by the number of a piece, counted from 0, its axis, and its own. Raises Refusal where the shape
    is not to be changed, or UnreadableDefinition."""

    def __init__(self, data, piece, axis, knot):
        recipes.require_free(data)
        shape.require_writable(data)
        shape.require_untouched(data)
        self.before = store.read(data)
        verbs.require_piece(self.before.pieces, piece + 1)
        self._alongs = shared_knots.together(self.before, piece, axis)
        self._data, self._knot, self._seams, self._is_moved = data, knot, held.known(data), False
        self.lost = ""                  # what does not hold as smoothly as it is to

    def show(self, to):
        """Let the knot lie at a parameter; seams that hold do it still. Raises, and nothing has changed, where it may
        not."""
        definition = knots.moved(self.before, self._alongs, self._knot, to)
        seams = self._seams_at(definition)
        kept = held_bounds.kept(definition, seams)
        shape.set_definition(self._data, kept.definition)
        self.lost = held_bounds.sentence(kept.lost)
        held.write(self._data, seams)
        self._is_moved = True

    def _seams_at(self, definition):
        """What holds, at the knot where that lies now."""
        if not definition.has_curves:
            return self._seams
        return seams_that_hold.at_knots_of(self._seams, self.before, definition)

    def put_back(self):
        if self._is_moved:
            shape.set_definition(self._data, self.before)
            held.write(self._data, self._seams)
            self._is_moved = False
