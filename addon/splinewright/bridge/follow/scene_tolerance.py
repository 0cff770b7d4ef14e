"""The tolerance of a scene: what constructions take where none is typed."""

import math

from ...core.base import decimals
from . import recipe_results

AUTOMATIC, OWN = 'AUTOMATIC', 'OWN'
#: An automatic one is at most this part of the largest object, and a power of ten in units of the scene: 0.1 mm for 2 m.
_SHARE = 5e-5
#: Where nothing has a size yet, in meters.
_AT_FIRST = 1e-4


def settings(scene):
    """Its PropertyGroup."""
    return scene.splinewright_tolerance


def of(scene):
    """A length in units of the scene."""
    chosen = settings(scene)
    return decimals.typed(chosen.own) if chosen.by == OWN else automatic(scene)


def automatic(scene):
    """The one that suits the size of the curves and surfaces, a length in units of the scene."""
    size = max((max(ob.dimensions) for ob in scene.objects if recipe_results.is_possible(ob)), default=0.0)
    most = _SHARE * size if 0.0 < size < math.inf else _AT_FIRST / scene.unit_settings.scale_length
    return float(f"1e{math.floor(math.log10(most) + 1e-6)}")
