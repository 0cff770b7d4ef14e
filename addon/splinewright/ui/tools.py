"""Operators, group by group, in a menu and in a panel of the sidebar.

Groups are pairs of a label and names of operators.
"""


def draw_menu(layout, groups):
    layout.operator_context = 'INVOKE_REGION_WIN'
    for i, (_, names) in enumerate(groups):
        if i:
            layout.separator()
        for name in names:
            layout.operator(f"splinewright.{name}")


def draw_panel(layout, groups):
    for label, names in groups:
        row = layout.split(factor=0.3)
        row.label(text=label)
        column = row.column(align=True)
        for name in names:
            column.operator(f"splinewright.{name}")
