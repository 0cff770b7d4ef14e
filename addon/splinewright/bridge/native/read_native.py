"""Blender's own curve and surface objects as splinecore values of what Blender draws."""

from dataclasses import replace
from typing import NamedTuple

import bpy

from ...core.base.failures import Refusal
from ...core.base.library import sc
from ...core.base.words import phrase
from ...core.native import native_values
from . import native_keys, native_splines

#: Modifiers that move the control points of a curve before Blender evaluates it.
_ON_POINTS = {'HOOK', 'SOFT_BODY', 'MESH_DEFORM'}
#: Modifiers after which no other moves control points.
_CONSTRUCTIVE = {'ARRAY', 'BEVEL', 'EDGE_SPLIT', 'MIRROR', 'SCREW', 'SOLIDIFY', 'SUBSURF', 'TRIANGULATE', 'WELD'}


class Reading(NamedTuple):
    """What a native object is. The pieces of the value come from `splines`, one each."""

    value: object                   # a curve, a list of curves, a patch, a PatchSet, or None
    splines: tuple                  # of NativeSpline
    indices: tuple                  # of the splines among those of the data-block
    materials: tuple                # material index of each
    dropped: list                   # what could not be made ours: fragments for "without ..."

    @property
    def pieces(self):
        """The value as a list of curves or patches."""
        if isinstance(self.value, (list, sc.PatchSet)):
            return [self.value[i] for i in range(len(self.value))]
        return [] if self.value is None else [self.value]


def read(ob, depsgraph=None):
    """What a CURVE or SURFACE object is, with its shape keys.

    With a depsgraph the points are those evaluated there: animated shape keys, and on curves hooks and
    other modifiers that move control points. Without one modifiers have no effect. In Edit Mode it is
    the edited state. Raises Refusal with a sentence where it is unclear what Blender draws.
    """
    if ob.type not in ('CURVE', 'SURFACE'):
        raise Refusal("{name} is not a curve or surface", name=ob.name)
    is_surface = ob.type == 'SURFACE'
    splines, materials = _splines(ob, is_surface, depsgraph)
    make = native_values.surface_value if is_surface else native_values.curve_value
    pieces, kept, dropped = [], [], []
    for i, spline in enumerate(splines):
        try:
            piece, words = make(spline, f"spline {i + 1}")
        except (Refusal, sc.Error) as error:
            piece, words = None, [phrase("spline {i} ({error})", i=i + 1, error=error)]
        dropped += words
        if piece is not None:
            pieces.append(piece)
            kept.append(i)
    return Reading(_joined(pieces, is_surface), tuple(splines[i] for i in kept), tuple(kept),
                   tuple(materials[i] for i in kept), dropped)


def rows(ob):
    """The NativeSplines of a SURFACE object of rows of points, as those of curves."""
    splines, _ = _splines(ob, True, None)
    return [replace(spline, points=spline.points[:, 0], directions=spline.directions[:1]) for spline in splines]


def single_point(ob):
    """(x, y, z) of the one point that a CURVE object has, or None."""
    if ob.type != 'CURVE' or len(ob.data.splines) != 1:
        return None
    spline = ob.data.splines[0]
    points = spline.bezier_points if spline.type == 'BEZIER' else spline.points
    return tuple(points[0].co[:3]) if len(points) == 1 else None


def _joined(pieces, is_surface):
    if len(pieces) < 2:
        return pieces[0] if pieces else None
    return sc.PatchSet.from_patches(pieces) if is_surface else pieces


def _splines(ob, is_surface, depsgraph):
    """The NativeSplines of the points that are drawn, and their material indices."""
    data = ob.data
    if data.is_editmode or not (data.shape_keys or depsgraph):
        return _of_data(data, is_surface)
    if is_surface:
        splines, materials = _of_data(data, True)
        keys = data.shape_keys if depsgraph is None else ob.evaluated_get(depsgraph).data.shape_keys
        return native_keys.mixed(splines, ob, keys) if keys else splines, materials
    if depsgraph is not None:
        return _of_evaluated(ob.evaluated_get(depsgraph), depsgraph)
    # Not by hand: Blender places handles that are not free anew.
    with native_splines.holder_of(data, ob) as holder:
        return _of_evaluated(holder, bpy.context.evaluated_depsgraph_get())


def _of_evaluated(ob, depsgraph):
    try:
        return _of_data(ob.to_curve(depsgraph, apply_modifiers=True), False)
    except RuntimeError as error:
        raise Refusal("{name} has no evaluated points ({error})", name=ob.name, error=error) from error
    finally:
        ob.to_curve_clear()


def _of_data(data, is_surface):
    return ([native_splines.read(spline, is_surface) for spline in data.splines],
            [spline.material_index for spline in data.splines])


#: What not_followed() calls the radius of points.
RADIUS = "the radius"


def not_followed(ob):
    """What of a native object read() does not read even with a depsgraph: nouns for the user."""
    found = [] if ob.type == 'SURFACE' else _thickness(ob.data)
    followed = 0 if ob.type == 'SURFACE' or ob.data.is_editmode else _modifiers_on_points(ob)
    return found + [phrase("the modifier {name}",
                           name=modifier.name) for modifier in ob.modifiers[followed:] if modifier.show_viewport]


def _modifiers_on_points(ob):
    """How many modifiers, from the first, act on control points."""
    count = 0
    for i, modifier in enumerate(ob.modifiers):
        if modifier.show_viewport and modifier.type in _CONSTRUCTIVE:
            break
        if modifier.show_viewport and (modifier.type in _ON_POINTS or modifier.use_apply_on_spline):
            count = i + 1
    return count


def _thickness(curve):
    """What gives a bare curve a thickness."""
    points = [point for spline in curve.splines for point in spline.bezier_points or spline.points]
    has = {
        "the bevel": curve.bevel_depth != 0 or curve.bevel_object is not None,
        "the extrusion": curve.extrude != 0,
        "the offset": curve.offset != 0,
        "the taper": curve.taper_object is not None,
        "the start and end of the bevel": (curve.bevel_factor_start, curve.bevel_factor_end) != (0, 1),
        "the tilt": any(point.tilt != 0 for point in points),
        RADIUS: any(point.radius != 1 for point in points),
    }
    return [noun for noun, is_there in has.items() if is_there]
