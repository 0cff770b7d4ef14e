"""What lies along the curves of a shape, carried over to the curves that came of them."""

import numpy as np

from ...core.shape import polylines
from ...core.verbs import verbs
from ..curve import curve_layers
from ..curve.curve_layers import Layers
from ..data import settings
from ..data.shading import Look
from ..recipes import recipes
from . import shape

_NONE = Layers(Look(), np.array([0.0, 1.0]), np.tile(curve_layers.PLAIN, (2, 1)))
_TILT = curve_layers.NAMES.index('tilt')
#: Parts of a domain that differ by less are one place.
_ROUNDING = 1e-9


def of(data, definition):
    """For each piece of the definition that a Curve shows a list of Layers, over parts of its domain: those of the
    splines that show it, in their order. Plain ones where the Curve shows something else."""
    shown = shown_of(data, definition)
    known, lines = curve_layers.kept(data), [line for piece in shown for line in piece]
    if [len(line.at) for line in lines] != [len(spline.points) for spline in data.splines]:
        known = [_NONE] * len(lines)
    splines = iter(known)
    return [[_over_domain(next(splines), line) for line in piece] for piece in shown]


def shown_of(data, definition):
    """For each piece of a definition the core.shape.polylines.Lines by which a Curve shows it."""
    found, around = [], recipes.around(data)
    for curve in verbs.curves_of(definition):
        counts = [(len(points), closed) for points, closed in shape.lines_of(data, curve, around)]
        found.append(polylines.lines(curve, counts, settings.of(data).reach if around is None else None))
    return found


def _over_domain(layers, line):
    ends = np.append(line.at, line.end) if line.closed else line.at
    return layers._replace(at=np.interp(layers.at, np.linspace(0.0, 1.0, len(ends)), ends))


def carried(pieces, changed):
    """What of() gives for the pieces of a core.verbs.verbs.Changed definition, from what it gave for those that they came of."""
    return [_chains([(origin.piece == parent, part) for origin in mine for stretch in origin.stretches
                     for layers in pieces[origin.piece] for part in _on_stretch(layers, stretch)])
            for parent, mine in zip(changed.parents, changed.origins)]


def _on_stretch(layers, stretch):
    """[what of the Layers lies on a core.shape.places.Stretch, where that lies now]; [] if nothing does."""
    first, last = max(stretch.start, layers.at[0]), min(stretch.end, layers.at[-1])
    if last - first <= _ROUNDING:
        return []
    at = np.concatenate([[first], layers.at[(layers.at > first) & (layers.at < last)], [last]])
    now, values = stretch.of(at), layers.there(at)
    if stretch.first > stretch.last:
        now, values = now[::-1], values[::-1] * np.where(np.arange(values.shape[1]) == _TILT, -1, 1).astype(np.float32)
    return [layers._replace(at=now, values=values)]


def _chains(parts):
    """Those that continue one another as one. parts: pairs of whether it came from the parent, and Layers."""
    chains = []
    for part in sorted(parts, key=lambda part: part[1].at[0]):
        if chains and part[1].at[0] - chains[-1][-1][1].at[-1] <= _ROUNDING:
            chains[-1].append(part)
        else:
            chains.append([part])
    return list(map(_chain, chains))


def _chain(parts):
    """The look is that of the longest part, if it can be of one from the parent."""
    _, longest = max(parts, key=lambda part: (part[0], part[1].at[-1] - part[1].at[0]))
    return longest._replace(at=np.concatenate([part.at for _, part in parts]),
                            values=np.concatenate([part.values for _, part in parts]))


def _over_spline(layers, line):
    """_over_domain() the other way round, from end to end."""
    ends = np.append(line.at, line.end) if line.closed else line.at
    at = np.union1d(layers.at[(layers.at > ends[0]) & (layers.at < ends[-1])], ends)
    return layers._replace(at=np.interp(at, ends, np.linspace(0.0, 1.0, len(ends))), values=layers.there(at))


def regrown(pieces, before, after):
    """What of() gives for the pieces of a definition whose curves have gained or lost spans, and go by the same parameter."""
    found = []
    for layers, was, now in zip(pieces, verbs.curves_of(before), verbs.curves_of(after)):
        (start, end), (first, last) = was.domain, now.domain
        found.append([each._replace(at=(start + each.at * (end - start) - first) / (last - first)) for each in layers])
    return found


def write(data, definition, pieces, is_kept=False):
    """Give the splines by which a Curve shows a definition what of() gave for its pieces. is_kept: what lies between their
    points counts where they get others."""
    lines = [(line, layers) for piece, layers in zip(shown_of(data, definition), pieces) for line in piece]
    if [len(line.at) for line, _ in lines] != [len(spline.points) for spline in data.splines]:
        return
    found = []
    for spline, (line, layers) in zip(data.splines, lines):
        nearest = min(layers or [_NONE], key=lambda each: each.distance(line.at[len(line.at) // 2]))
        if is_kept:
            nearest = _over_spline(nearest, line)
        found.append(nearest)
        at = curve_layers.fractions(len(line.at), line.closed) if is_kept else line.at
        curve_layers.write(spline, nearest, nearest.there(at))
    curve_layers.forget(data)
    if is_kept:
        curve_layers.remember(data, found)
    data.update_tag()
