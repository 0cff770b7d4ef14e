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
#: Of the ribs, by the half width; the last one is the edge, which lies in the base.
RIBS = (0.0, 0.3, 0.56, 0.78, 0.93, 1.0)
#: How much narrower and shorter the mouse is at its corners.
NARROWER, SHORTER = 0.14, 0.16
#: (size by the outline, height)
BASE = ((0.97, -0.02), (1.02, 0.02), (1.03, 0.10), (1.012, 0.15))
PARTS = np.linspace(0, np.pi, 13)


def rib(part):
    high = HIGH * (1 - (0.99 * part) ** 2.2) ** (1 / 2.2)
    x = LONG * (1 - SHORTER * part ** 2) * np.cos(PARTS)
    y = WIDE * part * (1 - NARROWER * np.cos(PARTS) ** 2)
    return np.stack([x, y, high * np.sin(PARTS) ** 0.85 * (1 + 0.16 * np.cos(PARTS))], 1)


def ring(size, height):
    """24 points, evenly spaced."""
    angles = np.linspace(0, 2 * np.pi, 2001)
    x, y = (np.sign(wave) * np.abs(wave) ** (2 / 4.4) for wave in (np.cos(angles), np.sin(angles)))
    points = np.stack([size * LONG * x, size * WIDE * y, np.full_like(x, height)], 1)
    lengths = np.r_[0, np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))]
    return points[np.searchsorted(lengths, np.arange(24) / 24 * lengths[-1])]


def cut(name, radius, **settings):
    ob = stage.follow('add_planes', [mouse], name, 'ink', count=1, resolution_u=24, **settings)
    return stage.tube(ob, radius)


stage.begin()
curves = [stage.through(rib(part), f"Rib {i + 1}" if part < 1 else "Edge") for i, part in enumerate(RIBS)]
half = stage.follow('add_loft', curves, "Half", 'snow')
half.hide_render = True
mouse = stage.follow('add_mirror', [half], "Mouse", 'snow', axis='y', gap=1e-3, smooth=True)
mouse.data.materials[0] = stage.striped('Z', 1.4, (0.62, 0.70, 0.78))
mouse.data.splinewright.resolution_u = mouse.data.splinewright.resolution_v = 8
cut("Line behind the buttons", 0.008, axis='x', offset=-0.25)
rings = [stage.through(ring(*form), f"Ring {i + 1} of the base", closed=True, parametrisation='uniform')
         for i, form in enumerate(BASE)]
base = stage.follow('add_loft', rings, "Base", 'ink', caps='both', align=False)
base.data.splinewright.resolution_u = base.data.splinewright.resolution_v = 4
stage.add('add_torus', "Wheel", (-0.62, 0, 0.42), (np.pi / 2, 0, 0), 'clay', radius=0.17, tube_radius=0.05)
stage.ground(-0.02, color='cloth')
stage.camera((-3.0, -3.1, 2.7), (0.0, -0.05, 0.2), lens=60)
stage.smooth(1)
stage.finish("mouse", samples=48, size=(800, 520))
