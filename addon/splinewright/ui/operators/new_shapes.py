"""How finely new shapes are shown, as the user chooses, or else as in the preferences; where they stand, and the report on them."""

import numpy as np
from mathutils import Matrix

from ...bridge.data import settings, store
from ...core.base import decimals
from ...core.base.words import phrase
from .. import preferences
from . import pieces

_RESOLUTIONS = ('resolution_u', 'resolution_v')
_FACES = ('faces_mode', 'faces_tolerance', 'faces_angle')


class Faces:
    """Properties of operators that add surfaces, beside their resolutions."""

    faces_mode: settings.mode_property()
    faces_tolerance: settings.tolerance_property()
    faces_angle: settings.angle_property()


def fill_from_preferences(operator):
    """Take from the preferences what an operator was not given. What Blender remembers of its last call is not given."""
    names = [name for name in (*_RESOLUTIONS, *_FACES) if hasattr(operator, name)]
    given = {name for name in names if operator.properties.is_property_set(name)}
    wanted = _wanted(is_surface=isinstance(operator, Faces))
    if given.intersection(_RESOLUTIONS) and 'faces_mode' in wanted:
        wanted['faces_mode'] = settings.COUNT
    for name in set(names).intersection(wanted) - given:
        setattr(operator, name, wanted[name])


def _wanted(is_surface):
    """The values of the preferences, by names of properties; no resolutions where they are to suit each kind of shape."""
    chosen = preferences.get()
    resolution = chosen.surface_resolution if is_surface else chosen.curve_resolution
    faces = {name: getattr(chosen, name.replace('faces', 'surface')) for name in _FACES} if is_surface else {}
    return {**faces, **(dict.fromkeys(_RESOLUTIONS, resolution) if resolution else {})}


def start(operator):
    """What settings.start() takes, of a settled operator."""
    resolutions = operator.resolution_u, getattr(operator, 'resolution_v', operator.resolution_u)
    if isinstance(operator, Faces):
        return (*resolutions, *(getattr(operator, name) for name in _FACES))
    return resolutions if _is_given(operator) else (*resolutions, settings.AUTOMATIC)


def _is_given(operator):
    return any(hasattr(operator, name) and operator.properties.is_property_set(name) for name in _RESOLUTIONS)


def start_of_any(operator, is_surface):
    """What settings.start() takes, of an operator that adds curves and surfaces and knows of resolutions only."""
    given = {name: getattr(operator, name) for name in _RESOLUTIONS}
    if not _is_given(operator):
        wanted = _wanted(is_surface)
        given.update(wanted)
        if not is_surface and not wanted:
            given['faces_mode'] = settings.AUTOMATIC
    return tuple(given[name] for name in (*_RESOLUTIONS, *_FACES) if name in given)


def draw(operator, layout):
    """The settings of an operator that adds a shape."""
    if not isinstance(operator, Faces):
        layout.prop(operator, "resolution_u", text="Resolution" if _is_given(operator) else "Resolution (Automatic)")
        return
    column = layout.column(align=True)
    column.prop(operator, "faces_mode")
    if operator.faces_mode == settings.COUNT:
        has_v = hasattr(operator, 'resolution_v')
        column.prop(operator, "resolution_u", text="Resolution U" if has_v else "Resolution")
        if has_v:
            column.prop(operator, "resolution_v", text="V")
    if operator.faces_mode in (settings.TOLERANCE, settings.BOTH):
        column.prop(operator, "faces_tolerance")
    if operator.faces_mode in (settings.ANGLE, settings.BOTH):
        column.prop(operator, "faces_angle")


def without_scale(matrix):
    """(the place and turn of an object's matrix alone, the (3, 3) array that takes points of the object's space into that one,
    where distances are those of the scene)."""
    place, turn, _ = matrix.decompose()
    standing = Matrix.LocRotScale(place, turn, None)
    linear = [np.array(each.to_3x3(), dtype=np.float64) for each in (standing, matrix)]
    return standing, np.linalg.solve(*linear)


def said_of(made, error):
    """How many control points new objects have, and how far they are at most from what they were made of, in the scene."""
    count = sum(pieces.points(store.read(ob.data)) for ob in made)
    shapes = phrase("{count} shapes, ", count=len(made)) if len(made) > 1 else ""
    return phrase("{shapes}{count} control points, largest distance {error}",
                  shapes=shapes, count=count, error=decimals.text_of(error, 4))
