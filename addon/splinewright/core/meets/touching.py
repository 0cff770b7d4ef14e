"""Circles that touch three curves of a plane (lecture row S18)."""

from itertools import product
from typing import NamedTuple

import numpy as np

from ..base.failures import Refusal
from ..base.library import sc
from . import plane_fit

#: Places of each curve from which circles are looked for, and how near, as a part of their radius, two are one.
_STARTS, _SAME = 5, 1e-6


class Circle(NamedTuple):
    """One that touches three curves."""

    arc: object                 # from where it touches the first through the second to the third
    center: np.ndarray
    radius: float
    normal: np.ndarray


def circles(a, b, c, cancel=None):
    """The Circles that are found from places all along three curves, the smallest first. Raises Refusal where there are
    none."""
    normal, found = plane_fit.normal_of([a, b, c]), []
    starts = [np.linspace(*curve.domain, _STARTS + 2)[1:-1] for curve in (a, b, c)]
    for near in product(*starts):
        if cancel is not None and cancel():
            raise sc.Cancelled("the call was cancelled")
        try:
            arc, center, radius, _ = sc.build.touching_circle(a, b, c, near, normal)
        except sc.InvalidShape:
            continue                    # there is none from there
        if not any(abs(radius - one.radius) + np.linalg.norm(center - one.center) <= _SAME * radius for one in found):
            found.append(Circle(arc, center, radius, normal))
    if not found:
        raise Refusal("no circle touches the three curves")
    return sorted(found, key=lambda one: one.radius)
