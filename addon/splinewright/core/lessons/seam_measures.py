"""Measures of the seam between two surfaces: of those sides that lie nearest to each other, for measures.py."""

from ..base.library import sc
from ..joints import patch_joints


def _seam(name):
    def measure(patches, to):
        (first, side), (second, other) = patch_joints.nearest_sides(patches, to)
        return getattr(sc.seam_continuity(patches[first], side, to[second], other), name)
    return measure


#: {name: (what it takes, function of two lists of patches)}. Angles are in radians.
MEASURES = {f"seam_{name}": (('to',), _seam(found))
            for name, found in (('gap', 'gap'), ('angle', 'angle'), ('bend', 'curvature_difference'), ('g', 'g'), ('c', 'c'))}
