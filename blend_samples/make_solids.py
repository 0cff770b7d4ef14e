"""Exact primitives, their degree, and how far their points are from the radius: rounding, no more (lecture row S20)."""

import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
import stage

stage.begin()
sc = stage.splinecore()


def first_patch(ob):
    """The one that is round: caps come after it."""
    value = ob.data.splinewright.value
    return value[0] if isinstance(value, sc.PatchSet) else value


def error_of_radius(ob, exact_of):
    """The largest relative deviation of `exact_of` height and distance from the axis from 1, on a dense grid."""
    patch = first_patch(ob)
    points = patch.evaluate_grid(*(np.linspace(*domain, 201) for domain in patch.domain))
    return np.abs(exact_of(points[..., 2], np.linalg.norm(points[..., :2], axis=-1)) - 1).max()


for x, operator, color, height, settings, exact_of in (
        (-3.95, 'add_sphere', 'clay', 1.0, {'radius': 1.0}, lambda z, r: np.hypot(z, r)),
        (-1.25, 'add_torus', 'sea', 0.36, {'radius': 0.85, 'tube_radius': 0.36},
         lambda z, r: np.hypot(z, r - 0.85) / 0.36),
        (1.4, 'add_cylinder', 'moss', 0.9, {'radius': 0.85, 'height': 1.8, 'caps': True}, lambda z, r: r / 0.85),
        (3.95, 'add_cone', 'sand', 0.95, {'radius': 1.0, 'height': 1.9, 'caps': True},
         lambda z, r: r + (z + 0.95) / 1.9)):
    name = operator.removeprefix('add_').capitalize()
    ob = stage.add(operator, name, (x, 0, height), color=color, resolution_u=16, **settings)
    degree = first_patch(ob).degree
    for row, text in enumerate((name.lower(), f"degree {degree[0]} x {degree[1]}",
                                f"radius to {error_of_radius(ob, exact_of):.0e}")):
        stage.label(text, (x, -1.5 - 0.38 * row), 0.3, 'CENTER', 0.004)
stage.ground()
stage.lamp((-5, -4, 7), (0, 0, 0.8), 90, 3)
stage.camera((0, -17.0, 10.2), (0, -0.6, 0.42), 62)
stage.smooth()
stage.finish("solids", samples=64, size=(1000, 480))
