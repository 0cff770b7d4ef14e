"""Conics: rational quadratic curves and their equations (lecture rows S1, S10, S11)."""

from ._splinecore import conics as _conics

ImplicitConic = _conics.ImplicitConic
arc = _conics.arc
arc_about = _conics.arc_about
arc_from_tangent = _conics.arc_from_tangent
arc_through = _conics.arc_through
as_hermite = _conics.as_hermite
by_foci = _conics.by_foci
circle = _conics.circle
class_of = _conics.class_of
conic_arc = _conics.conic_arc
ellipse = _conics.ellipse
from_implicit = _conics.from_implicit
hyperbola = _conics.hyperbola
implicit = _conics.implicit
parabola = _conics.parabola
through_points = _conics.through_points

__all__ = [
    "ImplicitConic",
    "arc",
    "arc_about",
    "arc_from_tangent",
    "arc_through",
    "as_hermite",
    "by_foci",
    "circle",
    "class_of",
    "conic_arc",
    "ellipse",
    "from_implicit",
    "hyperbola",
    "implicit",
    "parabola",
    "through_points",
]

ImplicitConic.__module__ = __name__
