"""The sidebar panel, and the same in the object data properties."""

import bpy

from ..bridge import baking, derived, follow, late, placing, recipes, shape, store, surveys
from ..bridge.net import net_object
from . import manual, net_panel, recipe_props, settings_panel, texts
from .operators import edit_linked


class _ShapePanel:
    bl_label = "NURBS Shape"

    @staticmethod
    def in_hand(context):
        """(a data-block or None, the object through which it is seen or None)."""
        ob = context.object
        return (ob.data if ob else None), ob

    @classmethod
    def poll(cls, context):
        data, ob = cls.in_hand(context)
        return net_object.is_net(ob) or shape.is_shape(data) or baking.is_baked(data)

    def draw_header_preset(self, context):
        data, ob = self.in_hand(context)
        theme = "curves.html" if isinstance(data, bpy.types.Curve) else "surfaces.html"
        manual.draw_button(self.layout, "nets.html" if net_object.is_net(ob) else theme)

    def draw(self, context):
        data, ob = self.in_hand(context)
        if net_object.is_net(ob):
            net_panel.draw(self.layout, ob)
            return
        if baking.is_baked(data):
            self.layout.label(text=f"Baked: frames {baking.frames(data)}", icon='RENDER_ANIMATION')
            if ob is not None:
                self.layout.operator("splinewright.unbake")
            return
        try:
            definition = store.read(data)
        except store.UnreadableDefinition as error:
            texts.draw_problem(self.layout, str(error))
            return
        is_active = ob is not None and ob == context.active_object
        if is_active:
            _draw_state(self.layout, ob)
        else:
            _draw_pinned(self.layout, data)
        _draw_definition(self.layout, data)
        settings_panel.draw(self.layout, data, definition, has_buttons=is_active)


def _draw_pinned(layout, data):
    """What can be said and changed of a shape that is not the active one: buttons would take another."""
    texts.draw_note(layout, "Pinned: for its buttons make its object active and unpin")
    if shape.seems_touched(data):
        texts.draw_problem(layout, "Changed by hand since Splinewright wrote it")
        return
    try:
        if recipes.has(data):
            recipe_props.draw(layout.box(), data, is_net_out=net_object.editor(data) is not None)
    except store.UnreadableDefinition as error:
        texts.draw_problem(layout, str(error))


def _draw_state(layout, ob):
    """The way into the net, or why there is none."""
    data = ob.data
    if shape.file_of(ob):
        texts.draw_note(layout, edit_linked.told(ob), icon='LIBRARY_DATA_DIRECT')
        edit_linked.draw_button(layout.row())
        return
    if ob.mode == 'EDIT':
        texts.draw_problem(layout, "This is the result, not the net: what is changed here is changed by hand")
        column = layout.column(align=True)
        for how, text in (('NET', "Back to the Net"), ('RESTORE', "Restore"), ('DETACH', "Detach")):
            column.operator("splinewright.leave_result", text=text).how = how
    elif recipes.follows(data):
        _draw_following(layout, ob)
    elif shape.seems_touched(data):
        texts.draw_problem(layout, "Changed by hand since Splinewright wrote it")
        column = layout.column(align=True)
        column.operator("splinewright.restore")
        column.operator("splinewright.adopt_transform")
        column.operator("splinewright.detach")
    else:
        layout.operator("splinewright.edit_net", icon='EDITMODE_HLT')
        if recipes.has(data):
            _draw_recipe(layout, data)


def _draw_recipe(layout, data):
    try:
        recipe_props.draw(layout.box() if recipes.of(data).parameters else layout, data)
    except store.UnreadableDefinition as error:
        texts.draw_problem(layout, str(error))
    layout.operator("splinewright.make_editable")


def _names(sources, frames):
    """What a shape follows, in words; of many objects how many."""
    names = [source.name for source in sources if source]
    count = len(frames) if not sources else len(names) if len(sources) > 2 else 0
    return f"{count} objects" if count else " and ".join(names)


def _draw_moving(layout, ob):
    is_free = placing.moves_freely(ob.data)
    row = layout.row(align=True)
    for how, text, is_so in (('FREELY', "Moves Freely", is_free), ('WITH_INPUTS', "Stays on Inputs", not is_free)):
        row.operator("splinewright.set_moving", text=text, depress=is_so).how = how
    if placing.is_away(ob.data, ob):
        texts.draw_note(layout, "Moved away from its inputs")


def _draw_update(layout, data):
    """When the shape is made anew, and whether it waits for that."""
    is_manual = data.splinewright.update_mode == 'MANUAL'
    row = layout.row(align=True)
    row.prop(data.splinewright, "update_mode")
    if is_manual:
        row.operator("splinewright.update_now", icon='FILE_REFRESH')
    if late.is_late(data):
        when = "it waits for Update Now" if is_manual else "it is made anew when the mouse rests"
        texts.draw_note(layout, f"Its inputs changed: {when}")


def _draw_following(layout, ob):
    data = ob.data
    try:
        sources, frames = recipes.read_inputs(data), recipes.frames(data)
        recipe_props.draw(layout.box() if recipes.of(data).parameters else layout, data)
    except store.UnreadableDefinition as error:
        texts.draw_problem(layout, str(error))
        layout.operator("splinewright.make_editable")
        return
    row = layout.row()
    texts.draw_note(row, f"Follows {_names(sources, frames) or 'nothing any more'}", icon='LINKED')
    are_hidden = all(source is None or source.hide_get() for source in sources)
    if sources:
        row.operator("splinewright.show_inputs", text="", icon='HIDE_ON' if are_hidden else 'HIDE_OFF').how = (
            'SHOW' if are_hidden else 'HIDE')
    problem = follow.problem(data)
    if problem:
        texts.draw_problem(layout, problem)
    else:
        for text in derived.not_followed_by(data, sources):
            texts.draw_note(layout, f"Not followed: {text}")
    _draw_update(layout, data)
    _draw_moving(layout, ob)
    column = layout.column(align=True)
    column.operator("splinewright.edit_source", icon='EDITMODE_HLT')
    column.operator("splinewright.make_editable")
    column.operator("splinewright.bake_animation")


def _draw_definition(layout, data):
    column = layout.column(align=True)
    for label, text in surveys.described(data):
        row = column.split(factor=0.3)
        row.label(text=label)
        lines = row.column(align=True)
        for line in texts.lines(text):
            lines.label(text=line)
    layout.separator()


class SPLINEWRIGHT_PT_shape(_ShapePanel, bpy.types.Panel):
    bl_idname = "SPLINEWRIGHT_PT_shape"
    bl_space_type = 'VIEW_3D'
    bl_region_type = 'UI'
    bl_category = "NURBS"
    bl_order = 1


class SPLINEWRIGHT_PT_data(_ShapePanel, bpy.types.Panel):
    bl_idname = "SPLINEWRIGHT_PT_data"
    bl_space_type = 'PROPERTIES'
    bl_region_type = 'WINDOW'
    bl_context = "data"
    bl_options = {'DEFAULT_CLOSED'}

    @staticmethod
    def in_hand(context):
        """What is pinned, or else the active object's; pinned data is seen without an object."""
        ob = context.object
        data = getattr(context, 'mesh', None) or getattr(context, 'curve', None) or (ob.data if ob else None)
        return data, ob if ob is not None and ob.data == data else None


CLASSES = (SPLINEWRIGHT_PT_shape, SPLINEWRIGHT_PT_data)
