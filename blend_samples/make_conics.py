"""One triangle, every conic: the weight of its middle point goes from 3 down to -3 (lecture row S10).

Every curve is a recipe whose weight is a slider in the sidebar. Parabolas and hyperbolas end at the shape's reach.
"""

import sys
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
import stage

stage.begin()
COLORS = {'hyperbola': 'clay', 'parabola': 'sand', 'ellipse': 'sea', 'segment': 'plum'}
SERIES = ((3.0, 'hyperbola'), (1.0, 'parabola'), (np.sqrt(0.5), 'ellipse'), (0.3, 'ellipse'), (0.0, 'segment'),
          (-0.3, 'ellipse'), (-np.sqrt(0.5), 'ellipse'), (-1.0, 'parabola'), (-3.0, 'hyperbola'))
SIZE = 2.6
HALF = SIZE * np.sqrt(0.5)

#: Of the arcs above the chord, which lie close: the right end of the uppermost line to a label, and how far the next is below.
ASIDE, DOWN = (1.9, 1.75), 0.38


def label(weight, height):
    """Below the lowest place of what is seen of a curve, or beside the arcs, in their order."""
    text, number = f"w = {weight:.3g}", [each for each, _ in SERIES].index(weight)
    if weight < 0:
        stage.label(text, (0, height - 0.22), 0.28, 'CENTER')
        return
    x, y = ASIDE[0] + 0.1 * number, ASIDE[1] - DOWN * number
    stage.polygon([(0.0, height, 0), (x, y, 0)], f"To {text}")
    stage.label(text, (x + 0.1, y), 0.28)


# The recipe's own triangle is (1, 0), (1, 1), (0, 1): turned, its middle point is above.
for weight, kind in SERIES:
    ob = stage.add('add_conic', f"w = {weight:.3g}", (0, -HALF, 0), (0, 0, np.pi / 4), COLORS[kind], weight=weight,
                   size=SIZE, resolution_u=96)
    ob.data.splinewright.reach = 6.0 if kind == 'ellipse' else 2.4
    stage.tube(ob, 0.03)
    if weight != -1:
        label(weight, HALF * weight / (1 + weight))
stage.label("w = -1 and w = -3 go on through infinity", (0, -5.12), 0.3, 'CENTER')
corners = [(-HALF, 0, 0), (0, HALF, 0), (HALF, 0, 0)]
stage.polygon(corners, "Triangle")
stage.beads(corners, "Its corners", radius=0.07)

points = 1.3 * np.array([(-1, 0, 0), (-0.5, 0.6, 0), (0.3, 0.7, 0), (1, 0.1, 0), (0.4, -0.6, 0)])
stage.tube(stage.add('add_five_points', "Through five points", (7, 1.9, 0), color='moss', size=1.3), 0.03)
stage.beads(points, "Five points", (7, 1.9, 0), radius=0.08)
stage.label("through five points", (7, 0.45), 0.3, 'CENTER')
for distance, color in ((2.4, 'sea'), (3.0, 'sea'), (0.8, 'clay')):
    ob = stage.add('add_foci', f"Sum or difference {distance}", (7, -2, 0), color=color, distance=distance)
    ob.data.splinewright.reach = 1.2
    stage.tube(ob, 0.03)
stage.beads([(-1, 0, 0), (1, 0, 0)], "Foci", (7, -2, 0), radius=0.08)
stage.label("by two foci", (7, -4.35), 0.3, 'CENTER')
bpy.context.view_layer.update()
stage.drawing((2.5, -0.6), 14.4)
stage.finish("conics", samples=16, size=(1100, 760))
