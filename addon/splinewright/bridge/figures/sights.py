"""What switches of the Overlays popover draw over shapes by lines and points, as a figure has it."""

from typing import NamedTuple

import numpy as np

from ..analysis import overlays

#: On white.
_COMB, _HODOGRAPH, _NORMALS, _KNOTS = (0.45, 0.25, 0.7), (0.7, 0.4, 0.0), (0.0, 0.45, 0.55), (0.0, 0.0, 0.0)
_FRAME, _CIRCLE = ((0.8, 0.1, 0.15), (0.25, 0.5, 0.0), (0.1, 0.35, 0.8)), (0.35, 0.35, 0.35)
_AXES, _GRID = (0.35, 0.35, 0.35), (0.8, 0.8, 0.8)


class Lines(NamedTuple):
    """In the space of a shape: pairs of ends (n, 2, 3), arrows from foot to head, points (m, 3)."""

    color: tuple
    pairs: np.ndarray = np.empty((0, 2, 3))
    arrows: tuple = ()
    points: np.ndarray = np.empty((0, 3))
    is_bold: bool = False


def of(ob, chosen):
    """[Lines] of a shape, by the switches that are on; what cannot be made is left out, as in views."""
    makers = _OF_CURVES if ob.type == 'CURVE' else _OF_PATCHES
    found = []
    for switch, (numbers, kept, make, show) in makers.items():
        if getattr(chosen, switch):
            made = overlays.kept(ob.data, kept, tuple(getattr(chosen, name) for name in numbers), make)
            found += show(made) if made is not None else []
    return found


def _comb(made):
    return [Lines(_COMB, made.teeth), Lines(_COMB, made.back, is_bold=True)]


def _frame(made):
    return [Lines(_CIRCLE, made.circles), *(Lines(color, pairs, is_bold=True) for color, pairs in zip(_FRAME, made.axes))]


def _axes(made):
    return [Lines(_GRID, made.grid), Lines(_AXES, made.lines)]


#: By switches: the numbers beside them, what is made of a data-block (not kept where views keep their strokes), and its Lines.
_OF_CURVES = {
    'comb': (('comb_density', 'comb_scale'), 'comb of figure', overlays.comb_of, _comb),
    'hodograph': (('place', 'hodograph_scale'), 'hodograph of figure', overlays.hodographs_of,
                  lambda made: [Lines(_HODOGRAPH, made.lines, made.arrows, is_bold=True)]),
    'frame': (('place', 'frame_length'), 'frame of figure', overlays.frames_of, _frame),
    'axes': ((), 'numbers', overlays.axes_of, _axes),
    'knots': ((), 'knots of figure', overlays.knots_of, lambda made: [Lines(_KNOTS, points=made)])}
_OF_PATCHES = {
    'normals': (('normal_count', 'normal_length'), 'normals of figure', overlays.normals_of, lambda made: [Lines(_NORMALS, made)]),
    'axes': ((), 'numbers', overlays.axes_of, _axes),
    'knots': ((), 'knots of figure', overlays.knots_of, lambda made: [Lines(_KNOTS, made, is_bold=True)])}
