"""What lies behind surfaces, by rays to the eye."""

import numpy as np

from ...core.figures import page
from ..cage import net_object

#: How far before a line a surface must lie to hide it, in mm of the page: meshes are only near to the surfaces that they show.
_LIFT = 1.0
#: How objects are shown that hide nothing.
_OPEN = 'WIRE', 'BOUNDS'
#: How far behind what it met a ray begins again, as a part of its length, and of the place: Blender counts in single precision.
_FARTHER, _ROUNDING = 1e-5, 5e-7


def sight(seen, scene, depsgraph):
    """A function that tells of a place (3,) of the world whether it is seen on a Page, among the meshes of a scene."""
    eye = page.eye(seen)

    def is_seen(place):
        along = eye[:3] - place if eye[3] else eye[:3]
        length, scale = float(np.linalg.norm(along)), page.unit(seen, place)
        if not (length > 0.0 and scale > 0.0):
            return True                 # behind the eye, where nothing is drawn
        reach = length - seen.near if eye[3] else np.inf
        return not _is_met(scene, depsgraph, place, along / length, _LIFT / scale, reach)
    return is_seen


def _is_met(scene, depsgraph, place, along, start, end):
    """Whether a face that hides others lies on a ray from a place, between two distances."""
    while start < end:
        reach = {'distance': end - start} if np.isfinite(end) else {}
        is_hit, met, _, _, ob, _ = scene.ray_cast(depsgraph, place + start * along, along, **reach)
        if not is_hit:
            return False
        if not (net_object.is_net(ob) or ob.display_type in _OPEN):
            return True
        reached = max(float((np.array(met) - place) @ along), start)
        start = reached + max(_FARTHER * reached, _ROUNDING * float(np.abs(met).max()))
    return False
