"""One curve at three speeds: beads at equal steps of the parameter (lecture row S12).

A Moebius map of the parameter multiplies the weights by powers of rho; no point of the curve moves.
"""

import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
import stage

stage.begin()
POINTS = [(-3, 0, 0), (-2, 1.8, 0), (1.5, 1.8, 0), (3, 0, 0)]
sc = stage.splinecore()
curve = sc.BezierCurve(POINTS)
steps = np.linspace(0, 1, 21)
for y, rho, color in ((1.9, 0.25, 'clay'), (0.0, 1.0, 'moss'), (-1.9, 4.0, 'sea')):
    mapped = curve.moebius(rho)
    ob = stage.tube(stage.shape(mapped, f"rho = {rho}", (0, y, 0), color, resolution_u=64), 0.03)
    stage.beads(mapped.evaluate(steps), f"Steps, rho = {rho}", (0, y, 0), radius=0.065)
    stage.polygon(POINTS, f"Polygon, rho = {rho}", (0, y, 0))
    weights = ", ".join(f"{weight:g}" for weight in mapped.weights)
    stage.label(f"rho = {rho:g}    weights {weights}", (0, y + 0.3), 0.18, 'CENTER')
stage.drawing((0, 0.78), 8.4)
stage.finish("moebius", samples=16, size=(960, 720))
