"""For operators of Blender that work on the selection: one object alone, and everything as it was afterwards."""

from contextlib import contextmanager

from ...core.base.failures import Refusal


@contextmanager
def alone(context, ob):
    """`ob` is the only selected object, active, and can be seen, also if it is in no scene or is hidden.

    Raises Refusal in Edit Mode and the like.
    """
    if context.mode != 'OBJECT':
        raise Refusal("leave the present mode first")
    layer, root = context.view_layer, context.scene.collection
    active, selected = layer.objects.active, [other for other in layer.objects if other and other.select_get()]
    is_linked = root.objects.get(ob.name) == ob
    if not is_linked:
        root.objects.link(ob)
        layer.update()
    hidden = ob.hide_get(), ob.hide_viewport, ob.hide_select
    try:
        ob.hide_viewport = ob.hide_select = False
        ob.hide_set(False)
        _select(layer, [ob], ob)
        with context.temp_override(area=None, region=None):     # a view may show a few objects only
            yield
    finally:
        if _is_alive(ob):
            ob.hide_set(hidden[0])
            ob.hide_viewport, ob.hide_select = hidden[1:]
            if not is_linked:
                root.objects.unlink(ob)
        layer.update()
        _select(layer, [other for other in selected if _is_alive(other)], active)


def _select(layer, chosen, active):
    """Only the chosen objects."""
    for other in layer.objects:
        if other:
            other.select_set(False)
    for other in chosen:
        if layer.objects.get(other.name) == other:
            other.select_set(True)
    layer.objects.active = active


def _is_alive(ob):
    try:
        return bool(ob.name)
    except ReferenceError:
        return False


@contextmanager
def linked(context, ob):
    """An object of the add-on in the scene for a moment, selected and active beside the selection."""
    context.scene.collection.objects.link(ob)
    context.view_layer.update()
    try:
        ob.select_set(True)
        context.view_layer.objects.active = ob
        yield
    finally:
        context.scene.collection.objects.unlink(ob)
