"""A shape is given other pieces, and its splines or faces keep what users put on them."""

from ...core.base.failures import Refusal
from ...core.verbs import verbs
from ..curve import handles
from ..data import held, store
from ..data.shading import Look
from ..mesh import mesh_attributes, mesh_looks, write_mesh
from ..recipes import recipes
from ..shape import curve_pieces, shape


def is_curve_shape(ob):
    """Whether the object is a shape of curves."""
    return shape.has_shape(ob) and ob.type == 'CURVE'


def is_patch_shape(ob):
    """Whether the object is a shape of patches."""
    return shape.has_shape(ob) and ob.type == 'MESH'


def require_changeable(data):
    """Raises Refusal where the definition is not to be changed, or cannot be."""
    recipes.require_free(data)
    shape.require_writable(data)
    shape.require_untouched(data)


def can_change(data):
    """Whether the definition can be changed."""
    try:
        require_changeable(data)
    except Refusal:
        return False
    return True


def seems_changeable(data):
    """can_change() as it was when Blender last reported a change, for repeated drawing."""
    try:
        recipes.require_free(data)
        shape.require_writable(data)
    except Refusal:
        return False
    return not shape.seems_touched(data)


def do(data, number, verb, already):
    """Do a verb with a piece of a shape, or with all where the number is 0.

    Returns the definition before and the verbs.Changed. Raises, and changes nothing, as verbs.changed() and
    shape.set_definition() do.
    """
    before = read(data)
    changed = verbs.changed(before, number, verb, already)
    put(data, before, changed)
    return before, changed


def do_each(data, make_verbs, already):
    """do() with a verb for each piece, by numbers from 0, that a function makes of the definition."""
    before = read(data)
    changed = verbs.each_changed(before, make_verbs(before), already)
    put(data, before, changed)
    return before, changed


def read(data):
    """The definition, which is to be changed. Raises Refusal."""
    require_changeable(data)
    return store.read(data)


def put(data, before, changed):
    """Write the verbs.Changed of the definition `before`, which the data-block has."""
    seams = held.known(data)
    if before.has_curves:
        _put_curves(data, before, changed)
    else:
        _put_patches(data, before, changed)
    held.carry(data, seams, before, changed.parents)


def _put_curves(data, before, changed):
    pieces = curve_pieces.carried(curve_pieces.of(data, before), changed)
    types = handles.known(data, before)
    shape.set_definition(data, changed.definition)
    curve_pieces.write(data, changed.definition, pieces)
    handles.carry(data, types, before, changed)


def _put_patches(data, before, changed):
    looks, uneven = mesh_looks.kept(data)
    with mesh_attributes.moved(data, write_mesh.owner_of(data), uneven, changed.parents, changed.places):
        shape.set_definition(data, changed.definition)
    # A patch of the same number is the same one; and uneven looks lie where they lay.
    if changed.parents != tuple(range(len(before.pieces))) and not uneven:
        give_looks(data, [looks.get(parent, Look()) for parent in changed.parents])


def give_looks(data, of_pieces):
    """Give the faces of each patch a Look."""
    mesh_looks.set_looks(data, dict(enumerate(of_pieces)))
    if not all(look.use_smooth for look in of_pieces):
        shape.rewrite(data)             # normals of flat faces are their own
