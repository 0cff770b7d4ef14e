"""Equal parts of curves by length, and where things stand on them."""

import numpy as np

from ..base.failures import Refusal

#: How a frame's tangent, side and up lie on the axes of what stands there: columns of these, each +1 or -1.
_AXES = {'X': ((0, 1), (1, 1), (2, 1)), 'Y': ((1, -1), (0, 1), (2, 1)), 'Z': ((1, 1), (2, 1), (0, 1))}
_UP = np.array([0.0, 0.0, 1.0])


def parameters(curve, count=None, length=None, with_ends=True, cancel=None):
    """Of the ends of equal parts: of this number, or of this length from the start on. An open curve has both its ends among them,
    or none. cancel: as the library takes it. Raises Refusal where the curve is shorter."""
    if length is None:
        at = curve.divide(count, cancel=cancel)
    else:
        at = curve.divide_by_length(length, cancel=cancel)
        if len(at) < 2:
            raise Refusal("it is shorter than one part")
    if with_ends or is_closed(curve):
        return at
    return at[1:-1] if length is None else at[1:][at[1:] < curve.domain[1]]


def is_closed(curve):
    return np.array_equal(*curve.evaluate(np.array(curve.domain)))


def places(curve, at, turned, along, cancel=None):
    """(n, 4, 4): where things stand at parameters, with their axis `along`, 'X', 'Y' or 'Z', ahead on the curve.

    turned: 'standing', upright in the world; 'upright', their upper side as far up as the curve lets it; 'minimal', turning
    no more than the curve makes them; 'frenet', to where the curve bends; 'not' leaves the axes of the space.
    cancel: as the library takes it. Raises what the library raises where the curve has no such frames.
    """
    found = np.zeros((len(at), 4, 4))
    found[:, 3, 3] = 1.0
    found[:, :3, 3] = curve.evaluate(at)
    found[:, :3, :3] = np.eye(3) if turned == 'not' else _rotations(_frames(curve, at, turned, cancel), along)
    return found


def _frames(curve, at, turned, cancel):
    """(n, 3, 3): tangent, upper side and tangent x upper side as rows."""
    if turned == 'frenet':
        return curve.frames(at, 'frenet', cancel=cancel)
    frames = curve.frames(at, start=_start(curve), closed=is_closed(curve), cancel=cancel)
    if turned == 'minimal':
        return frames
    if turned == 'standing':
        ahead = _unit(frames[:, 0] * (1.0, 1.0, 0.0), frames[:, 1] * (1.0, 1.0, 0.0))
        return _with_sides(ahead, np.broadcast_to(_UP, ahead.shape))
    return _with_sides(frames[:, 0], _unit(_UP - frames[:, 0] * frames[:, :1, 2], frames[:, 1]))


def _with_sides(ahead, up):
    return np.stack([ahead, up, np.cross(ahead, up)], axis=1)


def _unit(vectors, otherwise):
    """Of length 1; where they have none, the others."""
    chosen = np.where(np.linalg.norm(vectors, axis=1, keepdims=True) < 1e-6, otherwise, vectors)
    return chosen / np.linalg.norm(chosen, axis=1, keepdims=True)


def _start(curve):
    """Where the upper side points first: up, unless the curve begins so."""
    tangent = curve.frames(curve.domain[0])[0]
    return _UP if abs(tangent[2]) < 0.999 else np.array([1.0, 0.0, 0.0])


def _rotations(frames, along):
    """Matrices with the axes of what stands there as columns: one ahead, the upper side up, right-handed."""
    tangent, up, side = frames[:, 0], frames[:, 1], -frames[:, 2]          # side = up x tangent
    of_frame = tangent, side, up
    columns = [sign * of_frame[which] for which, sign in _AXES[along]]
    return np.stack(columns, axis=-1)
