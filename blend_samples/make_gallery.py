"""One of each kind that the Add menu makes."""

import sys
from math import pi
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
import stage

stage.begin()
UPRIGHT = (pi / 2, 0, 0)
for x, (operator, name, settings) in zip((-3.9, -1.3, 1.3, 3.9), (
        ('add_bezier_curve', "Bezier, degree 5", {'degree': 5}),
        ('add_hermite_curve', "Hermite chain", {'count': 5}),
        ('add_nurbs_curve', "NURBS, unclamped", {'knots': 'UNCLAMPED', 'count': 9, 'size': 1.4}),
        ('add_nurbs_curve', "NURBS, periodic", {'knots': 'PERIODIC', 'count': 7, 'size': 1.1}))):
    stage.tube(stage.add(operator, name, (x, 2.2, 1.6), UPRIGHT, 'clay', resolution_u=24, **settings), 0.06)
for x, color, (operator, name, settings) in zip((-3.9, -1.3, 1.3, 3.9), ('sea', 'moss', 'sand', 'plum'), (
        ('add_bezier_patch', "Bezier patch", {}),
        ('add_hermite_patch', "Ferguson patch", {}),
        ('add_nurbs_patch', "NURBS tube", {'knots_u': 'PERIODIC', 'count_u': 8}),
        ('add_nurbs_patch', "NURBS torus", {'knots_u': 'PERIODIC', 'knots_v': 'PERIODIC', 'count_u': 9, 'count_v': 6}))):
    stage.add(operator, name, (x, -1.2, 0.45 if 'torus' in name else 0.72 if 'tube' in name else 0.3), color=color,
              size=0.7 if 'tube' in name else 1.0, **settings)
stage.ground()
stage.camera((0, -12.5, 7.6), (0, 0.35, 0.75), 44)
stage.smooth()
stage.finish("gallery", samples=64)
