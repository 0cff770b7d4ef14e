"""Displays beside the shapes themselves, worked out when their definition changes and not at every redraw."""

import time
from contextlib import suppress

import numpy as np

from ...core.analysis import measured
from ...core.base.library import sc
from ...core.joints import applicable_verbs, continuity, holdable, seams
from ...core.rounding import edges as rounding
from ...core.shape import describe, transform
from ...core.surfaces import outlines, sections
from ...core.verbs import parameter_picking, verbs
from ..data import store
from ..data.file_state import remember, state

#: Joints that are measured.
SHOWN = 50
#: Seams that are drawn.
DRAWN = 500
#: So much of definitions is kept by their digests, and so many Wholes.
_KEPT, _WHOLES = 8, 64


def survey_of(data):
    """The core.joints.continuity.Survey of a definition as it is now: of the joints of curves, the seams of patches.

    Raises store.UnreadableDefinition.
    """
    return _kept('survey', data, _survey)


def seams_of(data):
    """(the measures along the seams of a Mesh's definition as it is now, and along creases, its size). Raises
    store.UnreadableDefinition."""
    return _kept('seams', data, lambda definition: (seams.lines_of(definition, DRAWN), definition.size))


def middles_of(data):
    """(n, 3): a point in the middle of each piece of a definition. Raises store.UnreadableDefinition."""
    return _kept('middles', data, lambda definition: outlines.middles(verbs.pieces_of(definition)))


def outlines_of(data):
    """For each piece of a definition the polylines of core.surfaces.outlines.outline(). Raises store.UnreadableDefinition."""
    return _kept('outlines', data, lambda definition: list(map(outlines.outline, verbs.pieces_of(definition))))


def sides_of(data):
    """For each patch of a definition its core.surfaces.outlines.sides(). Raises store.UnreadableDefinition."""
    return _kept('sides', data, lambda definition: list(map(outlines.sides, verbs.pieces_of(definition))))


def pieces_of(data):
    """The curves or patches of a definition. Raises store.UnreadableDefinition."""
    return _kept('pieces', data, verbs.pieces_of)


def samples_of(data):
    """For each curve of a definition its core.verbs.parameter_picking.Samples. Raises store.UnreadableDefinition."""
    return _kept('samples', data, lambda definition: list(map(parameter_picking.samples, verbs.pieces_of(definition))))


def edges_of(data, sources, matrices):
    """(n, 3): a point on each edge of shapes under matrices, as Round Edge numbers them, kept for what they make. Raises
    store.UnreadableDefinition and Refusal."""
    key = 'edges', data.name, *(store.digest(source.data) for source in sources), *(matrix.tobytes() for matrix in matrices)
    return _by_digest(key, lambda: rounding.middles_of(_shapes_of(sources, matrices)))


def edge_lines_of(sources, matrices, text=""):
    """([(n, 3)]: polylines of the edges of shapes under matrices, as Round Edge numbers them; the numbers of those that it rounds by a
    text). Raises as edges_of() does."""
    return rounding.lines_of(_shapes_of(sources, matrices), text)


def _shapes_of(sources, matrices):
    return [verbs.pieces_of(transform.transformed(store.read(source.data), matrix)) for source, matrix in zip(sources, matrices)]


def ways_of(data):
    """{sides: core.joints.holdable.Way} of the joints of survey_of(). Raises store.UnreadableDefinition."""
    return _kept('ways', data, lambda definition: holdable.of_joints(definition, survey_of(data).joints))


def starts_of(data):
    """(4, 3): where the first curve of a definition starts and a place a part further, and the latter and the former of the curve
    that is turned; of a patch its middle. Raises store.UnreadableDefinition."""
    return _kept('starts', data, _starts)


def _starts(definition):
    piece = verbs.pieces_of(definition)[0]
    if definition.has_curves:
        return sections.samples(piece)[[0, 3, -4, -1]]
    return np.repeat([piece.evaluate(*map(np.mean, piece.domain))], 4, axis=0)


def described(data):
    """core.shape.describe.lines() of a definition. Raises store.UnreadableDefinition."""
    return _kept('described', data, describe.lines)


def refused(data):
    """Names of operators that have nothing to do with a definition. Raises store.UnreadableDefinition."""
    return _kept('refused', data, applicable_verbs.refused)


def moved_of(data, matrix):
    """The core.analysis.measured.Moved of a definition under a matrix. Raises store.UnreadableDefinition and Refusal."""
    return _kept(('moved', matrix.tobytes()), data, lambda definition: measured.moved(definition, matrix))


def whole_soon(data, matrix, seconds):
    """The core.analysis.measured.Whole of it where that is known, or found in the seconds that a panel has; None where it takes
    longer, until keep_whole(). Raises as moved_of() does."""
    key = _key(data, matrix)
    if key not in state.wholes:
        whole = None
        with suppress(sc.Cancelled):
            whole = measured.whole(moved_of(data, matrix), _after(seconds))
        remember(state.wholes, key, whole, _WHOLES)
    return state.wholes[key]


def keep_whole(data, matrix, whole):
    """Have this for the Whole of a definition under a matrix."""
    remember(state.wholes, _key(data, matrix), whole, _WHOLES)


def place_of(data, matrix, number, fractions, seconds):
    """core.analysis.measured.at_parameter() of a piece, by its number from 0, without what takes longer than these seconds. The last
    one is kept."""
    key = *_key(data, matrix), number, fractions
    if state.place[0] != key:
        state.place = key, measured.at_parameter(moved_of(data, matrix).pieces[number], fractions, _after(seconds))
    return state.place[1]


def _key(data, matrix):
    return matrix.tobytes(), store.digest(data)


def _after(seconds):
    """A `cancel` as the library takes it that calls off what takes longer."""
    end = time.monotonic() + seconds
    return lambda: time.monotonic() > end


def _survey(definition):
    room = continuity if definition.has_curves else seams
    return room.surveyed(definition, SHOWN)


def _kept(what, data, work):
    reading = store.reading(data)
    return reading.kept(what, lambda: _by_digest((what, reading.digest), lambda: work(store.read(data))))


def _by_digest(name, make):
    """What undo brings back is known by its digest."""
    if name not in state.surveys:
        remember(state.surveys, name, make(), _KEPT)
    return state.surveys[name]
