"""Figures as images: twice as large, then halved, so that lines are smooth."""

import numpy as np
from PIL import Image, ImageChops, ImageDraw

from making import part

figures = part('core.figures.figure')

#: Points of a curve, and how much larger it is drawn.
_POINTS, _LARGER = 16, 2


def image(figure, pixels):
    """The image of a core.figures.figure.Figure that is so many pixels wide."""
    scale = _LARGER * pixels / figure.width
    made = Image.new('RGB', (_LARGER * pixels, round(scale * figure.height)), 'white')
    drawing = ImageDraw.Draw(made)
    for group in figure.groups:
        for item in group.items:
            color = tuple(round(255 * channel) for channel in item.color)
            if isinstance(item, figures.Dot):
                _dot(drawing, np.multiply(item.center, scale), item.diameter * scale, color)
            elif isinstance(item, figures.Stroke):
                for path in item.paths:
                    _line(drawing, _corners(path) * scale, item.width * scale, color)
            else:
                _area(made, [_corners(path) * scale for path in item.paths], color)
    return made.resize((pixels, round(made.height / _LARGER)), Image.LANCZOS)


def _corners(path):
    """(n, 2): the points of a Path, close enough to be a curve."""
    found, before = [path.start[None]], path.start
    at = np.linspace(0.0, 1.0, _POINTS + 1)[1:, None, None]
    for step in path.steps:
        level = np.broadcast_to(np.vstack([before, step]), (_POINTS, len(step) + 1, 2)) if len(step) > 1 else None
        while level is not None and level.shape[1] > 1:
            level = (1.0 - at) * level[:, :-1] + at * level[:, 1:]
        found.append(step if level is None else level[:, 0])
        before = step[-1]
    return np.concatenate([*found, path.start[None]] if path.closed else found)


def _line(drawing, corners, width, color):
    drawing.line(list(map(tuple, corners)), fill=color, width=max(1, round(width)), joint='curve')
    for end in corners[[0, -1]]:
        _dot(drawing, end, width, color)


def _dot(drawing, center, diameter, color):
    (x, y), half = center, max(diameter, 1.0) / 2.0
    drawing.ellipse((x - half, y - half, x + half, y + half), fill=color)


def _area(made, outlines, color):
    """Fill what lies inside an odd number of outlines."""
    places = np.concatenate(outlines)
    (left, top), (right, bottom) = np.floor(places.min(axis=0)).astype(int), np.ceil(places.max(axis=0)).astype(int) + 1
    if right <= 0 or bottom <= 0 or left >= made.width or top >= made.height:
        return
    inside = Image.new('1', (right - left, bottom - top))
    for outline in outlines:
        one = Image.new('1', inside.size)
        ImageDraw.Draw(one).polygon(list(map(tuple, outline - (left, top))), fill=1)
        inside = ImageChops.logical_xor(inside, one)
    made.paste(color, (int(left), int(top)), inside.convert('L'))
