"""Caps: open ends of surfaces that are closed (lecture row S20)."""

import numpy as np

from ..base import decimals
from ..base.failures import Refusal
from ..base.library import sc
from ..base.words import phrase
from ..surfaces import hollow
from .recipe import Parameter, of_patches

#: Which ends a recipe closes, as a parameter of it.
CHOICES = (("none", "None", "Both ends stay open"), ("start", "Start", "Close the end where it starts"),
           ("end", "End", "Close the end where it ends"), ("both", "Both", "Close both ends"))
PARAMETER = Parameter("caps", "Caps", "Which ends are closed; the normals of a closed surface point outward", "none",
                      choices=CHOICES)
_ENDS = {'none': (), 'start': ('start',), 'end': ('end',), 'both': ('start', 'end')}
_CLOSED = {'start': "the start is closed already", 'end': "the end is closed already"}


def result(patches, caps, error=0.0, said="", cancel=None, warning=""):
    """The Result of patches, each with its own ends, of which `caps` are closed: 'none', 'start', 'end' or 'both'. Raises Refusal
    or an error of the library."""
    if caps == 'none':
        return of_patches(patches, error, said, warning)
    ends = [_ends(patch, len(patches) > 1) for patch in patches]
    chosen = [{name: own[name] for name in _ENDS[caps] if name in own} for own in ends]
    left_open = set().union(*(set(_ENDS[caps]) - set(own) for own in chosen))
    made, bends = [], []
    for number, inside in _holes(patches, chosen).items():
        parts, bend = [patches[number]], 0.0
        if chosen[number]:
            parts, bend = _closed(patches, chosen, [number, *inside], cancel)
        made += parts
        bends.append(bend)
    told = [said, *(phrase(words) for name, words in _CLOSED.items() if name in left_open),
            *bend_in_words(max(bends, default=0.0))]
    return of_patches(made, error, ", ".join(filter(None, told)), warning)


def _closed(patches, chosen, numbers, cancel):
    """(patches, how far rims are from planes): of a patch, and of those that lie within it, which are holes. One hole is closed by
    a ring, where that does."""
    if len(numbers) == 2:
        try:
            return _hollow(patches, chosen, *numbers), 0.0
        except Refusal:
            pass
    ends = [[(place, chosen[number][name]) for place, number in enumerate(numbers)] for name in chosen[numbers[0]]]
    return sc.build.cap([patches[number].to_nurbs() for number in numbers], ends, cancel=cancel)


def _hollow(patches, chosen, number, inside):
    """Patches: one closed round another one that lies within it."""
    both = [hollow.around_u(patches[i].to_nurbs(), next(iter(chosen[i].values()))) for i in (number, inside)]
    found = hollow.hollow(*(patch for patch, _ in both), list(chosen[number]))
    whole = [found.outer, found.inner, *found.rings]
    return [patch.swapped().reversed('u') for patch in whole] if both[0][1] else whole


def _holes(patches, chosen):
    """{the number of a patch: those of the ones in it, which are holes}. Raises Refusal where that is not so at all ends."""
    names = sorted({name for own in chosen for name in own})
    rims = {name: {i: patch.boundary(own[name]) for i, (patch, own) in enumerate(zip(patches, chosen)) if name in own} for name in names}
    within = {name: {(i, k) for i, inner in own.items() for k, rim in own.items() if i != k and hollow.is_within(inner, rim)}
              for name, own in rims.items()}
    if len(set(map(frozenset, within.values()))) > 1:
        raise Refusal("one of its curves lies within another at one end alone: such a hole cannot be capped")
    pairs = next(iter(within.values()), set())
    depths = [sum(i == inner for inner, _ in pairs) for i in range(len(patches))]
    found = {}
    for number in (i for i, depth in enumerate(depths) if depth % 2 == 0):
        found[number] = sorted(inner for inner, rim in pairs if rim == number and depths[inner] == depths[number] + 1)
    return found


def bend_in_words(bend):
    """That rims are in no plane."""
    if bend > 0.0:
        yield phrase("a rim is up to {bend} off a plane: its cap is not flat", bend=decimals.text_of(bend, 2))


def _ends(patch, is_one_of_several):
    """The sides of a patch that alone go around its start and its end, by these names; one that is closed is missing. Raises
    Refusal where its sides go around nothing."""
    patch = patch.to_nurbs()
    open_ends = sc.build.open_ends([patch])
    axis = next((axis for axis, other in (('v', 'u'), ('u', 'v')) if _is_closed_along(patch, other)), "")
    if not axis:
        what = "one of its curves" if is_one_of_several else "what it is made from"
        raise Refusal("{what} is open, so that its ends have no closed rims to cap", what=what)
    sides = {name: f"{axis}_{name}" for name in ('start', 'end')}
    if any(len(end) > 1 for end in open_ends):
        raise Refusal("what it is made from ends only near where it starts: its rims have a gap, and cannot be capped")
    return {name: side for name, side in sides.items() if [(0, side)] in open_ends}


def _is_closed_along(patch, axis):
    """Whether the lines along an axis are closed, to a millionth of the size."""
    if patch.periodic['uv'.index(axis)]:
        return True
    (start, end), across = patch.domain['uv'.index(axis)], np.linspace(*patch.domain['vu'.index(axis)], 9)
    first, last = (patch.evaluate_grid(*(([at], across) if axis == 'u' else (across, [at]))).reshape(-1, 3) for at in (start, end))
    size = float(np.linalg.norm(np.ptp(patch.points[..., :3].reshape(-1, 3), axis=0)))
    return bool(np.abs(first - last).max() <= 1e-6 * size)
