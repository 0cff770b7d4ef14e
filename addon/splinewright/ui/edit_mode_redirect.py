"""The Mode menu, Ctrl+Tab and workspaces lead into the net, not into the mesh or curve that Splinewright wrote.

Blender tells no add-on of a mode before it is there: the way back is gone as soon as it is seen.
"""

import bpy
from bpy.app.handlers import persistent

from ..bridge.shape import shape
from ..core.base.failures import Refusal, blenders_refusals, sentence
from . import editing, texts, timers
from .ui_state import ui_state

_TOGGLES = {'OBJECT_OT_editmode_toggle', 'OBJECT_OT_mode_set'}


@persistent
def updated(scene, depsgraph):
    """Look at the mode, which undo and redo bring back as it was: that is left alone."""
    if bpy.app.background or ui_state.suspended:
        return
    is_in = editing.is_in_result(bpy.context)
    if is_in and not ui_state.was_in_result:
        timers.soon(_go)
    ui_state.was_in_result = is_in


@persistent
def undone(*_):
    ui_state.was_in_result = editing.is_in_result(bpy.context)
    timers.call_off(_go)


def _go():
    """Into the net, outside the handler."""
    windows = bpy.context.window_manager.windows
    found = [(window, area, region) for window in windows for area in window.screen.areas if area.type == 'VIEW_3D'
             for region in area.regions if region.type == 'WINDOW']
    if not found or not editing.is_in_result(bpy.context) or shape.is_touched(bpy.context.object.data):
        return
    window, area, region = found[0]
    with bpy.context.temp_override(window=window, area=area, region=region):
        _take_back()
        for operator in (bpy.ops.splinewright.edit_net, bpy.ops.splinewright.edit_source):
            if operator.poll():
                _call(operator)
                return


def _call(operator):
    """What it refuses, as where a definition is damaged or newer, is said: no operator is there to report it."""
    try:
        with blenders_refusals():
            operator('INVOKE_DEFAULT', True)
    except Refusal as error:
        texts.pop_up(sentence(error))


def _take_back():
    """Back to Object Mode, without the undo step that led away from it."""
    name, done = bpy.context.object.name, bpy.context.window_manager.operators
    if len(done) and done[-1].bl_idname in _TOGGLES and bpy.ops.ed.undo.poll():
        bpy.ops.ed.undo()
    if bpy.context.mode != 'OBJECT' or bpy.context.object is None or bpy.context.object.name != name:
        bpy.ops.object.mode_set(mode='OBJECT')


CLASSES = ()


def register():
    bpy.app.handlers.depsgraph_update_post.append(updated)
    bpy.app.handlers.undo_post.append(undone)
    bpy.app.handlers.redo_post.append(undone)


def unregister():
    bpy.app.handlers.depsgraph_update_post.remove(updated)
    bpy.app.handlers.undo_post.remove(undone)
    bpy.app.handlers.redo_post.remove(undone)
    timers.call_off(_go)
