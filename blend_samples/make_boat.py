"""A rowing boat: its hull is one loft through frames, its rails are pipes along the sides of the hull, its transom is ruled, its
seats are thick planes. The frames are in the file, hidden from the picture only: move one, and all of it follows.
"""

import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
import stage

stage.begin()
sc = stage.splinecore()
#: Frames from the stern to the bow: (place, half width, height of the side, half width of the bottom, height of the keel).
FRAMES = ((-2.4, 0.62, 0.95, 0.40, 0.30), (-1.5, 0.82, 0.86, 0.56, 0.12), (-0.4, 0.92, 0.82, 0.62, 0.05),
          (0.8, 0.82, 0.86, 0.48, 0.08), (1.8, 0.50, 0.98, 0.22, 0.22), (2.55, 0.10, 1.16, 0.03, 0.58), (2.75, 0.02, 1.22, 0.01, 0.90))


def frame(x, half, side, bottom, keel):
    """From the left side down under the keel and up to the right one."""
    low = keel + 0.35 * (side - keel)
    points = [(x, -half, side), (x, -0.5 * (half + bottom) - 0.06 * half, low), (x, -0.6 * bottom, keel + 0.06), (x, 0, keel)]
    return sc.fit.interpolate(np.array([*points, *((x, -y, z) for x, y, z in points[-2::-1])])).value


def source(value, name):
    ob = stage.shape(value, name, color='ink')
    ob.hide_render = True
    return ob


def side(name, border):
    """A side of the hull."""
    return source(hull.data.splinewright.value.boundary(border), f"Sheer line, {name}")


frames = [source(frame(*numbers), f"Frame {i + 1}") for i, numbers in enumerate(FRAMES)]
hull = stage.follow('add_loft', frames, "Hull", 'clay')
hull.data.splinewright.resolution_u, hull.data.splinewright.resolution_v = 8, 10
for name, border in (('left', 'u_start'), ('right', 'u_end')):
    stage.follow('add_pipe', [side(name, border)], f"Rail, {name}", 'biscuit', radius=0.045, end_radius=0.03, caps='round', resolution_u=6)
x, half, top = FRAMES[0][:3]
edge = source(sc.BezierCurve([(x, -half, top), (x, 0, top + 0.08), (x, half, top)]), "Upper edge of the transom")
stage.follow('add_ruled', [frames[0], edge], "Transom", 'biscuit', resolution_u=8)
for i, (place, wide) in enumerate(((-1.3, 0.80), (0.2, 0.84), (1.35, 0.62))):
    seat = stage.patch(sc.build.plane((place - 0.16, -wide, 0.62), (0.32, 0, 0), (0, 2 * wide, 0)), f"Top of seat {i + 1}")
    seat.hide_render = True
    stage.follow('add_thickened', [seat], f"Seat {i + 1}", 'biscuit', distance=0.05, resolution_u=1)
stage.ground(color='cloth')
stage.lamp((-4, -5, 6), (0, 0, 0.6), 190, 3)
stage.lamp((6, 3, 5), (0.5, 0, 0.6), 120, 2)
stage.camera((-5.4, -6.8, 4.4), (0.1, 0, 0.45), 56)
stage.smooth()
stage.finish("boat", samples=48, size=(800, 520))
