"""Eleven points of 1 / (1 + 25 x²): the polynomial through them oscillates, a spline does not (lecture row S3)."""

import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
import stage

stage.begin()
WIDE = 4.0
for name, operator, color, settings in (
        ("Polynomial of degree 10", 'add_polynomial', 'clay', {'resolution_u': 200}),
        ("Catmull-Rom spline", 'add_catmull_rom', 'moss', {'resolution_u': 24})):
    ob = stage.add(operator, name, color=color, count=11, parametrisation='uniform', size=WIDE, **settings)
    stage.tube(ob, 0.035)
stage.tube(stage.add('add_formula', "The function itself", color='sea', x="t", y="4/(1 + 25*(t/4)^2)", z="0", start=-WIDE,
                     end=WIDE), 0.02)
x = np.linspace(-1, 1, 11)
stage.beads(WIDE * np.column_stack([x, 1 / (1 + 25 * x * x), 0 * x]), "Points", radius=0.085)
stage.polygon([(-4.5, 0, 0), (4.5, 0, 0)], "Axis")
for y, text, color in ((6.6, "polynomial of degree 10", 'clay'), (5.9, "Catmull-Rom spline", 'moss'),
                       (5.2, "1 / (1 + 25 x²)", 'sea')):
    stage.beads([(-1.7, y, 0)], text, color=color, radius=0.1)
    stage.label(text, (-1.4, y), 0.34)
stage.drawing((0, 3.45), 12.6)
stage.finish("runge", samples=16, size=(1000, 740))
