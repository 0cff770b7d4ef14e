"""A bottle's section curves: rings by planes, its profile, and where a tilted plane and a pipe meet it; all follow the bottle,
which follows its profile (lecture row S18)."""

import math
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
import stage

PROFILE = [(0.0, 0.0, 0), (0.62, 0.0, 0), (0.78, 0.05, 0), (0.78, 0.5, 0), (0.7, 1.1, 0), (0.8, 1.7, 0), (0.62, 2.15, 0),
           (0.26, 2.3, 0), (0.24, 2.9, 0), (0.3, 3.0, 0)]

stage.begin()
sc = stage.splinecore()
knots = np.r_[[0] * 4, np.arange(1, 7), [7] * 4]
profile = stage.shape(sc.NurbsCurve(3, knots, PROFILE), "Profile", color='ink', resolution_u=16)
profile.rotation_euler = (math.radians(90), 0, 0)
bottle = stage.follow('add_revolve', [profile], "Bottle", 'sea', axis='y', resolution_u=16)
rings = stage.follow('add_planes', [bottle], "Rings", 'paper', axis='y', offset=0.25, count=11, spacing=0.25, resolution_u=24)
halves = stage.follow('add_planes', [bottle], "Upright section", 'sand', axis='z', offset=0.0, count=1, resolution_u=16)
cut = stage.patch(sc.build.plane((-1.3, -1.3, 0), (2.6, 0, 0), (0, 2.6, 0)), "Cutting plane", (0, 0, 1.15), 'snow', resolution=1)
cut.rotation_euler = (math.radians(24), math.radians(16), 0)
oblique = stage.follow('add_section', [bottle, cut], "Oblique section", 'clay', resolution_u=24)
pipe = stage.patch(sc.build.cylinder((0, 0, -1.5), (0, 0, 1), 0.34, 3.0), "Pipe", (0, 0, 0.62), 'snow', resolution=24)
pipe.rotation_euler = (math.radians(90), 0, math.radians(14))
hole = stage.follow('add_section', [bottle, pipe], "Where a pipe meets it", 'jam', resolution_u=24)
for ob, radius in ((rings, 0.012), (halves, 0.014), (oblique, 0.026), (hole, 0.026)):
    stage.tube(ob, radius)
for ob in (cut, pipe):
    ob.hide_render = True
stage.ground(-0.01, color='paper')
stage.camera((1.7, -5.6, 3.3), (0.0, 0.0, 1.42), lens=44)
stage.smooth()
stage.finish("bottle", samples=48, size=(700, 800))
