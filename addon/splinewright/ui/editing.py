"""Putting nets out and away. Undo steps are the operators' affair, but for end()."""

from contextlib import suppress

import bpy

from ..bridge import problems, recipes, remaking, settings, shape, store
from ..bridge.file_state import block_of, key, state
from ..bridge.net import free_net, live, net_object, selection
from ..core.failures import FAILURES, Refusal, sentence

def why_not(ob):
    """Why an object's net cannot be edited, as a sentence, or ""."""
    if not shape.has_shape(ob):
        return "Select a Splinewright shape"
    if ob.library or ob.data.library or ob.data.override_library:
        return "The shape is linked from another file: make it local first"
    if recipes.follows(ob.data):
        return "The shape follows another object: edit that, or use Make Editable first"
    try:
        is_of_numbers = recipes.has(ob.data) and not recipes.has_points(ob.data)
    except store.UnreadableDefinition as error:
        return str(error)
    return "The shape is made by its numbers: change them in the panel, or use Make Editable first" if is_of_numbers else ""


def nets():
    """All net objects of the file that the last scan or an operator told of."""
    found = [block_of(name) for name in sorted(state.nets)]
    if not all(net_object.is_net(ob) for ob in found):
        find_nets()                     # one was renamed or removed
        found = [block_of(name) for name in sorted(state.nets)]
    return found


def find_nets():
    """Scan the file."""
    state.nets.clear()
    state.nets.update(key(ob) for ob in bpy.data.objects if net_object.is_net(ob))


def nets_in_edit_mode(context):
    if not context.mode.startswith('EDIT'):
        return []
    return [ob for ob in context.objects_in_mode if net_object.is_net(ob)]


def enter(context, active, progress=shape.no_progress):
    """Put the nets of the active shape, and of selected ones of its kind, into Edit Mode.

    Raises Refusal, and nothing has changed, if the net of the active shape cannot be made.
    """
    chosen = [active] + [ob for ob in context.selected_objects
                         if ob != active and ob.type == active.type and not why_not(ob) and not shape.is_touched(ob.data)]
    put_out, seen = [], set()
    try:
        for ob in chosen:
            if ob.data.name not in seen:
                seen.add(ob.data.name)
                put_out.append(_put_out(context, ob))
                progress(len(put_out))
    except Exception:
        for ob in put_out:
            net_object.remove(ob)
        raise
    net_object.remember(put_out[0], [ob.name for ob in context.selected_objects if ob not in chosen])
    for ob in context.selected_objects:
        ob.select_set(False)
    for ob in put_out:
        ob.select_set(True)
        state.nets.add(key(ob))
    context.view_layer.objects.active = put_out[0]
    with suppress(RuntimeError):        # where Blender refuses, the mode tells
        bpy.ops.object.mode_set(mode='EDIT')
    if put_out[0].mode != 'EDIT':
        for ob in put_out:
            put_away(context, ob)
        raise Refusal(f"{active.name} is not in the view layer at hand: its net cannot be edited from here")
    return put_out


def _put_out(context, ob):
    data = ob.data
    shape.require_writable(data)
    shape.require_untouched(data)
    definition = remaking.edited(data)
    numbers = net_object.net_of(definition)
    is_free = remaking.takes_any_count(data)
    is_closed = is_free and remaking.is_closed(data)
    held = net_object.make(ob, definition, numbers, context.scene)      # nothing raises from here on
    if is_free:
        free_net.set_free(held.data, is_closed)
    live.begin(held.data, numbers, settings.values(data))
    space = context.space_data
    if space is not None and space.type == 'VIEW_3D' and space.local_view:
        held.local_view_set(space, True)
    return held


def leave(context, progress=shape.no_progress):
    """Put the nets in Edit Mode away; the shapes are selected. Returns the last problem, or ""."""
    editing = nets_in_edit_mode(context)
    problem = ""
    for ob in editing:
        live.pull(ob)
        problem = problem or live.problem(ob)
    bpy.ops.object.mode_set(mode='OBJECT')
    for i, ob in enumerate(editing, 1):
        put_away(context, ob)
        progress(i)
    find_nets()
    for copy in nets():
        if copy.mode == 'OBJECT':
            put_away(context, copy)
    return problem


def put_away(context, ob):
    """Remove a net in Object Mode; its shape is exact, and selected and active where the net was."""
    owner = net_object.shape_of(ob)
    if not _is_copy(ob):
        net_object.end(ob)
    layer = context.view_layer
    others = net_object.remembered(ob)
    was_active, was_selected = layer.objects.active == ob, _is_in(layer, ob) and ob.select_get()
    state.nets.discard(key(ob))
    net_object.remove(ob)
    if owner is None:
        return
    _settle(owner)
    if _is_in(layer, owner) and (was_active or was_selected):
        for other in filter(None, map(layer.objects.get, others)):
            other.select_set(True)
        owner.select_set(True)
        if was_active:
            layer.objects.active = owner


def anew(context, nets):
    """Put the nets away and out again, from what the shapes are now; points stay selected.

    Returns warnings: why they did not come out again. The shapes are as they should be.
    """
    selections = {}
    for ob in nets:
        owner = net_object.shape_of(ob)
        if owner is not None:
            selections[owner.name] = selection.selected(ob, live.session(ob.data).net)
    active = net_object.shape_of(context.object)
    leave(context)
    if active is None or context.view_layer.objects.get(active.name) != active:
        return ()
    context.view_layer.objects.active = active
    try:
        out = enter(context, active)
    except FAILURES as error:
        return (f"the net did not come out again: {sentence(error)}",)
    for ob in out:
        numbers = live.session(ob.data).net
        selection.select(ob, numbers, selections.get(net_object.shape_of(ob).name, ()))
    return ()


def sweep():
    """Put away the nets that were left by another way than leave(), and copies of nets."""
    find_nets()
    for ob in nets():
        if ob.mode == 'EDIT':
            continue
        if ob.mode != 'OBJECT' and not _to_object_mode(ob):
            continue
        if ob.users_scene and not _is_copy(ob):
            live.pull(ob)
        put_away(bpy.context, ob)


def _to_object_mode(ob):
    """Leave Sculpt Mode and the like by a step of its own, or undo would look for the net there."""
    layer = bpy.context.view_layer
    if not _is_in(layer, ob):
        return False
    layer.objects.active = ob
    bpy.ops.object.mode_set('EXEC_DEFAULT', True, mode='OBJECT')
    return True


def _is_copy(ob):
    """Whether the net itself is in Edit Mode, and this a part that was separated from it."""
    return any(other != ob and other.mode == 'EDIT' and net_object.token(other.data) == net_object.token(ob.data) for other in nets())


def end():
    """Put all nets away: the add-on goes."""
    context = bpy.context
    if nets_in_edit_mode(context):
        leave(context)
        # Without a step of its own undo would look for the net's points, and Blender 3.4 crash.
        bpy.ops.ed.undo_push(message="Leave Net")
    for ob in nets():
        live.pull(ob)
        put_away(context, ob)


def settle():
    """Exact normals for the shapes of all nets."""
    for ob in nets():
        owner = net_object.shape_of(ob)
        if owner is not None:
            _settle(owner)


def _settle(owner):
    try:
        live.settle(owner.data)
    except FAILURES as error:
        problems.tell(owner.data, problems.SETTING, sentence(error))


def _is_in(layer, ob):
    return layer.objects.get(ob.name) == ob
