"""Shapes that are hard to draw: points, infinite, huge, tiny, with gaps, of many spans."""

import numpy as np

import splinecore as sc
from splinecore import build


def random(*shape, seed=1):
    return np.random.default_rng(seed).uniform(-1, 1, shape)


def patches(count):
    return sc.PatchSet.from_patches([sc.BezierPatch(random(4, 4, 3, seed=i) + [3 * i, 0, 0]) for i in range(count)])


CURVES = {
    "cubic": sc.BezierCurve(random(4, 2)), "cubic in space": sc.BezierCurve(random(4, 3)), "line": sc.BezierCurve([(0, 0), (1, 1)]),
    "along x": sc.BezierCurve([(0, 0), (1, 0), (3, 0)]), "point": sc.BezierCurve([(1, 2), (1, 2)]),
    "arc": sc.BezierCurve([(1, 0), (1, 1), (0, 1)], weights=[1, 0.5**0.5, 1]),
    "half circle": sc.BezierCurve([(1, 0), (0, 1), (-1, 0)], weights=[1, 0, 1]),
    "hyperbola": sc.BezierCurve([(1, 0), (0, 1), (-1, 0)], weights=[1, -2, 1]),
    "from infinity": sc.BezierCurve([(1, 0), (0, 1)], weights=[0, 1]),
    "negative weights": sc.BezierCurve([(1, 0), (0, 1)], weights=[-1, -1]),
    "wild weights": sc.BezierCurve(random(6, 3), weights=[1e-300, 1, 1e300, -1, 1e-9, 1e9]),
    "degree 255": sc.BezierCurve(random(256, 3)), "ring": sc.NurbsCurve(3, range(13), random(12, 3), periodic=True),
    "many points": sc.fit.interpolate(np.cumsum(random(3000, 2), axis=0)).value,
    "huge": sc.BezierCurve(1.7e308 * np.sign(random(4, 2))), "tiny": sc.BezierCurve(5e-324 * np.sign(random(4, 2))),
    "far away": sc.BezierCurve(1e12 + random(4, 3)), "wide domain": sc.NurbsCurve(1, [-8e307, -8e307, 8e307, 8e307], random(2, 2)),
    "narrow domain": sc.NurbsCurve(2, [0, 0, 0, 1e-300, 1e-300, 1e-300], random(3, 2)),
    "gap": sc.NurbsCurve(1, [0, 0, 1, 1, 2, 2], random(4, 2)), "steps": sc.NurbsCurve(3, [0] * 4 + [1] * 4 + [2] * 4, random(8, 2)),
    "Hermite": sc.HermiteCurve(random(5, 2), random(5, 2)), "many of Hermite": sc.HermiteCurve(random(900, 3), random(900, 3)),
    "power": sc.PowerCurve(random(4, 2)), "rational power": sc.PowerCurve.from_homogeneous([(1, 0, 0, 1), (0, 2, 0, 0), (-1, 0, 0, 1)]),
    "power to infinity": sc.PowerCurve.from_homogeneous([(1, 0, 0, 1), (0, 2, 0, -2)]),
}
SURFACES = {
    "Bezier": sc.BezierPatch(random(4, 4, 3)), "NURBS": sc.NurbsPatch((3, 2), (range(10), range(8)), random(6, 5, 3)),
    "sphere": build.sphere((0, 0, 0), 1.0), "torus": build.torus((0, 0, 0), (0, 0, 1), 2.0, 0.5),
    "plane": build.plane((0, 0, 0), (1, 0, 0), (0, 1, 0)), "point": sc.BezierPatch(np.ones((2, 2, 3))),
    "line": sc.BezierPatch(np.linspace((0, 0, 0), (1, 2, 3), 4).reshape(2, 2, 3)),
    "Hermite": sc.HermitePatch(random(3, 4, 3), random(3, 4, 3), random(3, 4, 3)),
    "to infinity": sc.BezierPatch(random(3, 3, 3), [[1, 1, 1], [1, -3, 1], [1, 1, 1]]),
    "corner at infinity": sc.BezierPatch(random(3, 3, 3), [[0, 1, 1], [1, 1, 1], [1, 1, 1]]),
    "huge": sc.BezierPatch(1e307 * random(4, 4, 3)), "tiny": sc.BezierPatch(5e-324 * np.sign(random(4, 4, 3))),
    "many knots": sc.fit.interpolate_patch(random(40, 30, 3), 3).value, "degree 60": sc.BezierPatch(random(61, 3, 3)),
    "one of a set": patches(1), "32 of a set": patches(32), "150 of a set": patches(150), "1000 of a set": patches(1000),
}
