"""How finely a shape is shown, in the sidebar and in the object data properties."""

import contextlib

import bpy

from ..bridge.data import problems, store, tessellate
from ..bridge.net import keyed
from ..bridge.recipes import recipes
from ..core.base.words import phrase, say
from . import active_shape, fields, texts
from .sub_panel import SidePanel


class SPLINEWRIGHT_PT_display(SidePanel, bpy.types.Panel):
    bl_idname = "SPLINEWRIGHT_PT_display"
    bl_label = "Display"
    bl_order = 3

    @classmethod
    def poll(cls, context):
        return active_shape.shape_of(context.object) is not None

    def draw(self, context):
        data = active_shape.shape_of(context.object).data
        with contextlib.suppress(store.UnreadableDefinition):       # the panel of the shape says it
            draw(self.layout, data, store.read(data), has_buttons=active_shape.shape_of(context.object) == context.object)


def draw(layout, data, definition, has_buttons=True):
    """For the data-block of a shape and its definition. has_buttons: those of operators, which take the active object."""
    settings = data.splinewright
    column = layout.column(align=True)
    if definition.has_curves:
        fields.choice(column, settings, "mode", "Pieces")
        if settings.mode == tessellate.COUNT:
            fields.number(column, settings, "resolution_u", "Resolution")
        _draw_limits(column, settings)
        if definition.runs_to_infinity or _is_endless(data):
            fields.number(column, settings, "reach")
    else:
        _draw_fineness(column, settings, has_buttons)
        fields.number(layout, settings, "sharp_angle")
        column = layout.column(align=True)
        column.label(text=say(phrase("{count:,} vertices", one="{count:,} vertex", count=len(data.vertices))))
        column.label(text=say(_faces(data)))
        if has_buttons and len(definition.pieces) > 1 and len(data.materials) > 1:
            layout.operator("splinewright.set_patch_material", icon='MATERIAL')
    for about in (problems.SETTING, problems.KEYED):
        problem = problems.of(data, about)
        if problem:
            texts.draw_problem(layout, problem)
    if data.library and keyed.has_keys(data):
        texts.draw_note(layout, "Its keys do nothing here: it is linked, and shown as its file was saved. Bake Animation there "
                        "makes it move here")


def _is_endless(data):
    """Whether the recipe of a shape, if it can be read, makes curves that may run far."""
    with contextlib.suppress(store.UnreadableDefinition):
        return recipes.around(data) is not None
    return False


def _draw_fineness(column, settings, has_buttons):
    fields.choice(column, settings, "mode")
    if settings.mode == tessellate.COUNT:
        fields.number(column, settings, "resolution_u")
        fields.number(column, settings, "resolution_v")
    _draw_limits(column, settings, has_buttons)


def _draw_limits(column, settings, has_buttons=False):
    if settings.mode in (tessellate.TOLERANCE, tessellate.BOTH):
        row = column.row(align=True)
        row.prop(settings, "tolerance")
        if has_buttons:
            button = row.row(align=True)
            button.enabled = bpy.context.scene.camera is not None
            button.operator("splinewright.tolerance_from_render", text="", icon='RESTRICT_RENDER_OFF')
    if settings.mode in (tessellate.ANGLE, tessellate.BOTH):
        fields.number(column, settings, "angle")


def _faces(data):
    """Of a Mesh, and how many there were before."""
    before, now = data.splinewright.faces_before, len(data.polygons)
    return phrase("{before:,} → {count:,} faces", one="{before:,} → {count:,} face",
                  before=before, count=now) if before not in (0, now) else phrase("{count:,} faces", one="{count:,} face", count=now)


CLASSES = (SPLINEWRIGHT_PT_display,)
