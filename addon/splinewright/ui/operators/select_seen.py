"""A click in Edit Mode takes the visible points of nets: Blender's own click takes what lies behind the surface, too, as that is
another object than the net."""

import bpy
from bpy.props import StringProperty

from ...bridge.net import selection
from .. import editing, picking, seeing
from .gesture import Gesture

_PASSED = {'PASS_THROUGH', 'CANCELLED'}
#: Blender's keymap of the view. It is asked after all others: what has been taken there is no more, but may be dragged.
VIEW = "3D View"
#: Settings of Blender's own operator for other than one thing at the mouse.
_OTHER = ('center', 'enumerate', 'object')
_MODIFIERS = ('shift', 'ctrl', 'alt', 'oskey')
#: By what is selected: nothing but vertices, nothing but edges. What has faces is taken by the face at the mouse.
_NEAREST = {(True, False, False): seeing.nearest_vertex, (False, True, False): seeing.nearest_edge}


class SPLINEWRIGHT_OT_select_seen(Gesture, bpy.types.Operator):
    bl_idname = "splinewright.select_seen"
    bl_label = "Select Visible"
    bl_description = "Select the visible point or edge of a net nearest to the mouse"
    bl_options = {'INTERNAL'}

    #: Blender's keymap whose key for its own Select is taken.
    keymap: StringProperty(options={'HIDDEN', 'SKIP_SAVE'})

    @classmethod
    def poll(cls, context):
        space = context.space_data
        if context.mode != 'EDIT_MESH' or space is None or space.type != 'VIEW_3D':
            return False
        nets = editing.nets_in_edit_mode(context)
        return (bool(nets) and len(nets) == len(context.objects_in_mode) and seeing.hides(context, space)
                and tuple(context.tool_settings.mesh_select_mode) in _NEAREST)

    def invoke(self, context, event):
        own, view = _own_item(self.keymap, 'view3d.select', event), picking.view_at(event.mouse_x, event.mouse_y)
        if own is None or view is None or any(getattr(own.properties, other) for other in _OTHER):
            return _PASSED
        found = self._nearest(context, event, *view)
        if not found.is_met:
            return _PASSED              # Blender's own takes it
        if _take(context, own.properties, found):
            bpy.ops.ed.undo_push(message="Select")
        if event.value != 'PRESS':
            return {'FINISHED'}
        if self.keymap == VIEW:
            return {'PASS_THROUGH', 'FINISHED'}
        self._pressed, self._button = (event.mouse_x, event.mouse_y), event.type
        return self.begin_modal(context)

    def step(self, context, event):
        """Tools' keymaps would hand on the press to Blender's own Select, too: a drag is begun here."""
        if event.type == self._button and event.value == 'RELEASE':
            return {'FINISHED'}
        inputs = context.preferences.inputs
        least = picking.near(inputs.drag_threshold_tablet if event.is_tablet else inputs.drag_threshold_mouse)
        if max(abs(event.mouse_x - self._pressed[0]), abs(event.mouse_y - self._pressed[1])) < least:
            return {'RUNNING_MODAL'}
        _drag(context, self.keymap, self._button)
        return {'FINISHED'}

    def _nearest(self, context, event, region, view):
        sight = seeing.Sight(context, context.space_data, region, view)
        nearest = _NEAREST[tuple(context.tool_settings.mesh_select_mode)]
        pixel = event.mouse_x - region.x, event.mouse_y - region.y
        return nearest(sight, region, view, pixel, editing.nets_in_edit_mode(context))


def _take(context, asked, found):
    """Select as Blender's own operator does with such settings; whether anything may have changed."""
    kind = 'verts' if context.tool_settings.mesh_select_mode[0] else 'edges'
    how = next((name for name in ('extend', 'deselect', 'toggle') if getattr(asked, name)), 'only')
    if found.ob is None and (how != 'only' or not asked.deselect_all):
        return False
    if found.ob and how == 'only' and asked.select_passthrough and selection.is_chosen(found.ob, found.index, kind):
        return False
    for ob in editing.nets_in_edit_mode(context) if how == 'only' else ():
        selection.clear(ob)
    if found.ob:
        selection.choose(found.ob, found.index, kind, how)
        context.view_layer.objects.active = found.ob
    return True


def _own_item(name, operator, event):
    """The key of the user's by which an operator of Blender's begins at such an event, or None."""
    keymap = bpy.context.window_manager.keyconfigs.user.keymaps.get(name)
    return next((item for item in (keymap.keymap_items if keymap else ())
                 if item.idname == operator and item.active and item.type == event.type and item.value == event.value
                 and (item.any or all(getattr(item, key) in (-1, getattr(event, key)) for key in _MODIFIERS))), None)


def _drag(context, tool, button):
    """Begin what the user's keymaps have for a drag with a button alone, that of the active tool first."""
    active = context.workspace.tools.from_space_view3d_mode(context.mode)
    keymaps = context.window_manager.keyconfigs.user.keymaps
    names = (f"3D View Tool: {active.idname.split('.')[-1].replace('_', ' ').title()}" if active else "", tool, "Mesh", VIEW)
    for keymap in filter(None, map(keymaps.get, names)):
        for item in keymap.keymap_items:
            if (item.active and (item.type, item.value) == (button, 'CLICK_DRAG')
                    and not any(getattr(item, key) is True or getattr(item, key) == 1 for key in (*_MODIFIERS, 'any'))):
                room, _, name = item.idname.partition(".")
                getattr(getattr(bpy.ops, room), name)('INVOKE_DEFAULT', **dict(item.properties.items()))
                return


CLASSES = (SPLINEWRIGHT_OT_select_seen,)
