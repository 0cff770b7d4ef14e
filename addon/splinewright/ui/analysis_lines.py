"""How each sight that consists of lines and points is drawn."""

from collections.abc import Callable
from typing import NamedTuple

from ..bridge.analysis import overlays
from . import colors, line_batches


class Sight(NamedTuple):
    """What a switch of the Overlays popover shows of objects of a type, or of all.

    make gives the Strokes for a data-block and these numbers beside the switch.
    """

    switch: str
    type: str
    numbers: tuple
    make: Callable


def prepared(sight, data, chosen):
    """The Strokes of a Sight, worked out once until the shape or a number changes."""
    numbers = tuple(getattr(chosen, name) for name in sight.numbers)
    return overlays.kept(data, sight.switch, numbers, sight.make) or ()


def _isocurves(data, count):
    return [line_batches.lines(overlays.isocurves_of(data, count), lambda: colors.ISOCURVES, 1.2)]


def _knot_lines(data):
    return [line_batches.lines(overlays.knots_of(data), lambda: colors.KNOTS_OF_PATCHES, 2.4)]


def _normals(data, count, length):
    return [line_batches.lines(overlays.normals_of(data, count, length), lambda: colors.NORMALS, 1.2)]


def _polygon(data):
    found = overlays.polygon_of(data)
    rows = [line_batches.lines(pairs, lambda axis=axis: colors.of_net()[axis], 1.5) for axis, pairs in enumerate(found.rows)]
    return [*rows, line_batches.arrows(found.arrows, colors.of_arrows),
            line_batches.points(found.points, colors.of_points, lambda: 5.0)]


def _comb(data, density, scale):
    found = overlays.comb_of(data, density, scale)
    return [line_batches.lines(found.teeth, lambda: colors.TEETH, 1.0), line_batches.lines(found.back, lambda: colors.BACK, 1.8)]


def _hodograph(data, part, scale):
    found = overlays.hodographs_of(data, part, scale)
    return [line_batches.lines(found.lines, lambda: colors.HODOGRAPH, 1.8),
            line_batches.arrows(found.arrows, lambda: colors.HODOGRAPH)]


def _curve(data):
    return [line_batches.lines(overlays.curves_of(data), lambda: colors.CURVE, 2.5)]


def _frame(data, part, length):
    found = overlays.frames_of(data, part, length)
    axes = [line_batches.lines(pairs, lambda color=color: color, 2.5) for pairs, color in zip(found.axes, colors.FRAME)]
    return [line_batches.lines(found.circles, lambda: colors.CIRCLE, 1.5), *axes]


def _knot_marks(data):
    marks = overlays.knots_of(data)
    return [line_batches.points(marks, lambda: colors.RIM, lambda: 9.0),
            line_batches.points(marks, lambda: colors.KNOTS, lambda: 6.0)]


def _axes(data):
    found = overlays.axes_of(data)
    return [line_batches.lines(found.grid, lambda: colors.GRID, 1.0), line_batches.lines(found.lines, lambda: colors.AXES, 1.5)]


#: What lies above others comes last.
SIGHTS = (
    Sight('axes', '', (), _axes),
    Sight('isocurves', 'MESH', ('isocurve_count',), _isocurves),
    Sight('knots', 'MESH', (), _knot_lines),
    Sight('normals', 'MESH', ('normal_count', 'normal_length'), _normals),
    Sight('polygon', '', (), _polygon),
    Sight('comb', 'CURVE', ('comb_density', 'comb_scale'), _comb),
    Sight('hodograph', 'CURVE', ('place', 'hodograph_scale'), _hodograph),
    Sight('curve', 'CURVE', (), _curve),
    Sight('frame', 'CURVE', ('place', 'frame_length'), _frame),
    Sight('knots', 'CURVE', (), _knot_marks),
)
