"""A figure: strokes, dots and filled areas on a page, in groups by what they show."""

from typing import NamedTuple

import numpy as np

from .paths import Path

BLACK = (0.0, 0.0, 0.0)
#: The lightness below which a color is read well on white; how far apart the channels of a gray may lie.
_DARK, _GRAY = 0.3, 0.12
#: The arrow of a direction: how long and how wide its head is, in mm.
_HEAD = 2.4, 1.2


class Stroke(NamedTuple):
    paths: tuple                        # of Path
    color: tuple
    width: float                        # in mm
    dashed: bool = False


class Area(NamedTuple):
    """The inside of closed Paths; text: the letters that it shows."""

    paths: tuple
    color: tuple
    text: str = ""


class Dot(NamedTuple):
    center: tuple
    diameter: float
    color: tuple


class Group(NamedTuple):
    name: str
    items: tuple                        # of Stroke, Area and Dot


class Figure(NamedTuple):
    width: float
    height: float
    white: bool                         # whether the page is white; transparent otherwise
    groups: tuple


def ink(color):
    """A color of a dark view, dark enough to be read on white: grays change places, others become darker."""
    channels = np.clip(np.array(color[:3], float), 0.0, 1.0)
    if np.ptp(channels) <= _GRAY:
        gray = float(min(channels.mean(), 1.0 - channels.mean()))
        return (gray, gray, gray)
    lightness = float(channels @ (0.2126, 0.7152, 0.0722))
    return tuple((channels * min(1.0, (_DARK / max(lightness, 1e-9)) ** 0.5)).tolist())


def arrow_head(foot, tip):
    """The Paths of the head of an arrow on the page; () where that is a point."""
    along = np.asarray(tip, float) - foot
    length = np.linalg.norm(along)
    if not length > 0.0:
        return ()
    along = along / length
    across = np.array([-along[1], along[0]])
    corners = [tip, *(tip - _HEAD[0] * along + side * _HEAD[1] / 2.0 * across for side in (1.0, -1.0)), tip]
    return (Path(corners[0], tuple(corner[None] for corner in corners[1:]), closed=True),)
