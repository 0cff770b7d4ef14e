"""Splines of u x v points, which no call of Blender's makes: rows are joined in Edit Mode."""

from itertools import groupby

import bpy
import numpy as np

from ...core.base.failures import Refusal, blenders_refusals
from . import staging
from .native_splines import single


def new_surface(context, name, counts):
    """A new surface data-block with a spline of each of these (u, v) counts, two or more points each.

    Their points are anywhere. Mode, selection and active object are as before. Raises Refusal if
    Blender does not make them.
    """
    data = bpy.data.curves.new(name, 'SURFACE')
    data.dimensions = '3D'
    ob = bpy.data.objects.new(name, data)
    try:
        with staging.alone(context, ob):
            with blenders_refusals():
                _fill(data, counts)
        if [(spline.point_count_u, spline.point_count_v) for spline in data.splines] != list(counts):
            raise Refusal("Blender did not make the surfaces that were asked for")
    except Exception:
        bpy.data.curves.remove(data)
        raise
    bpy.data.objects.remove(ob)
    return data


def _fill(data, counts):
    bpy.ops.object.mode_set(mode='EDIT')
    try:
        for (u, v), group in groupby(counts):
            _add_run(data, u, v, len(list(group)))
    finally:
        bpy.ops.object.mode_set(mode='OBJECT')


def _add_run(data, u, v, count):
    """Add this number of splines of u x v points."""
    first = len(data.splines)
    _select(data, [])
    _add_one(data, u, v)
    while (have := len(data.splines) - first) < count:
        _select(data, data.splines[first:first + min(have, count - have)])
        bpy.ops.curve.duplicate()


def _add_one(data, u, v):
    """The joiner sorts rows by where they lie and never joins rows of two points, hence a plain grid
    and a row to delete."""
    length = max(v, 3)
    for i in range(u):
        row = np.ones((length, 4), np.float32)
        row[:, 0], row[:, 1], row[:, 2] = np.arange(length), i, 0
        spline = data.splines.new('NURBS')
        spline.points.add(length - 1)
        spline.points.foreach_set('co', single(row))
        spline.points.foreach_set('select', np.ones(length, bool))
    bpy.ops.curve.make_segment()
    if length > v:
        _select(data, [])
        for point in data.splines[-1].points[u * v:]:
            point.select = True
        bpy.ops.curve.delete(type='VERT')


def _select(data, splines):
    if len(data.splines):
        bpy.ops.curve.select_all(action='DESELECT')
    for spline in splines:
        spline.points.foreach_set('select', np.ones(len(spline.points), bool))
