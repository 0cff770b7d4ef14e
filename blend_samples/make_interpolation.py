"""Points of a function and three cubic splines through them, which differ in the spacing of their parameters (row S17)."""

import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
import stage

stage.begin()
fit = stage.splinecore().fit
X = np.array([-4.0, -2.6, -2.4, -0.1, 0.1, 2.4, 2.6, 4.0])
POINTS = np.column_stack([X, 1.2 * np.abs(X), 0 * X])
KINDS = (("uniform", 'clay', "uniform"), ("chordal", 'sea', "chordal: by the distances"),
         ("centripetal", 'moss', "centripetal: by their roots"))
for i, (kind, color, text) in enumerate(KINDS):
    curve = fit.interpolate(POINTS, parameters=kind).value
    stage.tube(stage.shape(curve, f"Spline, {kind}", color=color, resolution_u=32), 0.03)
    stage.beads([(-2.3, 6.6 - 0.6 * i, 0)], text, color=color, radius=0.09)
    stage.label(text, (-2.05, 6.6 - 0.6 * i), 0.3)
stage.polygon([(-4, 4.8, 0), (0, 0, 0), (4, 4.8, 0)], "The function itself", radius=0.012)
stage.beads(POINTS, "Points", radius=0.075)
stage.label("1.2 |x|", (-4.1, 3.3), 0.3)
stage.drawing((0, 2.85), 12.6)
stage.finish("interpolation", samples=16, size=(1000, 740))
