"""What lies behind surfaces, by rays to the eye."""

import numpy as np

from ...core.figures import page
from ..cage import net_object

#: How far before a line a surface must lie to hide it, in mm of the page: meshes are only near to the surfaces that they show.
_LIFT = 1.0
#: Objects that a ray goes through, and that hide nothing.
_MOST, _OPEN = 64, ('WIRE', 'BOUNDS')


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
    for _ in range(_MOST):
        if start >= end:
            return False
        reach = {'distance': end - start} if np.isfinite(end) else {}
        is_hit, met, _, _, ob, _ = scene.ray_cast(depsgraph, place + start * along, along, **reach)
        if not is_hit:
            return False
        if not (net_object.is_net(ob) or ob.display_type in _OPEN):
            return True
        start = float((np.array(met) - place) @ along) * (1.0 + 1e-5)
    return False
