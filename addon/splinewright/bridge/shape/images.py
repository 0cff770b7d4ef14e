"""Where an object is seen again: in Blender's Mirror modifiers and in instances of collections."""

import itertools

from mathutils import Matrix

from . import shape


def of(ob, layer, view=None):
    """The matrices that lead from the space of an object into the world: its own, and those of its images in mirrors and in the
    instances of a view layer. view: the space of a 3D view, where objects hidden in that view alone are left out."""
    own = _in_mirrors(ob)
    where = {'view_layer': layer} if view is None else {'view_layer': layer, 'viewport': view}
    found = list(own) if ob.visible_get(**where) else []
    if ob.hide_viewport:
        return found
    for holder in _holders(layer.objects):
        if holder.visible_get(**where):
            found += [place @ matrix for place in _places(holder, ob, ()) for matrix in own]
    return found


def shapes_in(ob):
    """The shapes that the instance of a collection shows, whatever collections of that are instanced in it."""
    found, waiting, seen = {}, [ob], set()
    while waiting:
        holder = waiting.pop()
        if _is_holder(holder) and holder.instance_collection not in seen:
            seen.add(holder.instance_collection)
            for each in holder.instance_collection.all_objects:
                waiting.append(each)
                if shape.has_shape(each):
                    found[each] = None
    return list(found)


def _is_holder(ob):
    return ob.instance_type == 'COLLECTION' and ob.instance_collection is not None


def _holders(objects):
    return [ob for ob in objects if _is_holder(ob)]


def _places(holder, ob, above):
    """The matrices that lead from the world of a collection, in which an object lies, into that of its instances by a holder."""
    collection = holder.instance_collection
    if collection in above:
        return
    place = holder.matrix_world @ Matrix.Translation(-collection.instance_offset)
    inside = collection.all_objects
    if inside.get(ob.name) == ob:
        yield place
    for inner in _holders(inside):
        yield from (place @ matrix for matrix in _places(inner, ob, (*above, collection)))


def _in_mirrors(ob):
    found = [ob.matrix_world]
    for modifier in ob.modifiers:
        if modifier.type == 'MIRROR' and modifier.show_viewport:
            found = [mirror @ matrix for mirror in _mirrors(ob, modifier) for matrix in found]
    return found


def _mirrors(ob, modifier):
    """One of each combination of its axes, as matrices of the world; first the one that changes nothing."""
    place = modifier.mirror_object.matrix_world if modifier.mirror_object else ob.matrix_world
    if place.determinant() == 0.0:
        return [Matrix()]
    signs = itertools.product(*((1.0, -1.0) if is_on else (1.0,) for is_on in modifier.use_axis))
    return [place @ Matrix.Diagonal((*sign, 1.0)) @ place.inverted() for sign in signs]
