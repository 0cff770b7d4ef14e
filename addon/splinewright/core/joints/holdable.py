"""What the joints of curves and the seams of patches may hold."""

from typing import NamedTuple

from ..shape import parameters
from ..verbs import verbs
from . import held, held_joints


class Way(NamedTuple):
    """What a joint or seam may hold."""

    is_open: bool                       # whether anything can hold there
    why_not: str                        # of two edges of which nothing can, as a sentence, or ""
    knot: int                           # of a curve: which of its inner knots it is, from 1; 0 for none


def of_joints(definition, joints):
    """{sides: Way} of those of some core.joints.continuity.Joints that have two sides."""
    pieces = verbs.pieces_of(definition) if definition.has_curves else []
    return {joint.sides: _way(definition, pieces, *joint.sides) for joint in joints if joint.sides}


def _way(definition, pieces, first, second):
    is_open = held.can_hold(definition, first, second)
    is_knot = definition.has_curves and first[1] not in held_joints.ENDS
    knots = parameters.inner_knots(pieces[first[0]]).tolist() if is_knot else []
    number = knots.index(first[1]) + 1 if first[1] in knots else 0
    return Way(is_open, "" if is_open else held.why_not(definition, first, second), number)
