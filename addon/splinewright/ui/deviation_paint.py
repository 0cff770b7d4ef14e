"""Colours by the distance of shapes from another object, on surfaces and along curves, and their legend."""

from typing import NamedTuple

import bpy
import gpu
import numpy as np

from ..bridge import deviations, sights
from ..bridge.file_state import state
from ..core import lengths
from ..core.failures import FAILURES
from ..core.sights import deviations as measures
from . import legend, strokes, surface_shader

#: Seconds after the last change until distances are measured in the end.
_SETTLE = 0.3
#: Of lines, and of surfaces as of surface_paint.
_WIDTH, _PART = 4.0, 0.5
#: Characters of a name in the legend.
_NAME = 20


class Shown(NamedTuple):
    """What shapes show of one object."""

    obs: list                           # [(object, its core.sights.deviations.Deviation)]
    words: str                          # of bridge.deviation_targets
    reach: float                        # the distance that has the last colour
    is_final: bool


def draw(chosen, obs):
    """In the 3D view at hand, over the faces of those objects that are surfaces."""
    shown = _shown(chosen, obs)
    for ob, deviation in _of_type(shown, 'MESH'):
        batch = sights.kept(ob.data, ('painted', ob.name), (deviation,), _surface)
        gpu.state.depth_test_set('NONE' if ob.show_in_front else 'LESS_EQUAL')
        with strokes.nearer(_PART):
            surface_shader.draw(batch, ob.matrix_world, 'NUMBERS', reach=shown.reach, colors=surface_shader.DISTANCES)
    gpu.state.depth_test_set('NONE')


def draw_lines(chosen, obs):
    """In the 3D view at hand, along those that are curves."""
    shown = _shown(chosen, obs)
    for ob, deviation in _of_type(shown, 'CURVE'):
        lines = sights.kept(ob.data, ('painted', ob.name), (deviation, shown.reach), _lines)
        gpu.state.depth_test_set('NONE' if ob.show_in_front else 'LESS_EQUAL')
        with gpu.matrix.push_pop(), strokes.nearer():
            gpu.matrix.multiply_matrix(ob.matrix_world)
            strokes.draw([lines])
    gpu.state.depth_test_set('NONE')


def draw_legend(context, chosen, obs):
    """In pixels."""
    shown = _shown(chosen, obs)
    if not shown:
        return
    system = context.scene.unit_settings
    unit = lengths.unit_for(shown.reach, system.system, system.length_unit, system.scale_length)
    name = chosen.deviation_object.name
    largest, mean = measures.over_all([deviation for _, deviation in shown.obs])
    about = "" if shown.is_final else "≈ "
    notes = [f"Largest {about}{lengths.text(largest, unit)}"]
    if len({ob.type for ob, _ in shown.obs}) == 1:
        notes.append(f"Mean {about}{lengths.text(mean, unit)}")
    legend.draw(context, ["Distance to", name if len(name) <= _NAME else f"{name[:_NAME - 1]}…", f"({shown.words})"],
                [lengths.text(part / 4 * shown.reach, unit) for part in range(5)], surface_shader.DISTANCES, notes)


def settle():
    """Nothing has changed for a while."""
    state.is_still = True
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
    found, is_final = [], True
    for ob in obs:
        if ob != other:
            deviation, is_measured, is_new = deviations.of(ob, target, state.is_still)
            if is_new:
                _wait()
            if deviation is not None and np.isfinite(deviation.largest):
                found.append((ob, deviation))
                is_final = is_final and is_measured
    if not found:
        return None
    reach = chosen.deviation_range or max(deviation.largest for _, deviation in found)
    return Shown(found, target.geometry.words, reach, is_final)


def _wait():
    state.is_still = False
    if bpy.app.timers.is_registered(settle):
        bpy.app.timers.unregister(settle)
    bpy.app.timers.register(settle, first_interval=_SETTLE)


def _surface(data, deviation):
    known, _, _ = sights.kept(data, 'placed', (), deviations.faces_of)
    return surface_shader.batch(known._replace(values=deviation.values.astype(np.float32)))


def _lines(data, deviation, reach):
    pairs = sights.kept(data, 'lines', (), deviations.lines_of)
    parts = deviation.values.ravel() / reach if reach > 0.0 else np.zeros(deviation.values.size)
    shades = np.append(surface_shader.colors_at(2.0 * parts - 1.0, surface_shader.DISTANCES), np.ones((parts.size, 1)), 1)
    is_known = np.isfinite(parts.reshape(-1, 2)).all(1)
    return strokes.coloured(pairs[is_known], shades.reshape(-1, 2, 4)[is_known], _WIDTH)
