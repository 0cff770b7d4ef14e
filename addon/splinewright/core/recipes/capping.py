"""Caps: open ends of surfaces that are closed (lecture row S20)."""

import numpy as np

from .. import decimals, sections
from ..failures import Refusal
from ..library import sc
from .recipe import Parameter, of_patches

#: Which ends a recipe closes, as a parameter of it.
CHOICES = (("none", "None", "Both ends stay open"), ("start", "Start", "Close the end where it starts"),
           ("end", "End", "Close the end where it ends"), ("both", "Both", "Close both ends"))
PARAMETER = Parameter("caps", "Caps", "Which ends are closed; what is closed altogether has its normals outwards", "none",
                      choices=CHOICES)
_ENDS = {'none': (), 'start': ('start',), 'end': ('end',), 'both': ('start', 'end')}


def result(patches, caps, error=0.0, said="", cancel=None):
    """The Result of patches, each with its own ends, of which `caps` are closed: 'none', 'start', 'end' or 'both'. Raises Refusal
    or an error of the library."""
    if caps == 'none':
        return of_patches(patches, error, said)
    made, bends, left_open, rims = [], [], set(), []
    for patch in patches:
        ends = _ends(patch, len(patches) > 1)
        chosen = {name: ends[name] for name in _ENDS[caps] if name in ends}
        left_open |= set(_ENDS[caps]) - set(chosen)
        rims += [(len(made), patch.boundary(side)) for side in chosen.values()]
        parts, bend = [patch], 0.0
        if chosen:
            parts, bend = sc.build.cap([patch], [[(0, side)] for side in chosen.values()], cancel=cancel)
        made += parts
        bends.append(bend)
    _require_apart(rims)
    told = [said, *(f"the {name} is closed already" for name in ('start', 'end') if name in left_open), *bend_in_words(max(bends))]
    return of_patches(made, error, ", ".join(filter(None, told)))


def bend_in_words(bend):
    """That rims are in no plane."""
    if bend > 0.0:
        yield f"a rim is up to {decimals.text_of(bend, 2)} off a plane: its cap is not flat"


def _ends(patch, is_one_of_several):
    """The sides of a patch that alone go round its start and its end, by these names; one that is closed is missing. Raises
    Refusal where its sides go round nothing."""
    patch = patch.to_nurbs()
    open_ends = sc.build.open_ends([patch])
    axis = next((axis for axis, other in (('v', 'u'), ('u', 'v')) if _is_closed_along(patch, other)), "")
    if not axis:
        what = "one of its curves" if is_one_of_several else "what it is made from"
        raise Refusal(f"{what} is open: no rim goes round its ends, so that these cannot be capped")
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


def _require_apart(rims):
    """Raises Refusal where a rim lies within that of another patch in its plane: that would be a hole."""
    for number, rim in rims:
        for other, inner in rims:
            if other != number and _is_within(inner, rim):
                raise Refusal("one of its curves lies within another: a cap with a hole cannot be made")


def _is_within(inner, rim):
    points = sections.samples(rim)[:-1]
    middle = points.mean(axis=0)
    _, spread, axes = np.linalg.svd(points - middle)
    normal, place = axes[2], sections.samples(inner)[5]
    if abs((place - middle) @ normal) > 1e-6 * spread[0]:
        return False
    flat = rim.transformed(_onto(middle, normal))
    point = _onto(middle, normal) @ [*place, 1.0]
    return flat.winding_number(point[:3], normal) != 0


def _onto(middle, normal):
    """(4, 4): onto the plane through a point."""
    matrix = np.eye(4)
    matrix[:3, :3] -= np.outer(normal, normal)
    matrix[:3, 3] = normal * (normal @ middle)
    return matrix
