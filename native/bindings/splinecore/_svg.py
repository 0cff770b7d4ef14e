"""What notebooks show of curves, patches and sets: a small SVG each, in colors for light and dark pages."""

from textwrap import wrap
from xml.sax.saxutils import escape

import numpy as np

from . import _cubics
from ._splinecore import Error, HermiteCurve, PatchSet

#: Ten units are a pixel; the longest side of the drawing.
_LONGEST, _MARGIN = 3000, 120
#: So much is drawn at most, so that a picture stays small.
_SEGMENTS, _CONTROL_POINTS, _OUTLINES = 140, 160, 150
#: To the right and up, of one who looks from the front, the right and above.
_VIEW = np.array([[0.8660254037844386, 0.5, 0.0], [-0.25, 0.4330127018922193, 0.8660254037844386]])
_CURVE, _NET = "#2b83d6", "#8a8a8a"


def curve(shape):
    """The curve with its control polygon, or with the tangents of a Hermite chain."""
    return _guarded(shape, _curve)


def surface(shape):
    """Borders and isocurves of a patch or of the patches of a set."""
    return _guarded(shape, _surface)


def region(shape):
    """The outlines of a region, its inside shaded."""
    return _guarded(shape, _region)


def _guarded(shape, draw):
    try:
        with np.errstate(all="ignore"):
            return draw(shape)
    except Error as error:
        return _document(shape, [], (_LONGEST, 0), ["not drawn:", *wrap(str(error), 44)])


def _curve(shape):
    notes = []
    count = len(_cubics.bounds_of(shape)) - 1
    if count > _SEGMENTS:
        notes.append(f"{count} spans drawn as {_cubics.MORE_LINES * _SEGMENTS} lines")
    segments = _cubics.cubics(shape, _SEGMENTS)
    if isinstance(shape, HermiteCurve):
        net = np.concatenate([segments[:, :2], segments[:, :1:-1]]) if count <= _SEGMENTS else np.empty((0, 2, 3))
    else:
        net = _cubics.control_polygon(shape)[None] if hasattr(shape, "points") else np.empty((0, 2, 3))
    if net.size > 3 * _CONTROL_POINTS * (2 if isinstance(shape, HermiteCurve) else 1):
        notes.append(f"{len(shape.points)} control points not drawn")
        net = np.empty((0, 2, 3))
    points = np.concatenate([segments.reshape(-1, 3), net.reshape(-1, 3)])
    seen, size = _placed(points, is_flat=_is_flat(points))
    path = _curve_path(seen[:4 * len(segments)].reshape(-1, 4, 2))
    net = seen[4 * len(segments):].reshape(*net.shape[:2], 2)
    ends = net.reshape(-1, 2) if len(net) else seen[:4 * len(segments)].reshape(-1, 4, 2)[:, ::3].reshape(-1, 2)[[0, -1]]
    layers = [_stroke(_lines_path(net), _NET, 8), _stroke(path, _CURVE, 20), _stroke(_dots_path(ends), _NET, 50)]
    return _document(shape, layers, size, notes)


def _region(shape):
    outlines = [_cubics.cubics(outline, _SEGMENTS) for outline in shape.outlines]
    segments = np.concatenate(outlines) if outlines else np.empty((0, 4, 3))
    points = segments.reshape(-1, 3)
    seen, size = _placed(points, is_flat=_is_flat(points)) if outlines else (points[:, :2], (0, 0))
    rows = np.split(seen.reshape(-1, 4, 2), np.cumsum([len(outline) for outline in outlines])[:-1]) if outlines else []
    path = "".join(_curve_path(row) + "z" for row in rows)
    inside = f'<path d="{path}" fill="{_CURVE}" fill-opacity=".2" fill-rule="evenodd"/>' if path else ""
    return _document(shape, [inside, _stroke(path, _CURVE, 20)], size, [] if outlines else ["empty"])


def _surface(shape):
    patches = [shape[i] for i in _chosen(len(shape))] if isinstance(shape, PatchSet) else [shape]
    notes = [f"{len(patches)} of {len(shape)} patches drawn"] if isinstance(shape, PatchSet) and len(patches) < len(shape) else []
    share = len(patches) ** -0.5
    strips = max(1, round(8 * share))
    places = np.linspace(0, 1, strips * max(2, round(40 * share / strips)) + 1)
    drawn = [_outline_and_inner(patch, places, strips) for patch in patches]
    outlines, inner = [outline for outline, _ in drawn], [line for _, lines in drawn for line in lines]
    seen, size = _placed(np.concatenate(outlines + inner), is_flat=False)
    rows = np.split(seen, np.cumsum([len(line) for line in outlines + inner])[:-1])
    layers = [_stroke(_lines_path(rows[len(outlines):]), _CURVE, 7), _stroke(_lines_path(rows[:len(outlines)]), _CURVE, 14)]
    return _document(shape, layers, size, notes)


def _chosen(count):
    return range(count) if count <= _OUTLINES else np.linspace(0, count - 1, _OUTLINES).astype(int).tolist()


def _outline_and_inner(patch, places, strips):
    """The four sides, one after the other, and the isocurves that part a patch into strips."""
    knots = getattr(patch, "knots", getattr(patch, "parameters", ((), ())))
    (u, at_u), (v, at_v) = (_sampled(*given, places, strips) for given in zip(patch.domain, knots))
    grid = _grid(patch, u, v)
    outline = np.concatenate([grid[:, 0], grid[-1, 1:], grid[-2::-1, -1], grid[0, -2::-1]])
    return outline, [*grid[at_u], *grid[:, at_v].swapaxes(0, 1)]


def _sampled(domain, knots, places, strips):
    """Parameters along u or v, breaks among them, and where those of isocurves stand in them."""
    start, end = domain
    even = start + (end - start) * places
    even[-1] = end
    breaks = np.array([knot for knot in dict.fromkeys(knots) if start < knot < end]) if 2 < len(knots) <= len(places) else ()
    steps = (len(places) - 1) // strips
    if len(breaks) == 0:
        return even, range(steps, len(places) - 1, steps)
    every = np.unique(np.concatenate([even, breaks]))
    return every, np.searchsorted(every, even[steps:-1:steps])


def _grid(patch, u, v):
    """Points of a patch, nan where they are far from its control points on the way to infinity."""
    points = patch.evaluate_grid(u, v, at_infinity="nan")
    if _cubics.reaches_infinity(patch):
        control = _cubics.finite_points(patch)
        low, high = np.nanmin(control, axis=0), np.nanmax(control, axis=0)
        reach = (high / 2 - low / 2).max() or np.nanmax(np.abs(control)) or 1.0
        points[((points < low - reach) | (points > high + reach)).any(axis=-1)] = np.nan
    return points


def _is_flat(points):
    z = points[np.isfinite(points).all(axis=1), 2]
    return len(z) == 0 or bool(np.all(z == z[0]))


def _placed(points, is_flat):
    """Whole numbers (n, 2), y downward, nan where a point is not finite, and (width, height) of their box."""
    points = np.where(np.isfinite(points).all(axis=1, keepdims=True), points, np.nan)
    if np.isnan(points).all():
        return points[:, :2], (0, 0)
    points = points / (np.nanmax(np.abs(points)) or 1.0)
    seen = (points[:, :2] if is_flat else points @ _VIEW.T) * (1, -1)
    low, high = np.nanmin(seen, axis=0), np.nanmax(seen, axis=0)
    scale = (high - low).max() or 1.0
    return np.rint((seen - low) / scale * _LONGEST), np.rint((high - low) / scale * _LONGEST).astype(int)


def _numbers(values):
    return " ".join(map(str, values)).replace(" -", "-")


def _curve_path(segments):
    """Cubic segments, and straight ones shorter."""
    parts, at = [], None
    for is_straight, (a, *rest) in zip(_are_straight(segments), segments.astype(int).tolist()):
        if at != a:
            parts.append(f"M{_numbers(a)}")
        at = rest[-1]
        ends = [value - a[i] for point in (rest[-1:] if is_straight else rest) for i, value in enumerate(point)]
        parts.append(("l" if is_straight else "c") + _numbers(ends))
    return "".join(parts)


def _are_straight(segments):
    thirds = segments[:, :1] + (segments[:, 3:] - segments[:, :1]) * np.array([1 / 3, 2 / 3])[:, None]
    return (np.abs(segments[:, 1:3] - thirds) < 2).all(axis=(1, 2))


def _lines_path(rows):
    """Polylines, broken where a point is nan; points of a straight line are left out."""
    parts = []
    for part in (part for row in rows for part in _finite_parts(row)):
        points = _turns(part).astype(int)
        steps = (points[1:] - points[:-1]).ravel().tolist()
        parts.append(f"M{_numbers(points[0].tolist())}l{_numbers(steps)}")
    return "".join(parts)


def _finite_parts(row):
    ok = np.isfinite(row[:, 0])
    parts = [row] if ok.all() else np.split(row, np.flatnonzero(ok[1:] != ok[:-1]) + 1)
    return [part for part in parts if len(part) > 1 and np.isfinite(part[0, 0])]


def _turns(points):
    """A row's ends alone where all of it is on the line between them."""
    along = points[-1] - points[0]
    off = points - points[0]
    length = np.hypot(*along)
    is_line = length > 0 and np.abs(off[:, 0] * along[1] - off[:, 1] * along[0]).max() <= length
    return points[[0, -1]] if is_line and (np.diff(off @ along) >= 0).all() else points


def _dots_path(points):
    """Lines without length, whose round ends are dots."""
    found = np.unique(points[np.isfinite(points).all(axis=1)], axis=0).astype(int).tolist()
    return "".join(f"M{_numbers(point)}h0" for point in found)


def _stroke(path, color, width):
    return f'<path d="{path}" stroke="{color}" stroke-width="{width}"/>' if path else ""


def _document(shape, layers, size, notes):
    """The picture, with notes on the parts that are not drawn below it."""
    width, height = (int(side) + 2 * _MARGIN for side in size)
    width = max(width, 2600) if notes else width
    rows = "".join(f'<text x="{_MARGIN - 100}" y="{height + 160 * i}" font-size="120" fill="{_NET}">{escape(note)}</text>'
                   for i, note in enumerate(notes))
    height += 160 * len(notes)
    return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{width / 10:g}" height="{height / 10:g}" '
            f'viewBox="{-_MARGIN} {-_MARGIN} {width} {height}"><title>{escape(repr(shape))}</title>'
            f'<g fill="none" stroke-linecap="round" stroke-linejoin="round">{"".join(layers)}</g>{rows}</svg>')
