"""Shapes that recipes make for scripts: settings are exact, and inputs keep the order in which they are given."""

from contextlib import suppress

import numpy as np

from ...core.base.failures import FAILURES, Refusal, WrongKind
from ...core.base.words import phrase
from ..data import settings
from ..shape import recipe_edit, shape
from . import follow, recipe_results, scene_tolerance


def from_objects(recipe, sources, given, frame, scene, depsgraph):
    """A new object, in no scene, that a recipe makes from objects.

    given: values of parameters by name; frame: the object of which the place and axes count, or None. Raises Refusal or an
    error of the library.
    """
    _require_inputs(recipe, sources, frame, depsgraph)
    suggested = _suggested(recipe, sources, depsgraph) if recipe.first_values and frame is None else {}
    values = recipe.completed(given, scene_tolerance.of(scene), suggested)
    frames = (frame,) if frame is not None else ()
    sources, frames = ((), tuple(sources)) if recipe.has_places else (sources, frames)
    return follow.new_object(recipe, values, sources, _start(recipe), depsgraph, frames)


def from_points(recipe, points, given, scene):
    """A new Mesh or Curve that a recipe makes of numbers and points (n, 3), or of those that it starts from for None. Raises as
    from_objects()."""
    values = recipe.completed(given, scene_tolerance.of(scene))
    points = recipe.start_for(values) if points is None else points_for(recipe, points, values)
    return recipe_edit.new_data(recipe.label, recipe, values, points, _start(recipe))


def _start(recipe):
    """What settings.start() takes: as many steps as the recipe says count as soon as the user counts."""
    return recipe.resolution, recipe.resolution, settings.AUTOMATIC


def points_for(recipe, points, values):
    """Points (n, 3) as the recipe takes them with these values of its parameters. Raises WrongKind or Refusal."""
    points = np.array(points, dtype=np.float64)
    if points.ndim != 2 or points.shape[1] != 3:
        raise WrongKind("points have the shape {shape}: (n, 3) is expected", shape=points.shape)
    if not np.isfinite(points).all():
        raise Refusal("a point is not finite")
    if not recipe.points:
        raise Refusal("{label} is made from numbers alone: it takes no points", label=phrase(recipe.label))
    count = len(recipe.start_for(values))
    if not recipe.can_gain_points and len(points) != count:
        raise Refusal("{label} takes {count} points, not {given}",
                      "{label} takes {count} point, not {given}", label=phrase(recipe.label), count=count, given=len(points))
    return points


def _require_inputs(recipe, sources, frame, depsgraph):
    if frame is not None and not recipe.frame:
        raise Refusal("{label} has no axis that an object could give", label=phrase(recipe.label))
    if recipe.has_places:
        if len(sources) < 2:
            raise Refusal("{label} takes two objects or more", label=phrase(recipe.label))
    elif not recipe.takes(len(sources)):
        raise Refusal("{label} is made from {wanted}", label=phrase(recipe.label), wanted=phrase(recipe.wanted))
    else:
        for source in sources:
            if not recipe_results.can_make(recipe, source):
                raise Refusal("{name} cannot be an input: {label} is made from {wanted}",
                              name=source.name, label=phrase(recipe.label), wanted=phrase(recipe.wanted))
    for ob in (*sources, *filter(None, [frame])):
        if not shape.is_shown(ob, depsgraph):
            raise Refusal("{name} is hidden, or is not in this view layer: show it first", name=ob.name)


def _suggested(recipe, sources, depsgraph):
    """What cannot be read is refused where it is used."""
    with suppress(*FAILURES):
        return recipe.first_values(recipe_results.inputs_of(recipe, sources, follow.first_space(sources, depsgraph)))
    return {}
