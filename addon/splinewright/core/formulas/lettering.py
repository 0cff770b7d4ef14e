"""Labels as curves, which render: strokes beside what they name."""

import numpy as np

from . import glyphs, signs
from .functions import Part

#: What stands below the line: how large it is, and how far below, as parts of the height of letters.
_SMALL, _DROP = 0.72, 0.3
#: Where a label begins beside its place, as a part of the height of letters.
_BESIDE = 0.35
#: The axes of letters: to the right, and up.
PLANES = {'xy': (0, 1), 'xz': (0, 2), 'yz': (1, 2)}


def picture(labels, height, plane):
    """The Parts of labels.Labels, called after what they stand beside. height: of capitals; plane: one of PLANES."""
    right, up = np.eye(3)[list(PLANES[plane])]
    scale = height / glyphs.CAPITAL
    parts = []
    for label in labels:
        start = np.array(label.point) + _BESIDE * height * (right + up)
        name = f"{signs.TEXT} {label.part or label.base}"
        parts += [Part(name, signs.polyline(start + scale * np.array(stroke) @ [right, up])) for stroke in written(label.runs)]
    return parts


def written(runs):
    """[[(x, y)]]: the strokes of texts one after the other on the grid of glyphs; runs: (text, whether it stands below the line)."""
    found, x = [], 0.0
    for text, is_below in runs:
        size, y = (_SMALL, -_DROP * glyphs.CAPITAL) if is_below else (1.0, 0.0)
        for sign in text:
            found += [[(x + size * at, y + size * over) for at, over in stroke] for stroke in glyphs.strokes(sign)]
            x += size * glyphs.width(sign)
    return found
