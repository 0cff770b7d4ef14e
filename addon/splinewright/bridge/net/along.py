"""Radius and tilt of the control points of a net of curves: they lie along the shape, which has them from its points.

Edit Mode's undo knows the net alone. So a state of what lies along a shape has a number there, which goes with the
number that the net carries (settings_number).
"""

import numpy as np

from ...core.base.failures import Refusal
from ...core.net import along
from ...core.verbs import verbs
from ..cage import net_object
from ..curve import curve_layers
from ..data import store, tessellate
from ..recipes import recipes
from ..shape import curve_pieces, shape
from . import selection

_COLUMNS = [curve_layers.NAMES.index(name) for name in ('radius', 'tilt')]


def chosen(ob, net):
    """{number of a piece: numbers of its selected points, as the net counts them} of a net of curves."""
    vertices, found, first = selection.every_selected(ob, net), {}, 0
    for spline in net.splines:
        step = 3 if spline.kind == 'BEZIER' else 1
        own = vertices[(vertices >= first) & (vertices < first + step * spline.count)] - first
        own = own[own % step == step // 2] // step
        if spline.piece >= 0 and len(own):
            found[spline.piece] = own
        first += step * spline.count
    return found


class Gesture:
    """What lies along the shape of a net while the radius and tilt of its selected points change. Raises Refusal where they
    cannot."""

    def __init__(self, ob, net):
        owner = net_object.shape_of(ob)
        if owner is None:
            raise Refusal("the shape of this net was deleted, or is in no scene")
        self.net_data, self.data = ob.data, owner.data
        recipes.require_free(self.data)
        shape.require_writable(self.data)
        shape.require_untouched(self.data)
        self._points = chosen(ob, net)
        self.count = sum(map(len, self._points.values()))
        self._definition = store.read(self.data)
        self.pieces = self.pieces_before = curve_pieces.of(self.data, self._definition)
        self._before = curve_layers.snapshot(self.data)
        curves, shown = verbs.curves_of(self._definition), curve_pieces.shown_of(self.data, self._definition)
        self._held = {piece: [self._held_of(piece, curves[piece], layers, shown[piece]) for layers in self.pieces[piece]]
                      for piece in self._points}

    def _held_of(self, piece, curve, layers, lines):
        """(where it is reported, the core.net.along.Held) of Layers of a piece."""
        steps = tessellate.steps_of(self.data, curve)
        at = np.concatenate([along.places(self._definition, piece, curve, steps), *(line.at for line in lines)])
        at = np.union1d(layers.at, at[(at >= layers.at[0]) & (at <= layers.at[-1])])
        mixtures = tuple(along.mixture(self._definition, piece, curve, at, way) for way in layers.ways)
        return at, along.held(at, layers.there(at)[:, _COLUMNS].astype(np.float64), mixtures)

    def show(self, factor, angle):
        """Radii are multiplied, tilts are turned on."""
        self.pieces = list(self.pieces_before)
        for piece, held in self._held.items():
            self.pieces[piece] = [_changed(layers, at, along.changed(one, self._points[piece], factor, angle))
                                  for layers, (at, one) in zip(self.pieces[piece], held)]
        curve_pieces.write(self.data, self._definition, self.pieces, is_kept=True)

    def put_back(self):
        curve_layers.put(self.data, self._before)


def _changed(layers, at, columns):
    values = layers.there(at)
    values[:, _COLUMNS] = columns
    return layers._replace(at=at, values=values)


def put(data, pieces, new):
    """Let this lie along a shape, and have the number `new`, if it has such pieces."""
    definition = store.read(data)
    if definition is not None and len(definition.pieces) == len(pieces):
        curve_pieces.write(data, definition, pieces, is_kept=True)
    curve_layers.set_number(data, new)
