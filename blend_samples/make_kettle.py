"""A kettle of our own design: its body is lofted through circles, its spout is swept along a curve, its handle runs on two
rails. The curves are in the file, hidden from the picture only: move or edit one, and the kettle follows.
"""

import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
import stage

stage.begin()
sc = stage.splinecore()
#: (radius, height) of the circles that the body goes through, from the edge of the bottom up and over into the opening.
BODY = ((1.02, 0.0), (1.20, 0.10), (1.27, 0.42), (1.12, 0.88), (0.78, 1.22), (0.52, 1.32), (0.47, 1.38))
#: The rails of the handle: (place, half width, height).
HANDLE = ((-0.86, 0.07, 1.13), (-0.98, 0.09, 1.75), (-0.55, 0.15, 2.32), (0.0, 0.17, 2.45), (0.55, 0.15, 2.32),
          (0.98, 0.09, 1.75), (0.86, 0.07, 1.13))
LID = ((0, 1.58), (0.16, 1.57), (0.34, 1.50), (0.46, 1.40), (0.50, 1.37), (0.52, 1.36))
KNOB = ((0, 1.86), (0.09, 1.86), (0.13, 1.78), (0.09, 1.68), (0.05, 1.62), (0.07, 1.56))


def source(value, name, turn=0.0):
    ob = stage.shape(value, name, color='ink')
    ob.rotation_euler.z, ob.hide_render = turn, True
    return ob


def circle(radius, height, name):
    return source(sc.conics.circle((0, 0, height), radius), name)


def through(points):
    return sc.fit.interpolate(np.array(points, float)).value


def revolved(profile, name, color):
    curve = source(through([(radius, 0, height) for radius, height in profile]), f"Profile of {name}")
    ob = stage.follow('add_revolve', [curve], name, color, axis='z')
    ob.data.splinewright.resolution_u, ob.data.splinewright.resolution_v = 20, 5


def body():
    circles = [circle(radius, height, f"Section {i + 1}") for i, (radius, height) in enumerate(BODY)]
    ob = stage.follow('add_loft', circles, "Body", 'cobalt')
    ob.data.splinewright.resolution_u, ob.data.splinewright.resolution_v = 24, 8
    stage.patch(sc.build.disc((0, 0, 0.0), (0, 0, 1), BODY[0][0]), "Bottom", color='cobalt')


def spout():
    rail = source(through([(1.0, 0, 0.42), (1.42, 0, 0.62), (1.66, 0, 1.02), (2.02, 0, 1.42)]), "Rail of the spout", -0.35)
    section = source(sc.conics.circle((0, 0, 0), 0.27), "Section of the spout")
    section.location = (4, 0, 0)
    ob = stage.follow('add_sweep', [rail, section], "Spout", 'cobalt', end_scale=0.45)
    ob.data.splinewright.resolution_u, ob.data.splinewright.resolution_v = 12, 6


def handle():
    rails = [source(through([(x, side * width, z) for x, width, z in HANDLE]), f"Rail {name} of the handle", 1.2)
             for side, name in ((-1, "A"), (1, "B"))]
    for bulge, name in ((-0.10, "outside"), (0.05, "inside")):
        x, width, z = HANDLE[0]
        section = source(sc.build.polynomial_through([(x, -width, z), (x + bulge, 0, z), (x, width, z)]), f"Section {name}", 1.2)
        ob = stage.follow('add_two_rails', [*rails, section], f"Handle, {name}", 'biscuit')
        ob.data.splinewright.resolution_u, ob.data.splinewright.resolution_v = 10, 6


body()
spout()
handle()
revolved(LID, "Lid", 'cobalt')
revolved(KNOB, "Knob", 'biscuit')
stage.ground(color='cloth')
stage.lamp((-4, -4, 6), (0, 0, 1), 160, 3)
stage.lamp((6, 3, 5), (0.5, 0, 1), 110, 2)
stage.camera((1.2, -8.2, 3.9), (0.25, 0, 1.12), 58)
stage.smooth()
stage.finish("kettle", samples=48, size=(720, 560))
