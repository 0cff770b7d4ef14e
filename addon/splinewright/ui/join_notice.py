"""Says that definitions ended where Blender's own Join, from its menu or the search, took shapes in.

Blender tells no add-on of a join before it is done: what was selected at the last change is compared with the objects that are left.
"""

import bpy
from bpy.app.handlers import persistent

from ..bridge.data.file_state import ended_operators
from ..bridge.shape import shape
from ..core.base.words import phrase, say
from . import texts
from .ui_state import ui_state

_WIDTH = 60
_WORDS = ("Blender's Join made plain faces or points of them. Undo brings the definitions back; Ctrl+J, or NURBS > "
          "Join > Join Shapes, makes shapes one shape.")


@persistent
def updated(scene, depsgraph):
    """Compare, and look at the selection now."""
    if bpy.app.background or bpy.context.mode != 'OBJECT' or not depsgraph.id_type_updated('SCENE'):
        return
    if _is_new_join():
        lost = sorted(name for name in ui_state.selected_shapes if name not in bpy.data.objects)
        if lost:
            bpy.app.timers.register(lambda: _say(lost), first_interval=0.0)
    ui_state.selected_shapes = {ob.name for ob in bpy.context.view_layer.objects.selected if shape.has_shape(ob)}


def _is_new_join():
    """Undo and redo leave the last one among what was done."""
    ended = ended_operators()
    if not ended or bpy.context.window_manager.operators[-1].bl_idname != 'OBJECT_OT_join' or ended == ui_state.last_join:
        return False
    ui_state.last_join = ended
    return True


def _say(names):
    """A popup, outside the handler."""
    manager = bpy.context.window_manager
    count = len(names)
    title = phrase("The definition of {names} ended",
                   names=names[0]) if count == 1 else phrase("The definitions of {count} shapes ended", count=count)
    with bpy.context.temp_override(window=manager.windows[0]):
        manager.popup_menu(lambda menu, context: texts.draw_note(menu.layout, _WORDS, _WIDTH), title=say(title), icon='ERROR')


CLASSES = ()


def register():
    bpy.app.handlers.depsgraph_update_post.append(updated)


def unregister():
    bpy.app.handlers.depsgraph_update_post.remove(updated)
