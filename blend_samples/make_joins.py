"""Two cubics joined C0, G1, C1 and C2, with the combs of their curvature (lecture rows S7, S16)."""

import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
import stage

stage.begin()
FIRST = [(-2.2, 0, 0), (-1.9, 1.2, 0), (-1.0, 1.7, 0), (0, 1.2, 0)]
SECOND = [(0, 1.2, 0), (0.3, 1.9, 0), (1.5, 1.8, 0), (2.2, 0.2, 0)]
sc = stage.splinecore()


def comb(curve):
    """Teeth along the normal, as long as the curvature is large, and the line over their heads."""
    teeth = []
    for bezier in curve.to_bezier():
        heads = []
        for t in np.linspace(0, 1, 25):
            point, first, second = bezier.derivatives(t, 2)
            speed = np.linalg.norm(first)
            bend = (first[0] * second[1] - first[1] * second[0]) / speed ** 3
            heads.append(point + 0.35 * bend * np.array([first[1], -first[0], 0]) / speed)
            teeth.append([point, heads[-1]])
        teeth.append(heads)
    return teeth


for number, name in enumerate(('C0', 'G1', 'C1', 'C2')):
    place = (5.0 * (number % 2), -3.0 * (number // 2), 0)
    joined = sc.BezierCurve(FIRST).to_nurbs().join(sc.BezierCurve(SECOND).to_nurbs(), name).value
    (u, found), *_ = joined.joints()
    stage.tube(stage.shape(joined, f"Joined {name}", place, ('clay', 'sand', 'moss', 'sea')[number], resolution_u=32), 0.04)
    for i, line in enumerate(comb(joined)):
        stage.polygon(line, f"Comb {name} {i}", place, radius=0.006)
    stage.beads(joined.evaluate([u]), f"Joint {name}", place, radius=0.08)
    stage.label(f"C{found.c}, G{found.g}: angle {np.degrees(found.angle):.1f}°, curvature difference "
                f"{found.curvature_difference:.2f}", (place[0], place[1] - 0.3), 0.18, 'CENTER')
stage.drawing((2.5, -0.75), 10.8)
stage.finish("joins", samples=16, size=(1060, 660))
