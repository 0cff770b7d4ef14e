"""A shape and its image in a plane, live."""

from dataclasses import replace

import numpy as np

from ..base import decimals
from ..base.failures import Refusal
from ..base.words import phrase
from ..deform import mirroring
from . import wanted
from .recipe import Parameter, Recipe, Result, of_patches
from .surface_recipes import AXIS, axis_of

#: Ends and borders this near to a plane, as a part of the size, lie on it when it is looked for.
_NEAR = 0.01
#: Planes by the axis that stands on them.
_PLANES = {'x': "YZ", 'y': "XZ", 'z': "XY"}


def _mirror(inputs, axis, gap, smooth, frame=None):
    definition, = inputs
    point, direction = axis_of(axis, (0.0, 0.0, 0.0), frame)
    plane = mirroring.Plane(point, direction / np.linalg.norm(direction))
    found = mirroring.mirrored(definition, plane, gap, smooth)
    across = phrase("across the {plane} plane of its origin" if frame is None else "across the {plane} plane of the plane object",
                    plane=_PLANES[axis])
    if not definition.has_curves:
        return of_patches(found.pieces, said=_said(found, True, gap, across))
    return Result(found.pieces if len(found.pieces) > 1 else found.pieces[0], 0.0, _said(found, False, gap, across))


def _said(found, is_surface, gap, across):
    if not found.count:
        yet = phrase("no border lies on the plane within {gap}: the halves are apart" if is_surface else
                     "no end lies on the plane within {gap}: the halves are apart", gap=decimals.text_of(gap, 3))
    elif is_surface:
        yet = phrase("{count} borders on the plane, points moved by {moved}", one="{count} border on the plane, points moved by {moved}",
                     count=found.count, moved=decimals.text_of(found.moved, 2))
    else:
        yet = phrase("{count} ends on the plane, points moved by {moved}", one="{count} end on the plane, points moved by {moved}",
                     count=found.count, moved=decimals.text_of(found.moved, 2))
    return f"{yet}; {across}" + ("; it crosses the plane" if found.across else "")


def _first_values(inputs):
    definition, = inputs
    places = definition.pool[definition.pool[:, 3] != 0.0, :3]
    if not len(places):
        raise Refusal("it has no points")
    size = float(np.linalg.norm(np.ptp(places, axis=0)))
    return {'axis': mirroring.suggested_axis(definition, _NEAR * size)}


RECIPES = (
    Recipe("mirror", "Mirror",
           "A live curve or surface joined with its mirror image, smooth across the plane",
           (replace(AXIS, description="Across which the plane lies: of the plane object, or its own, through the origin"),
            Parameter("gap", "Merge Distance", "How far ends and borders may lie from the plane to be taken onto it", 1e-3, 0.0,
                      unit='LENGTH', of_scene=True),
            Parameter("smooth", "Smooth Across", "Move points next to the plane so that tangent planes and curvatures (G2) "
                                                 "are continuous across it", True)),
           _mirror, is_surface=True, covers_inputs=True, resolution=12, inputs=(wanted.CURVE_OR_SURFACE,), frame="Plane", first_values=_first_values),
)
