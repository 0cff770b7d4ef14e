"""Where Blender's Mirror modifiers show an object again."""

import itertools

from mathutils import Matrix


def of(ob):
    """The matrices that lead from the space of an object into the world: its own, and those of its images in mirrors."""
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
