"""Offsets of one curve, to both sides: as they are, with cusps and loops, and trimmed; they follow the curve (lecture row S18)."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
import stage

DISTANCES = (-1.0, -0.75, -0.5, -0.25, 0.25, 0.5, 0.75, 1.0)
COLORS = ('plum', 'plum', 'sea', 'sea', 'clay', 'clay', 'sand', 'sand')
POINTS = [(-2.4, 0.0, 0), (-1.9, 0.9, 0), (-0.8, 1.1, 0), (-0.2, -1.5, 0), (0.6, -1.3, 0), (1.0, 1.4, 0), (2.0, 0.8, 0), (2.5, -0.4, 0)]

stage.begin()
sc = stage.splinecore()
knots = [0, 0, 0, 0, 1, 2, 3, 4, 5, 5, 5, 5]
for x, trimmed, name in ((-3.4, False, "as they are"), (3.4, True, "trimmed")):
    curve = stage.shape(sc.NurbsCurve(3, knots, POINTS), f"Curve, offsets {name}", (x, 0, 0), 'ink', resolution_u=24)
    for distance, color in zip(DISTANCES, COLORS):
        ob = stage.follow('add_offset', [curve], f"Offset {distance:g}, {name}", color, distance=distance, trimmed=trimmed,
                          tolerance=1e-4, resolution_u=16)
        stage.tube(ob, 0.016)
    stage.tube(curve, 0.035)
    stage.label(name, (x, -2.75), 0.28, 'CENTER')
stage.drawing((0, -0.3), 13.4)
stage.finish("offsets", samples=16, size=(1000, 480))
