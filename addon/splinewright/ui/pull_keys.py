"""What keys say while a shape is pulled at: an axis, a distance, whether it snaps."""

import numpy as np

from ..core.base import typed_number
from ..core.base.words import phrase

_AXES = ('X', 'Y', 'Z')
#: An axis that is seen from its end to this part follows what the mouse says in the plane of the view.
_STEEP = 0.05


class Keys:
    """Between two moves of the mouse."""

    def __init__(self):
        self.axis, self.typed, self.snaps = "", typed_number.Typed(), False

    def take(self, event):
        """Whether an event was a key of these."""
        if event.value != 'PRESS':
            return False
        if event.type in _AXES:
            self.axis = "" if self.axis == event.type else event.type
        elif event.type == 'BACK_SPACE':
            self.typed = typed_number.shortened(self.typed)
        else:
            longer = typed_number.after(self.typed, event.unicode) if event.unicode else None
            self.typed = longer or self.typed
            return longer is not None
        return True

    @property
    def distance(self):
        """The typed number, or None where the text is incomplete."""
        return self.typed.number

    def vector(self, free, sight, step):
        """The vector of the world that is meant, where the mouse leads along `free`, at right angles to the direction
        `sight` in which one looks. step: to which it snaps."""
        if not self.axis and self.distance is None:
            return np.round(free / step) * step if self.snaps else free
        along = self._direction(free)
        if self.distance is not None:
            return self.distance * along
        seen = along - (along @ sight) * sight
        steep = seen @ seen
        length = free @ seen / steep if steep > _STEEP else free @ along
        return (round(length / step) * step if self.snaps else length) * along

    def along_axis(self, vector):
        """What of a vector lies along the axis, where one was chosen."""
        return (vector @ self._direction(vector)) * self._direction(vector) if self.axis else vector

    def _direction(self, free):
        if self.axis:
            return np.eye(3)[_AXES.index(self.axis)]
        length = np.linalg.norm(free)
        return free / length if length > 0 else np.eye(3)[0]

    def words(self):
        """What the header says of them."""
        return "".join([phrase("  along {axis}",
                               axis=self.axis) if self.axis else "", f"  [{self.typed}|]" if str(self.typed) else "",
                        "  in steps" if self.snaps else ""])
