"""Transforms of objects into definitions."""

import numpy as np
from mathutils import Matrix

from ...core.base.failures import FAILURES, Refusal
from ...core.base.words import phrase
from ...core.shape import transform
from ..data import animation, held, settings, store
from ..follow import follow
from ..keys import point_keys
from ..mesh import stamp
from ..recipes import placing, recipes
from ..shape import recipe_edit, shape

_CURES = "Discard Manual Changes makes the shape again, Convert to Plain Mesh/Curve keeps them"
_ANIMATED = {'location': "its location is animated: the keys or drivers would move the shape away again",
             'rotation': "its rotation is animated: the keys or drivers would move the shape away again",
             'scale': "its scale is animated: the keys or drivers would move the shape away again"}


def apply(ob, location, rotation, scale):
    """Move parts of an object's own transform into its definition; its children stay where they are.

    Raises Refusal, and changes nothing, where several objects show the data or the scale is 0.
    """
    data = ob.data
    if ob.library or ob.override_library:
        raise Refusal("it is linked from another file")
    if data.users - data.use_fake_user > 1:
        raise Refusal("{count} users show the same data: make it single-user first", count=data.users)
    recipes.require_free(data)
    _require_still(ob, location, rotation, scale)
    _require_no_keys(data)
    shape.require_writable(data)
    shape.require_untouched(data)
    before = ob.matrix_basis.copy()
    after = _rest(before, location, rotation, scale)
    definition = store.read(data)
    matrix = np.linalg.inv(_exact(after)) @ _exact(before)
    moved = transform.transformed(definition, matrix)
    _set_definition(data, moved, matrix)
    ob.matrix_basis = after
    into = after.inverted_safe() @ before
    for child in ob.children:
        if child.parent_type.startswith('VERTEX'):
            continue                    # it hangs on points that stay where they are
        child.matrix_parent_inverse = into @ child.matrix_parent_inverse


def _require_still(ob, location, rotation, scale):
    """Raises Refusal where keys or drivers would put back the part that is taken out."""
    for (name, words), is_taken in zip(_ANIMATED.items(), (location, rotation, scale)):
        # "rotation_euler", "delta_location", but nothing of a pose's bones or a modifier
        if is_taken and any(path.removeprefix("delta_").startswith(name) for path in animation.paths(ob)):
            raise Refusal(words)


def _require_no_keys(data):
    """Raises Refusal where keys or drivers would put points back."""
    if point_keys.has(data):
        raise Refusal("its points have keys, which would move them back: use Clear Point Keyframes first")


def _rest(matrix, location, rotation, scale):
    """The rest of a transform when parts of it are taken out. Raises Refusal for a scale of 0."""
    offset, turn, size = matrix.decompose()
    if min(map(abs, size)) == 0.0:
        raise Refusal("it has a scale of 0, which would flatten the shape for ever")
    return Matrix.LocRotScale(None if location else offset, None if rotation else turn, None if scale else size)


def _set_definition(data, definition, matrix):
    """A mirroring has exchanged u and v of patches: so are their resolutions, and the sides that hold."""
    is_exchanged = _exchanges(matrix, definition)
    if is_exchanged:
        settings.exchange_resolutions(data)
    shape.set_definition(data, definition)
    if is_exchanged:
        held.mirror(data)


def _exchanges(matrix, definition):
    return np.linalg.det(matrix[:3, :3]) < 0 and not definition.has_curves


def _exact(matrix):
    return np.array(matrix, dtype=np.float64)


def adopt(data, depsgraph):
    """Take an affine map of the whole mesh or curve, made by others, into the definition, and into what makes it.

    Returns what was lost by that, as a sentence, or "". Raises Refusal where the geometry is not an affine image of what the
    definition shows.
    """
    _require_no_keys(data)
    shape.require_writable(data)
    if not shape.is_touched(data):
        raise Refusal("it is as Splinewright wrote it: there is nothing to adopt")
    matrix = _map_by_others(data)
    known = store.read_stamp(data)
    store.write_stamp(data, stamp.of(data))     # what lies there counts as written from here on
    try:
        if recipes.follows(data):
            if placing.moves_freely(data) and _exchanges(matrix, store.read(data)):
                settings.exchange_resolutions(data)
            follow.take_along(data, matrix, depsgraph)
            return ""
        return _take_in(data, matrix)
    except Exception:
        store.write_stamp(data, known)
        raise


def take_in_applied(ob, depsgraph):
    """adopt() for what Blender's Apply and Set Origin do; what cannot be adopted stays as it is. Returns a sentence or ""."""
    if ob.mode != 'OBJECT' or not shape.has_shape(ob) or not shape.is_touched(ob.data):
        return ""
    try:
        return adopt(ob.data, depsgraph)
    except FAILURES:
        return ""                       # the panel says that it was changed by hand, and what can be done


def _map_by_others(data):
    definition = store.read(data)
    known = store.read_stamp(data)
    is_turned_over = not stamp.same_topology(known, stamp.of(data))
    if is_turned_over and not stamp.same_topology(known, stamp.of_turned_over(data)):
        raise Refusal("its faces or splines were changed, too: {cures}", cures=_CURES)
    before, after = shape.evaluated(data, definition, recipes.around(data)).points.astype(np.float64), shape.points_of(data)
    matrix = transform.affine_between(before, after) if len(before) == len(after) else None
    if matrix is None or is_turned_over and not np.linalg.det(matrix[:3, :3]) < 0:
        raise Refusal("it was not moved as a whole: {cures}", cures=_CURES)
    return matrix


def _take_in(data, matrix):
    moved = transform.transformed(store.read(data), matrix)
    shape.evaluated(data, moved)        # raises before anything is changed
    stored = recipes.read(data)
    if stored and not recipe_edit.take_along(data, matrix, moved):
        recipes.remove(data)
        _set_definition(data, moved, matrix)
        return phrase("{name} has no numbers any more: as {label} it cannot lie like that",
                      name=data.name, label=phrase(stored.recipe.label))
    if not stored:
        _set_definition(data, moved, matrix)
    return ""
