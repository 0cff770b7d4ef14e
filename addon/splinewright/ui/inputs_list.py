"""The list of what a surface is made from, in its panel: order, directions, more and fewer."""


def draw(layout, stored):
    """stored: a bridge.recipes.Stored of a recipe that takes any number of objects."""
    column = layout.column(align=True)
    for i, (source, is_turned) in enumerate(zip(stored.sources, stored.turned)):
        row = column.row(align=True)
        name = source.name if source else "Deleted"
        row.label(text=f"{i + 1}  {name}", icon='NONE' if source else 'ERROR')
        if stored.recipe.has_turns:
            row.operator("splinewright.turn_input", text="", icon='UV_SYNC_SELECT', depress=is_turned).index = i
        for way, icon in (('UP', 'TRIA_UP'), ('DOWN', 'TRIA_DOWN')):
            settings = row.operator("splinewright.move_input", text="", icon=icon)
            settings.index, settings.way = i, way
        row.operator("splinewright.remove_input", text="", icon='X').index = i
    column.operator("splinewright.add_inputs", icon='ADD')
    if stored.recipe.arranged:
        row = column.row(align=True)
        row.operator("splinewright.sort_inputs", icon='SORTSIZE')
        row.operator("splinewright.reverse_inputs", icon='UV_SYNC_SELECT')
