"""The selected objects, of the kinds that menus and panels concern."""

from ..bridge.edit import baking
from ..bridge.shape import shape

SHAPES = frozenset({'curve', 'patch'})
#: What shapes can be made from.
FOLLOWED = SHAPES | {'native'}
ALL = FOLLOWED | {'baked'}
#: What can be made exact.
INEXACT = frozenset({'native', 'text'})


def of(ob):
    """The kind of an object or None: a shape of curves, of patches, a baked one, Blender's own curve or surface, its text, or ""."""
    if ob is None:
        return ""
    if shape.has_shape(ob):
        return 'curve' if ob.type == 'CURVE' else 'patch'
    if baking.is_baked(ob.data):
        return 'baked'
    return {'CURVE': 'native', 'SURFACE': 'native', 'FONT': 'text'}.get(ob.type, "")


def selected(context):
    """The kinds of the selected objects."""
    return {of(ob) for ob in context.selected_objects} - {""}
