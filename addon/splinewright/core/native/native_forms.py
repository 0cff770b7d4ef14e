"""Values as Blender's splines, exactly: as they are where Blender has such knots, else in Bezier pieces."""

from typing import NamedTuple

import numpy as np

from ..base.failures import Refusal
from ..base.library import sc
from . import native
from .native import Direction, Flags, NativeSpline
from .native_match import matching_direction
from .native_refine import Axis, bezier_rows, homogeneous

#: Blender's order ends at 64.
MOST_DEGREE = 63
#: A span is halved so often, at most, to make its weights positive.
MOST_HALVINGS = 10

_AT_INFINITY = "it passes through infinity, where Blender has no points"
_NEAR_INFINITY = "it comes closer to infinity than Blender's weights can hold"


class Form(NamedTuple):
    """One spline, and for each direction our parameters between which Blender's run evenly."""

    spline: NativeSpline
    joints: tuple
    part: object                    # what of the value it shows: a curve or a patch
    is_as_given: bool               # or in other pieces than that part

    def parameters(self, axis, blenders):
        """Our parameters where Blender's are these."""
        direction, joints = self.spline.directions[axis], self.joints[axis]
        start, end = (0, len(joints) - 1) if self.spline.kind == 'BEZIER' else native.domain(direction)
        return np.interp(blenders, np.linspace(start, end, len(joints)), joints)

    def at_parts(self, fractions):
        """Our parameters, of a curve, at parts of its spline."""
        joints, = self.joints
        return np.interp(fractions, np.linspace(0.0, 1.0, len(joints)), joints)

    def parts_at(self, parameters):
        """At which parts of the spline of a curve our parameters lie; those beyond it are left out."""
        joints, = self.joints
        inside = parameters[(parameters >= joints[0]) & (parameters <= joints[-1])]
        return np.interp(inside, joints, np.linspace(0.0, 1.0, len(joints)))


def curve_forms(curve):
    """The Forms of a curve: one, or more where its knots break it. Raises Refusal with a sentence."""
    _require_degree(curve.degree)
    if isinstance(curve, sc.HermiteCurve) or _is_plain_cubic(curve):
        return [_chain(curve)]
    forms = []
    for part in _unbroken(curve.to_nurbs()):
        axis = Axis(part.degree, part.knots, part.periodic)
        forms.append(_form(part, [axis], homogeneous(part.points, part.weights)))
    return forms


def patch_forms(patch):
    """curve_forms() of a patch. Blender's faces look where ours do, so Blender's u is our v."""
    _require_degree(max(patch.degree))
    forms = []
    for part in _unbroken_patches(patch.to_nurbs()):
        axes = [Axis(*fields) for fields in zip(part.degree, part.knots, part.periodic)]
        net = homogeneous(part.points, part.weights)
        forms.append(_form(part, axes[::-1], net.swapaxes(0, 1)))
    return forms


def _require_degree(degree):
    if degree > MOST_DEGREE:
        raise Refusal("its degree is {degree}: Blender's own curves and surfaces end at {most_degree}",
                      degree=degree, most_degree=MOST_DEGREE)


def _is_plain_cubic(curve):
    return isinstance(curve, sc.BezierCurve) and curve.degree == 3 and (curve.weights == curve.weights[0]).all()


def _chain(curve):
    """A cubic Bezier curve or a Hermite chain as a Bezier spline, cyclic where a chain closes."""
    cubics = np.array([piece.points for piece in curve.to_bezier()])
    positions = np.concatenate([cubics[:, 0], cubics[-1:, 3]])
    left = np.concatenate([2 * cubics[:1, 0] - cubics[:1, 1], cubics[:, 2]])
    right = np.concatenate([cubics[:, 1], 2 * cubics[-1:, 3] - cubics[-1:, 2]])
    joints = np.array([0.0, 1.0])
    if isinstance(curve, sc.HermiteCurve):
        joints = curve.parameters
        left[0] = positions[0] - (joints[1] - joints[0]) / 3 * curve.tangents[0, 0]
        right[-1] = positions[-1] + (joints[-1] - joints[-2]) / 3 * curve.tangents[-1, 1]
    points = np.stack([left, positions, right], axis=1)
    is_closed = len(points) > 2 and np.array_equal(positions[0], positions[-1])
    if is_closed:
        points[0, 0] = points[-1, 0]
        points = points[:-1]
    direction = Direction(len(points), 3, Flags(cyclic=is_closed))
    return Form(NativeSpline('BEZIER', _in_single(points), (direction,)), (joints,), curve, True)


def _unbroken(curve):
    """The parts of a NURBS curve between the knots that break it."""
    if curve.periodic:
        if not _breaks(curve.unrolled()).size:
            return [curve]
        curve = curve.unrolled()
    parts = []
    for knot in _breaks(curve):
        start, curve = curve.split(knot)
        parts.append(start)
    return [*parts, curve]


def _breaks(curve):
    return _breaking_knots(Axis(curve.degree, curve.knots))


def _breaking_knots(axis):
    """Knots of multiplicity degree + 1 inside the domain."""
    start, end = axis.domain
    values, counts = np.unique(axis.knots, return_counts=True)
    return values[(counts > axis.degree) & (values > start) & (values < end)]


def _unbroken_patches(patch):
    if any(patch.periodic) and any(_patch_breaks(patch.unrolled(), axis).size for axis in (0, 1)):
        patch = patch.unrolled()
    parts = [patch]
    for axis in (0, 1):
        parts = [piece for part in parts for piece in _split_along(part, axis)]
    return parts


def _patch_breaks(patch, axis):
    return _breaking_knots(Axis(patch.degree[axis], patch.knots[axis], patch.periodic[axis]))


def _split_along(patch, axis):
    parts = []
    for knot in _patch_breaks(patch, axis):
        start, patch = patch.split('uv'[axis], knot)
        parts.append(start)
    return [*parts, patch]


def _form(part, axes, net):
    """The Form of a part whose homogeneous net, (n, 4) or (nu, nv, 4), no knot breaks."""
    if (net[..., 3] < 0).all():
        net = -net
    is_positive = (net[..., 3] > 0).all()
    directions = [matching_direction(axis, net.shape[i]) if is_positive else None for i, axis in enumerate(axes)]
    is_as_given = None not in directions
    joints = [np.array(axis.domain) if direction else _start_joints(axis)
              for axis, direction in zip(axes, directions)]
    if is_positive:
        net = _in_pieces(axes, net, [None if direction else at for direction, at in zip(directions, joints)])
    else:
        net = _with_positive_weights(axes, net, joints)
    for i, (axis, direction) in enumerate(zip(axes, directions)):
        if direction is None:
            net, directions[i] = _closed(net, axis, i)
    points = np.concatenate([net[..., :3] / net[..., 3:], net[..., 3:]], axis=-1)
    return Form(NativeSpline('NURBS', _in_single(points), tuple(directions)), tuple(joints), part, is_as_given)


def _start_joints(axis):
    """A closed direction needs two Bezier pieces in Blender."""
    joints = axis.joints
    return np.linspace(*joints, 3) if axis.periodic and len(joints) == 2 else joints


def _closed(net, axis, i):
    """A net in Bezier pieces along axis i, without its last row where it is closed, and the Direction."""
    if axis.periodic:
        net = np.delete(net, -1, axis=i)
    return net, Direction(net.shape[i], axis.degree, Flags(axis.periodic, True, True))


def _in_pieces(axes, net, joints):
    """The net in Bezier pieces that meet at the joints, along the axes whose joints are not None."""
    for i, (axis, at) in enumerate(zip(axes, joints)):
        if at is not None:
            rows = np.moveaxis(net, i, 0)
            made = bezier_rows(axis, rows.reshape(len(rows), -1), at)
            net = np.moveaxis(made.reshape(-1, *rows.shape[1:]), 0, i)
    return net


def _with_positive_weights(axes, net, joints):
    """The net in Bezier pieces, halved where a weight is not positive; `joints` take the halves in."""
    for _ in range(MOST_HALVINGS + 1):
        pieces = _in_pieces(axes, net, joints)
        pieces = pieces * np.sign(pieces[..., 3].flat[0])
        _require_finite_joints(axes, pieces[..., 3])
        bad = np.argwhere(pieces[..., 3] <= 0)
        if not len(bad):
            return pieces
        for i, axis in enumerate(axes):
            inner = bad[bad[:, i] % axis.degree != 0, i]
            spans = np.unique(inner // axis.degree)
            joints[i] = np.union1d(joints[i], (joints[i][spans] + joints[i][spans + 1]) / 2)
    raise Refusal(_NEAR_INFINITY)


def _require_finite_joints(axes, weights):
    at_joints = weights[np.ix_(*(range(0, weights.shape[i], axis.degree) for i, axis in enumerate(axes)))]
    if (at_joints <= 0).any():
        raise Refusal(_AT_INFINITY)


def _in_single(points):
    """The points rounded as Blender will hold them. Raises Refusal where it cannot."""
    with np.errstate(over='ignore'):
        single = points.astype(np.float32)
    if not np.isfinite(single).all():
        raise Refusal("a point is farther away than Blender can hold (3.4e38)")
    if points.shape[-1] == 4 and (single[..., 3] == 0).any():
        raise Refusal(_NEAR_INFINITY)
    return points
