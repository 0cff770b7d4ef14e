"""A cup, a sugar bowl, a spoon and biscuits of our own design: exact surfaces that follow their profiles and outlines.

What is round is revolved, the biscuits are extruded and ruled, handles and spoon are NURBS tubes, closed one way.
The curves are in the file, hidden from the picture only: edit one, and what was made of it follows.
"""

import sys
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
import stage

#: (distance from the axis, height), from the middle of the underside out, up, round the rim and back inside.
CUP = ((0, 0.10), (0.30, 0.10), (0.44, 0.10), (0.46, 0.0), (0.57, 0.0), (0.58, 0.07), (0.54, 0.17), (0.86, 0.30),
       (1.06, 0.70), (1.04, 1.08), (1.12, 1.33), (1.18, 1.41), (1.14, 1.43), (1.06, 1.33), (0.97, 1.08), (0.99, 0.72),
       (0.80, 0.38), (0.40, 0.24), (0, 0.24))
SAUCER = ((0, 0.06), (0.50, 0.06), (0.66, 0.06), (0.68, 0), (0.80, 0), (0.82, 0.06), (1.15, 0.09), (1.50, 0.18),
          (1.88, 0.34), (1.99, 0.40), (1.96, 0.43), (1.86, 0.39), (1.48, 0.24), (1.12, 0.155), (0.80, 0.14),
          (0.72, 0.15), (0.66, 0.11), (0.40, 0.10), (0, 0.10))
BOWL = ((0, 0.08), (0.35, 0.08), (0.43, 0.08), (0.45, 0), (0.58, 0), (0.59, 0.07), (0.58, 0.14), (1.02, 0.28),
        (1.27, 0.75), (1.05, 1.16), (0.80, 1.26), (0.77, 1.33), (0.70, 1.33), (0.72, 1.22), (0.95, 1.10),
        (1.16, 0.75), (0.94, 0.38), (0.50, 0.20), (0, 0.20))
LID = ((0, 1.44), (0.50, 1.40), (0.66, 1.34), (0.82, 1.32), (0.90, 1.34), (0.86, 1.40), (0.62, 1.54), (0.30, 1.64),
       (0.10, 1.68), (0.07, 1.76), (0.18, 1.84), (0.24, 1.94), (0.16, 2.04), (0, 2.05))
#: Along the spoon: (place, half width, height, hollow, thickness). At its ends it is one point,
#: with the next row in the plane across, so that they are round.
SPOON = ((0, 0, 0.20, 0, 0), (0, 0.20, 0.20, 0, 0.02), (0.22, 0.40, 0.21, 0.15, 0.022),
         (0.62, 0.42, 0.22, 0.20, 0.025), (0.95, 0.22, 0.23, 0.08, 0.03), (1.12, 0.08, 0.27, 0, 0.04),
         (1.45, 0.06, 0.36, 0, 0.04), (2.0, 0.07, 0.36, 0, 0.035), (2.5, 0.12, 0.20, 0, 0.03),
         (2.85, 0.16, 0.12, 0, 0.03), (3.02, 0.10, 0.13, 0, 0.03), (3.02, 0, 0.13, 0, 0))
stage.begin()
sc = stage.splinecore()


def clamped(count, degree=3):
    return [0] * degree + list(range(count - degree + 1)) + [count - degree] * degree


def source(value, name, place, turn=0.0):
    """A curve that shapes follow, left out of the picture."""
    ob = stage.add('add_bezier_curve', name, place, (0, 0, turn), 'ink', resolution_u=24)
    ob.data.splinewright.value = value
    ob.hide_render = True
    return ob


def revolved(profile, name, place, color):
    points = [(radius, 0, height) for radius, height in profile]
    curve = source(sc.NurbsCurve(3, clamped(len(points)), points), f"Profile of {name}", place)
    ob = stage.follow('add_revolve', [curve], name, color)
    ob.data.splinewright.resolution_u, ob.data.splinewright.resolution_v = 20, 3
    return ob


def tube(rings):
    """A patch through the room of rings (n, m, 3) of control points: clamped along, closed around."""
    rings = np.asarray(rings, float)
    return sc.NurbsPatch((3, 3), (clamped(len(rings)), range(rings.shape[1] + 1)), rings, periodic=(False, True))


def bow(spine, widths, name, place, color, turn=0.0):
    """A handle in the plane of x and z: an ellipse carried along a polygon of (x, z)."""
    spine, widths = np.array(spine), np.array(widths)
    along = np.gradient(spine, axis=0)
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    angles = np.linspace(0, 2 * np.pi, 9)[:-1]
    rings = [[(x + thin * np.cos(a) * -dz, wide * np.sin(a), z + thin * np.cos(a) * dx) for a in angles]
             for (x, z), (dx, dz), (thin, wide) in zip(spine, along, widths)]
    ob = stage.patch(tube(rings), name, place, color, 6)
    ob.rotation_euler = (0, 0, turn)
    return ob


def spoon():
    angles = -np.linspace(0, 2 * np.pi, 13)[:-1]
    side, up = np.cos(angles), np.sin(angles)
    return tube([np.column_stack([np.full(12, x), wide * side, height - hollow * up**2 + thick * up])
                 for x, wide, height, hollow, thick in SPOON])


def ring(radii):
    """A closed curve round the z axis with its control points that far away in turn."""
    angles = 2 * np.pi * np.arange(len(radii)) / len(radii)
    points = np.column_stack([radii * np.cos(angles), radii * np.sin(angles), 0 * angles])
    return sc.NurbsCurve(3, range(len(radii) + 1), points, periodic=True)


def biscuit(name, place, turn, thick=0.16):
    """Walls are extruded; the top is ruled between the hole and an outline that shares the data of the one below."""
    above = (*place[:2], place[2] + thick)
    outline = source(ring(np.tile([0.74, 0.52], 8)), f"Outline of {name}", place, turn)
    hole = source(ring(np.full(16, 0.24)), f"Hole of {name}", above, turn)
    rim = bpy.data.objects.new(f"{outline.name}, above", outline.data)
    rim.location, rim.rotation_euler, rim.hide_render = above, (0, 0, turn), True
    bpy.context.scene.collection.objects.link(rim)
    stage.follow('add_extrude', [outline], f"{name}, outside", 'biscuit', x=0.0, y=0.0, z=thick, resolution_u=4)
    stage.follow('add_extrude', [hole], f"{name}, inside", 'biscuit', x=0.0, y=0.0, z=-thick, resolution_u=4)
    stage.follow('add_ruled', [rim, hole], f"{name}, top", 'biscuit', resolution_u=4)
    jam = sc.build.disc((0, 0, 0.7 * thick), (0, 0, 1), 0.24)
    stage.patch(jam, f"{name}, jam", place, 'jam', 8)


revolved(SAUCER, "Saucer", (0, 0, 0), 'porcelain')
revolved(CUP, "Cup", (0, 0, 0.11), 'porcelain')
stage.patch(sc.build.disc((0, 0, 1.16), (0, 0, 1), 1.0), "Tea", (0, 0, 0), 'tea')
bow(((0.99, 1.10), (1.16, 1.16), (1.55, 1.30), (1.86, 1.02), (1.72, 0.60), (1.30, 0.42), (1.02, 0.46), (0.86, 0.44)),
    ((0.10, 0.14), (0.07, 0.12), (0.05, 0.10), (0.05, 0.09), (0.05, 0.09), (0.05, 0.10), (0.07, 0.12), (0.09, 0.14)),
    "Handle", (0, 0, 0.11), 'porcelain', -0.55)
revolved(BOWL, "Sugar bowl", (3.3, 1.5, 0), 'cobalt')
revolved(LID, "Lid", (3.3, 1.5, 0), 'cobalt')
for number, turn in enumerate((-0.35, np.pi - 0.35)):
    bow(((1.00, 0.98), (1.14, 1.05), (1.42, 1.20), (1.60, 0.92), (1.42, 0.62), (1.20, 0.62), (1.10, 0.62)),
        ((0.08, 0.12), (0.06, 0.10), (0.05, 0.08), (0.05, 0.08), (0.05, 0.08), (0.06, 0.10), (0.08, 0.12)),
        f"Ear {number + 1}", (3.3, 1.5, 0), 'cobalt', turn)
ob = stage.patch(spoon(), "Spoon", (-2.35, -1.75, 0), 'silver', 5)
ob.rotation_euler = (0, 0, -0.25)
biscuit("Biscuit 1", (2.55, -1.35, 0), 0.2)
biscuit("Biscuit 2", (3.85, -0.75, 0), 0.55)
stage.ground(color='cloth')
stage.lamp((-5, -3, 6), (0.5, 0, 0.6), 110, 3)
stage.lamp((6, 5, 5), (1.5, 0.5, 0.8), 120, 2)
stage.camera((0.6, -10.6, 5.6), (0.95, -0.15, 0.58), 51)
stage.smooth()
stage.finish("cups", samples=64, size=(960, 560))
