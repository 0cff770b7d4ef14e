"""The profile of a vase three ways, each revolved by a Screw modifier, and the same point moved in each.

One Bezier curve of degree 11 changes everywhere, two joined Beziers change in one half, a B-spline
changes near the point only.
"""

import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
import stage

PROFILE = np.array([(0.0, 0.0), (0.45, 0.0), (0.72, 0.05), (0.95, 0.45), (1.05, 0.9), (0.80, 1.35),
                    (0.45, 1.70), (0.28, 2.05), (0.30, 2.40), (0.42, 2.62), (0.56, 2.75), (0.62, 2.80)])
MOVED, BY = 8, np.array((0.45, 0.0))


def in_space(points):
    return np.column_stack([points[:, 0], np.zeros(len(points)), points[:, 1]])


def bezier(sc, points):
    return sc.BezierCurve(in_space(points))


def two_beziers(sc, points):
    """Degree 6 each; the joint lies between its neighbours, so the pair is C1."""
    joint = 0.5 * (points[5] + points[6])
    return [sc.BezierCurve(in_space(np.vstack([points[:6], joint]))),
            sc.BezierCurve(in_space(np.vstack([joint, points[6:]])))]


def b_spline(sc, points):
    count = len(points)
    knots = np.concatenate([np.zeros(3), np.arange(count - 2.0), np.full(3, count - 3.0)])
    return sc.NurbsCurve(3, knots, in_space(points))


def revolve(ob):
    screw = ob.modifiers.new("Revolve", 'SCREW')
    screw.axis, screw.steps, screw.render_steps = 'Z', 96, 96
    screw.use_merge_vertices, screw.use_smooth_shade, screw.use_normal_calculate = True, True, True


stage.begin()
sc = stage.splinecore()
moved = PROFILE.copy()
moved[MOVED] += BY
for x, operator, name, make, color in ((-4.5, 'add_bezier_curve', "Bezier of degree 11", bezier, 'clay'),
                                       (0.0, 'add_bezier_curve', "Two joined Beziers", two_beziers, 'sea'),
                                       (4.5, 'add_nurbs_curve', "Cubic B-spline", b_spline, 'moss')):
    for step, points, suffix in ((-1.05, PROFILE, ""), (1.05, moved, ", moved")):
        ob = stage.add(operator, name + suffix, (x + step, 0, 0), color=color, resolution_u=48)
        ob.data.splinewright.value = make(sc, points)
        revolve(ob)
stage.ground()
stage.camera((0, -16.0, 7.0), (0, 0, 1.2), 44)
stage.finish("vase", size=(1100, 520))
