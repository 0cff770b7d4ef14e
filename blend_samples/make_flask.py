"""A flask: its sides are lofts through sections that turn from rounded oblongs into circles, its dented front and back are holes
that Fill closes, going on from the open sides of the lofts, G2. The left half has the sections of the right one, mirrored. All
curves are in the file, hidden from the picture only: edit a section, and the flask follows.
"""

import sys
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
import stage

stage.ROUGHNESS['sea'] = 0.12
stage.begin()
sc = stage.splinecore()
#: (height, half width, half depth, exponent of the superellipse, depth of the dents as a part of the half depth, where they
#: begin as a part of the half width)
SECTIONS = ((0.0, 0.76, 0.52, 4.0, 0.0, 0.5), (0.25, 0.87, 0.61, 3.6, 0.06, 0.5), (1.1, 0.80, 0.57, 3.0, 0.34, 0.5),
            (2.0, 0.80, 0.56, 2.8, 0.16, 0.5), (2.6, 0.5, 0.42, 2.2, 0.0, 0.55), (2.95, 0.27, 0.27, 2.0, 0.0, 0.62))
KNOTS = (0, 0, 0, 0, 0.25, 0.5, 0.75, 1, 1, 1, 1)
#: (radius, height)
COLLAR = ((0.29, 2.90), (0.31, 2.91), (0.315, 2.96), (0.31, 3.03), (0.29, 3.045), (0.27, 3.05))
CAP = ((0, 3.77), (0.16, 3.77), (0.38, 3.77), (0.375, 3.62), (0.37, 3.4), (0.365, 3.2), (0.36, 3.05), (0.28, 3.05))
#: (place, height)
BACKDROP = ((-14, 0), (2, 0), (6, 0), (9, 0.5), (11, 4), (12, 22))


def section(width, depth, exponent, dent, start):
    """The side of a superellipse, from where the dent of the front begins to where that of the back ends: seven points."""
    turn = np.arccos(start ** (exponent / 2))
    angles = np.linspace(-turn, turn, 41)
    x = width * np.cos(angles) ** (2 / exponent)
    y = depth * np.sign(angles) * np.abs(np.sin(angles)) ** (2 / exponent)
    points = np.stack([x, y * (1 - dent * (1 - (x / width) ** 2) ** 2), 0 * x], 1)
    lengths = np.r_[0, np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))]
    return sc.fit.approximate(points, parameters=lengths / lengths[-1], knots=KNOTS, corrections=20).value


def source(value, name, height=0.0):
    ob = stage.shape(value, name, (0, 0, height), 'ink')
    ob.hide_render = True
    return ob


def mirrored(ob, name):
    """A second object of the same curve."""
    other = ob.copy()
    other.name, other.scale.x = name, -1
    bpy.context.scene.collection.objects.link(other)
    return other


def surface(operator, sources, name, color, u, v, **settings):
    ob = stage.follow(operator, sources, name, color, **settings)
    ob.data.splinewright.resolution_u, ob.data.splinewright.resolution_v = u, v
    return ob


def bridge(i, end, name):
    """The curve over a dent, from a section to the one mirrored."""
    ob = stage.follow('add_blend', [right[i], left[i]], name, 'ink', continuity='G2', first_end=end, second_end=end)
    ob.hide_render = True
    return ob


def spline(points):
    """The clamped cubic B-spline of control points."""
    spans = len(points) - 3
    return sc.NurbsCurve(3, [0] * 3 + [*range(spans + 1)] + [spans] * 3, points)


def revolved(profile, name, color):
    curve = source(spline([(radius, 0, height) for radius, height in profile]), f"Profile of the {name.lower()}")
    surface('add_revolve', [curve], name, color, 20, 6, axis='z')


right = [source(section(*form), f"Section {i + 1}, right", height) for i, (height, *form) in enumerate(SECTIONS)]
left = [mirrored(ob, f"Section {i + 1}, left") for i, ob in enumerate(right)]
sides = [surface('add_loft', curves, name, 'cobalt', 12, 16) for curves, name in ((right, "Right side"), (left, "Left side"))]
for end, name in (('start', "Front"), ('end', "Back")):
    borders = [bridge(i, end, f"{where} of the {name.lower()}") for i, where in ((0, "Foot"), (-1, "Collar"))]
    surface('add_filling', [*sides, *borders], name, 'sea', 12, 12, continuity='G2')
revolved(COLLAR, "Collar", 'silver')
revolved(CAP, "Cap", 'biscuit')
wall = source(spline([(-30, y, z) for y, z in BACKDROP]), "Profile of the backdrop")
surface('add_extrude', [wall], "Backdrop", 'cloth', 8, 1, x=60, z=0)
for ob in bpy.context.scene.objects:
    if ob.type == 'LIGHT':
        ob.data.energy = 0.6
stage.lamp((-4.7, -6.7, 2.6), (0, 0, 1.5), 300, 1.2, 4.4)
stage.lamp((-7.5, -1.5, 4.2), (0, 0, 1.8), 280, 1.4, 4)
stage.lamp((6, -1, 3.4), (0, 0, 1.6), 160, 0.8, 4.5)
stage.camera((4.6, -8.9, 3.1), (0, 0, 1.84), 68)
stage.smooth()
bpy.context.scene.cycles.caustics_reflective = False
stage.finish("flask", samples=64, size=(560, 720))
