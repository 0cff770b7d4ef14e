"""What the switches of the scene show of shapes, worked out when a shape or a number of the switch changes."""

from ...core.analysis import combs, faces, frames, lines, polygon, scales
from ...core.base.failures import FAILURES
from ...core.formulas import labels
from ...core.shape import definition as definitions
from ...core.shape import sewing
from ...core.verbs import knot_strip, verbs
from ..data import settings, store, tessellate
from ..data.file_state import key, remember, state
from ..recipes import recipes

#: Shapes of which something is kept.
_KEPT = 512


def kept(data, what, numbers, make):
    """What make(data, *numbers) gave for a data-block as it is now; None where it cannot be made."""
    name = key(data)
    known = state.sights.get(name)
    if known is None:
        known = remember(state.sights, name, {}, _KEPT)
    numbers = (data.as_pointer(), *numbers)     # another may have been given its name
    if what not in known or known[what][0] != numbers:
        try:
            known[what] = numbers, make(data, *numbers[1:])
        except FAILURES:
            known[what] = numbers, None
    return known[what][1]


def is_known(data, what, numbers):
    """Whether kept() has it."""
    return state.sights.get(key(data), {}).get(what, ((),))[0] == (data.as_pointer(), *numbers)


def polygon_of(data):
    """The core.analysis.polygon.Polygon of a definition."""
    return polygon.of(store.read(data))


def labels_of(data):
    """The core.formulas.labels.Labels of a definition."""
    return labels.of(store.read(data))


def axes_of(data):
    """The core.analysis.scales.Scale of a definition."""
    return scales.of(store.read(data))


def curves_of(data):
    """(n, 2, 3): the lines of curves."""
    chosen = settings.of(data)
    return lines.curves(verbs.curves_of(store.read(data)), chosen.resolution_u, chosen.reach, recipes.around(data))


def comb_of(data, density, scale):
    """The core.analysis.combs.Comb of curves."""
    return combs.of(verbs.curves_of(store.read(data)), density, scale)


def frames_of(data, part, length):
    """The core.analysis.frames.Frame of curves."""
    return frames.frames(verbs.curves_of(store.read(data)), part, length)


def hodographs_of(data, part, scale):
    """The core.analysis.frames.Hodograph of curves."""
    return frames.hodographs(verbs.curves_of(store.read(data)), part, scale)


def normals_of(data, count, length):
    """(n, 2, 3): normals of patches."""
    return lines.normals(sewing.patches_of(store.read(data)), count, length)


def knots_of(data):
    """Points (n, 3) of curves, lines (n, 2, 3) of patches."""
    definition = store.read(data)
    if definition.has_curves:
        return lines.knots_of_curves(verbs.curves_of(definition))
    return lines.knots_of_patches(sewing.patches_of(definition))


def bars_of(data, number):
    """(the core.verbs.knot_strip.Bars of a piece counted from 1, of the first where there are fewer; its number; how many
    there are)."""
    pieces = store.read(data).pieces
    number = number if 1 <= number <= len(pieces) else 1
    return knot_strip.bars_of(pieces[number - 1]), number, len(pieces)


def faces_of(data, value=None):
    """The core.analysis.faces.Faces of patches: shaded() ones, or those that are colored() by a value."""
    patch_set = definitions.to_patch_set(store.read(data))
    tessellation = tessellate.tessellated(data, patch_set)
    return faces.colored(tessellation, patch_set, value) if value else faces.shaded(tessellation, patch_set)


def isocurves_of(data, count):
    """(n, 2, 3): a given number of lines in every span of patches."""
    return lines.isocurves(sewing.patches_of(store.read(data)), count)
