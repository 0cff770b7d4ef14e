"""Colors by the distance of shapes from another object, on surfaces and along curves, and their legend."""

from typing import NamedTuple

import bpy
import gpu
import numpy as np

from ..bridge.analysis import deviations, overlays
from ..core.analysis import deviations as measures
from ..core.base import length_units
from ..core.base.failures import FAILURES
from ..core.base.words import phrase
from . import legend, line_batches, surface_shader, timers
from .ui_state import ui_state

#: Seconds after the last change until distances are measured in the end, and from one part of that to the next.
_SETTLE, _NEXT = 0.3, 0.01
#: Of lines, and of surfaces as of surface_paint.
_WIDTH, _PART = 4.0, 0.5
#: Characters of a name in the legend.
_NAME = 20


class Shown(NamedTuple):
    """What shapes show of one object."""

    obs: list                           # [(object, its core.analysis.deviations.Deviation)]
    words: str                          # of bridge.analysis.deviation_targets
    reach: float                        # the distance that has the last color
    share: float                        # how much is measured in the end, of 1


def draw(chosen, obs):
    """In the current 3D view, over the faces of those objects that are surfaces."""
    shown = _shown(chosen, obs)
    for ob, deviation in _of_type(shown, 'MESH'):
        batch = overlays.kept(ob.data, ('painted', ob.name), (deviation,), _surface)
        gpu.state.depth_test_set('NONE' if ob.show_in_front else 'LESS_EQUAL')
        with line_batches.nearer(_PART):
            surface_shader.draw(batch, ob.matrix_world, 'NUMBERS', reach=shown.reach, colors=surface_shader.DISTANCES)
    gpu.state.depth_test_set('NONE')


def draw_lines(chosen, obs):
    """In the current 3D view, along those that are curves."""
    shown = _shown(chosen, obs)
    for ob, deviation in _of_type(shown, 'CURVE'):
        lines = overlays.kept(ob.data, ('painted', ob.name), (deviation, shown.reach), _lines)
        gpu.state.depth_test_set('NONE' if ob.show_in_front else 'LESS_EQUAL')
        with gpu.matrix.push_pop(), line_batches.nearer():
            gpu.matrix.multiply_matrix(ob.matrix_world)
            line_batches.draw([lines])
    gpu.state.depth_test_set('NONE')


def draw_legend(context, chosen, obs):
    """In pixels."""
    shown = _shown(chosen, obs)
    if not shown:
        return
    system = context.scene.unit_settings
    unit = length_units.unit_for(shown.reach, system.system, system.length_unit, system.scale_length)
    name = chosen.deviation_object.name
    numbers = [length_units.text(part / 4 * shown.reach, unit) for part in range(5)] if shown.obs else []
    legend.draw(context, ["Distance to", name if len(name) <= _NAME else f"{name[:_NAME - 1]}…", f"({shown.words})"],
                numbers, surface_shader.DISTANCES, _notes(shown, unit))


def rest():
    """Nothing has changed for a while."""
    ui_state.is_still = True
    redraw()


def _notes(shown, unit):
    notes = []
    if shown.obs:
        largest, mean = measures.over_all([deviation for _, deviation in shown.obs])
        about = "" if shown.share == 1.0 else "≈ "
        notes.append(phrase("Largest {about}{largest}", about=about, largest=length_units.text(largest, unit)))
        if len({ob.type for ob, _ in shown.obs}) == 1:
            notes.append(phrase("Mean {about}{mean}", about=about, mean=length_units.text(mean, unit)))
    if shown.share < 1.0 and (shown.share > 0.0 or not shown.obs):
        notes.append(phrase("Measuring: {share:.0f} %", share=100 * shown.share))
    return notes


def redraw():
    for window in bpy.context.window_manager.windows:
        for area in window.screen.areas:
            if area.type == 'VIEW_3D':
                area.tag_redraw()


def _of_type(shown, kind):
    return [(ob, deviation) for ob, deviation in shown.obs if ob.type == kind] if shown else []


def _shown(chosen, obs):
    """None where there is nothing to measure, or to measure to."""
    other = chosen.deviation_object
    try:
        target = deviations.target(bpy.context.scene)
    except FAILURES:
        return None                     # the popover says it
    found, shares = [], []
    for ob in obs:
        if ob != other:
            deviation, share, is_new = deviations.of(ob, target, ui_state.is_still)
            if is_new:
                _wait()
            if deviation is not None and np.isfinite(deviation.largest):
                found.append((ob, deviation))
            if deviation is not None or share < 1.0:
                shares.append(share)
    share = sum(shares) / len(shares) if shares else 1.0
    if ui_state.is_still and share < 1.0:
        timers.later(redraw, _NEXT)
    if not found and share == 1.0:
        return None
    reach = chosen.deviation_range or max([deviation.largest for _, deviation in found], default=0.0)
    return Shown(found, target.geometry.words, reach, share)


def _wait():
    ui_state.is_still = False
    timers.later(rest, _SETTLE)


def _surface(data, deviation):
    known, _, _ = overlays.kept(data, 'placed', (), deviations.faces_of)
    return surface_shader.batch(known._replace(values=deviation.values.astype(np.float32)))


def _lines(data, deviation, reach):
    pairs = overlays.kept(data, 'lines', (), deviations.lines_of)
    parts = deviation.values.ravel() / reach if reach > 0.0 else np.zeros(deviation.values.size)
    shades = np.append(surface_shader.colors_at(2.0 * parts - 1.0, surface_shader.DISTANCES), np.ones((parts.size, 1)), 1)
    is_known = np.isfinite(parts.reshape(-1, 2)).all(1)
    return line_batches.colored(pairs[is_known], shades.reshape(-1, 2, 4)[is_known], _WIDTH)
