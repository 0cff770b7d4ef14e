"""A contour of segments and arcs: its corners sharp, round and cut off; a plate whose corners and slot are arcs, with the circle
that touches three of its sides (lecture row S18)."""

import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).parent))
import stage

HOUSE = [(-1.5, -1, 0), (1.5, -1, 0), (1.5, 0.4, 0), (0.5, 0.4, 0), (0, 1.3, 0), (-0.5, 0.4, 0), (-1.5, 0.4, 0)]

stage.begin()
sc = stage.splinecore()
for x, size, corners, color, name in ((-5.2, 0.0, None, 'sea', "sharp"), (-1.7, 0.3, 'round', 'clay', "round"),
                                      (1.8, 0.3, 'cut', 'moss', "cut off")):
    contour = stage.shape(sc.build.contour(HOUSE, closed=True), f"Contour, corners {name}", (x, 0, 0), color, resolution_u=16)
    if corners:
        verb = bpy.ops.splinewright.fillet_corners if corners == 'round' else bpy.ops.splinewright.chamfer_corners
        bpy.ops.object.select_all(action='DESELECT')
        contour.select_set(True)
        bpy.context.view_layer.objects.active = contour
        verb(size=size)
    stage.tube(contour, 0.03)
    stage.label(name, (x, -1.5), 0.24, 'CENTER')
plate = sc.build.contour([(-1.1, -1, 0), (1.1, -1, 0), (1.1, 0.6, 0), (-1.1, 0.6, 0)], [0, 0, 0.7, 0], closed=True).rounded(0.25)
slot = sc.build.contour([(-0.5, -0.75, 0), (0.5, -0.75, 0), (0.5, -0.45, 0), (-0.5, -0.45, 0)], [0, 1, 0, 1], closed=True)
stage.tube(stage.shape([plate, slot], "Plate with a slot", (5.3, 0, 0), 'plum', resolution_u=16), 0.03)
sides = [sc.BezierCurve(row) for row in ([(-1.1, -0.4, 0), (-1.1, 1.2, 0)], [(1.1, -0.4, 0), (1.1, 1.2, 0)],
                                         [(-1, -0.45, 0), (1, -0.45, 0)])]
_, center, radius, _ = sc.build.touching_circle(*sides, (0.5, 0.5, 0.5))
hole = sc.conics.circle(center, 0.4 * radius)
stage.tube(stage.shape(hole, "Hole about the circle that touches three sides", (5.3, 0, 0), 'sand', resolution_u=16), 0.03)
stage.label("segments and arcs", (5.3, -1.5), 0.24, 'CENTER')
stage.drawing((0.1, 0.0), 14.4)
stage.finish("contour", samples=16, size=(1000, 360))
