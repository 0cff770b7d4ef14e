"""What of our operators is offered: which are gray as all selected shapes would refuse them, and what a button of each says."""

import bpy

from ..bridge.analysis import surveys
from ..bridge.data import store
from ..bridge.recipes import recipes
from ..bridge.shape import shape
from . import active_shape, object_kinds

#: With two shapes selected they take a piece of each.
_JOINS = {'join_ends', 'join_patches'}


def why_not(data):
    """Why nothing can be done to a shape, or ""."""
    if recipes.follows(data):
        return "It follows another object: Apply Construction ends that"
    if recipes.has(data):
        return "It is made by its numbers: Apply Construction ends that"
    if shape.seems_touched(data):
        return "It was changed by hand: first use Discard Manual Changes, or Convert to Plain Mesh/Curve"
    return ""


#: Operators on whole shapes, and when one refuses them.
_REFUSING = {
    'make_editable': lambda data: not recipes.has(data), 'edit_source': lambda data: not recipes.follows(data),
    'adopt_transform': lambda data: not shape.seems_touched(data),
    'apply_transform': why_not, 'set_knots': why_not,
    **dict.fromkeys(('separate_pieces', 'delete_pieces', 'explode'), lambda data: why_not(data) or active_shape.count_of(data) < 2),
    **dict.fromkeys(('edit_net', 'to_native', 'bake_animation'), shape.seems_touched)}


def is_gray(entry, obs):
    """Whether every shape among objects that an entry of ui.menu_table concerns would refuse it."""
    if not (entry.changes or entry.operator in _REFUSING):
        return False
    shapes = [ob for ob in obs if object_kinds.of(ob) in entry.concerns & object_kinds.SHAPES]
    return bool(shapes) and all(_refuses(ob.data, entry.operator, len(shapes)) for ob in shapes)


def _refuses(data, name, count):
    """Whether a shape, of all that are selected, refuses an operator."""
    if name in _REFUSING:
        return bool(_REFUSING[name](data))
    if why_not(data):
        return True
    try:
        return name in surveys.refused(data) and not (count > 1 and name in _JOINS)
    except store.UnreadableDefinition:
        return False


def works_on_nets(name):
    """Whether an operator works while nets are edited."""
    return getattr(_class_of(name), 'works_on_nets', False)


def text_of(name):
    """What a button of an operator says: in menus to add there is no "Add", which Undo History shows."""
    kind = _class_of(name)
    return getattr(kind, 'button', kind.bl_label)


def _class_of(name):
    return getattr(bpy.types, f"SPLINEWRIGHT_OT_{name}")
