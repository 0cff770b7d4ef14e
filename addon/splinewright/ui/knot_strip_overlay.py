"""Over the 3D view: the knots of the active shape on bars along its lower end."""

from typing import NamedTuple

import blf
import bpy
import gpu
import numpy as np
from gpu_extras.batch import batch_for_shader

from ..bridge.analysis import overlays
from ..core.verbs import knot_strip
from . import knot_strip as strip
from . import colors, hints
from .ui_state import ui_state

#: In pixels of an interface that is not scaled.
_SIZE, _GAP, _EDGE, _TEXT_ABOVE, _TEXT_BELOW = 11.0, 8.0, 3.0, 9.5, -17.0
#: Where the name of an axis stands, from the left end of its box and the middle of its bar.
_NAME = 4.0, -4.0
_BAR, _TICK, _WIDER, _HALF = 4.0, 3.0, 1.5, 7.0
#: Marks of knots that stand there more often are no wider.
_WIDEST = 5
#: Outside the domain this part is seen of a bar and its marks.
_FADED = 0.4


class Text(NamedTuple):
    """In pixels of a region."""

    words: str
    x: float
    y: float
    color: tuple


class Picture(NamedTuple):
    """Drawings kept until something changes."""

    batch: gpu.types.GPUBatch
    texts: tuple


def draw():
    """Called by Blender for each 3D view."""
    context = bpy.context
    found = strip.shown(context)
    if found is None:
        if ui_state.pointed_knot and ui_state.pointed_knot.region == context.region.as_pointer():
            ui_state.pointed_knot = None   # the strip went away below the mouse
            hints.redraw(context)
        return
    looks = found.boxes, found.spans, found.scale, colors.of_net(), _moved(found)
    picture = overlays.kept(found.ob.data, ('strip picture', context.region.as_pointer()), (found.number, *looks),
                          lambda *_: _picture(found, *looks[3:]))
    if picture is not None:
        _draw(picture, found.scale)
    hit = strip.pointed_at(found, context.region)
    if hit is not None and ui_state.moved_knot is None:
        _draw_at_mouse(hit)


def _draw_at_mouse(hit):
    """The mark at the mouse, or where on the bar a knot would be inserted, above the others."""
    shown, bar, scale = hit.shown, hit.bar, hit.shown.scale
    left, right = shown.ends(hit.axis)
    x = left + float(knot_strip.fractions(hit.value, shown.spans[hit.axis])) * (right - left)
    if not left - 1 <= x <= right + 1:
        return
    middle = _middle(shown, hit.axis)
    is_mark = hit.mark is not None
    color = colors.of_selected() if is_mark else (*colors.of_selected()[:3], 0.6)
    texts = knot_strip.number(bar, hit.value), knot_strip.words(bar, hit.mark) if is_mark else ""
    blf.size(0, _SIZE * scale)
    quads = [_tick(x, middle, scale, bar.counts[hit.mark] if is_mark else 1, color)]
    written = []
    for words, above in zip(texts, (_TEXT_BELOW, _TEXT_ABOVE)):
        if words:
            width = blf.dimensions(0, words)[0]
            at = _between(shown.box, x - width / 2, width)
            y = middle + above * scale
            edge = _EDGE * scale
            quads.append((at - edge, y - edge, at + width + edge, y + _SIZE * scale, colors.STRIP_LABEL))
            written.append(Text(words, at, y, (*color[:3], 1.0)))
    _draw(Picture(_batch(quads), tuple(written)), scale)


def top(context):
    """Up to where a strip reaches in the current view; 0 where there is none."""
    found = strip.shown(context)
    return found.box.top if found else 0.0


def _moved(found):
    """(axis, mark) of the knot of a shape that is being moved, or None."""
    moved = ui_state.moved_knot
    return (moved.axis, moved.mark) if moved and moved.data == found.ob.data.name else None


def _picture(found, of_axes, moved):
    blf.size(0, _SIZE * found.scale)
    quads, texts = [(*found.box, colors.STRIP)], []
    for axis, bar in enumerate(found.bars):
        places = found.places(axis)
        color = of_axes[axis]
        quads += _bar(found, axis, places, color)
        quads += _ticks(found, axis, places, moved)
        texts += _texts(found, axis, places, moved)
        texts.append(_name(found, axis, color))
    return Picture(_batch(quads), tuple(filter(None, texts)))


def _middle(found, axis):
    return found.boxes[axis].bottom + strip.MIDDLE * found.scale


def _bar(found, axis, places, color):
    """The domain, and what of the bar lies outside."""
    middle, half = _middle(found, axis), _BAR / 2 * found.scale
    start, end = places[list(found.bars[axis].domain)]
    faded = (*color[:3], _FADED)
    for left, right, of_part in ((places[0], start, faded), (start, end, color), (end, places[-1], faded)):
        if right > left:
            yield left, middle - half, right, middle + half, of_part


def _ticks(found, axis, places, moved):
    """Their rims first, which lie below all of them."""
    bar, middle = found.bars[axis], _middle(found, axis)
    left, right = found.ends(axis)
    shown = [i for i in _told_apart(places) if left - 1 <= places[i] <= right + 1]
    for color, rim in ((colors.RIM, 1.0), (colors.KNOTS, 0.0)):
        for i in shown:
            of_mark = color if knot_strip.is_inside(bar, i) else (*color[:3], _FADED)
            of_mark = colors.of_selected() if moved == (axis, i) and not rim else of_mark
            yield _tick(places[i], middle, found.scale, bar.counts[i], of_mark, rim)


def _told_apart(places):
    """Numbers of the marks that do not lie in one pixel with the one before."""
    pixels = np.floor(places)
    return np.flatnonzero(np.diff(pixels, prepend=pixels[0] - 1) != 0).tolist()


def _tick(x, middle, scale, count, color, rim=0.0):
    half = (_TICK + _WIDER * (min(int(count), _WIDEST) - 1)) / 2 * scale + rim
    high = _HALF * scale + rim
    return x - half, middle - high, x + half, middle + high, color


def _texts(found, axis, places, moved):
    """Numbers below the bar, multiplicities and continuities above; where they would overlap, those that tell most."""
    bar, middle, box = found.bars[axis], _middle(found, axis), found.boxes[axis]
    first = [moved[1]] if moved and moved[0] == axis else []
    meant = {*_told_apart(places), *bar.domain, *first}
    order = [i for i in dict.fromkeys(first + knot_strip.by_weight(bar)) if i in meant]
    for of_mark, above in ((lambda i: knot_strip.number(bar, float(bar.values[i])), _TEXT_BELOW),
                           (lambda i: knot_strip.words(bar, i), _TEXT_ABOVE)):
        words = [of_mark(i) for i in order]
        widths = [blf.dimensions(0, text)[0] if text else 0.0 for text in words]
        lefts = [_between(box, places[i] - width / 2, width) for i, width in zip(order, widths)]
        is_shown = knot_strip.thinned(lefts, [width + _GAP * found.scale for width in widths])
        for k in np.flatnonzero(is_shown).tolist():
            color = colors.STRIP_TEXT if knot_strip.is_inside(bar, order[k]) else colors.STRIP_FADED
            color = colors.of_selected() if order[k] in first else color
            if words[k]:
                yield Text(words[k], lefts[k], middle + above * found.scale, color)


def _between(box, left, width):
    """Where a text begins that is to stay inside a box."""
    return max(min(left, box.right - width - 2), box.left + 2)


def _name(found, axis, color):
    """Of the axis of a patch, and of which piece it is where there are several."""
    words = found.bars[axis].name
    if found.count > 1 and axis == 0:
        words = f"{found.number} {words}".strip()
    left = found.boxes[axis].left
    place = left + _NAME[0] * found.scale, _middle(found, axis) + _NAME[1] * found.scale
    return Text(words, *place, color) if words else None


def _batch(quads):
    """Of (left, bottom, right, top, color)."""
    corners = [corner for left, bottom, right, top, _ in quads
               for corner in ((left, bottom, 0), (right, bottom, 0), (right, top, 0), (left, top, 0))]
    of_corners = [color for *_, color in quads for _ in range(4)]
    indices = [(4 * i + a, 4 * i + b, 4 * i + c) for i in range(len(quads)) for a, b, c in ((0, 1, 2), (0, 2, 3))]
    shader = gpu.shader.from_builtin('SMOOTH_COLOR')
    content = {'pos': np.array(corners, np.float32), 'color': np.array(of_corners, np.float32)}
    return batch_for_shader(shader, 'TRIS', content, indices=indices)


def _draw(picture, scale):
    gpu.state.blend_set('ALPHA')
    picture.batch.draw(gpu.shader.from_builtin('SMOOTH_COLOR'))
    blf.size(0, _SIZE * scale)
    for text in picture.texts:
        blf.color(0, *text.color)
        blf.position(0, text.x, text.y, 0)
        blf.draw(0, text.words)
    gpu.state.blend_set('NONE')
