"""What of the nets in Edit Mode is drawn in a 3D view, and what of it lies behind a surface."""

from typing import NamedTuple

import bmesh
import numpy as np
from bpy_extras import view3d_utils
from mathutils import Vector

from ..bridge.cage import net_object
from . import editing, picking

#: How near a click is to what it takes, in pixels of an interface that is not scaled: as in Blender's own Edit Mode.
_NEAR = 75.0
#: What lies less behind a surface is drawn over it, as large as points are drawn; in pixels.
_SLACK = 4.0
#: Blender looks about a pixel in squares: it may take what is farther away by this part and by the slack.
_FARTHER = 1.5
_WIRES = {'WIRE', 'BOUNDS'}


class Near(NamedTuple):
    """The vertex or edge of a net in Edit Mode that is seen nearest to a pixel, by its index among those of its bmesh; no net
    where none is near. is_met: whether one that is hidden may be taken for it, as that is as near."""

    ob: object = None
    index: int = -1
    is_met: bool = False


def looks_through(space):
    """Whether a 3D view shows what lies behind surfaces."""
    shading = space.shading
    if shading.type == 'WIREFRAME':
        return shading.show_xray_wireframe
    return shading.type == 'SOLID' and shading.show_xray


def hides(context, space):
    """Whether surfaces hide points of nets in Edit Mode in a 3D view."""
    return not looks_through(space) and not any(ob.show_in_front for ob in editing.nets_in_edit_mode(context))


class Sight:
    """One 3D view, and whether places of the world are to be seen in it."""

    def __init__(self, context, space, region, view):
        self._scene, self._depsgraph = context.scene, context.evaluated_depsgraph_get()
        self._region, self._view = region, view
        # The ray meets what is drawn by its lines alone, or in other views only, too.
        self._passed = {ob.name for ob in context.view_layer.objects
                        if ob and (net_object.is_net(ob) or ob.display_type in _WIRES or not ob.visible_get(viewport=space))}

    def sees(self, place):
        pixel = view3d_utils.location_3d_to_region_2d(self._region, self._view, Vector(place))
        if pixel is None:
            return False
        eye = view3d_utils.region_2d_to_origin_3d(self._region, self._view, pixel)
        end = Vector(place)
        slack = _SLACK * picking.size_of_pixel(self._region, self._view, end)
        away = (end - eye).length - slack
        if not away > 0:
            return True
        along = (end - eye).normalized()
        while True:
            is_hit, met, _, _, ob, _ = self._scene.ray_cast(self._depsgraph, eye, along, distance=away)
            if not is_hit:
                return True
            if ob.name not in self._passed:
                return False
            step = (met - eye).length + max(1e-5 * away, 1e-6)
            eye, away = eye + step * along, away - step
            if not away > 0:
                return True


def point_at(context, area, region, view, pixel, nets, **asked):
    """picking.point_at() in a 3D view, among visible shapes."""
    space = area.spaces.active
    sees = Sight(context, space, region, view).sees if hides(context, space) else lambda place: True
    return picking.point_at(region, view, pixel, nets, sees=sees, **asked)


def nearest_vertex(sight, region, view, pixel, nets):
    """The Near vertex of nets at a pixel of a region."""
    return _nearest(sight, pixel, ((ob, *_of_vertices(region, view, ob)) for ob in nets))


def nearest_edge(sight, region, view, pixel, nets):
    """The Near edge of nets, where it comes nearest to a pixel of a region."""
    return _nearest(sight, pixel, ((ob, *_of_edges(region, view, pixel, ob)) for ob in nets))


def _nearest(sight, pixel, found):
    """found: (object, indices, places in the world, those in pixels)."""
    near = []
    for ob, indices, places, pixels in found:
        away = np.linalg.norm(pixels - pixel, axis=1)
        near += [(away[i], ob, int(indices[i]), places[i]) for i in np.flatnonzero(away <= picking.near(_NEAR))]
    near.sort(key=lambda one: one[0])
    seen = next((i for i, one in enumerate(near) if sight.sees(one[3])), None)
    if seen is None:
        return Near(is_met=bool(near))
    away, ob, index, _ = near[seen]
    as_near = (place for other, _, _, place in near[seen + 1:] if other <= _FARTHER * away + _SLACK)
    return Near(ob, index, seen > 0 or not all(map(sight.sees, as_near)))


def _in_world(ob, points):
    matrix = np.array(ob.matrix_world, dtype=np.float64)
    return points @ matrix[:3, :3].T + matrix[:3, 3]


def _of_vertices(region, view, ob):
    mesh = bmesh.from_edit_mesh(ob.data)            # its parts are gone with it
    shown = [vertex for vertex in mesh.verts if not vertex.hide]
    places = _in_world(ob, np.array([vertex.co for vertex in shown]).reshape(-1, 3))
    return [vertex.index for vertex in shown], places, picking.on_screen(region, view, np.eye(4), places)


def _of_edges(region, view, pixel, ob):
    mesh = bmesh.from_edit_mesh(ob.data)
    shown = [edge for edge in mesh.edges if not edge.hide]
    ends = _in_world(ob, np.array([[vertex.co for vertex in edge.verts] for edge in shown]).reshape(-1, 3))
    pixels = picking.on_screen(region, view, np.eye(4), ends).reshape(-1, 2, 2)
    start, along = pixels[:, 0], pixels[:, 1] - pixels[:, 0]
    with np.errstate(divide='ignore', invalid='ignore'):
        part = np.nan_to_num(np.clip(((pixel - start) * along).sum(1) / (along * along).sum(1), 0.0, 1.0))[:, None]
    ends = ends.reshape(-1, 2, 3)
    return [edge.index for edge in shown], ends[:, 0] + part * (ends[:, 1] - ends[:, 0]), start + part * along
