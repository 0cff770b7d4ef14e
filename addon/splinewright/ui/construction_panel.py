"""What a shape is made from, and by which numbers, in the sidebar."""

import bpy

from ..bridge.cage import net_object
from ..bridge.data import store
from ..bridge.follow import follow, recipe_results
from ..bridge.recipes import late, placing, recipes
from ..bridge.shape import shape
from ..core.base.words import phrase, say
from . import active_shape, fields, recipe_props, texts
from .sub_panel import SidePanel


#: In pixels of an interface that is not scaled, an icon and what is between it and words.
_EYE = 28


class SPLINEWRIGHT_PT_construction(SidePanel, bpy.types.Panel):
    bl_idname = "SPLINEWRIGHT_PT_construction"
    bl_label = "Construction"
    bl_order = 2

    @classmethod
    def poll(cls, context):
        ob = active_shape.shape_of(context.object)
        return ob is not None and (recipes.has(ob.data) if net_object.is_net(context.object) else is_shown(ob))

    def draw(self, context):
        ob = active_shape.shape_of(context.object)
        if net_object.is_net(context.object):
            _draw_numbers(self.layout, ob.data, is_net_out=True)
        else:
            draw(self.layout, ob)


def is_shown(ob):
    """Whether the construction of a shape can be changed."""
    if not recipes.has(ob.data) or shape.file_of(ob) or ob.mode == 'EDIT':
        return False
    return recipes.follows(ob.data) or not shape.seems_touched(ob.data)


def draw(layout, ob):
    """For an object with a shape that is_shown()."""
    if recipes.follows(ob.data):
        _draw_following(layout, ob)
    else:
        _draw_numbers(layout, ob.data)
        layout.operator("splinewright.make_editable")


def _draw_numbers(layout, data, is_net_out=False):
    try:
        recipe_props.draw(layout, data, is_net_out)
    except store.UnreadableDefinition as error:
        texts.draw_problem(layout, str(error))


def _names(sources, frames):
    """What a shape follows, in words; of many objects how many."""
    names = [source.name for source in sources if source]
    count = len(frames) if not sources else len(names) if len(sources) > 2 else 0
    return phrase("{count} objects", count=count) if count else " and ".join(names)


def _draw_moving(layout, ob):
    is_free = placing.moves_freely(ob.data)
    column = layout.column(align=True)
    for how, text, is_so in (('FREELY', "Moves Freely", is_free), ('WITH_INPUTS', "Stays on Inputs", not is_free)):
        column.operator("splinewright.set_moving", text=say(text), depress=is_so).how = how
    if placing.is_away(ob.data, ob):
        texts.draw_note(layout, "Moved away from its inputs")


def _draw_update(layout, data):
    """When the shape is made again, and whether it waits for that."""
    is_manual = data.splinewright.update_mode == 'MANUAL'
    is_stopped = late.is_stopped(data)
    column = layout.column(align=True)
    fields.choice(column, data.splinewright, "update_mode")
    if is_manual or is_stopped:
        column.operator("splinewright.update_now", icon='FILE_REFRESH')
    if late.is_late(data) and not is_stopped:
        when = "it waits for Update Now" if is_manual else "it is updated when the mouse rests"
        texts.draw_note(layout, phrase("Its inputs changed: {when}", when=when))


def _draw_following(layout, ob):
    data = ob.data
    try:
        sources, frames = recipes.read_inputs(data), recipes.frames(data)
        recipe_props.draw(layout, data)
    except store.UnreadableDefinition as error:
        texts.draw_problem(layout, str(error))
        layout.operator("splinewright.make_editable")
        return
    row = layout.row()
    texts.draw_note(row, phrase("Follows {names}", names=_names(sources, frames) or "nothing any more"), icon='LINKED', beside=_EYE)
    are_hidden = all(source is None or source.hide_get() for source in sources)
    if sources:
        row.operator("splinewright.show_inputs", text="", icon='HIDE_ON' if are_hidden else 'HIDE_OFF').how = (
            'SHOW' if are_hidden else 'HIDE')
    problem = follow.problem(data)
    if problem:
        texts.draw_problem(layout, problem)
    else:
        for text in recipe_results.not_followed_by(data, sources):
            texts.draw_note(layout, phrase("Not followed: {text}", text=text))
    _draw_update(layout, data)
    _draw_moving(layout, ob)
    column = layout.column(align=True)
    column.operator("splinewright.make_editable")
    column.operator("splinewright.bake_animation")


CLASSES = (SPLINEWRIGHT_PT_construction,)
