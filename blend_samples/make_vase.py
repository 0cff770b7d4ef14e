"""The profile of a vase three ways, and the same point moved in each (lecture rows S7, S13).

One Bezier curve of degree 11 changes everywhere, two joined Beziers change in one half, a B-spline changes near the
point only. The vases are exact surfaces that follow their profiles, the dark lines: edit one, and its vase follows.
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
    """Degree 6 each; the joint lies between its neighbors, so the pair is C1."""
    joint = 0.5 * (points[5] + points[6])
    return [sc.BezierCurve(in_space(np.vstack([points[:6], joint]))),
            sc.BezierCurve(in_space(np.vstack([joint, points[6:]])))]


def b_spline(sc, points):
    count = len(points)
    knots = np.concatenate([np.zeros(3), np.arange(count - 2.0), np.full(3, count - 3.0)])
    return sc.NurbsCurve(3, knots, in_space(points))


stage.begin()
sc = stage.splinecore()
moved = PROFILE.copy()
moved[MOVED] += BY
for x, name, caption, make, color, steps in (
        (-4.6, "Bezier of degree 11", "one Bezier curve, degree 11", bezier, 'clay', 48),
        (0.0, "Two joined Beziers", "two joined Bezier curves", two_beziers, 'sea', 24),
        (4.6, "Cubic B-spline", "cubic B-spline", b_spline, 'moss', 6)):
    for step, points, suffix in ((-1.1, PROFILE, ""), (1.1, moved, ", moved")):
        turn, place = np.radians(-65), (x + step, 0, 0)
        profile = stage.add('add_bezier_curve', f"Profile: {name}{suffix}", place, (0, 0, turn), 'ink', resolution_u=48)
        profile.data.splinewright.value = make(sc, points)
        stage.tube(profile, 0.018)
        vase = stage.follow('add_revolve', [profile], f"Vase: {name}{suffix}", color, resolution_u=20)
        vase.data.splinewright.resolution_v = steps
        radius, height = points[MOVED]
        point = radius * np.cos(turn), radius * np.sin(turn), height
        stage.beads([point], f"Point: {name}{suffix}", place, radius=0.055)
    label = stage.label(caption, (x, -1.8), 0.36, 'CENTER', 0.2)
    label.rotation_euler.x, label.visible_shadow = np.radians(70), False    # towards who looks
stage.ground()
stage.lamp((-6, -5, 8), (0, 0, 1), 120, 3)
stage.camera((0, -19.0, 8.6), (0, -0.15, 1.1), 50)
stage.smooth()
stage.finish("vase", samples=64, size=(1100, 450))
