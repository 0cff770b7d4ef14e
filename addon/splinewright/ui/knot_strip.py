"""Where the knots of the active shape are shown in a 3D view, and which of them is at the mouse."""

from typing import NamedTuple

import numpy as np

from ..bridge.analysis import overlays
from ..bridge.data import settings
from ..bridge.data.settings import overlays_of
from ..bridge.shape import shape
from ..core.verbs import knot_strip
from . import active_shape, editing
from .ui_state import ui_state

#: In pixels of an interface that is not scaled: of a bar, with its texts, how high it is and how far its middle lies
#: above its lower end; what is kept free beside it, and below; and how far the ends of the bar lie inside.
ROW, MIDDLE, _MARGIN, _BELOW, _INSET = 42.0, 21.0, 12.0, 8.0, 26.0
#: What a digit of the number of a piece takes.
_DIGIT = 8.0
#: Views that leave less room show none; it goes above the panel of the last operator where that leaves less beside it.
_LEAST, _WISHED = 200.0, 420.0
#: So much is left free for that panel, where there is room, that the strip stays where it is when it comes.
_LAST_OPERATOR = 180.0
#: As near to a knot the mouse is at it.
_NEAR = 7.0


class Box(NamedTuple):
    """In pixels of a region."""

    left: float
    bottom: float
    right: float
    top: float

    def has(self, x, y):
        return self.left <= x <= self.right and self.bottom <= y <= self.top


class Shown(NamedTuple):
    """The bars of a piece in a region. Boxes are the rows around them; a bar is drawn, and dragged along, in its box."""

    ob: object                          # the shape
    number: int                         # of its piece, counted from 1
    count: int                          # of its pieces
    bars: tuple                         # core.verbs.knot_strip.Bars
    spans: tuple                        # from which parameter to which each reaches
    boxes: tuple
    scale: float                        # of the interface

    @property
    def box(self):
        return Box(*np.min(self.boxes, 0)[:2], *np.max(self.boxes, 0)[2:])

    def ends(self, axis):
        """Where a bar begins and ends, in pixels."""
        name = _DIGIT * len(str(self.count)) if self.count > 1 else 0.0
        return self.boxes[axis].left + (_INSET + name) * self.scale, self.boxes[axis].right - _INSET * self.scale

    def places(self, axis):
        """(n,) where the marks of a bar lie, in pixels."""
        left, right = self.ends(axis)
        return left + knot_strip.fractions(self.bars[axis].values, self.spans[axis]) * (right - left)

    def width(self, axis):
        """By how much parameters differ a pixel apart."""
        left, right = self.ends(axis)
        start, end = self.spans[axis]
        return end / (right - left) - start / (right - left)

    def value(self, axis, x):
        """The parameter at a pixel."""
        left, right = self.ends(axis)
        return knot_strip.at_fraction((x - left) / (right - left), self.spans[axis])


class Hit(NamedTuple):
    """The part of a strip at a pixel."""

    shown: Shown
    axis: int
    mark: int                           # the number of the mark there, or None
    value: float                        # its parameter; else that at the pixel, as short as pixels tell it

    @property
    def bar(self):
        return self.shown.bars[self.axis]


class Moved(NamedTuple):
    """A knot that is being moved; bars reach as far as when it began."""

    data: str                           # the name of a data-block
    axis: int
    mark: int
    spans: tuple


class Pointed(NamedTuple):
    """The item at the mouse."""

    region: int                         # as_pointer()
    data: str                           # the name of a data-block
    axis: int
    mark: int                           # or None
    value: float


def is_on(context):
    """Whether the strip is wanted in the current 3D view: where that shows no gizmos, the mouse does not reach it."""
    space = context.space_data
    if space is None or space.type != 'VIEW_3D' or not overlays_of(context.scene).strip:
        return False
    return space.overlay.show_overlays and space.show_gizmo


def shown(context):
    """The Shown of the current 3D view, or None."""
    found = _active_bars(context) if is_on(context) else None
    if found is None:
        return None
    ob, (bars, number, count) = found
    moved = ui_state.moved_knot
    spans = moved.spans if moved and moved.data == ob.data.name else tuple(bar.span for bar in bars)
    scale = context.preferences.system.ui_scale
    boxes = _boxes(context, len(bars), scale)
    return Shown(ob, number, count, bars, spans, boxes, scale) if boxes else None


def hit(context, x, y):
    """The Hit at a pixel of the current region, or None beside the strip."""
    found = shown(context)
    axis = next((i for i, box in enumerate(found.boxes) if box.has(x, y)), None) if found else None
    if axis is None:
        return None
    bar = found.bars[axis]
    mark = knot_strip.nearest(found.places(axis), x, _NEAR * found.scale)
    if mark is not None:
        return Hit(found, axis, mark, float(bar.values[mark]))
    step = knot_strip.step(found.width(axis), 1.0)
    return Hit(found, axis, None, knot_strip.rounded(found.value(axis, x), step))


def pointed(region, hit):
    """The Pointed of a region where that is hit."""
    return Pointed(region.as_pointer(), hit.shown.ob.data.name, hit.axis, hit.mark, hit.value)


def pointed_at(found, region):
    """The Hit at the mouse, of the Shown in a region; None where it is elsewhere, or that is gone."""
    pointed = ui_state.pointed_knot
    if pointed is None or pointed[:2] != (region.as_pointer(), found.ob.data.name) or pointed.axis >= len(found.bars):
        return None
    values = found.bars[pointed.axis].values
    is_there = pointed.mark is None or pointed.mark < len(values) and values[pointed.mark] == pointed.value
    return Hit(found, *pointed[2:]) if is_there else None


def _active_bars(context):
    """(the shape, overlays.bars_of() it), or None."""
    ob, net = context.object, None
    if context.mode != 'OBJECT':
        net = ob if ob in editing.nets_in_edit_mode(context) else None
    owner = active_shape.shape_of(ob) if net else ob
    if not shape.has_shape(owner) or context.mode != 'OBJECT' and net is None:
        return None
    if not owner.visible_get(viewport=context.space_data) or net is None and not owner.select_get():
        return None
    number = _number(owner.data, net)
    bars = overlays.kept(owner.data, 'strip', (number,), overlays.bars_of)
    return (owner, bars) if bars else None


def _number(data, net):
    """Of the active piece; what points of a net say of it is kept until that changes."""
    if net is None:
        return settings.of(data).piece
    return overlays.kept(net.data, 'active piece', (settings.of(data).piece,), lambda *_: active_shape.chosen(data, net)) or 0


def _boxes(context, count, scale):
    """The Box of each bar, u above v, or () where there is no room."""
    left, bottom, right, top = _free_room(context, count * ROW * scale, scale)
    if right - left < _LEAST * scale or bottom + count * ROW * scale > top:
        return ()
    rows = [bottom + i * ROW * scale for i in reversed(range(count))]
    return tuple(Box(left, row, right, row + ROW * scale) for row in rows)


def _free_room(context, height, scale):
    """(left, bottom, right, top) of what other regions leave of the lower end of a view for something so high."""
    region, margin = context.region, _MARGIN * scale
    left, bottom, right, top = 0.0, 0.0, float(region.width), 0.6 * region.height
    over = [(other.type, *_within(other, region)) for other in context.area.regions if _lies_over(other, region)]
    for kind, x, y, width, upper in over:
        if kind == 'TOOLS':
            left = max(left, x + width)
        elif kind == 'UI':
            right = min(right, x)
        elif kind != 'HUD' and y < region.height / 2:
            bottom = max(bottom, upper)
    bottom += _BELOW * scale
    if right - left >= (_LAST_OPERATOR + _WISHED) * scale:
        left += _LAST_OPERATOR * scale
    for kind, x, y, width, upper in over:
        if kind == 'HUD' and y < bottom + height and upper > bottom:
            if right - (x + width) >= _WISHED * scale:
                left = max(left, x + width)
            else:
                bottom = max(bottom, upper)
    return left + margin, bottom, right - margin, top


def _lies_over(other, region):
    """Whether a region is to be seen above the one of the view."""
    return other.type not in ('WINDOW', 'XR') and other.width > 1 and other.height > 1 and (
        other.x < region.x + region.width and other.x + other.width > region.x
        and other.y < region.y + region.height and other.y + other.height > region.y)


def _within(other, region):
    """(left, bottom, width, top) of a region, in pixels of another."""
    return other.x - region.x, other.y - region.y, other.width, other.y - region.y + other.height
