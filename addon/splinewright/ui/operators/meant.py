"""Tools that are clicked say which shapes they work on, and why one at the mouse is none of them."""

from ...bridge.data import store
from ...bridge.recipes import recipes
from ...bridge.shape import shape
from ...core.base.failures import FAILURES
from ...core.base.words import phrase
from .. import active_shape, picking
from .reports import listed


def works_on(obs):
    """The shapes that are worked on, for the status bar."""
    return phrase("Works on {names}   |   ", names=listed([ob.name for ob in obs])) if obs else ""


def why_none(context, event, meant):
    """Why a click there does nothing, where a shape is at the mouse that is not meant; else ""."""
    known = {ob.name for ob in meant}
    others = [ob for ob in context.visible_objects if ob.name not in known and shape.has_shape(ob)]
    found = [one for ob in others for one in [_pointed_at(context, event, ob)] if one]
    return _why_not(context, found[0], meant) if found else ""


def _pointed_at(context, event, ob):
    """The object where it is at the mouse, or None."""
    try:
        found = picking.pointed_at(event.mouse_x, event.mouse_y, [ob], context.evaluated_depsgraph_get())
    except FAILURES:
        return None                     # such a shape shows nothing to point at
    return ob if found else None


def _why_not(context, ob, meant):
    alone = phrase("only {names} are worked on" if len(meant) > 1 else "only {names} is worked on",
                   names=listed([one.name for one in meant])) if meant else ""
    if ob not in context.selected_objects and ob not in context.objects_in_mode:
        return phrase("{name} is not selected", name=ob.name) + (f": {alone}" if alone else "")
    return f"{ob.name} {_bound(ob)}" + (f"; {alone}" if alone else "")


def _bound(ob):
    """Why a selected shape is not meant."""
    if ob.data.library:
        return "is linked from another file: make it local first"
    try:
        if recipes.has(ob.data):
            return "is made by a recipe: use Apply Construction first"
    except store.UnreadableDefinition:
        return "cannot be read"
    return "is not meant now" if active_shape.is_free(ob) else "cannot be changed"
