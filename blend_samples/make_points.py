"""A cubic B-spline whose middle control point is simple, doubled and tripled (lecture row S13).

Doubled, the joint lies on a leg of the polygon, without curvature; tripled, the legs are straight and meet in a
corner, though the curve is still C2 in its parameter: the derivative falls to zero there.
"""

import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
import stage

stage.begin()
OUTER = np.array([(-2.0, 0, 0), (-1.6, 1.2, 0), (-0.9, -0.3, 0)])
sc = stage.splinecore()
for x, copies, name, color in ((-4.4, 1, "simple", 'sea'), (0.0, 2, "doubled", 'moss'), (4.4, 3, "tripled", 'clay')):
    points = np.vstack([OUTER, [(0, 1.5, 0)] * copies, OUTER[::-1] * (-1, 1, 1)])
    curve = sc.NurbsCurve(3, range(len(points) + 4), points)
    stage.tube(stage.shape(curve, f"Middle point {name}", (x, 0, 0), color, resolution_u=24), 0.035)
    stage.polygon(points, f"Polygon, {name}", (x, 0, 0))
    stage.beads(points, f"Points, {name}", (x, 0, 0))
    stage.beads(curve.evaluate(curve.knots[4:-4]), f"Joints, {name}", (x, 0, 0), color, 0.065)
    stage.label(name, (x, 1.85), 0.24, 'CENTER')
stage.drawing((0, 0.75), 13.4)
stage.finish("points", samples=16, size=(1100, 300))
