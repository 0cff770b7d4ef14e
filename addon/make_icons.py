"""The icons of the tools in Blender's form for them: colored triangles on a square of 255."""

import math
import struct

_WHITE, _GREEN, _LILAC = (0xE5, 0xE5, 0xE5, 0xFF), (0x59, 0xFF, 0x80, 0xFF), (0xD9, 0xAF, 0xF5, 0xFF)
_DARK = (0x38, 0x38, 0x40, 0xFF)
#: The width of most lines.
_THIN = 15
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


def arc(x, y, radius, first, last, count=16):
    """From one angle to another, in degrees."""
    turns = [math.radians(first + (last - first) * i / count) for i in range(count + 1)]
    return [(x + radius * math.cos(turn), y + radius * math.sin(turn)) for turn in turns]


def head(tip, towards, size=46):
    """The head of an arrow at a tip that points towards an angle in degrees."""
    def away(angle):
        turn = math.radians(towards + angle)
        return tip[0] + size * math.cos(turn), tip[1] + size * math.sin(turn)
    return fan([tip, away(180 - 33), away(180 + 33)])


def between(low, high):
    """What lies between two rows of as many points."""
    return [part for a, b, c, d in zip(low, low[1:], high[1:], high) for part in fan([a, b, c, d])]


def dashes(points, width):
    """Every other part of a line."""
    return [part for pair in zip(points[::2], points[1::2]) for part in line(pair, width)]


def cross(x, y, size, width=_THIN):
    return line([(x - size, y - size), (x + size, y + size)], width) + line([(x - size, y + size), (x + size, y - size)], width)


def _pencil(x, y):
    """Its tip at (x, y)."""
    corners = [(x, y), (x + 17, y + 50), (x + 50, y + 17)]
    body = [(x + 25, y + 58), (x + 58, y + 25), (x + 118, y + 85), (x + 85, y + 118)]
    return [(fan(corners), _WHITE), (fan(body), _GREEN)]


def _patch(left, right, low=35, high=215):
    """The lower and the upper side of a bent patch between two x."""
    third = (right - left) / 3
    return [cubic((left, y - 10), (left + third, y + 35), (right - third, y - 45), (right, y + 5)) for y in (low + 10, high - 15)]


def draw_curve():
    """A stroke, and a pencil at its end."""
    return [(line(cubic((25, 150), (40, 10), (110, -15), (128, 115)), _THIN), _WHITE), *_pencil(128, 115)]


def draw_on_surface():
    """The same on a patch."""
    return [(between(*_patch(15, 225, 20, 200)), _LILAC), (line(cubic((45, 95), (60, 30), (110, 30), (128, 110)), 15), _DARK),
            *_pencil(128, 115)]


def draw_contour():
    """Segments and an arc between the points that were clicked."""
    corners = [(35, 40), (35, 120), (125, 212), (222, 212)]
    path = [corners[0], *arc(125, 122, 90, 180, 90), corners[3]]
    return [(line(path, _THIN), _WHITE), ([part for corner in corners for part in disc(*corner, 25)], _GREEN)]


def insert_knot():
    """A curve, a knot on it, and a plus."""
    curve = cubic((32, 60), (80, 235), (165, 10), (225, 175))
    return [(line(curve, _THIN), _WHITE), (disc(*curve[8], 25), _GREEN),
            (line([(48, 205), (108, 205)], _THIN) + line([(78, 175), (78, 235)], _THIN), _GREEN)]


def split():
    """Two parts of a curve, and the cut between them."""
    curve = cubic((20, 60), (80, 255), (165, 0), (235, 190), 20)
    return [(line(curve[:8], 18) + line(curve[-8:], 18), _WHITE), (dashes([(128, y) for y in (22, 62, 107, 148, 193, 233)], 18), _GREEN)]


def isocurve():
    """A patch, and a curve on it from side to side."""
    low, high = _patch(22, 233)
    return [(between(low, high), _LILAC), (line(cubic(low[8], (160, 80), (95, 160), high[8]), 24), _GREEN),
            (disc(*low[8], 23) + disc(*high[8], 23), _GREEN)]


def edge():
    """A patch, and one of its edges beside it."""
    low, high = _patch(95, 238)
    return [(between(low, high), _LILAC), (line([(40, low[0][1]), (40, high[0][1])], 26), _GREEN)]


def trim():
    """A curve that ends where it meets another; the part behind is struck out."""
    return [(line([(118, 25), (118, 230)], _THIN), _WHITE), (line(cubic((18, 70), (45, 110), (80, 125), (118, 128)), _THIN), _WHITE),
            (dashes([(148, 128), (178, 126), (206, 118), (234, 104)], _THIN), _GREEN), (cross(195, 195, 30, 20), _GREEN)]


def extend():
    """A curve that continues to another."""
    return [(line([(230, 25), (230, 230)], _THIN), _WHITE), (line(cubic((20, 60), (45, 105), (65, 120), (105, 128)), _THIN), _WHITE),
            (line([(112, 128), (175, 128)], 18), _GREEN), (head((218, 128), 0, 60), _GREEN)]


def _corner(middle):
    """Two lines and the space between them."""
    return [(line([(40, 25), (40, 118)], _THIN) + line([(137, 215), (230, 215)], _THIN), _WHITE),
            (dashes([(40, 145), (40, 172), (40, 205), (50, 215), (83, 215), (110, 215)], 9), _WHITE), (line(middle, 24), _GREEN)]


def fillet():
    return _corner(arc(137, 118, 97, 180, 90))


def chamfer():
    return _corner([(40, 118), (137, 215)])


def round_edges():
    """A block, and one of its edges rounded."""
    return [(fan([(128, 245), (228, 198), (128, 150), (28, 198)]), _LILAC),
            (fan([(18, 180), (98, 142), (98, 20), (18, 60)]) + fan([(238, 180), (158, 142), (158, 20), (238, 60)]), _LILAC),
            (line([(128, 120), (128, 28)], 34), _GREEN)]


def pull():
    """A curve that is drawn up by an arrow."""
    curve = cubic((32, 50), (120, 50), (80, 150), (128, 150), 10) + cubic((128, 150), (176, 150), (136, 50), (224, 50), 10)[1:]
    return [(line(curve, _THIN), _WHITE), (line([(128, 150), (128, 225)], _THIN), _GREEN),
            (fan([(128, 245), (158, 200), (98, 200)]), _GREEN)]


def join():
    """Two patches that move to each other."""
    return [(fan([(12, 40), (88, 25), (88, 200), (12, 215)]), _LILAC), (fan([(168, 25), (244, 40), (244, 215), (168, 200)]), _LILAC),
            (head((124, 113), 0, 62) + head((132, 113), 180, 62), _GREEN)]


def weight():
    """A weight of a scale."""
    handle = [(128 + 25 * math.cos(turn / 8 * math.pi), 188 + 25 * math.sin(turn / 8 * math.pi)) for turn in range(17)]
    return [(line(handle, _THIN), _WHITE), (fan([(84, 168), (172, 168), (204, 40), (52, 40)]), _LILAC)]


def radius():
    """The circle of a pipe, and its radius."""
    return [(line(arc(128, 128, 98, 0, 360, 32), _THIN), _LILAC), (line([(128, 128), (165, 165)], 18), _GREEN),
            (head((196, 196), 45, 56), _GREEN), (disc(128, 128, 22), _WHITE)]


def tilt():
    """An arrow that turns around a curve."""
    turn = arc(128, 110, 88, -200, 25, 24)
    squeezed = [(x, 110 + 0.5 * (y - 110)) for x, y in turn]
    return [(line([(128, 20), (128, 240)], _THIN), _WHITE), (line(squeezed, 18), _GREEN), (head((198, 168), 112, 64), _GREEN)]


def measure():
    """A ruler across the picture."""
    def along(way, off):
        return 25 + way + off, 75 + way - off
    ticks = [line([along(way, 0), along(way, -20 if i % 2 else -32)], 11) for i, way in enumerate(range(25, 150, 25))]
    return [(fan([along(0, -38), along(155, -38), along(155, 38), along(0, 38)]), _LILAC), (sum(ticks, []), _DARK)]


def pick():
    """One of several pieces, and the mouse on it."""
    return [(fan([(15, 140), (110, 140), (110, 235), (15, 235)]), _LILAC), (fan([(130, 140), (225, 140), (225, 235), (130, 235)]), _GREEN),
            (fan([(15, 25), (110, 25), (110, 120), (15, 120)]), _LILAC),
            (fan([(165, 195), (235, 95), (188, 90)]) + fan([(165, 195), (188, 90), (152, 65)]) + line([(186, 95), (208, 45)], 24), _WHITE)]


ICONS = (draw_curve, draw_on_surface, draw_contour, insert_knot, split, isocurve, edge, trim, extend, fillet, chamfer, round_edges,
         pull, join, weight, radius, tilt, measure, pick)


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
