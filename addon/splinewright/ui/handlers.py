"""What Blender tells of changes, passed on to the shapes they concern."""

import bpy
from bpy.app.handlers import persistent

from ..bridge import follow, versions
from ..bridge.file_state import forget, key, state
from ..bridge.net import live
from . import editing, saving

#: Seconds after the last move until a shape gets its exact normals.
_SETTLE = 0.3


@persistent
def updated(scene, depsgraph):
    """Shapes follow their nets and their inputs. Cheap where nothing changed."""
    changed = set()
    if state.followers or depsgraph.id_type_updated('MESH') or depsgraph.id_type_updated('CURVE'):
        changed = _changed_blocks(depsgraph.updates)
        _look_again(changed)
    if state.nets:
        changed |= _follow_nets(changed)
    if changed:
        follow.refresh(changed, depsgraph)


@persistent
def undone(*_):
    """After undo and redo every object is another."""
    state.touched.clear()
    editing.find_nets()
    follow.scan()
    live.trust()
    _pull_all()


@persistent
def loaded(*_):
    forget()
    undone()


@persistent
def frame_changed(scene, depsgraph=None):
    follow.refresh_all(depsgraph or bpy.context.evaluated_depsgraph_get())


def _follow_nets(changed):
    """Bring the shapes of changed nets up to date; the data-blocks that were written."""
    written = set()
    for ob in editing.nets():
        if ob.mode != 'EDIT':
            _soon(editing.sweep, 0.0)
        elif ob.data in changed:
            written.add(live.pull(ob))
    written.discard(None)
    if written:
        _later(editing.settle)
    return written


def _look_again(changed):
    """What was found out about changed data-blocks may not be so any more."""
    for block in changed if state.touched else ():
        state.touched.pop(key(block), None)


def _changed_blocks(updates):
    """The original objects and data-blocks whose geometry or transform changed."""
    return {update.id.original for update in updates
            if update.is_updated_geometry or update.is_updated_transform}


def _pull_all():
    for ob in editing.nets():
        if ob.mode == 'EDIT':
            live.pull(ob)
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
}
if versions.tells_of_failed_saves:
    _HANDLERS['save_post_fail'] = saving.after


def register():
    for name, handler in _HANDLERS.items():
        getattr(bpy.app.handlers, name).append(handler)
    _soon(loaded, 0.0)                  # a file is open already; bpy.data may be out of reach now


def unregister():
    editing.end()
    for name, handler in _HANDLERS.items():
        getattr(bpy.app.handlers, name).remove(handler)
    for function in (loaded, editing.sweep, editing.settle):
        if bpy.app.timers.is_registered(function):
            bpy.app.timers.unregister(function)
