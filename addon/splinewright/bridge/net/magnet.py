"""While nets are out what follows them is no target of Blender's magnet: a point would be drawn to what it moves, and hop about.

Blender excludes objects that cannot be selected, where its *Exclude Non-Selectable* is on. Both are put back as they were.
"""

from ..cage import net_object
from ..data.file_state import key, state
from ..recipes import recipes

#: On an object: whether it could not be selected before. Undo brings it back as it was; settings of tools it leaves as they are.
_WAS = "splinewright_magnet_was"


def exclude_nets(scene, nets):
    """Exclude what moves with the nets that are edited in a scene, and nothing else."""
    if scene.library:
        return
    edited = [owner for ob in nets if ob.mode == 'EDIT' and scene in ob.users_scene for owner in [net_object.shape_of(ob)] if owner]
    moving = _moving_with(edited, scene.objects) if edited else []
    for ob in moving:
        if _WAS not in ob.keys() and not (ob.library or ob.override_library):
            ob[_WAS], ob.hide_select = ob.hide_select, True
    for ob in scene.objects:
        if ob not in moving:
            readmit(ob)
    tools = scene.tool_settings
    if moving:
        state.magnets.setdefault(key(scene), tools.use_snap_selectable)
        tools.use_snap_selectable = True
    elif key(scene) in state.magnets:
        tools.use_snap_selectable = state.magnets.pop(key(scene))


def readmit(ob):
    """Let an object be a target again, and be selected."""
    if _WAS in ob.keys() and not ob.library:
        ob.hide_select = bool(ob[_WAS])
        del ob[_WAS]


def _moving_with(edited, obs):
    """Objects that show the edited shape, or are made from that."""
    found, blocks = set(edited), {ob.data for ob in edited}
    is_more = True
    while is_more:
        new = {ob for ob in obs if ob not in found and ob.data is not None and not net_object.is_net(ob)
               and (ob.data in blocks or recipes.is_from(ob.data, found))}
        found |= new
        blocks |= {ob.data for ob in new}
        is_more = bool(new)
    return found
