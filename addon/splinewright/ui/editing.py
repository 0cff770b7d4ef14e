"""Putting nets out and away. Undo steps are the operators' affair, but for end()."""

import re
from contextlib import nullcontext, suppress

import bpy

from ..bridge.cage import free_net, net_object
from ..bridge.data import problems, store
from ..bridge.data.file_state import block_of, ended_operators, key, state
from ..bridge.keys import point_keys
from ..bridge.net import live, magnet, selection
from ..bridge.recipes import recipes
from ..bridge.shape import recipe_edit, shape
from ..core.base.failures import FAILURES, Refusal, sentence, text_of
from ..core.base.words import phrase
from . import progress
from .ui_state import ui_state


def why_not(ob):
    """Why an object's net cannot be edited, as a sentence, or ""."""
    if not shape.has_shape(ob):
        return "Select a Splinewright shape"
    if ob.library or ob.data.library or ob.data.override_library:
        return "The shape is linked from another file: make it local first"
    if recipes.follows(ob.data):
        return "The shape follows another object: edit that, or use Apply Construction first"
    try:
        is_of_numbers = recipes.has(ob.data) and not recipes.has_points(ob.data)
    except store.UnreadableDefinition as error:
        return str(error)
    return "The shape is made by its numbers: change them in the panel, or use Apply Construction first" if is_of_numbers else ""


def nets():
    """All net objects of the file that the last scan or an operator reported."""
    found = _known_nets()
    if not all(_is_out(ob) for ob in found):
        find_nets()                     # one was renamed or removed
        found = _known_nets()
    return found


def _known_nets():
    """Blender looks through all objects for a name, but knows the active one."""
    layer = bpy.context.view_layer
    active = layer.objects.active if layer is not None else None
    near = {key(active): active} if active is not None else {}
    return [near.get(name) or block_of(name) for name in sorted(ui_state.nets)]


def find_nets():
    """Scan the file."""
    ui_state.nets.clear()
    ui_state.nets.update(key(ob) for ob in bpy.data.objects if _is_out(ob))
    ui_state.kept &= ui_state.nets


def _is_out(ob):
    return net_object.is_net(ob) and not ob.library and not net_object.is_resting(ob)


def nets_in_edit_mode(context):
    if not context.mode.startswith('EDIT'):
        return []
    return [ob for ob in context.objects_in_mode if net_object.is_net(ob)]


def is_in_result(context):
    """Whether the mesh or curve that Splinewright wrote is in Edit Mode, not the net."""
    ob = getattr(context, 'object', None)           # a window that is closing has none
    return ob is not None and ob.mode == 'EDIT' and shape.has_shape(ob)


def kept_net(data):
    """The net in Object Mode that edits a shape's data-block, which holds what that has not taken, or None."""
    return next((ob for ob in nets() if ob.mode == 'OBJECT' and net_object.is_current(ob)
                 and net_object.shape_of(ob).data == data), None)


def blocks_of(ob):
    """The data-blocks of a net and of its shape."""
    owner = net_object.shape_of(ob)
    return {ob.data, owner.data} if owner else {ob.data}


def enter(context, active, progress=shape.no_progress):
    """Put the nets of the active shape, and of selected ones of its kind, into Edit Mode.

    Raises Refusal, and nothing has changed, if the net of the active shape cannot be made.
    """
    chosen = [active] + [ob for ob in context.selected_objects
                         if ob != active and ob.type == active.type and not why_not(ob) and not shape.is_touched(ob.data)]
    put_out, made, seen = [], [], set()
    try:
        for ob in chosen:
            if ob.data.name not in seen:
                seen.add(ob.data.name)
                kept = kept_net(ob.data)
                put_out.append(_brought_back(context, kept) if kept else _put_out(context, ob))
                made += [] if kept else put_out[-1:]
                progress(len(put_out))
    except Exception:
        for ob in made:
            net_object.remove(ob)
        raise
    if put_out[0] in made:
        net_object.remember(put_out[0], [ob.name for ob in context.selected_objects if ob not in chosen])
    for ob in context.selected_objects:
        ob.select_set(False)
    for ob in put_out:
        ob.select_set(True)
        ui_state.nets.add(key(ob))
    context.view_layer.objects.active = put_out[0]
    with suppress(RuntimeError):        # where Blender refuses, the mode tells
        bpy.ops.object.mode_set(mode='EDIT')
    if put_out[0].mode != 'EDIT':
        for ob in made:
            put_away(context, ob)
        raise Refusal("{name} is not in the current view layer: its net cannot be edited from here", name=active.name)
    for ob in put_out:
        if ob not in made:
            live.sync_from_cage(ob)
    settle_magnet()
    return put_out


def settle_magnet():
    """What moves with nets is no target of Blender's magnet, and all else is."""
    for scene in bpy.data.scenes:
        magnet.exclude_nets(scene, nets())


def _put_out(context, ob):
    data = ob.data
    shape.require_writable(data)
    shape.require_untouched(data)
    definition = recipe_edit.edited(data)
    numbers = net_object.net_of(definition)
    is_free = recipe_edit.takes_any_count(data)
    is_closed = is_free and recipe_edit.is_closed(data)
    held = net_object.make(ob, definition, numbers, context.scene)      # nothing raises from here on
    if is_free:
        free_net.set_free(held.data, is_closed)
    live.begin(held.data, numbers, live.shown_now(data))
    space = context.space_data
    if space is not None and space.type == 'VIEW_3D' and space.local_view:
        held.local_view_set(space, True)
    return held


def show_in_local_views(manager):
    """Where a net was taken into a local view alone, its shape follows."""
    spaces = [area.spaces.active for window in manager.windows for area in window.screen.areas if area.type == 'VIEW_3D']
    for space in spaces:
        for held in nets() if space.local_view else ():
            owner = net_object.shape_of(held)
            if held.mode == 'EDIT' and held.visible_get(viewport=space) and _is_left_behind(owner, space):
                owner.local_view_set(space, True)


def _is_left_behind(ob, space):
    """Whether an object is hidden by the local view of a space alone. Blender 3.4's local_view_get() is always false."""
    return ob is not None and ob.visible_get() and not ob.visible_get(viewport=space)


def _brought_back(context, held):
    """A net that was kept, where it can be edited."""
    if not _is_in(context.view_layer, held):
        raise Refusal("{name} holds changes that its shape has not taken, and is not in the current view layer: continue where it "
                      "is, or delete it",
                      name=held.name)
    held.hide_viewport = False
    held.hide_set(False)
    return held


def unread(nets):
    """What the shapes of nets in Edit Mode do not take, as one sentence, or ""."""
    for ob in nets:
        live.sync_from_cage(ob)
    return "; ".join(filter(None, map(live.unread, nets)))


def leave(context, progress=shape.no_progress):
    """Put the nets in Edit Mode away, whatever they hold; the shapes are selected. Returns unread() of them."""
    editing = nets_in_edit_mode(context)
    lost = unread(editing)
    tokens = {net_object.token(ob.data) for ob in editing} - {""}
    bpy.ops.object.mode_set(mode='OBJECT')
    for i, ob in enumerate(editing, 1):
        put_away(context, ob)
        progress(i)
    find_nets()
    for copy in nets():
        if copy.mode == 'OBJECT' and net_object.token(copy.data) in tokens:
            put_away(context, copy)
    settle_magnet()
    return lost


def put_away(context, ob):
    """Remove a net in Object Mode; its shape is exact, and selected and active where the net was."""
    owner = net_object.shape_of(ob)
    if not _is_copy(ob):
        net_object.end(ob)
        if owner is not None:
            point_keys.finalize(owner.data)
    layer = context.view_layer
    others = net_object.remembered(ob)
    was_active, was_selected = layer.objects.active == ob, _is_in(layer, ob) and ob.select_get()
    ui_state.nets.discard(key(ob))
    ui_state.kept.discard(key(ob))
    net_object.remove(ob)
    if owner is None:
        return
    magnet.readmit(owner)
    _settle(owner)
    if _is_in(layer, owner) and (was_active or was_selected):
        for other in filter(None, map(layer.objects.get, others)):
            other.select_set(True)
        owner.select_set(True)
        if was_active:
            layer.objects.active = owner


def anew(context, nets):
    """Put the nets away and out again, from what the shapes are now; points stay selected, where there are others by
    where they are.

    Returns warnings: why they did not come out again. The shapes are as they should be.
    """
    selections = {}
    for ob in nets:
        owner, session = net_object.shape_of(ob), live.known_session(ob.data)
        if owner is not None and session is not None:
            selections[owner.name] = selection.selected(ob, session.net), session.points
    active = net_object.shape_of(context.object)
    leave(context)
    if active is None or context.view_layer.objects.get(active.name) != active:
        return ()
    context.view_layer.objects.active = active
    try:
        out = enter(context, active)
    except FAILURES as error:
        return (phrase("the net did not come out again: {error}", error=sentence(error)),)
    for ob in out:
        session, owner = live.session(ob.data), net_object.shape_of(ob)
        if owner.name in selections:
            selection.select(ob, session.net, _same(session.points, *selections[owner.name]))
    return ()


def _same(points, chosen, before):
    """Of points (n, 3) those that were chosen among the ones before."""
    if len(points) == len(before):
        return chosen
    positions = {tuple(point) for point in before[chosen].tolist()}
    return [i for i, point in enumerate(points.tolist()) if tuple(point) in positions]


def sweep():
    """Put away the nets that were left by another way than leave(), and copies of nets. One that holds what its shape
    does not take stays, as an object. Whatever goes wrong with one is shown: others are to be swept, too."""
    if ui_state.suspended:                 # a file is being saved
        return
    find_nets()
    for ob in nets():
        try:
            _sweep(ob)
        except Exception as error:
            problems.set_problem(ob.data, problems.NET, text_of(error))
    settle_magnet()


def _sweep(ob):
    ui_state.kept.discard(key(ob))
    if ob.mode == 'EDIT' or ob.mode != 'OBJECT' and not _to_object_mode(ob):
        return
    if ob.users_scene and not _is_copy(ob):
        live.sync_from_cage(ob)
        if live.unread(ob):
            ui_state.kept.add(key(ob))
            return
    put_away(bpy.context, ob)


def _to_object_mode(ob):
    """Leave Sculpt Mode and the like by a separate step, or undo would look for the net there."""
    layer = bpy.context.view_layer
    if not _is_in(layer, ob):
        return False
    layer.objects.active = ob
    bpy.ops.object.mode_set('EXEC_DEFAULT', True, mode='OBJECT')
    return True


def _is_copy(ob):
    """Whether another is the net itself, and this a part that was separated from it, or a duplicate."""
    token = net_object.token(ob.data)
    others = [other for other in nets() if other != ob and token and net_object.token(other.data) == token]
    return any(_rank(other) < _rank(ob) for other in others)


def _rank(ob):
    """Of nets with one token the net is the first."""
    size = len(ob.data.vertices) if isinstance(ob.data, bpy.types.Mesh) else len(ob.data.splines)
    return ob.mode != 'EDIT', -size, ob.name


def end():
    """Put all nets away: the add-on goes. One that holds what its shape does not take stays, as an object."""
    context = bpy.context
    if nets_in_edit_mode(context):
        bpy.ops.object.mode_set(mode='OBJECT')
        sweep()
        # Without a step of its own undo would look for the net's points, and Blender 3.4 crash.
        bpy.ops.ed.undo_push(message="Finish Editing")
    sweep()
    for ob in nets():
        if ob.mode == 'EDIT':           # in another scene
            live.sync_from_cage(ob)
            if not live.unread(ob):
                put_away(context, ob)
    for scene in bpy.data.scenes:
        magnet.exclude_nets(scene, ())


def finalize():
    """Exact normals for the shapes of all nets."""
    for ob in nets():
        owner = net_object.shape_of(ob)
        if owner is None:
            continue
        data = owner.data
        is_long = isinstance(data, bpy.types.Mesh) and len(data.vertices) >= _MANY and store.is_draft(data)
        with progress.shown(bpy.context, shape.STEPS) if is_long else nullcontext(shape.no_progress) as step:
            _settle(owner, ob, step)


#: Vertices of which exact normals take half a second, before Blender 4.5.
_MANY = 200_000


def _settle(owner, held=None, step=shape.no_progress):
    """Whatever goes wrong is kept in words: other shapes are to get theirs, too. held: the net, if it stays out."""
    try:
        if held is not None:
            live.look_at_all(held)
        live.finalize(owner.data, step)
    except Exception as error:
        problems.set_problem(owner.data, problems.SETTING, text_of(error))


def reactivate():
    """After undo without Blender's global undo: nets that were left are in Edit Mode again, and are to be seen there."""
    for ob in bpy.data.objects:
        if net_object.is_net(ob) and net_object.awakened(ob, bpy.context.scene):
            ob.select_set(True)
            bpy.context.view_layer.objects.active = ob


def adopt_rows():
    """A timer: nets take up rows that were cut in when the operator has ended, which may slide them until then, and rows
    that are gone with the faces beside them, for which others are to be made."""
    waiting = [ob for ob in nets() if ob.mode == 'EDIT' and live.is_waiting(ob)]
    if waiting and ended_operators() == ui_state.awaited:
        return _LOOK
    for ob in waiting:
        live.sync_from_cage(ob)
    return None


#: Seconds until adopt_rows() looks again.
_LOOK = 0.02


def select_originals():
    """Where points were duplicated and that was called off, the points themselves are selected, not their copies.

    Only what an operator left when it had ended is looked at, since Blender is in the middle of one otherwise.
    """
    ended = ended_operators()
    if not ended or ended in (ui_state.handed, state.began):
        return
    if _DUPLICATING.search(bpy.context.window_manager.operators[-1].bl_idname):
        ui_state.handed = ended
        hand_over_now()


_DUPLICATING = re.compile('extrude|duplicate')


def hand_over_now():
    """hand_over() where no operator runs: after undo, too, copies are selected that were when they were made."""
    for ob in nets():
        session = live.known_session(ob.data) if ob.mode == 'EDIT' else None
        if session is not None and live.note(ob) and not free_net.is_free(ob.data):
            with suppress(Refusal):     # of which live.problem() tells
                selection.select_originals(ob, session.net)
                live.ignore_called_off(ob)


def want_whole_step():
    """Let the next undo step in Edit Mode hold the whole file, not the net alone: Blender makes one where data-blocks came
    or went."""
    bpy.data.meshes.remove(bpy.data.meshes.new("step"))


def _is_in(layer, ob):
    return layer.objects.get(ob.name) == ob
