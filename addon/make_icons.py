"""The icons of the tools in Blender's form for them: colored triangles on a square of 255."""

import math
import struct

_WHITE, _GREEN, _LILAC = (0xE5, 0xE5, 0xE5, 0xFF), (0x59, 0xFF, 0x80, 0xFF), (0xD9, 0xAF, 0xF5, 0xFF)
#: Corners of a disc.
_CORNERS = 20


def disc(x, y, radius):
    turns = [2 * math.pi * i / _CORNERS for i in range(_CORNERS + 1)]
    rim = [(x + radius * math.cos(turn), y + radius * math.sin(turn)) for turn in turns]
    return [((x, y), a, b) for a, b in zip(rim, rim[1:])]


def line(points, width):
    """Through points, with round corners and ends."""
    found = [triangle for point in points for triangle in disc(*point, width / 2)]
    for (ax, ay), (bx, by) in zip(points, points[1:]):
        part = width / 2 / math.hypot(bx - ax, by - ay)
        x, y = -part * (by - ay), part * (bx - ax)
        found += fan([(ax + x, ay + y), (bx + x, by + y), (bx - x, by - y), (ax - x, ay - y)])
    return found


def fan(corners):
    """A convex polygon."""
    return [(corners[0], a, b) for a, b in zip(corners[1:], corners[2:])]


def cubic(a, b, c, d, count=16):
    def at(t):
        weights = (1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t ** 3
        return tuple(sum(w * p[axis] for w, p in zip(weights, (a, b, c, d))) for axis in (0, 1))
    return [at(i / count) for i in range(count + 1)]


def insert_knot():
    """A curve, a knot on it, and a plus."""
    curve = cubic((32, 60), (80, 235), (165, 10), (225, 175))
    return [(line(curve, 13), _WHITE), (disc(*curve[8], 25), _GREEN),
            (line([(48, 205), (108, 205)], 13) + line([(78, 175), (78, 235)], 13), _GREEN)]


def pull():
    """A curve that is drawn up by an arrow."""
    curve = cubic((32, 50), (120, 50), (80, 150), (128, 150), 10) + cubic((128, 150), (176, 150), (136, 50), (224, 50), 10)[1:]
    return [(line(curve, 13), _WHITE), (line([(128, 150), (128, 225)], 13), _GREEN),
            (fan([(128, 245), (158, 200), (98, 200)]), _GREEN)]


def weight():
    """A weight of a scale."""
    handle = [(128 + 25 * math.cos(turn / 8 * math.pi), 188 + 25 * math.sin(turn / 8 * math.pi)) for turn in range(17)]
    return [(line(handle, 13), _WHITE), (fan([(84, 168), (172, 168), (204, 40), (52, 40)]), _LILAC)]


ICONS = (insert_knot, pull, weight)


def packed(parts):
    """The bytes of an icon: the corners of all triangles, then their colors. parts: triangles and the color of each."""
    corners = [corner for triangles, _ in parts for triangle in triangles for corner in triangle]
    colors = [color for triangles, color in parts for _ in range(3 * len(triangles))]
    numbers = [min(max(round(number), 0), 255) for corner in corners for number in corner]
    return struct.pack('<4s4B', b'VCO\0', 255, 255, 0, 0) + bytes(numbers) + b"".join(map(bytes, colors))


def content():
    """Pairs of the name of a file and its bytes."""
    for icon in ICONS:
        yield f"{icon.__name__}.dat", packed(icon())
