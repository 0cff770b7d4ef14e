"""From points of the world to pixels of a 3D view, and from a pixel to the piece that is seen there."""

from typing import NamedTuple

import bpy
import numpy as np
from bpy_extras import view3d_utils
from mathutils import Vector

from ..bridge.analysis import surveys
from ..bridge.data import store
from ..bridge.mesh import mesh_layers, mesh_looks
from ..bridge.net import live
from ..core.verbs import parameter_picking

#: How near to a curve or a number the mouse must be, in pixels.
_NEAR = 18.0
#: A place is hidden by what lies before it by this part of how far it is from the eye.
_LIFT = 0.01


def face_seen(context, region, view, pixel, depsgraph, ignored, most=64):
    """(object, number of its face, where it is met) of the face at a pixel of a region, on what stands in front but for the
    objects with the ignored names; None over nothing."""
    origin = view3d_utils.region_2d_to_origin_3d(region, view, pixel)
    along = view3d_utils.region_2d_to_vector_3d(region, view, pixel)
    for _ in range(most):               # objects that are looked through
        is_hit, place, _, face, ob, _ = context.scene.ray_cast(depsgraph, origin, along)
        if not is_hit:
            return None
        if ob.name not in ignored:
            return ob, face, place
        origin = place + max(1e-5 * (place - origin).length, 1e-6) * along
    return None


def near(pixels=_NEAR):
    """Pixels of an unscaled interface, in pixels of this one."""
    return pixels * max(bpy.context.preferences.system.ui_scale, 1.0)


def views():
    """(area, region, its RegionView3D) of every 3D view of the window."""
    return [(area, region, region.data) for area in bpy.context.window.screen.areas if area.type == 'VIEW_3D'
            for region in area.regions if region.type == 'WINDOW' and region.data]


def area_at(x, y):
    """(area, region, its RegionView3D) of the 3D view at a pixel of the window, or None over anything else."""
    for area, region, view in views():
        if region.x <= x < region.x + region.width and region.y <= y < region.y + region.height:
            return area, region, view
    return None


def view_at(x, y):
    """(region, its RegionView3D) of the 3D view at a pixel of the window, or None over anything else."""
    found = area_at(x, y)
    return found and found[1:]


def on_screen(region, view, matrix, points):
    """(n, 2) float64: where points (n, 3) of an object of this matrix lie in a region; nan behind the eye."""
    clip = np.array(view.perspective_matrix, dtype=np.float64) @ np.array(matrix, dtype=np.float64)
    flat = np.column_stack([points, np.ones(len(points))]) @ clip.T
    with np.errstate(divide='ignore', invalid='ignore'):
        pixels = 0.5 + 0.5 * flat[:, :2] / np.where(flat[:, 3:] > 0, flat[:, 3:], np.nan)
    return pixels * (region.width, region.height)


def size_of_pixel(region, view, place):
    """Of the world, at a place of it."""
    ends = [view3d_utils.region_2d_to_location_3d(region, view, pixel, place) for pixel in ((0, 0), (1, 0))]
    return (ends[1] - ends[0]).length


def piece_at(region, view, pixel, obs, depsgraph):
    """(object, number of its piece) at a pixel of a region, in front of all others of these shapes; None where none is."""
    hits = [hit for ob in obs if ob.type == 'MESH' for hit in [_face_at(region, view, pixel, ob, depsgraph)] if hit]
    if hits:
        nearest = min(hits, key=lambda hit: hit.distance)
        return nearest.ob, nearest.number
    lines = [hit for ob in obs for hit in [_line_at(region, view, pixel, ob)] if hit]
    return min(lines, key=lambda hit: hit[0])[1:] if lines else None


class _Hit(NamedTuple):
    """Where a ray meets the mesh of patches."""

    distance: float
    ob: bpy.types.Object
    number: int
    fractions: tuple                    # (u, v) as parts of the domain of the patch, or None


def _face_at(region, view, pixel, ob, depsgraph):
    """The _Hit of a mesh as it is drawn, or None."""
    shown = ob.evaluated_get(depsgraph)
    if not abs(shown.matrix_world.determinant()) > 0.0:
        return None
    into = shown.matrix_world.inverted()
    origin = view3d_utils.region_2d_to_origin_3d(region, view, pixel)
    along = view3d_utils.region_2d_to_vector_3d(region, view, pixel)
    is_hit, point, _, face = shown.ray_cast(into @ origin, into.to_3x3() @ along)
    number = mesh_looks.patch_of_face(shown.data, face) if is_hit else 0
    if not number:
        return None
    distance = (shown.matrix_world @ point - origin).dot(along)
    return _Hit(distance, ob, number, mesh_layers.parameters_at(shown.data, face, point))


def side_at(region, view, pixel, pieces, depsgraph):
    """(object, number, side) of the side of a patch that is nearest to a pixel of a region: of the patch that is seen there, or
    near enough. pieces: (object, number) of those that are meant."""
    obs = {ob.name: ob for ob, _ in pieces}.values()
    faces = [hit for hit in (_face_at(region, view, pixel, ob, depsgraph) for ob in obs) if hit]
    front = min(faces, key=lambda hit: hit.distance, default=None)
    seen = [(ob, number) for ob, number in pieces if front and (ob, number) == (front.ob, front.number)]
    found = [(min(distance(on_screen(region, view, ob.matrix_world, line), pixel) for line in lines), ob, number, side)
             for ob, number in seen or pieces for side, lines in surveys.sides_of(ob.data)[number - 1].items() if lines]
    nearest = min(found, key=lambda one: one[0], default=(np.inf,))
    return nearest[1:] if nearest[0] <= (np.inf if seen else near()) and len(nearest) > 1 else None


def _line_at(region, view, pixel, ob):
    """(distance in pixels, object, number) of the nearest curve, or number of a patch, near enough; or None."""
    try:
        shown = surveys.outlines_of(ob.data) if ob.type == 'CURVE' else surveys.middles_of(ob.data)[:, None, None]
    except store.UnreadableDefinition:
        return None
    distances = [min([distance(on_screen(region, view, ob.matrix_world, line), pixel) for line in lines], default=np.inf)
                 for lines in shown]
    nearest = int(np.argmin(distances))
    return (distances[nearest], ob, nearest + 1) if distances[nearest] <= near() else None


def distance(line, pixel):
    """From a pixel to a polyline (n, 2); a part with an end that is nan is none of it."""
    return float(np.nanmin(_parts(line, pixel)[1], initial=np.inf))


def nearest_place(region, view, line, pixel):
    """(distance in pixels, (3,)): of the place of a polyline (n, 3) of the world that is nearest to a pixel of a region."""
    part, distances = _parts(on_screen(region, view, np.eye(4), line), pixel)
    if np.isnan(distances).all():
        return np.inf, line[0]
    i = int(np.nanargmin(distances))
    return float(distances[i]), line[i] + part[i] * (line[i + 1] - line[i])


def is_seen(context, region, view, place, depsgraph):
    """Whether nothing stands before a place of the world; what lies about there does not."""
    pixel = on_screen(region, view, np.eye(4), np.asarray(place)[None])[0]
    found = face_seen(context, region, view, pixel, depsgraph, ())
    if found is None:
        return True
    origin = view3d_utils.region_2d_to_origin_3d(region, view, pixel)
    far = (Vector(place) - origin).length
    return (found[2] - origin).length >= far - _LIFT * max(view.view_distance, far)


def _parts(line, pixel):
    """Of each part of a polyline (n, 2) where on it a pixel is nearest, from 0 to 1, and how far that is, or nan."""
    starts, ends = (line[:-1], line[1:]) if len(line) > 1 else (line, line)
    along, to = ends - starts, np.asarray(pixel) - starts
    with np.errstate(divide='ignore', invalid='ignore'):
        part = np.nan_to_num(np.clip((to * along).sum(1) / (along * along).sum(1), 0.0, 1.0))
    return part, np.linalg.norm(to - part[:, None] * along, axis=1)


def parameters_at(region, view, pixel, obs, depsgraph):
    """(object, number of its piece, its parameters) at a pixel of a region: (u, v) of a patch, (u,) of a curve. None where
    none of these shapes is."""
    hits = [hit for ob in obs if ob.type == 'MESH' for hit in [_face_at(region, view, pixel, ob, depsgraph)] if hit]
    if hits:
        nearest = min(hits, key=lambda hit: hit.distance)
        if nearest.fractions is None:
            return None
        piece = surveys.pieces_of(nearest.ob.data)[nearest.number - 1]
        return nearest.ob, nearest.number, parameter_picking.of_domain(piece, nearest.fractions)
    found = [one for ob in obs if ob.type == 'CURVE' for one in _on_curves(region, view, pixel, ob)]
    nearest = min(found, key=lambda one: one[0], default=(np.inf,))
    return nearest[1:] if nearest[0] <= near() else None


def pointed_at(x, y, obs, depsgraph):
    """parameters_at() at a pixel of the window, in the 3D view that is there; None over anything else."""
    found = view_at(x, y)
    if found is None:
        return None
    region, view = found
    return parameters_at(region, view, (x - region.x, y - region.y), obs, depsgraph)


def point_at(region, view, pixel, nets, are_meant=lambda net: net.rows >= 0, within=_NEAR, sees=lambda place: True):
    """(net, vertex) nearest to a pixel of a region among the points and handles of nets, or None where nothing
    is near. are_meant: gives (n,) bool for a core.net.Net; within: pixels of an interface that is not scaled; sees: whether a
    place of the world counts."""
    found = [hit for ob in nets if ob.visible_get() for hit in _points_near(region, view, pixel, ob, are_meant, near(within))]
    return next(((ob, vertex) for _, ob, vertex, place in sorted(found, key=lambda hit: hit[0]) if sees(place)), None)


def _points_near(region, view, pixel, ob, are_meant, within):
    """(distance in pixels, net, vertex, place in the world) of each that is not farther away."""
    session = live.known_session(ob.data)
    there = np.flatnonzero(are_meant(session.net) & (session.slots >= 0)) if session else []
    if not len(there):
        return
    distances = np.linalg.norm(on_screen(region, view, ob.matrix_world, session.points[there]) - pixel, axis=1)
    for i in np.flatnonzero(distances <= within):       # what is nan is not
        yield distances[i], ob, int(there[i]), ob.matrix_world @ Vector(session.points[there[i]])


def _on_curves(region, view, pixel, ob):
    """(distance in pixels, object, number, parameters) for each curve of a shape that is to be seen."""
    for number, (parameters, points) in enumerate(surveys.samples_of(ob.data), 1):
        part, distances = _parts(on_screen(region, view, ob.matrix_world, points), pixel)
        if not np.isnan(distances).all():
            i = int(np.nanargmin(distances))
            yield distances[i], ob, number, (float(parameters[i] + part[i] * (parameters[i + 1] - parameters[i])),)
