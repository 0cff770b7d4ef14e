"""A computer mouse under stripes: one half is a loft through curves that run from front to back; Mirror joins it with its
image, G2 across the plane, so that stripes run on over it. The line between its buttons and its back is where a plane cuts both
halves. The curves go through the vertices of lines; they are in the file, hidden from the picture only: move one, and all of it
follows.
"""

import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
import stage

LONG, WIDE, HIGH = 1.15, 0.62, 0.68
#: Of the ribs and of the edge, by the half width.
RIBS, EDGE = (0.0, 0.3, 0.56, 0.76), 0.86
#: (size by the outline, height)
BASE = ((0.97, -0.02), (1.02, 0.02), (1.03, 0.10), (1.012, 0.15))
PARTS = np.linspace(0, np.pi, 13)


def outline(y):
    """Half the length at a distance from the middle."""
    return LONG * (1 - (y / WIDE) ** 3) ** (1 / 3)


def rib(part):
    y = part * WIDE
    high = HIGH * (1 - part ** 2.2) ** (1 / 2.2)
    x = outline(y) * np.cos(PARTS)
    return np.stack([x, np.full_like(x, y), high * np.sin(PARTS) ** 0.85 * (1 + 0.16 * np.cos(PARTS))], 1)


def edge():
    x = outline(EDGE * WIDE) * np.cos(PARTS)
    return np.stack([x, WIDE * (1 - np.abs(x / LONG) ** 3) ** (1 / 3), 0 * x], 1)


def ring(size, height):
    """24 points, evenly spaced."""
    angles = np.linspace(0, 2 * np.pi, 2001)
    x, y = (np.sign(wave) * np.abs(wave) ** (2 / 3) for wave in (np.cos(angles), np.sin(angles)))
    points = np.stack([size * LONG * x, size * WIDE * y, np.full_like(x, height)], 1)
    lengths = np.r_[0, np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))]
    return points[np.searchsorted(lengths, np.arange(24) / 24 * lengths[-1])]


def cut(name, radius, **settings):
    ob = stage.follow('add_planes', [mouse], name, 'ink', count=1, resolution_u=24, **settings)
    return stage.tube(ob, radius)


stage.begin()
curves = [stage.through(points, name) for points, name in
          [*((rib(part), f"Rib {i + 1}") for i, part in enumerate(RIBS)), (edge(), "Edge")]]
half = stage.follow('add_loft', curves, "Half", 'snow')
half.hide_render = True
mouse = stage.follow('add_mirror', [half], "Mouse", 'snow', axis='y', gap=1e-3, smooth=True)
mouse.data.materials[0] = stage.striped('Z', 1.4, (0.62, 0.70, 0.78))
mouse.data.splinewright.resolution_u = mouse.data.splinewright.resolution_v = 8
cut("Line behind the buttons", 0.008, axis='x', offset=-0.25)
rings = [stage.through(ring(*form), f"Ring {i + 1} of the base", closed=True) for i, form in enumerate(BASE)]
base = stage.follow('add_loft', rings, "Base", 'ink', caps='both')
base.data.splinewright.resolution_u = base.data.splinewright.resolution_v = 4
stage.add('add_torus', "Wheel", (-0.62, 0, 0.42), (np.pi / 2, 0, 0), 'clay', radius=0.17, tube_radius=0.05)
stage.ground(-0.02, color='cloth')
stage.camera((-3.0, -3.1, 2.7), (0.0, 0.0, 0.24), lens=66)
stage.smooth(1)
stage.finish("mouse", samples=48, size=(800, 520))
