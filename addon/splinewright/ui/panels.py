"""What a shape is, in the sidebar; and in the object data properties how it is made and shown, too."""

import bpy

from ..bridge.analysis import surveys
from ..bridge.cage import net_object
from ..bridge.data import store
from ..bridge.edit import baking
from ..bridge.recipes import recipes
from ..bridge.shape import shape
from ..core.base.words import phrase, say
from . import construction_panel, manual, net_panel, recipe_props, settings_panel, texts
from .operators import edit_linked
from .sub_panel import SidePanel


class _ShapePanel:
    @staticmethod
    def active(context):
        """(a data-block or None, the object through which it is seen or None)."""
        ob = context.object
        return (ob.data if ob else None), ob

    @classmethod
    def poll(cls, context):
        data, ob = cls.active(context)
        return net_object.is_net(ob) or shape.is_shape(data) or baking.is_baked(data)

    def draw_header_preset(self, context):
        data, ob = self.active(context)
        theme = "curves.html" if isinstance(data, bpy.types.Curve) else "surfaces.html"
        manual.draw_button(self.layout, "nets.html" if net_object.is_net(ob) else theme)

    def draw(self, context):
        data, ob = self.active(context)
        if net_object.is_net(ob):
            net_panel.draw_state(self.layout, ob)
        elif baking.is_baked(data):
            self.layout.label(text=say(phrase("Baked: frames {frames}", frames=baking.frames(data))), icon='RENDER_ANIMATION')
            if ob is not None:
                self.layout.operator("splinewright.unbake")
        else:
            try:
                self.draw_shape(self.layout, context, data, ob, store.read(data))
            except store.UnreadableDefinition as error:
                texts.draw_problem(self.layout, str(error))


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
        texts.draw_problem(layout, "This is the generated mesh, not the net: changes here count as made by hand")
        column = layout.column(align=True)
        for how, text in (('NET', "Back to the Net"), ('RESTORE', "Discard Manual Changes"), ('DETACH', "Convert to Plain Mesh/Curve")):
            column.operator("splinewright.leave_result", text=say(text)).how = how
    elif recipes.follows(data):
        layout.operator("splinewright.edit_source", icon='EDITMODE_HLT')
    elif shape.seems_touched(data):
        texts.draw_problem(layout, "Changed by hand since Splinewright wrote it")
        column = layout.column(align=True)
        column.operator("splinewright.restore")
        column.operator("splinewright.adopt_transform")
        column.operator("splinewright.detach")
    else:
        layout.operator("splinewright.edit_net", icon='EDITMODE_HLT')


def _draw_definition(layout, data):
    texts.draw_pairs(layout, surveys.described(data))


class SPLINEWRIGHT_PT_shape(_ShapePanel, SidePanel, bpy.types.Panel):
    bl_idname = "SPLINEWRIGHT_PT_shape"
    bl_label = "Shape"
    bl_order = 1

    @staticmethod
    def draw_shape(layout, _context, data, ob, _definition):
        _draw_state(layout, ob)
        _draw_definition(layout, data)


class SPLINEWRIGHT_PT_data(_ShapePanel, bpy.types.Panel):
    bl_idname = "SPLINEWRIGHT_PT_data"
    bl_label = "NURBS Shape"
    bl_space_type = 'PROPERTIES'
    bl_region_type = 'WINDOW'
    bl_context = "data"
    bl_options = {'DEFAULT_CLOSED'}

    @staticmethod
    def active(context):
        """The pinned data, or else the active object's; pinned data is seen without an object."""
        ob = context.object
        data = getattr(context, 'mesh', None) or getattr(context, 'curve', None) or (ob.data if ob else None)
        return data, ob if ob is not None and ob.data == data else None

    @staticmethod
    def draw_shape(layout, context, data, ob, definition):
        is_active = ob is not None and ob == context.active_object
        if is_active:
            _draw_state(layout, ob)
            if construction_panel.is_shown(ob):
                construction_panel.draw(layout, ob)
        else:
            _draw_pinned(layout, data)
        _draw_definition(layout, data)
        layout.separator()
        settings_panel.draw(layout, data, definition, has_buttons=is_active)


CLASSES = (SPLINEWRIGHT_PT_shape, SPLINEWRIGHT_PT_data)
