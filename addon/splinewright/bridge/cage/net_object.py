"""The net as a Blender object: a Mesh cage or a Curve, made when editing starts and gone when it ends.

The net's data-block keeps the definition it was made from, the object points to its shape. Both survive undo and saving,
so that a net means the same whenever it is read. This is the one door to the stored data of a net: what it gives is valid,
and anything else that may be stored is refused with a sentence.
"""

import uuid

import bpy
import numpy as np

from ...core.base.failures import Refusal
from ...core.net import curve_net, handles, patch_net
from ..curve import handles as kept_types
from ..data import blocks, problems, store
from ..data.settings import overlays_of
from . import cage, net_splines, settings_number

#: On the net's data-block: the definition it was made from, and numbers typed since.
KEY = "splinewright_net"
#: On the shape's data-block: the token of the one net that edits it.
EDITED_BY = "splinewright_edited_by"
#: On the net's object: the shape it edits.
SHAPE = "splinewright_shape"


class DamagedNet(Refusal):
    """The stored net is damaged."""


def damaged(reason):
    return DamagedNet("the stored data of this net is damaged ({reason}): the shape keeps what it has", reason=str(reason)[:200])


def is_net(ob):
    return (ob is not None and SHAPE in ob.keys() and isinstance(ob.data, (bpy.types.Mesh, bpy.types.Curve))
            and KEY in ob.data.keys())


def shape_of(ob):
    """The shape that a net edits, or None where it was deleted."""
    shape = ob.get(SHAPE)
    if not isinstance(shape, bpy.types.Object) or not isinstance(shape.data, (bpy.types.Mesh, bpy.types.Curve)):
        return None
    return shape if store.has_definition(shape.data) and _is_in_scene(shape) else None


def _is_in_scene(ob):
    """Whether an object is in a scene. Blender finds one that is seen at once; to ask for all its scenes takes
    as long as the file has objects."""
    layer = bpy.context.view_layer
    return layer is not None and ob.visible_get(view_layer=layer) or bool(ob.users_scene)


def is_orphan(ob):
    """Whether the shape of a net was deleted, or is in no scene."""
    shape = ob.get(SHAPE)
    return (shape is None or isinstance(shape, bpy.types.Object)) and shape_of(ob) is None


def required_shape(ob):
    """shape_of(). Raises DamagedNet where it cannot be told which net of which shape this is."""
    required_token(ob.data)
    shape = shape_of(ob)
    if shape is None and not is_orphan(ob):
        raise damaged("what it edits is no object")
    return shape


def net_of(definition):
    """The core.net.Net of a definition."""
    return (curve_net if definition.has_curves else patch_net).make(definition)


def make(shape, definition, net, scene):
    """A net object for a shape, always where that is, linked to the scene. net: net_of(definition)."""
    if not (np.isfinite(net.single).all() and np.isfinite(net.single_weights).all()):
        raise Refusal("a control point of {name} lies farther away than Blender's Edit Mode reaches (3.4e38)", name=shape.name)
    if definition.has_curves:
        data = net_splines.make(shape.name, net, handles.of_net(net, kept_types.of_pieces(shape.data, definition)))
    else:
        data = cage.make(shape.name, net)
    data[KEY] = {'token': uuid.uuid4().hex, 'definition': store.encoded(definition)}
    settings_number.make(data)
    shape.data[EDITED_BY] = token(data)
    ob = bpy.data.objects.new(data.name, data)
    ob[SHAPE] = shape
    ob.matrix_world = shape.matrix_world
    ob.constraints.new('COPY_TRANSFORMS').target = shape        # children of a path would run along it
    ob.show_in_front = overlays_of(scene).points_behind
    ob.hide_render = True
    if not definition.has_curves:
        ob.display_type = 'WIRE'
    scene.collection.objects.link(ob)
    return ob


def present(ob, net):
    """The core.net.reading.Present points of a net object made of a Net. Raises ChangedNet."""
    return net_splines.present(ob.data, net) if isinstance(ob.data, bpy.types.Curve) else cage.present(ob, net)


def kind_of(data):
    """The module by which a net's data-block is read and written: net_splines or cage."""
    return net_splines if isinstance(data, bpy.types.Curve) else cage


def is_current(ob):
    """Whether the net is the one that edits its shape: no copy, and none of an earlier time."""
    shape = shape_of(ob)
    return shape is not None and edits(ob, shape)


def edits(ob, shape):
    """Whether a net is the one that edits a shape."""
    return editor(shape.data) == token(ob.data) != ""


def end(ob):
    """Nothing edits the shape of a net any more."""
    if is_current(ob):
        del shape_of(ob).data[EDITED_BY]


def remove(ob):
    """Take a net out of the file, and all messages about it.

    Without Blender's global undo it only goes out of sight: the steps of its Edit Mode are kept all the same, and Blender
    crashes where it does not find the net of one. See awakened().
    """
    data = ob.data
    problems.clear(data)
    if bpy.context.preferences.edit.use_global_undo:
        bpy.data.objects.remove(ob)
        blocks.remove(data)
        return
    for collection in list(ob.users_collection):
        collection.objects.unlink(ob)
    store.assign(data, _REST, _definition_of(shape_of(ob)))


#: On the data-block of a net that went out of sight: a digest of the definition that its shape had then.
_REST = "splinewright_net_rests"


def is_resting(ob):
    """Whether a net is out of sight, until undo takes it into Edit Mode again."""
    return _REST in ob.data.keys() and ob.mode != 'EDIT'


def awakened(ob, scene):
    """Whether undo brought a net into Edit Mode that was out of sight; it is linked to the scene then.

    It edits its shape again, unless that was given another definition since.
    """
    data, shape = ob.data, shape_of(ob)
    if _REST not in data.keys() or ob.mode != 'EDIT':
        return False
    if shape is not None and data[_REST] == _definition_of(shape):
        shape.data[EDITED_BY] = token(data)
    del data[_REST]
    if not ob.users_scene:
        scene.collection.objects.link(ob)
    return True


def _definition_of(shape):
    try:
        return store.digest(shape.data).hex() if shape else ""
    except store.UnreadableDefinition:
        return ""


def stored(data):
    """The stored data of a net, by name; {} where that has no names."""
    group = data.get(KEY)
    return group if store.is_group(group) else {}


def token(data):
    """Names the net among all that ever were: equal tokens, equal baselines. "" where it is damaged."""
    found = stored(data).get('token')
    return found if type(found) is str else ""


def required_token(data):
    """token(). Raises DamagedNet where that is damaged."""
    found = token(data)
    if not found:
        raise damaged("its token is none")
    return found


def editor(shape_data):
    """The token of the net that edits a shape, or None."""
    found = shape_data.get(EDITED_BY)
    return found if type(found) is str else None


def source(data):
    """The definition that a net was made from. Raises DamagedNet."""
    group = stored(data).get('definition')
    if not store.is_group(group):
        raise damaged("its definition is none")
    try:
        definition = store.valid(group)
    except Refusal as error:
        raise damaged(error) from error
    if definition.has_curves != isinstance(data, bpy.types.Curve):
        raise damaged("its definition is of another kind")
    return definition


def remember(ob, names):
    """Keep the names of objects that were selected when the net came."""
    ob.data[KEY]['selected'] = dict(zip(map(str, range(len(names))), names))


def remembered(ob):
    group = stored(ob.data).get('selected')
    return [name for name in group.values() if type(name) is str] if store.is_group(group) else []


def typed(data, net=None):
    """(k, 5): vertex, x, y, z, w that were typed in float64, those of a Net where it is given. Later rows win."""
    found = stored(data).get('typed')
    if getattr(found, 'typecode', None) != 'd' or len(found) % 5:
        return np.empty((0, 5))
    rows = np.array(found).reshape(-1, 5)
    rows = rows[np.isfinite(rows).all(1)]
    if net is None:
        return rows
    rows[:, 0] -= net.first
    return rows[(rows[:, 0] >= 0) & (rows[:, 0] < len(net.rows))]


def add_typed(data, rows):
    """Remember typed numbers. They are never removed: undo takes the vertex back, and so the match."""
    every = np.concatenate([typed(data), rows])
    last = len(every) - 1 - np.unique(every[::-1], axis=0, return_index=True)[1]
    store.assign(data[KEY], 'typed', every[np.sort(last)].ravel())
