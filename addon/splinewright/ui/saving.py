"""Files are saved without nets, so that they open as they should where Splinewright is missing."""

import bpy
from bpy.app.handlers import persistent

from ..bridge.net import live
from . import editing

#: (net, its collections) of nets that are out of the file while it is written; the active first.
_suspended = []


@persistent
def before(*_):
    """Take the nets in Edit Mode out of their scene."""
    context = bpy.context
    editing.sweep()
    nets = editing.nets_in_edit_mode(context)
    if not nets:
        return
    nets.sort(key=lambda ob: ob != context.view_layer.objects.active)
    for ob in nets:
        live.pull(ob)
    editing.settle()
    bpy.ops.object.mode_set(mode='OBJECT')
    for ob in nets:
        collections = list(ob.users_collection)
        _suspended.append((ob, collections))
        for collection in collections:
            collection.objects.unlink(ob)
    if not bpy.app.background:
        bpy.app.timers.register(after)  # Blender 3.4 does not tell of a save that failed


@persistent
def after(*_):
    """Put them back, in Edit Mode."""
    if not _suspended:
        return
    layer = bpy.context.view_layer
    back = [ob for ob, _ in _suspended]
    for ob, collections in _suspended:
        for collection in collections:
            collection.objects.link(ob)
    _suspended.clear()
    for ob in bpy.context.selected_objects:
        ob.select_set(False)
    for ob in back:
        ob.select_set(True)
    layer.objects.active = back[0]
    bpy.ops.object.mode_set(mode='EDIT')
