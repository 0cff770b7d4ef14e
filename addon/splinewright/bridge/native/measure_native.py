"""How far Blender's own evaluation of a curve or surface lies from ours, measured."""

import bpy
import numpy as np

from ...core.native import native
from ..data import versions
from . import native_splines

#: Enough to see a difference; one step has oddities of its own in some versions.
_CURVE_STEPS = (2, 12)
_SURFACE_STEPS = (1, 4)


def of_reading(ob, reading):
    """The largest distance, in units of the object, between what Blender makes of its bare points in
    Object Mode, without bevel or modifiers, and a Reading of them. None where it cannot be measured."""
    if reading.value is None:
        return None
    evaluators = [_same_parameters(piece) for piece in reading.pieces]
    return _deviation(ob.data, ob, reading.indices, reading.splines, evaluators)


def of_forms(data, forms):
    """The same between the splines of a data-block and what they show: a Form for each."""
    return _deviation(data, None, range(len(forms)), [form.spline for form in forms], [_through(form) for form in forms])


def _same_parameters(piece):
    """Our points at Blender's parameters, which are ours; u of a patch is Blender's v."""
    return lambda *at: _points(piece, at)


def _through(form):
    return lambda *at: _points(form.part, [form.parameters(axis, blenders) for axis, blenders in enumerate(at)])


def _points(piece, at):
    if len(at) == 1:
        return piece.evaluate(at[0], at_infinity='nan')
    return piece.evaluate_grid(at[1], at[0], at_infinity='nan').swapaxes(0, 1).reshape(-1, 3)


def _deviation(data, ob, indices, splines, evaluators):
    bare = _bare_copy(data, indices)
    if bare is None:
        return None
    try:
        blenders = _evaluated(bare, ob)
        at = [_parameters(theirs, spline) for theirs, spline in zip(bare.splines, splines)]
    finally:
        bpy.data.curves.remove(bare)
    ours = np.concatenate([evaluate(*parameters) for evaluate, parameters in zip(evaluators, at)])
    if ours.shape != blenders.shape:
        return None
    distances = np.linalg.norm(ours - blenders, axis=1)
    return float(np.nanmax(distances)) if np.isfinite(distances).any() else None


def _bare_copy(data, indices):
    """A copy of the data with nothing but these splines; None where shape keys do not let others go."""
    if data.shape_keys and len(indices) != len(data.splines):
        return None
    bare = data.copy()
    bare.dimensions = '3D'
    bare.bevel_object = bare.taper_object = None
    bare.bevel_depth = bare.extrude = bare.offset = 0
    bare.bevel_factor_start, bare.bevel_factor_end = 0, 1
    kept = set(indices)
    for spline in [spline for i, spline in enumerate(bare.splines) if i not in kept]:
        bare.splines.remove(spline)
    is_surface = isinstance(data, bpy.types.SurfaceCurve)
    for spline in bare.splines:
        _set_steps(spline, _SURFACE_STEPS if is_surface else _CURVE_STEPS)
    return bare


def _set_steps(spline, limits):
    for name in ('resolution_u', 'resolution_v'):
        setattr(spline, name, int(np.clip(getattr(spline, name), *limits)))


def _evaluated(bare, ob):
    """The vertices that Blender makes."""
    with native_splines.holder_of(bare, ob) as holder:
        mesh = holder.to_mesh()
        flat = np.empty(3 * len(mesh.vertices), np.float32)
        mesh.vertices.foreach_get('co', flat)
        holder.to_mesh_clear()
    return flat.reshape(-1, 3).astype(np.float64)


def _parameters(theirs, spline):
    if spline.kind == 'BEZIER':
        straight = native_splines.straight_segments(theirs)
        return [native.bezier_samples(straight, theirs.use_cyclic_u, theirs.resolution_u)]
    if len(spline.directions) == 1:
        return [native.curve_samples(spline, theirs.resolution_u, versions.sampling)]
    return [native.surface_parameters(direction, getattr(theirs, f"resolution_{axis}"))
            for axis, direction in zip('uv', spline.directions)]
