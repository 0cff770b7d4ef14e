"""How large a lesson may be in sum: nobody can stop a step that is being made."""

import math

import numpy as np

from ..base.failures import Refusal

#: Most shapes of a lesson, faces of one span of all its surfaces, and faces that are there at once.
MOST_SHAPES, MOST_OF_SPANS, MOST_FACES = 200, 40_000, 300_000


def require_few(steps):
    """Refuse steps that make too many shapes, or ask for too many faces."""
    shapes = sum(len(step.make) for step in steps)
    if shapes > MOST_SHAPES:
        raise Refusal("the lesson makes {count} shapes: {most} are the most", count=shapes, most=MOST_SHAPES)
    asked = sum(math.prod(one.faces) for step in steps for one in (*step.make, *step.change) if one.faces)
    if asked > MOST_OF_SPANS:
        raise Refusal("the surfaces of the lesson ask for {count:,} faces of a span in sum: {most:,} are the most; fewer faces each, or "
                      "fewer surfaces with faces, are needed", count=asked, most=MOST_OF_SPANS)


def require_room(definition, faces, others):
    """Refuse faces of each span of a definition that are too many beside those of other shapes."""
    count = others + math.prod(faces) * sum(map(_spans, definition.pieces))
    if count > MOST_FACES:
        raise Refusal("the lesson would show {count:,} faces: {most:,} are the most", count=count, most=MOST_FACES)


def _spans(piece):
    return math.prod(max(len(np.unique(knots)) - 1, 1) for knots in piece.knots)
