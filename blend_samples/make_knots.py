"""Degree 5: five inner knots are merged one after the other into one of multiplicity 5 (lecture row S14).

On the left the basis functions, which follow the curve's knots live; on the right the curve, on one polygon.
At the last step the curve passes through a control point and has a corner there.
"""

import sys
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
import stage

stage.begin()
MERGED = ((1, 2, 3, 4, 5), (1, 3, 3, 4, 5), (1, 3, 3, 3, 5), (3, 3, 3, 3, 5), (3, 3, 3, 3, 3))
POINTS = np.array([(-2.0, 0, 0), (-1.9, 0.7, 0), (-1.3, 1.0, 0), (-0.8, 0.1, 0), (-0.5, 0.2, 0), (0, 1.15, 0),
                   (0.5, 0.2, 0), (0.8, 0.1, 0), (1.3, 1.0, 0), (1.9, 0.7, 0), (2.0, 0, 0)])
sc = stage.splinecore()
for row, (inner, color) in enumerate(zip(MERGED, ('sea', 'moss', 'sand', 'clay', 'plum'))):
    y = -1.5 * row
    curve = sc.NurbsCurve(5, [0] * 6 + list(inner) + [6] * 6, POINTS)
    ob = stage.tube(stage.shape(curve, f"Inner knots {inner}", (2.7, y, 0), color, resolution_u=64), 0.03)
    stage.polygon(POINTS, f"Polygon {row + 1}", (2.7, y, 0))
    stage.beads(POINTS, f"Points {row + 1}", (2.7, y, 0), radius=0.035)
    bpy.ops.object.select_all(action='DESELECT')
    ob.select_set(True)
    bpy.context.view_layer.objects.active = ob
    bpy.ops.splinewright.add_basis(width=4.6, height=0.9, resolution_u=48)
    basis = stage.tube(bpy.context.object, 0.016)
    basis.name = basis.data.name = f"Basis functions {row + 1}"
    basis.location = (-4.8, y + 0.02, 0)
    basis.data.materials.append(stage.paint(color))
    stage.polygon([(-4.9, y, 0), (-0.1, y, 0)], f"Axis {row + 1}")
    stage.label("inner knots " + " ".join(map(str, inner)), (-2.5, y + 1.12), 0.2, 'CENTER')
bpy.context.view_layer.update()
stage.drawing((0, -2.45), 10.4)
stage.finish("knots", samples=16, size=(1000, 800))
