"""What Blender tells of changes, passed on to the shapes they concern."""

import sys

import bpy
from bpy.app.handlers import persistent

from ..bridge.analysis import deviation_targets
from ..bridge.data import file_state, versions
from ..bridge.data.file_state import ended_operators, key, look_again, state
from ..bridge.edit import transforming
from ..bridge.follow import follow
from ..bridge.net import dragging, keyed, live
from ..bridge.net.growing import Phase
from ..bridge.recipes import late, recipes
from ..core.base.words import phrase
from . import deviation_paint, editing, finishing, hints, languages, main_thread, messages, saving, texts, timers
from .ui_state import forget, ui_state

#: Seconds after the last move until a shape gets its exact normals.
_SETTLE = 0.3
#: Seconds between two looks whether a drag is over.
_LOOK = 0.1


@persistent
def updated(scene, depsgraph):
    """Shapes follow their nets, their inputs, their keys and drivers. Cheap where nothing changed."""
    if not main_thread.is_main_thread():
        return                          # of a render: frame_changed() sees to that
    state.overlaid.clear()
    occasion = dragging.occasion(depsgraph.updates) if ui_state.nets else None
    if state.drag and dragging.goes_on(occasion):
        timers.later(editing.finalize, _SETTLE)
        return
    _put_back_after_failure()
    is_new = _look_through()
    changed = set()
    if state.targets:
        deviation_targets.look_again(depsgraph.updates)
    if state.followers or depsgraph.id_type_updated('MESH') or depsgraph.id_type_updated('CURVE'):
        _look_again(depsgraph.updates)
        changed = _changed_blocks(depsgraph.updates)
        _take_in_applied(depsgraph)
    written = _follow_nets(changed) if ui_state.nets else set()
    if ui_state.nets or ui_state.status:
        messages.refresh()
    if main_thread.is_away():
        return                          # a render is at another frame
    changed |= written
    if changed:
        recipes.show_new(changed)
        # What nets wrote now is newer than what was evaluated.
        changed |= keyed.show(changed - written, depsgraph)
    if is_new:
        follow.refresh_all(changed, depsgraph)
    elif changed or state.doubtful:
        follow.refresh(changed, depsgraph, _budget(sys._getframe().f_back))
    if state.late:
        timers.later(_finish_late, _SETTLE)
    if state.followers or ui_state.stopped:
        if is_new or depsgraph.id_type_updated('SCENE') or depsgraph.id_type_updated('COLLECTION'):
            follow.look_for_inputs()
        hints.say_stopped()
    if len(ui_state.nets) == len(written) == 1 and _is_alone(changed - written):
        dragging.begin(*editing.nets(), occasion)
    state.seen = ended_operators()


def _budget(caller):
    """The late.Budget of a step; None where there is no user who drags. caller: the frame of Python that had Blender look for
    changes, or None where it does so by itself, between two events."""
    return None if bpy.app.background else late.Budget(is_awaited=caller is not None and not ui_state.is_unawaited)


def _finish_late():
    """The mouse rests: what was put off is made."""
    if main_thread.is_away():
        timers.later(_finish_late, _SETTLE)
        return
    if ui_state.finishing is None and late.waiting(finishing.is_released()):
        with finishing.unawaited(), bpy.context.temp_override(window=bpy.context.window_manager.windows[0]):
            bpy.ops.splinewright.update_late('INVOKE_DEFAULT')
    if late.waiting():
        timers.later(_finish_late, _LOOK)


@persistent
def undoes(*_):
    """In Edit Mode undo leaves the frame alone, and so it is where a step holds the whole file."""
    scene = bpy.context.scene
    is_out = any(ob.mode == 'EDIT' for ob in editing.nets())
    ui_state.frame_before = (scene.name, scene.frame_current, scene.frame_subframe) if is_out else ()


def _keep_frame():
    """Be at the frame again where undo began, with nets as they came back: they are newer than their keys."""
    name, *frame = ui_state.frame_before or ("", 0, 0.0)
    ui_state.frame_before, scene = (), bpy.context.scene
    if scene.name != name or [scene.frame_current, scene.frame_subframe] == frame:
        return
    if any(ob.mode == 'EDIT' for ob in editing.nets()):
        with keyed.kept():
            scene.frame_set(frame[0], subframe=frame[1])


@persistent
def undone(*_):
    """After undo and redo every object is another."""
    _put_back_after_failure()
    for known in (state.late, state.touched, state.selected, state.drawn, state.sights, state.shown, state.targets, state.overlaid):
        known.clear()
    state.drag = None
    ui_state.handed = state.began = ended_operators()
    ui_state.was_undone = True
    editing.reactivate()
    editing.find_nets()
    follow.scan()
    live.accept_undo()
    _keep_frame()
    _pull_all()
    editing.settle_magnet()
    messages.refresh()
    if state.followers or ui_state.stopped:
        follow.look_for_inputs()
        hints.say_stopped()


@persistent
def loaded(*_):
    messages.take_back()
    file_state.forget()
    forget()
    undone()
    hints.follow_tools()
    languages.follow()
    recipes.show_new((*bpy.data.meshes, *bpy.data.curves))
    ui_state.is_scanned, ui_state.was_undone = True, False


def _look_through():
    """Whether the file was open before the add-on was there. In background handlers are the first to notice."""
    if ui_state.is_scanned:
        return False
    loaded()
    return True


@persistent
def frame_changes(*_):
    """Other add-ons may move the inputs of followers when the frame has changed: theirs comes first."""
    chain = bpy.app.handlers.frame_change_post
    if frame_changed in chain[:-1]:
        chain.remove(frame_changed)
        chain.append(frame_changed)


@persistent
def render_begins(scene, *_):
    """Of a still, which may show the frame as it is."""
    if state.late:
        main_thread.in_main_thread(_finish_all, scene)


def _finish_all():
    follow.finish(late.blocks(), bpy.context.evaluated_depsgraph_get())


@persistent
def frame_changed(scene, depsgraph):
    """The shapes of another frame: in views, renders and exports."""
    if state.targets and main_thread.is_main_thread():
        deviation_targets.look_again(depsgraph.updates)
    changed = _changed_blocks(depsgraph.updates)
    state.overlaid.clear()
    if len(bpy.app.handlers.frame_change_post) > 1:
        _evaluate(depsgraph)
    if not ui_state.is_scanned or state.followers or any(map(keyed.is_shape, changed)):
        main_thread.in_main_thread(lambda: _show_frame(changed, depsgraph), scene)


def _show_frame(changed, depsgraph):
    is_new = _look_through()
    changed |= keyed.show(changed, depsgraph) | follow.take_late()
    # What a render evaluates is new in every frame, and before it shapes were at another.
    refresh = follow.refresh_all if is_new or depsgraph.mode == 'RENDER' else follow.refresh
    refresh(changed, depsgraph)


def _evaluate(depsgraph):
    """What other add-ons changed since Blender evaluated the frame counts, too. It evaluates that after all handlers.

    Not where a render continues from the frame before: it would not learn what changed. There the shapes are late by a frame.
    """
    if main_thread.is_main_thread() and depsgraph == bpy.context.evaluated_depsgraph_get():
        return                          # that has done it, where there was anything to do
    if not depsgraph.scene.render.use_persistent_data:
        depsgraph.update()


def _come_back():
    """A render or an export is over; views show the current frame."""
    depsgraph = bpy.context.evaluated_depsgraph_get()
    follow.refresh_all(keyed.show({*bpy.data.meshes, *bpy.data.curves}, depsgraph), depsgraph)
    if ui_state.missed:
        texts.pop_up(phrase("{count} frames were rendered with shapes as they were before: switch Render > Lock Interface on and "
                            "render again",
                            one="{count} frame was rendered with shapes as they were before: switch Render > Lock Interface on and render again",
                            count=ui_state.missed))
        ui_state.missed = 0


def _serve():
    if ui_state.nets:
        editing.show_in_local_views(bpy.context.window_manager)
    return main_thread.serve(_come_back)


def _first_look():
    if _look_through():
        follow.refresh_all(set(), bpy.context.evaluated_depsgraph_get())


def _follow_nets(changed):
    """Bring the shapes of changed nets up to date; the data-blocks that were written."""
    written, is_idle, is_draft = set(), _is_idle(), False
    for ob in editing.nets():
        if ob.mode == 'EDIT':
            ui_state.kept.discard(key(ob))
            if ob.data in changed:
                changed_now = live.sync_from_cage(ob, Phase.TOLD if is_idle else Phase.BUSY)
                written.add(changed_now)
                is_draft = is_draft or changed_now is None and live.is_draft(ob)
                if live.note(ob):
                    timers.soon(editing.select_originals)
                if live.is_waiting(ob):
                    _take_up_after(None if is_idle else ended_operators())
        elif key(ob) not in ui_state.kept or not changed.isdisjoint(editing.blocks_of(ob)):
            timers.soon(editing.sweep)
    written.discard(None)
    if written or is_draft:
        timers.later(editing.finalize, _SETTLE)
    return written


def _is_alone(changed):
    """Whether nothing but its net has to do with a shape, where these blocks change with it."""
    return not state.followers and not state.targets and not any(map(keyed.is_shape, changed))


def _is_idle():
    """Whether no operator is in the middle of something: one has ended since Blender reported a change or drew, or is
    repeated with other settings, which undo comes before."""
    return bpy.app.background or ui_state.was_undone or ended_operators() != state.seen


def _take_up_after(ended):
    """Let nets take up what waits when other operators have ended than these."""
    ui_state.awaited = ended
    timers.soon(editing.adopt_rows)


def _put_back_after_failure():
    """Blender 3.4 does not tell of a save that failed; in a window a timer of saving puts nets back, where there are
    none the next handler that is called."""
    if ui_state.suspended and bpy.app.background:
        saving.put_back()


def _look_again(updates):
    """What was found out about changed data-blocks may not be so any more."""
    for update in updates:
        block = update.id.original
        if isinstance(block, (bpy.types.Mesh, bpy.types.Curve)):
            look_again(block)
            if update.is_updated_geometry or update.is_updated_transform:
                state.touched.pop(key(block), None)
            else:
                follow.look_again(block)


def _changed_blocks(updates):
    """The original objects and data-blocks whose geometry or transform changed."""
    return {update.id.original for update in updates
            if update.is_updated_geometry or update.is_updated_transform}


def _take_in_applied(depsgraph):
    """What Blender's Apply and Set Origin did to shapes: they change an object's place and its mesh or curve at once."""
    updates = [(update.id.original, update) for update in depsgraph.updates]
    changed = {block for block, update in updates if update.is_updated_geometry}
    state.by_hand.update(key(block) for block in changed
                         if isinstance(block, (bpy.types.Mesh, bpy.types.Curve)) and block.is_editmode)
    objects = [block for block, update in updates
               if isinstance(block, bpy.types.Object) and update.is_updated_transform and block.data in changed
               and key(block.data) not in state.by_hand]
    ui_state.to_say += filter(None, [transforming.take_in_applied(ob, depsgraph) for ob in objects])
    if ui_state.to_say:
        timers.soon(_say)


def _say():
    sentences, ui_state.to_say = ui_state.to_say, []
    for sentence in sentences:
        texts.pop_up(sentence)


def _pull_all():
    for ob in editing.nets():
        if ob.mode == 'EDIT':
            live.sync_from_cage(ob, Phase.TOLD)
            if live.note(ob):
                timers.soon(editing.hand_over_now)
            if live.is_waiting(ob):
                _take_up_after(None)
        else:
            timers.soon(editing.sweep)


CLASSES = ()

_HANDLERS = {
    'depsgraph_update_post': updated,
    'undo_pre': undoes,
    'redo_pre': undoes,
    'undo_post': undone,
    'redo_post': undone,
    'load_post': loaded,
    'frame_change_pre': frame_changes,
    'frame_change_post': frame_changed,
    'render_init': render_begins,
    'save_pre': saving.before,
    'save_post': saving.after,
}
if versions.tells_of_failed_saves:
    _HANDLERS['save_post_fail'] = saving.put_back


def register():
    for name, handler in _HANDLERS.items():
        getattr(bpy.app.handlers, name).append(handler)
    ui_state.is_scanned = False            # a file is open already; bpy.data may be out of reach now
    timers.soon(_first_look)
    if not bpy.app.background:
        bpy.app.timers.register(_serve, persistent=True)


def unregister():
    editing.end()
    for name, handler in _HANDLERS.items():
        getattr(bpy.app.handlers, name).remove(handler)
    messages.take_back()
    for function in (_first_look, _serve, _say, _finish_late, editing.sweep, editing.finalize, editing.select_originals, editing.hand_over_now,
                     editing.adopt_rows, deviation_paint.rest, deviation_paint.redraw):
        timers.call_off(function)
