"""Shape keys of surfaces, mixed as Blender mixes them: Blender gives out no evaluated points of a surface."""

from dataclasses import replace

import numpy as np

from ...core.base.failures import Refusal


def mixed(splines, ob, keys):
    """The NativeSplines of a surface with their points where the Key puts them.

    `keys` may be evaluated, for values that are animated. Raises Refusal where it cannot be told.
    """
    if not keys.use_relative and not ob.show_only_shape_key:
        raise Refusal("{name} has absolute shape keys, which are not read from surfaces", name=ob.name)
    if any(len(block.data) != sum(map(_point_count, splines)) for block in keys.key_blocks):
        raise Refusal("{name} has shape keys of another number of points", name=ob.name)
    basis = keys.reference_key
    if ob.show_only_shape_key:
        shown = keys.key_blocks[ob.active_shape_key_index]
        return _moved(splines, _positions(basis if shown.mute else shown))
    positions = _positions(basis)
    for block in keys.key_blocks:
        if block != basis and not block.mute and block.value:
            positions = positions + block.value * (_positions(block) - _positions(block.relative_key))
    return _moved(splines, positions)


def _positions(block):
    flat = np.empty(3 * len(block.data), np.float32)
    block.data.foreach_get('co', flat)
    return flat.reshape(-1, 3).astype(np.float64)


def _point_count(spline):
    return spline.points[..., 0].size


def _moved(splines, positions):
    starts = np.cumsum([_point_count(spline) for spline in splines])[:-1]
    moved = []
    for spline, own in zip(splines, np.split(positions, starts)):
        points = spline.points.copy()
        points[..., :3] = own.reshape(*points.shape[1::-1], 3).swapaxes(0, 1)       # u runs fastest
        moved.append(replace(spline, points=points))
    return moved
