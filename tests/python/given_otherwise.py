"""Sections of two patches that are given in other ways: each is the same set."""

import numpy as np
from scipy.spatial.transform import Rotation


def sections_otherwise(rng, a, b, tolerance, far, magnitudes, cuts):
    """[(Sections, how much larger they are)]: in the other order, moved by about so far, scaled by up to so many magnitudes, reversed,
    and refined by so many cuts."""
    motion = np.eye(4)
    motion[:3, :3] = Rotation.from_quat(rng.normal(size=4)).as_matrix()
    motion[:3, 3] = far * rng.normal(size=3)
    scale = 10**rng.uniform(-magnitudes, magnitudes)
    scaling = np.diag([scale, scale, scale, 1])
    return [(b.sections(a, tolerance), 1), (a.transformed(motion).sections(b.transformed(motion), tolerance), 1),
            (a.transformed(scaling).sections(b.transformed(scaling), tolerance * scale), scale),
            (a.reversed("u").sections(b.swapped(), tolerance), 1),
            (a.refine("u", sorted(rng.uniform(0.1, 0.9, cuts))).sections(b.elevate("v"), tolerance), 1)]
