"""Operators, group by group, in a menu and in a panel of the sidebar.

Groups are pairs of a label and names of operators.
"""

import bpy

from ..bridge import recipes, shape, store, surveys
from . import hand, texts

#: What buttons leave out of an operator's label, which Undo History shows, too.
_LEFT_OUT = ("Add ", "Bring To ", "Convert ", "Take ")


#: Made from a shape without changing it.
_LEAVES_IT = {'extract_isocurve', 'extract_boundary', 'add_offset'}
#: With two shapes selected they take a piece of each.
_JOINS = {'join_ends', 'join_patches'}


def draw_menu(layout, groups, obs):
    """Operators on shapes; what none of the objects can have done is grey."""
    layout.operator_context = 'INVOKE_REGION_WIN'
    refused = [_refused(ob, groups, len(obs)) for ob in obs if shape.has_shape(ob)]
    for i, names in enumerate(filter(None, (names for _, names in groups))):
        if i:
            layout.separator()
        for name in names:
            row = layout.row()
            row.enabled = not all(name in of_one for of_one in refused)
            row.operator(f"splinewright.{name}", text=text_of(name))


def why_not(data):
    """Why nothing can be done to a shape, or ""."""
    if recipes.follows(data):
        return "It follows another object: Make Editable ends that"
    if recipes.has(data):
        return "It is made by its numbers: Make Editable ends that"
    if shape.seems_touched(data):
        return "It was changed by hand: Restore or Detach comes first"
    return ""


#: Operators on whole shapes, and when one refuses them.
_REFUSING = {
    'make_editable': lambda data: not recipes.has(data), 'adopt_transform': lambda data: not shape.seems_touched(data),
    'apply_transform': why_not, 'set_knots': why_not,
    **dict.fromkeys(('separate_pieces', 'delete_pieces', 'explode'), lambda data: why_not(data) or hand.count_of(data) < 2),
    **dict.fromkeys(('edit_net', 'to_native', 'bake_animation'), shape.seems_touched)}


def is_refused(name, obs):
    """Whether an operator on whole shapes would be refused for every shape among objects."""
    shapes = list(filter(shape.has_shape, obs))
    return name in _REFUSING and bool(shapes) and all(_REFUSING[name](ob.data) for ob in shapes)


def refused_by_all(names, obs):
    """Those of the verbs that none of the shapes can have done. What asks its poll() is not among them."""
    verbs = [name for name in names if works_on_nets(name)]
    refused = [_refused(ob, (("", verbs),), len(obs)) for ob in obs]
    return {name for name in names if refused and all(name in of_one for of_one in refused)}


def _refused(ob, groups, count):
    """Names of operators that would be refused for an object, of so many that are selected."""
    if why_not(ob.data):
        return {name for _, names in groups for name in names} - _LEAVES_IT
    try:
        return surveys.refused(ob.data) - (_JOINS if count > 1 else set())
    except store.UnreadableDefinition:
        return set()


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


def draw_verbs(layout, groups, context, fits, by_mouse):
    """draw_panel() with the verbs of shapes that fit, below names of operators on what is at the mouse; what none of the
    selected ones can have done is grey."""
    active = hand.shape_of(context.object)
    draw_hand(layout, active.data)
    reason = why_not(active.data)
    if reason:
        texts.draw_note(layout, reason)
    obs = list(filter(fits, hand.shapes(context))) or [active]
    column = layout.column(align=True)
    for name in by_mouse:
        column.operator(f"splinewright.{name}", text=text_of(name))
    draw_panel(layout, groups, [_refused(ob, groups, len(obs)) for ob in obs])


def draw_panel(layout, groups, refused=(set(),)):
    """refused: names of operators that are, of each object."""
    for label, names in groups:
        row = layout.split(factor=0.3)
        row.label(text=label)
        column = row.column(align=True)
        for name in names:
            button = column.row(align=True)
            button.enabled = not all(name in of_one for of_one in refused)
            button.operator(f"splinewright.{name}", text=_SHORTER.get(name) or text_of(name))


#: What buttons beside the word of their group say, where their text would be cut in a sidebar as wide as at first.
_SHORTER = {'fillet_curves': "Fillet Two", 'chamfer_curves': "Chamfer Two", 'split_where_met': "Split Where Met",
            'patch_to_bezier': "To Bezier", 'project_curve': "Perspective"}


def works_on_nets(name):
    """Whether an operator of curves or patches also works while their nets are edited."""
    return getattr(getattr(bpy.types, f"SPLINEWRIGHT_OT_{name}"), 'works_on_nets', False)


def text_of(name):
    """What a button of an operator says."""
    label = getattr(bpy.types, f"SPLINEWRIGHT_OT_{name}").bl_label
    for words in _LEFT_OUT:
        label = label.removeprefix(words)
    return label
