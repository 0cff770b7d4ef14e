"""Where the next point of the drawing in a plane goes, when its way is held to angles or numbers are typed.

All is in the plane of the view: x to the right, y up, from the point before.
"""

import math

import numpy as np

#: Angles to which a way is held.
STEP = math.radians(15.0)


def next_point(away, way=None, is_held=False, length=None, angle=None):
    """(2,): from the point before to the next one. away: to the mouse; way: the direction in which the part
    before ends, or None; angle: in radians from that, or from the right, counterclockwise."""
    away = np.asarray(away, dtype=np.float64)
    base = _direction(way)
    if angle is not None:
        direction = base + angle
    elif is_held:
        direction = _held(_direction(away), base)
    else:
        direction = _direction(away)
    along = np.array([math.cos(direction), math.sin(direction)])
    if length is None:
        is_turned = angle is not None or is_held
        length = max(float(away @ along), 0.0) if is_turned else float(np.linalg.norm(away))
    return length * along


def turn(away, way=None):
    """The angle of a way from that before it, or from the right, above -pi and up to pi."""
    found = _direction(away) - _direction(way)
    return math.pi - (math.pi - found) % (2 * math.pi)


def _direction(away):
    return 0.0 if away is None or not np.any(away) else math.atan2(away[1], away[0])


def _held(direction, base):
    """The nearest of whole steps from the right and from a base."""
    found = (first + STEP * round((direction - first) / STEP) for first in (base, 0.0))
    return min(found, key=lambda one: abs(one - direction))
