"""Tab where a shape has no net: to what it is made from, or to the choice. And out of the result's own mesh."""

import bpy
from bpy.props import EnumProperty, StringProperty

from ...bridge.data import store
from ...bridge.recipes import recipes
from ...bridge.shape import shape
from ...core.base.failures import FAILURES, Refusal
from ...core.base.words import phrase, say
from .. import editing, texts
from . import polls, reports


def _shape_without_net(ob):
    """Whether an object is a shape whose recipe says where its points are: in other objects, or in numbers."""
    if not shape.has_shape(ob) or ob.library or ob.data.library or ob.data.override_library:
        return False
    try:
        return recipes.follows(ob.data) or recipes.has(ob.data) and not recipes.has_points(ob.data)
    except store.UnreadableDefinition:
        return False


class SPLINEWRIGHT_OT_edit_source(bpy.types.Operator):
    bl_idname = "splinewright.edit_source"
    bl_label = "Edit Source Object"
    bl_description = "Edit the object that the active shape is made from: its net, or Blender's own points"
    bl_options = {'REGISTER', 'UNDO'}

    source: StringProperty(name="Object", description="Which of the objects it is made from; empty where it is one",
                           options={'SKIP_SAVE'})

    @classmethod
    def poll(cls, context):
        if not polls.in_object_mode(cls, context):
            return False
        if not _shape_without_net(context.object):
            cls.poll_message_set(say("Select a shape that follows another object"))
            return False
        return True

    def invoke(self, context, event):
        if self.source or len(_sources(context.object)) == 1 or _places(context.object):
            return self.execute(context)
        context.window_manager.popup_menu(_draw_choice, title=say(_title(context.object)), icon='QUESTION')
        return {'CANCELLED'}

    def execute(self, context):
        try:
            _edit_source(context, self.source)
        except FAILURES as error:
            return reports.failed(self, error)
        return {'FINISHED'}


def _sources(ob):
    return recipes.pointers(ob.data) if recipes.follows(ob.data) else []


def _places(ob):
    """The objects in this view layer that a shape goes through."""
    found = recipes.frames(ob.data) if recipes.follows(ob.data) and not _sources(ob) else []
    return [place for place in found if bpy.context.view_layer.objects.get(place.name) == place and place.visible_get()]


def _title(ob):
    return phrase("{name} is made from {count} objects", one="{name} is made from {count} object",
                  name=ob.name, count=len(_sources(ob))) if _sources(ob) else phrase("{name} is made by its numbers",
                                                                                             name=ob.name)


def _draw_choice(menu, context):
    layout = menu.layout
    for source in _sources(context.object):
        layout.operator(SPLINEWRIGHT_OT_edit_source.bl_idname, text=say(phrase("Edit {name}", name=source.name)), icon='EDITMODE_HLT').source = source.name
    if not _sources(context.object):
        texts.draw_note(layout, "Change them in the sidebar, or end that and edit its points", 60)
    layout.operator("splinewright.make_editable")


def _edit_source(context, name=""):
    """Into the points of what the active shape is made from, or to the objects that it goes through. Raises Refusal."""
    places = _places(context.object)
    if places:
        _select(context, *places)
    else:
        _edit(context, _chosen(context, name))


def _chosen(context, name):
    """Raises Refusal where it is not there, or there are several."""
    sources = [ob for ob in _sources(context.object) if not name or ob.name == name]
    if not _sources(context.object):
        raise Refusal("it is made by its numbers: change them in the panel, or use Apply Construction first")
    if len(sources) != 1:
        raise Refusal("choose one of the objects it is made from" if sources else phrase("it is not made from {name}", name=name))
    return sources[0]


def _edit(context, ob):
    """Into the points of an object; of one that follows another in turn, of that. Raises Refusal."""
    seen = set()
    while recipes.follows(ob.data) and len(_sources(ob)) == 1 and ob not in seen:
        seen.add(ob)
        ob = _sources(ob)[0]
    if context.view_layer.objects.get(ob.name) == ob and ob.hide_get():
        ob.hide_set(False)
    if context.view_layer.objects.get(ob.name) != ob or not ob.visible_get():
        raise Refusal("{name} is hidden, or not in this view layer: show it to edit it", name=ob.name)
    if shape.has_shape(ob):
        reason = editing.why_not(ob)
        if reason:
            raise Refusal("{name}: {reason}", name=ob.name, reason=reason)
        _select(context, ob)
        editing.enter(context, ob)
        return
    if ob.library or ob.data.library:
        raise Refusal("{name} is linked from another file: make it local first", name=ob.name)
    _select(context, ob)
    bpy.ops.object.mode_set(mode='EDIT')


def _select(context, *obs):
    for other in context.selected_objects:
        other.select_set(False)
    for ob in obs:
        ob.select_set(True)
    context.view_layer.objects.active = obs[0]


class SPLINEWRIGHT_OT_leave_result(bpy.types.Operator):
    bl_idname = "splinewright.leave_result"
    bl_label = "Leave Generated Mesh"
    bl_description = "Leave Edit Mode of the mesh or curve that Splinewright wrote, which is not the net"
    bl_options = {'REGISTER', 'UNDO'}

    how: EnumProperty(name="How", options={'SKIP_SAVE'}, items=(
        ('NET', "To the Net", "Edit the net, or what the shape follows; changes by hand must be none"),
        ('RESTORE', "Discard Manual Changes", "Make the mesh or curve again from the definition"),
        ('DETACH', "Convert to Plain Mesh/Curve", "Keep the changes and drop the definition")))

    @classmethod
    def poll(cls, context):
        if not editing.is_in_result(context):
            cls.poll_message_set(say("No mesh or curve of a shape is being edited"))
            return False
        return True

    def execute(self, context):
        ob = context.object
        bpy.ops.object.mode_set(mode='OBJECT')
        try:
            if self.how == 'DETACH':
                shape.detach(ob.data)
            elif self.how == 'RESTORE':
                shape.restore(ob.data)
            elif _shape_without_net(ob):
                _edit_source(context)
            else:
                editing.enter(context, ob)
        except FAILURES as error:
            return reports.finished(self, reports.Report(warnings=(reports.named(ob.name, str(error)),)))
        return {'FINISHED'}


CLASSES = (SPLINEWRIGHT_OT_edit_source, SPLINEWRIGHT_OT_leave_result)
