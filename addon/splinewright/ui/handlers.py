"""What Blender tells of changes, passed on to the shapes they concern."""

import bpy
from bpy.app.handlers import persistent

from ..bridge import follow
from ..bridge.file_state import forget, key, look_again, state
from ..bridge.net import live
from . import editing, messages, saving

#: Seconds after the last move until a shape gets its exact normals.
_SETTLE = 0.3


@persistent
def updated(scene, depsgraph):
    """Shapes follow their nets and their inputs. Cheap where nothing changed."""
    _put_back_after_failure()
    changed = set()
    if state.followers or depsgraph.id_type_updated('MESH') or depsgraph.id_type_updated('CURVE'):
        _look_again(depsgraph.updates)
        changed = _changed_blocks(depsgraph.updates)
    if state.nets:
        changed |= _follow_nets(changed)
    if state.nets or state.status:
        messages.refresh()
    if changed:
        follow.refresh(changed, depsgraph)


@persistent
def undone(*_):
    """After undo and redo every object is another."""
    _put_back_after_failure()
    for known in (state.touched, state.selected, state.drawn):
        known.clear()
    editing.awaken()
    editing.find_nets()
    follow.scan()
    live.trust()
    _pull_all()
    messages.refresh()


@persistent
def loaded(*_):
    messages.take_back()
    forget()
    undone()


@persistent
def frame_changed(scene, depsgraph=None):
    follow.refresh_all(depsgraph or bpy.context.evaluated_depsgraph_get())


def _follow_nets(changed):
    """Bring the shapes of changed nets up to date; the data-blocks that were written."""
    written = set()
    for ob in editing.nets():
        if ob.mode == 'EDIT':
            state.kept.discard(key(ob))
            if ob.data in changed:
                written.add(live.pull(ob))
                if live.note(ob):
                    _soon(editing.hand_over, 0.0)
        elif key(ob) not in state.kept or not changed.isdisjoint(editing.blocks_of(ob)):
            _soon(editing.sweep, 0.0)
    written.discard(None)
    if written:
        _later(editing.settle)
    return written


def _put_back_after_failure():
    """Blender 3.4 does not tell of a save that failed; in a window a timer of saving puts nets back, where there are
    none the next handler that is called."""
    if state.suspended and bpy.app.background:
        saving.put_back()


def _look_again(updates):
    """What was found out about changed data-blocks may not be so any more."""
    for update in updates:
        block = update.id.original
        if isinstance(block, (bpy.types.Mesh, bpy.types.Curve)):
            look_again(block)
            if update.is_updated_geometry or update.is_updated_transform:
                state.touched.pop(key(block), None)


def _changed_blocks(updates):
    """The original objects and data-blocks whose geometry or transform changed."""
    return {update.id.original for update in updates
            if update.is_updated_geometry or update.is_updated_transform}


def _pull_all():
    for ob in editing.nets():
        if ob.mode == 'EDIT':
            live.pull(ob)
            if live.note(ob):
                _soon(editing.hand_over_now, 0.0)
        else:
            _soon(editing.sweep, 0.0)


def _soon(function, seconds):
    """Call a function once, outside this handler. Timers never run in background."""
    if not bpy.app.timers.is_registered(function):
        bpy.app.timers.register(function, first_interval=seconds)


def _later(function):
    """Call a function when nothing has happened for a while."""
    if bpy.app.timers.is_registered(function):
        bpy.app.timers.unregister(function)
    bpy.app.timers.register(function, first_interval=_SETTLE)


CLASSES = ()

_HANDLERS = {
    'depsgraph_update_post': updated,
    'undo_post': undone,
    'redo_post': undone,
    'load_post': loaded,
    'frame_change_post': frame_changed,
    'save_pre': saving.before,
    'save_post': saving.after,
    'save_post_fail': saving.put_back,     # from Blender 3.6 on
}


def register():
    for name, handler in _HANDLERS.items():
        if hasattr(bpy.app.handlers, name):
            getattr(bpy.app.handlers, name).append(handler)
    _soon(loaded, 0.0)                  # a file is open already; bpy.data may be out of reach now


def unregister():
    editing.end()
    for name, handler in _HANDLERS.items():
        if hasattr(bpy.app.handlers, name):
            getattr(bpy.app.handlers, name).remove(handler)
    messages.take_back()
    for function in (loaded, editing.sweep, editing.settle, editing.hand_over, editing.hand_over_now):
        if bpy.app.timers.is_registered(function):
            bpy.app.timers.unregister(function)
