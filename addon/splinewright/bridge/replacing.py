"""A shape is given other pieces, and its splines or faces keep their look."""

from ..core import verbs
from . import mesh_attributes, mesh_looks, recipes, shape, store, write_curve, write_mesh


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


def do(data, number, verb, already):
    """Do a verb with a piece of a shape, or with all where the number is 0.

    Returns the definition before and the verbs.Changed. Raises, and changes nothing, as verbs.changed() and
    shape.set_definition() do.
    """
    require_changeable(data)
    before = store.read(data)
    changed = verbs.changed(before, number, verb, already)
    put(data, before, changed)
    return before, changed


def put(data, before, changed):
    """Write the verbs.Changed of the definition `before`, which the data-block has."""
    if before.has_curves:
        _put_curves(data, before, changed)
    else:
        _put_patches(data, before, changed)


def _put_curves(data, before, changed):
    worn = carried(write_curve.dresses(data), before, changed, data)
    shape.set_definition(data, changed.definition)
    if len(worn) == len(data.splines):
        write_curve.put_on(data, worn)


def _put_patches(data, before, changed):
    looks = mesh_looks.looks_by_patch(data)
    with mesh_attributes.moved(data, write_mesh.owner_of(data), changed.parents, changed.places):
        shape.set_definition(data, changed.definition)
    if changed.parents == tuple(range(len(before.pieces))):
        return                          # a patch of the same number is the same one
    give_looks(data, [looks.get(parent, mesh_looks.Look()) for parent in changed.parents])


def give_looks(data, of_pieces):
    """Give the faces of each patch a mesh_looks.Look."""
    mesh_looks.set_looks(data, dict(enumerate(of_pieces)))
    if not all(look.use_smooth for look in of_pieces):
        shape.rewrite(data)             # normals of flat faces are their own


def carried(worn, before, changed, data):
    """The dresses of the splines of a changed definition: each piece wears what the piece wore that it came from.

    A piece may be shown by several splines, or none, where it runs to infinity. [] if the dresses are not of `before`.
    """
    of_pieces, first = [], 0
    for count in _spline_counts(before, data):
        of_pieces.append(worn[first:first + count])
        first += count
    if first != len(worn):
        return []
    result = []
    for parent, count in zip(changed.parents, _spline_counts(changed.definition, data)):
        was = of_pieces[parent]
        result += was if len(was) == count else (was[:1] or [write_curve.Dress()]) * count
    return result


def _spline_counts(definition, data):
    """For each piece, as shape.evaluated() shows it."""
    return [len(shape.lines_of(data, curve)) for curve in verbs.curves_of(definition)]
