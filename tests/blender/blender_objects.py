"""Native curves and surfaces without a window, and the points that Blender evaluates on them."""

from pathlib import Path

import bpy
import numpy as np


def curve_object():
    """A linked curve object with no splines."""
    data = bpy.data.curves.new("curve", 'CURVE')
    data.dimensions = '3D'                      # flat curves are filled
    return _linked(data)


def set_nurbs_spline(ob, points, direction, resolution):
    """Replace the splines by one through (n, 4) points: x, y, z and the weight."""
    spline = unset_nurbs_spline(ob, points)
    _set_direction(spline, "u", direction, resolution)
    ob.data.update_tag()                        # in 3.4 foreach_set alone tags nothing
    return spline


def unset_nurbs_spline(ob, points):
    """Replace the splines by one of Blender's own default order, flags and resolution."""
    ob.data.splines.clear()
    spline = ob.data.splines.new('NURBS')
    spline.points.add(len(points) - 1)
    spline.points.foreach_set("co", _single(points))
    ob.data.update_tag()
    return spline


def set_bezier_spline(ob, points, handles, *, cyclic, resolution):
    """Replace the splines by one Bezier spline.

    points: (n, 3, 3): left handle, point, right handle. handles: (left, right) types of every
    point. Returns the (n, 3, 3) that Blender makes of it: it places the handles that are not FREE.
    """
    ob.data.splines.clear()
    spline = ob.data.splines.new('BEZIER')
    spline.bezier_points.add(len(points) - 1)
    for name, column in zip(("handle_left", "co", "handle_right"), np.swapaxes(points, 0, 1)):
        spline.bezier_points.foreach_set(name, _single(column))
    spline.use_cyclic_u = cyclic
    spline.resolution_u = resolution
    for point, (left, right) in zip(spline.bezier_points, handles):
        point.handle_left_type, point.handle_right_type = left, right
    ob.data.update_tag()
    return np.array([(p.handle_left, p.co, p.handle_right) for p in spline.bezier_points], float)


def surface_object(count_u, count_v):
    """A linked surface object with one patch of count_u x count_v points, two or more each.

    No call sets point_count_v, so rows are joined in edit mode. The joiner sorts rows by where
    they lie and never joins rows of two points, hence a plain grid and a row to delete.
    """
    data = bpy.data.curves.new("surface", 'SURFACE')
    data.dimensions = '3D'
    length = max(count_v, 3)
    for u in range(count_u):
        row = np.zeros((length, 4))
        row[:, 0], row[:, 1], row[:, 3] = np.arange(length), u, 1
        spline = data.splines.new('NURBS')
        spline.points.add(length - 1)
        spline.points.foreach_set("co", _single(row))
    ob = _linked(data)
    _join_rows(ob, keep=count_u * count_v)
    spline = data.splines[0]
    assert len(data.splines) == 1
    assert (spline.point_count_u, spline.point_count_v) == (count_u, count_v)
    return ob


def _join_rows(ob, keep):
    """Make the splines of a surface one patch, of its first `keep` points."""
    if bpy.context.mode != 'OBJECT':
        bpy.ops.object.mode_set(mode='OBJECT')
    for other in bpy.context.view_layer.objects:
        other.select_set(other is ob)
    ob.select_set(True)
    bpy.context.view_layer.objects.active = ob
    bpy.ops.object.mode_set(mode='EDIT')
    bpy.ops.curve.select_all(action='SELECT')
    bpy.ops.curve.make_segment()
    points = ob.data.splines[0].points
    if len(points) > keep:
        bpy.ops.curve.select_all(action='DESELECT')
        for point in points[keep:]:
            point.select = True
        bpy.ops.curve.delete(type='VERT')
    bpy.ops.object.mode_set(mode='OBJECT')


def set_surface(ob, net, directions, resolution):
    """Give a surface its (nu, nv, 4) net; directions and resolution are pairs for u and v."""
    spline = set_net(ob, net)
    for name, direction, steps in zip("uv", directions, resolution):
        _set_direction(spline, name, direction, steps)
    ob.data.update_tag()
    return spline


def set_net(ob, net):
    """Give a surface its (nu, nv, 4) net and leave the rest. Blender stores it with u fastest."""
    spline = ob.data.splines[0]
    spline.points.foreach_set("co", _single(np.swapaxes(net, 0, 1)))
    ob.data.update_tag()
    return spline


def _set_direction(spline, name, direction, resolution):
    for flag, value in direction.flags._asdict().items():
        setattr(spline, f"use_{flag}_{name}", value)
    setattr(spline, f"resolution_{name}", resolution)
    setattr(spline, f"order_{name}", direction.degree + 1)      # last: it is clamped on writing
    assert getattr(spline, f"order_{name}") == direction.degree + 1


def evaluated_vertices(ob):
    """(m, 3) float64: the vertices that Blender evaluates, in local space and its own order."""
    return _evaluated(ob, "vertices", "co", 3, np.float32).astype(float)


def evaluated_edges(ob):
    """(m, 2): the pairs of vertices that Blender's edges join."""
    return _evaluated(ob, "edges", "vertices", 2, np.int32)


def _evaluated(ob, elements, attribute, width, dtype):
    evaluated = ob.evaluated_get(bpy.context.evaluated_depsgraph_get())
    mesh = evaluated.to_mesh()
    values = np.empty(len(getattr(mesh, elements)) * width, dtype)
    getattr(mesh, elements).foreach_get(attribute, values)
    evaluated.to_mesh_clear()
    return values.reshape(-1, width)


def remove(ob):
    """Remove an object with its data."""
    bpy.data.curves.remove(ob.data)


def _linked(data):
    ob = bpy.data.objects.new(data.name, data)
    bpy.context.scene.collection.objects.link(ob)
    return ob


def _single(values):
    return np.ascontiguousarray(values, np.float32).ravel()


def grease_pencil(*lines, closed=False, hidden=False):
    """A selected Grease Pencil object, alone, with these strokes on one layer."""
    if hasattr(bpy.data, 'grease_pencils_v3') or bpy.app.version >= (5, 0):
        kept = bpy.data.grease_pencils_v3 if hasattr(bpy.data, 'grease_pencils_v3') else bpy.data.grease_pencils
        data = kept.new("drawn")
        layer = data.layers.new("L")
        drawing = layer.frames.new(1).drawing
        if lines:                       # Blender crashes where it is to add none
            drawing.add_strokes([len(line) for line in lines])
        for stroke, line in zip(drawing.strokes, lines):
            stroke.cyclic = closed
            for point, place in zip(stroke.points, line):
                point.position = place
    else:
        data = bpy.data.grease_pencils.new("drawn")
        layer = data.layers.new("L")
        frame = layer.frames.new(1)
        for line in lines:
            stroke = frame.strokes.new()
            stroke.use_cyclic = closed
            stroke.points.add(len(line))
            for point, place in zip(stroke.points, line):
                point.co = place
    layer.hide = hidden
    ob = bpy.data.objects.new("drawn", data)
    bpy.context.scene.collection.objects.link(ob)
    for other in bpy.context.selected_objects:
        other.select_set(False)
    ob.select_set(True)
    bpy.context.view_layer.objects.active = ob
    return ob


def annotations(*lines):
    """Strokes in space on the scene's annotations."""
    scene = bpy.context.scene
    data = _stored_annotations(lines) if bpy.app.version >= (4, 3) else _new_annotations(lines, scene.frame_current)
    setattr(scene, 'annotation' if hasattr(scene, 'annotation') else 'grease_pencil', data)
    for stroke, line in zip(data.layers[0].frames[0].strokes, lines, strict=True):
        for point, place in zip(stroke.points, line, strict=True):
            point.co = place


def _new_annotations(lines, frame):
    data = bpy.data.grease_pencils.new("notes")
    strokes = data.layers.new("L").frames.new(frame).strokes
    for line in lines:
        stroke = strokes.new()
        stroke.display_mode = '3DSPACE'
        stroke.points.add(len(line))
    return data


def _stored_annotations(lines):
    """Scripts make no strokes in Blender 4.3 and 4.5 to 5.1. Blender 3.4 has made some on what its annotation_add() gave, and
    named them by the numbers of their points."""
    name = " ".join(str(len(line)) for line in lines)
    with bpy.data.libraries.load(str(Path(__file__).resolve().parents[1] / "data" / "annotations.blend")) as (_, wanted):
        kind = 'annotations' if hasattr(wanted, 'annotations') else 'grease_pencils'
        setattr(wanted, kind, [name])
    return getattr(wanted, kind)[0]
