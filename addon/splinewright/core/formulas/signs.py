"""Crosses, arrows and polygons of pictures. Names of marks and arrows say what stands beside them.

Such a name is "mark d_{1}  2 : 3" or "arrow R_{0}": what it is, a letter, what stands below its line, and what follows. All of
one letter have one color.
"""

from fractions import Fraction

import numpy as np

from ..base.library import sc
from .functions import Part

MARK, ARROW = "mark", "arrow"
#: Letters that are drawn beside something are called by this and what that is called.
TEXT = "text"
#: Of an arrow, how long its head is and how far it reaches to each side.
_HEAD, _BARB = 0.15, 0.05
#: Largest number of a ratio that is written in whole numbers.
_WHOLE = 99


def cross(text, point, radius):
    """The Part that is three lines through a point, along the axes; in a list, which is empty where there is no radius."""
    if radius <= 0.0 or not np.isfinite(point).all():
        return []
    arms = radius * np.eye(3)
    steps = np.concatenate([each for arm in arms for each in ([-arm], [arm], [np.zeros(3)])])[:-1]
    return [Part(f"{MARK} {text}", polyline(point + steps))]


def arrow(text, start, vector):
    """The Part that is an arrow, whose head is seen from everywhere; in a list, which is empty where it has no length."""
    length = np.linalg.norm(vector)
    if not length > 0.0 or not np.isfinite([start, vector]).all():
        return []
    along = vector / length
    away = np.eye(3)[2] if abs(along[2]) < 0.9 else np.eye(3)[0]
    across = np.cross(away, along)
    across /= np.linalg.norm(across)
    tip, back = start + vector, start + (1.0 - _HEAD) * vector
    sides = [sign * _BARB * length * side for side in (across, np.cross(along, across)) for sign in (1.0, -1.0)]
    return [Part(f"{ARROW} {text}", polyline(np.array([start, tip, *(each for side in sides for each in (back + side, tip))])))]


def named(name):
    """(letter, what stands below its line, what follows) of the name of a mark or an arrow."""
    text = name.partition(" ")[2]
    letter, has_index, rest = text.partition("_{")
    if not has_index:
        letter, _, after = text.partition(" ")
        return letter, "", f" {after}" if after else ""
    below, _, after = rest.partition("}")
    return letter, below, after


def group_of(name):
    """What has one color: of marks and arrows all of a letter, else the name itself. Letters have that of what they stand beside."""
    name = of_text(name)
    kind = name.partition(" ")[0]
    return f"{kind} {named(name)[0]}" if kind in (MARK, ARROW) else name


def of_text(name):
    """What letters stand beside, where a name is one of letters, else the name."""
    return name.removeprefix(f"{TEXT} ")


def place_of(name, points):
    """Where the label of a mark or an arrow stands, by the points of its curve."""
    if name.partition(" ")[0] == ARROW:
        return points[1]
    return (points.min(axis=0) + points.max(axis=0)) / 2.0


def ratio(one, other):
    """Two lengths as a text: in whole numbers where those are small, else with 1 as the smaller one; none where one is not above 0."""
    if not (one > 0.0 and other > 0.0):
        return ""
    near = Fraction(one / other).limit_denominator(_WHOLE)
    if 0 < near.numerator <= _WHOLE and abs(near * other - one) <= 1e-6 * one:
        return f"  {near.numerator} : {near.denominator}"
    return f"  1 : {other / one:.4g}" if one < other else f"  {one / other:.4g} : 1"


def polyline(points):
    """The curve of degree 1 through points."""
    return sc.NurbsCurve(1, _knots(len(points)), points)


def polygon(rows):
    """The polygon of homogeneous points, as curves of degree 1. A leg with both ends at infinity is left out."""
    is_leg = (rows[:-1, 3] != 0.0) | (rows[1:, 3] != 0.0)
    runs = np.flatnonzero(np.diff(np.concatenate([[0], is_leg, [0]])))
    for first, last in runs.reshape(-1, 2):
        row = rows[first:last + 1]
        yield sc.NurbsCurve.from_homogeneous(1, _knots(len(row)), row)


def _knots(count):
    return np.concatenate([[0.0], np.arange(count), [count - 1.0]])


def place(row):
    """(3,): where a homogeneous point is; NaN at infinity."""
    return row[:3] / row[3] if row[3] != 0.0 else np.full(3, np.nan)
