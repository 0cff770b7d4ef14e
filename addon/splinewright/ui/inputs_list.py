"""The list of what a surface is made from, in its panel: order, directions, more and fewer."""

import bpy

from ..bridge.recipes import parameters, recipes
from ..core.base.words import phrase, say
from ..core.recipes.table import RECIPES

#: Rows that are shown at least, and at most.
_FEWEST, _MOST = 3, 10


class SPLINEWRIGHT_UL_inputs(bpy.types.UIList):
    def draw_item(self, _context, layout, group, _item, _icon, _active, _name, index):
        source, is_turned = recipes.input_at(group.id_data, index)
        row = layout.row(align=True)
        if source is None:
            row.label(text=say(phrase("{index}  Deleted", index=index + 1)), icon='ERROR')
        else:
            row.label(text=str(index + 1), icon='OUTLINER_OB_CURVE' if source.type == 'CURVE' else 'OUTLINER_OB_SURFACE')
            row.prop(source, "name", text="", emboss=False)
        if RECIPES[recipes.kind(group.id_data)].has_turns:
            row.operator("splinewright.turn_input", text="", icon='UV_SYNC_SELECT', depress=is_turned, emboss=is_turned).index = index


def draw(layout, data, recipe):
    """For a data-block with a recipe that takes any number of objects."""
    group = parameters.of(data)
    row = layout.row()
    row.template_list("SPLINEWRIGHT_UL_inputs", "", group, "inputs", group, "active_input",
                      rows=min(max(len(group.inputs), _FEWEST), _MOST), sort_lock=True)
    column = row.column(align=True)
    column.operator("splinewright.add_inputs", text="", icon='ADD')
    column.operator("splinewright.remove_input", text="", icon='REMOVE').index = group.active_input
    column.separator()
    for way, icon in (('UP', 'TRIA_UP'), ('DOWN', 'TRIA_DOWN')):
        settings = column.operator("splinewright.move_input", text="", icon=icon)
        settings.index, settings.way = group.active_input, way
    if recipe.arranged:
        column = layout.column(align=True)
        column.operator("splinewright.sort_inputs", icon='SORTSIZE')
        column.operator("splinewright.reverse_inputs", icon='UV_SYNC_SELECT')


CLASSES = (SPLINEWRIGHT_UL_inputs,)
