"""The radius that users gave the points of a curve, by Alt+S, as a function of its parameter."""

import numpy as np

from ...core.base.failures import Refusal
from ...core.net import along
from ...core.verbs import verbs
from . import curve_pieces, shape

_SEVERAL = "{} consists of {} curves: the radius along one is followed, so join them first"


def along_curve(ob, definition):
    """The curve over the domain of the one piece of a definition, as recipe_results.definition_of() gives it, of which x is
    the radius that an object has there. Raises Refusal where there is none."""
    if not definition.has_curves:
        raise Refusal("{name} is not a curve: it has no radius", name=ob.name)
    if len(definition.pieces) != 1:
        raise Refusal(_SEVERAL.format(ob.name, len(definition.pieces)))
    curve = verbs.curves_of(definition)[0]
    own = _own_of_shape(ob.data, definition, curve) if shape.has_shape(ob) else _own_of_points(ob, definition, curve)
    return along.factor(definition, 0, curve, own)


def _own_of_shape(data, definition, curve):
    """(n,): the radius of each point, as the shape shows them."""
    layers = curve_pieces.of(data, definition)[0][0]
    column = layers.values[:, 0].astype(np.float64)
    return along.held(layers.at, column[:, None], (along.mixture(definition, 0, curve, layers.at, layers.ways[0]),)).own[:, 0]


def _own_of_points(ob, definition, curve):
    """(n,): the radius of each point of Blender's own curve."""
    spline = ob.data.splines[0]
    radii = np.array([point.radius for point in spline.bezier_points or spline.points], np.float64)
    count = len(along.mixture(definition, 0, curve, np.zeros(1)).own)
    if len(ob.data.splines) != 1 or len(radii) != count:
        raise Refusal("{name} has other points than its curve: its radius is not followed. Make it exact first", name=ob.name)
    return radii
