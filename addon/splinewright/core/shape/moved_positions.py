"""Positions on the faces of a patch set that is dragged, and their checksum: what depends on points that moved alone is
worked out, with the bits of the whole."""

import numpy as np

from ..base.arrays import are_equal
from ..base.checksum import Kept, room
from ..base.failures import FAILURES

#: Sets of rows of which it is known where they move vertices.
_KNOWN = 4
#: Bits that no evaluation gives, not even one that fails.
_UNTOUCHED = 0x7FC5A5A5
#: Between such weights a coordinate that changed changes the point times its weight, and nothing else. Tangents have none.
_LEAST, _MOST = 1e-100, 1e100


class MovedPositions:
    """Of one Tessellation. What it gives it writes over the next time."""

    def __init__(self, faces, patch_set):
        self.faces, self._room = faces, room(3 * faces.vertex_count)
        self.positions = self._room[:3 * faces.vertex_count].reshape(-1, 3)
        self._evaluated, self._checksum = None, None
        self._places = {}               # of which rows moved the checksum.Places of what they move
        self.move(patch_set)

    def move(self, patch_set, rows=None):
        """Be those of another set with the same patches, that fits. rows: the only ones of its points that may be others now,
        where that is known."""
        before, self._evaluated = self._evaluated, None
        kept, self._checksum = self._checksum, None         # of what may be no more
        places = None
        if kept is not None and before is not None:
            rows = _moved_rows(before, patch_set) if rows is None else rows
            places = None if rows is None else self._places_of(kept, before, rows)
        if places is not None:
            kept.writes(places)
        self.faces.evaluate_positions(patch_set, before=before, out=self.positions)
        self._evaluated = patch_set
        if places is not None:
            kept.wrote()
            self._checksum = kept

    def fits(self, patch_set):
        """Whether the faces can show a set."""
        return self.faces.fits(patch_set, self._evaluated)

    def checksum(self):
        """checksum.of() the positions."""
        if self._checksum is None:
            self._checksum = Kept(self._room)
        return self._checksum.value()

    def _places_of(self, kept, before, rows):
        """The Places of all numbers that may become others where these rows move, or None where that may be any."""
        known = rows.tobytes()
        if known not in self._places:
            if len(self._places) >= _KNOWN:
                del self._places[next(iter(self._places))]
            written = self._tried(before, rows)
            self._places[known] = None if written is None else kept.places(np.add.outer(3 * written, np.arange(3)).ravel())
        return self._places[known]

    def _tried(self, before, rows):
        """The vertices that move where those rows do, to any place, or None where that may be any: the rows are moved in all
        coordinates, and the vertices that change are seen."""
        sizes = np.abs(before.weights)
        if not (_LEAST < sizes.min() and sizes.max() < _MOST):
            return None
        points = before.points.copy()
        points[rows] = np.where(np.abs(points[rows]) < 1, points[rows] + 2, 0.5 * points[rows])
        out = np.full(3 * self.faces.vertex_count, _UNTOUCHED, np.uint32)
        try:
            self.faces.evaluate_positions(before.with_points(points), before=before, out=out.view(np.float32).reshape(-1, 3))
        except FAILURES:
            return None
        return np.flatnonzero(out[::3] != _UNTOUCHED)


def _moved_rows(before, patch_set):
    """(k,) the points of a set that are others than before, or None where more than that is."""
    points = before.points
    if points.shape != patch_set.points.shape or not are_equal(before.weights, patch_set.weights):
        return None
    differ = points.view(np.uint64) != patch_set.points.view(np.uint64)
    return (differ[:, 0] | differ[:, 1] | differ[:, 2]).nonzero()[0]
