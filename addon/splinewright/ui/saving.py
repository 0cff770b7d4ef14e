"""Files are saved without nets, so that they open as they should where Splinewright is missing.

A net that holds what its shape does not take stays in the file, as an object in Object Mode, and can be gone on with.
"""

from contextlib import suppress
from typing import NamedTuple

import bpy
from bpy.app.handlers import persistent

from ..bridge.cage import net_object
from ..bridge.data import problems
from ..bridge.data.file_state import state
from ..bridge.follow import follow
from ..bridge.net import live, magnet
from ..bridge.recipes import late
from ..core.base.failures import text_of
from ..core.base.words import phrase
from . import editing
from .ui_state import ui_state


class _Suspended(NamedTuple):
    """What was in Edit Mode in a view layer, while its nets are out of the file."""

    scene: bpy.types.Scene
    layer: bpy.types.ViewLayer
    editing: list                       # objects, the active one first
    collections: list                   # for each the collections it was taken from


@persistent
def before(*_):
    """Take the nets in Edit Mode out of their scenes."""
    editing.sweep()
    for ob in editing.nets():
        live.sync_from_cage(ob)
    editing.finalize()
    if state.late:
        follow.finish(late.blocks(), bpy.context.evaluated_depsgraph_get())
    suspended = []
    try:
        for scene in bpy.data.scenes:
            for layer in scene.view_layers:
                members = [ob for ob in layer.objects if ob and ob.mode == 'EDIT']
                if any(map(net_object.is_net, members)):
                    suspended.append(_suspend(scene, layer, members))
    finally:
        ui_state.suspended += suspended
    if suspended and not bpy.app.background:
        bpy.app.timers.register(put_back)       # Blender 3.4 does not tell of a save that failed


def _suspend(scene, layer, members):
    members.sort(key=lambda ob: ob != layer.objects.active)
    with _at(scene, layer, members[0]):
        bpy.ops.object.mode_set(mode='OBJECT')
    taken = [list(ob.users_collection) if net_object.is_net(ob) and not live.unread(ob) else [] for ob in members]
    for ob, collections in zip(members, taken):
        for collection in collections:
            collection.objects.unlink(ob)
    magnet.exclude_nets(scene, ())
    _select_shapes(layer, [ob for ob, collections in zip(members, taken) if collections])
    return _Suspended(scene, layer, members, taken)


def _select_shapes(layer, nets):
    """The file opens with the shapes whose nets were edited and are not in it."""
    owners = [owner for owner in map(net_object.shape_of, nets) if owner is not None and layer.objects.get(owner.name) == owner]
    for owner in owners:
        owner.select_set(True, view_layer=layer)
    if owners and layer.objects.active is None:
        layer.objects.active = owners[0]


@persistent
def after(*_):
    """A file was written."""
    put_back()
    for ob in editing.nets():
        problems.set_problem(ob.data, problems.SAVED, _where(ob) if live.unread(ob) else "")


def _where(ob):
    return phrase("the file has that in {name}, as an object: Tab on it continues", name=ob.name)


@persistent
def put_back(*_):
    """Put the nets back, in Edit Mode, whether a file was written or not."""
    while ui_state.suspended:
        suspended = ui_state.suspended.pop()
        try:
            with suppress(ReferenceError):      # something took the scene or its objects away meanwhile
                _put_back(suspended)
        except Exception as error:
            text_of(error)                 # others are to be put back, too


def _put_back(suspended):
    scene, layer, members, taken = suspended
    for ob, collections in zip(members, taken):
        for collection in collections:
            collection.objects.link(ob)
    for ob in layer.objects.selected:
        ob.select_set(False, view_layer=layer)
    for ob in members:
        ob.select_set(True, view_layer=layer)
    layer.objects.active = members[0]
    with _at(scene, layer, members[0]):
        bpy.ops.object.mode_set(mode='EDIT')
    magnet.exclude_nets(scene, editing.nets())


def _at(scene, layer, active):
    """A context in which operators act on a view layer, whichever the window shows."""
    if bpy.context.view_layer == layer:
        return suppress()
    return bpy.context.temp_override(scene=scene, view_layer=layer, active_object=active, object=active)
