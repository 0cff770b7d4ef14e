"""Operators, group by group, in a menu and in a panel of the sidebar.

Groups are pairs of a label and names of operators.
"""

import bpy

from . import hand

#: What buttons leave out of an operator's label, which Undo History shows, too.
_LEFT_OUT = ("Add ", "Bring To ", "Convert ", "Take ")


def draw_menu(layout, groups):
    layout.operator_context = 'INVOKE_REGION_WIN'
    for i, names in enumerate(filter(None, (names for _, names in groups))):
        if i:
            layout.separator()
        for name in names:
            layout.operator(f"splinewright.{name}", text=text_of(name))


def draw_hand(layout, data):
    """The pieces in hand, where there are several."""
    if hand.count_of(data) < 2:
        return
    chosen = data.splinewright
    layout.prop(chosen, "show_numbers")
    column = layout.column(align=True)
    for name, is_other in (("piece", False), ("other_piece", True)):
        row = column.row(align=True)
        row.prop(chosen, name)
        row.operator("splinewright.pick_piece", text="", icon='EYEDROPPER').other = is_other


def draw_panel(layout, groups):
    for label, names in groups:
        row = layout.split(factor=0.3)
        row.label(text=label)
        column = row.column(align=True)
        for name in names:
            column.operator(f"splinewright.{name}", text=text_of(name))


def works_on_nets(name):
    """Whether an operator of curves or patches also works while their nets are edited."""
    return getattr(getattr(bpy.types, f"SPLINEWRIGHT_OT_{name}"), 'works_on_nets', False)


def text_of(name):
    """What a button of an operator says."""
    label = getattr(bpy.types, f"SPLINEWRIGHT_OT_{name}").bl_label
    for words in _LEFT_OUT:
        label = label.removeprefix(words)
    return label
