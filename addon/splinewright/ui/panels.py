"""The sidebar panel, and the same in the object data properties."""

import contextlib

import bpy

from ..bridge import baking, derived, fineness, follow, problems, recipes, shape, store
from ..bridge.net import net_object
from ..core import describe
from . import net_panel, recipe_props, texts


class _ShapePanel:
    bl_label = "Splinewright"

    @classmethod
    def poll(cls, context):
        ob = context.object
        return shape.has_shape(ob) or net_object.is_net(ob) or ob is not None and baking.is_baked(ob.data)

    def draw(self, context):
        ob = context.object
        if net_object.is_net(ob):
            net_panel.draw(self.layout, ob)
            return
        if baking.is_baked(ob.data):
            self.layout.label(text=f"Baked: frames {baking.frames(ob.data)}", icon='RENDER_ANIMATION')
            self.layout.operator("splinewright.unbake")
            return
        try:
            definition = store.read(ob.data)
        except store.UnreadableDefinition as error:
            texts.draw_problem(self.layout, str(error))
            return
        _draw_state(self.layout, ob)
        _draw_definition(self.layout, definition)
        _draw_settings(self.layout, ob.data, definition)


def _draw_state(layout, ob):
    """The way into the net, or why there is none."""
    data = ob.data
    if ob.mode == 'EDIT':
        texts.draw_problem(layout, "This is Edit Mode of the result: leave it and press Tab to edit the net")
    elif recipes.follows(data):
        _draw_following(layout, data)
    elif shape.seems_touched(data):
        texts.draw_problem(layout, "Changed by hand since Splinewright wrote it")
        column = layout.column(align=True)
        column.operator("splinewright.restore", text="Restore: throw the changes away")
        column.operator("splinewright.adopt_transform", text="Adopt: it was moved as a whole")
        column.operator("splinewright.detach", text="Detach: keep them, end the shape")
    else:
        layout.operator("splinewright.edit_net", icon='EDITMODE_HLT')
        if recipes.has(data):
            _draw_recipe(layout, data)


def _draw_recipe(layout, data):
    try:
        recipe_props.draw(layout.box(), data)
    except store.UnreadableDefinition as error:
        texts.draw_problem(layout, str(error))
    layout.operator("splinewright.make_editable")


def _draw_following(layout, data):
    try:
        sources = recipes.read_inputs(data)
        recipe_props.draw(layout.box() if recipes.of(data).parameters else layout, data)
    except store.UnreadableDefinition as error:
        texts.draw_problem(layout, str(error))
        layout.operator("splinewright.make_editable")
        return
    names = " and ".join(source.name for source in sources if source)
    layout.label(text=f"Follows {names or 'nothing any more'}", icon='LINKED')
    problem = follow.problem(data)
    if problem:
        texts.draw_problem(layout, problem)
    else:
        for text in (text for source in sources for text in derived.not_followed(source)):
            texts.draw_note(layout, f"Not followed: {text}")
    layout.operator("splinewright.make_editable")
    layout.operator("splinewright.bake_animation")


def _draw_definition(layout, definition):
    column = layout.column(align=True)
    for label, text in describe.lines(definition):
        row = column.split(factor=0.3)
        row.label(text=label)
        row.label(text=text)
    layout.separator()


def _draw_settings(layout, data, definition):
    settings = data.splinewright
    column = layout.column(align=True)
    if definition.has_curves:
        column.prop(settings, "resolution_u", text="Resolution")
        if definition.runs_to_infinity or _is_endless(data):
            column.prop(settings, "reach")
    else:
        _draw_fineness(column, settings)
        layout.prop(settings, "sharp_angle")
        column = layout.column(align=True)
        column.label(text=f"{len(data.vertices):,} vertices")
        column.label(text=_faces(data))
        if len(definition.pieces) > 1 and len(data.materials) > 1:
            layout.operator("splinewright.set_patch_material", icon='MATERIAL')
    for about in (problems.SETTING, problems.KEYED):
        if problem := problems.of(data, about):
            texts.draw_problem(layout, problem)


def _is_endless(data):
    """Whether the recipe of a shape, if it can be read, makes curves that may run far."""
    with contextlib.suppress(store.UnreadableDefinition):
        return recipes.around(data) is not None
    return False


def _draw_fineness(column, settings):
    column.prop(settings, "mode")
    if settings.mode == fineness.COUNT:
        column.prop(settings, "resolution_u")
        column.prop(settings, "resolution_v", text="V")
    if settings.mode in (fineness.TOLERANCE, fineness.BOTH):
        row = column.row(align=True)
        row.prop(settings, "tolerance")
        row.operator("splinewright.tolerance_from_render", text="", icon='RESTRICT_RENDER_OFF')
    if settings.mode in (fineness.ANGLE, fineness.BOTH):
        column.prop(settings, "angle")


def _faces(data):
    """Of a Mesh, and how many there were before."""
    before, now = data.splinewright.faces_before, len(data.polygons)
    return f"{before:,} → {now:,} faces" if before not in (0, now) else f"{now:,} faces"


class SPLINEWRIGHT_PT_shape(_ShapePanel, bpy.types.Panel):
    bl_idname = "SPLINEWRIGHT_PT_shape"
    bl_space_type = 'VIEW_3D'
    bl_region_type = 'UI'
    bl_category = "Splinewright"


class SPLINEWRIGHT_PT_data(_ShapePanel, bpy.types.Panel):
    bl_idname = "SPLINEWRIGHT_PT_data"
    bl_space_type = 'PROPERTIES'
    bl_region_type = 'WINDOW'
    bl_context = "data"
    bl_options = {'DEFAULT_CLOSED'}


CLASSES = (SPLINEWRIGHT_PT_shape, SPLINEWRIGHT_PT_data)
