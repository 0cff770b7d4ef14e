"""What recipes are made from, in words, and of which kind that is."""

from typing import NamedTuple


class Input(NamedTuple):
    text: str
    kinds: frozenset = frozenset()      # of 'curve', 'surface' and 'point', one of which is wanted; empty: any

    def accepts(self, kind):
        return kind in self.kinds or not self.kinds


_CURVE, _SURFACE = frozenset({'curve'}), frozenset({'surface'})

ONE_CURVE, ANOTHER_CURVE = Input("one curve", _CURVE), Input("another curve", _CURVE)
MORE_CURVES = Input("more curves", _CURVE)
ONE_SURFACE, ANOTHER_SURFACE = Input("one surface", _SURFACE), Input("another surface", _SURFACE)
SURFACES = Input("one surface or more", _SURFACE)
CURVE_OR_SURFACE = Input("one curve or surface", _CURVE | _SURFACE)
MORE_SECTIONS = Input("more curves, surfaces or points", _CURVE | _SURFACE | {'point'})
MORE, ONE_OBJECT, ONE_MESH = Input("more"), Input("one object"), Input("one mesh")
