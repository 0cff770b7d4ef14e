"""From a pixel of a 3D view to the edge of a mesh that is seen there."""

import numpy as np
from mathutils import Vector

from . import picking


def edge_at(context, x, y, but):
    """(name of the object, start, end in the world) of the edge at a pixel of the window; None where there is none. `but` is
    an object that is looked through."""
    found = picking.view_at(x, y)
    if found is None:
        return None
    region, view = found
    pixel = x - region.x, y - region.y
    depsgraph = context.evaluated_depsgraph_get()
    candidates = _hit(context, region, view, pixel, depsgraph, but) or _loose(context, depsgraph, but)
    nearest, within = None, np.inf
    near = picking.near()
    for ob, edges, is_face in candidates:
        ends = _ends(ob.evaluated_get(depsgraph).data, edges)
        flat = picking.on_screen(region, view, ob.matrix_world, ends.reshape(-1, 3)).reshape(-1, 2, 2)
        distances = np.array([picking.distance(line, pixel) for line in flat])
        i = int(np.argmin(distances)) if len(distances) else -1
        if i >= 0 and distances[i] < within and (is_face or distances[i] <= near):
            nearest, within = (ob.name, *(tuple(ob.matrix_world @ Vector(end)) for end in ends[i])), distances[i]
    return nearest


def _hit(context, region, view, pixel, depsgraph, but):
    """[(object, vertex pairs of the edges of its face, True)] of the face in front; [] where none is."""
    found = picking.face_seen(context, region, view, pixel, depsgraph, {but.name} if but else ())
    if found is None:
        return []
    ob, face, _ = found
    return [(ob.original, list(ob.evaluated_get(depsgraph).data.polygons[face].edge_keys), True)]


def _loose(context, depsgraph, but):
    """(object, vertex pairs of its edges, False) of the meshes without faces that are seen."""
    for ob in context.visible_objects:
        if ob.type == 'MESH' and ob != but:
            mesh = ob.evaluated_get(depsgraph).data
            if len(mesh.edges) and not len(mesh.polygons):
                yield ob, [tuple(edge.vertices) for edge in mesh.edges], False


def _ends(mesh, edges):
    """(n, 2, 3): where edges begin and end, in the space of the object."""
    return np.array([[mesh.vertices[i].co for i in pair] for pair in edges], dtype=np.float64).reshape(-1, 2, 3)
