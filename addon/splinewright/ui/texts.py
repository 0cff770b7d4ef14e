"""Sentences in a layout, broken into lines."""

import textwrap

import blf
import bpy

from ..core.base.words import say

#: Characters that fit a line where no region is drawn.
WIDTH = 23
#: Characters of a name beside words.
_NAME = 12
#: Of a line the largest part that labels take, and the largest beside texts.
_MOST, _LONG = 0.65, 0.42
#: In pixels of an interface that is not scaled: what tabs and margins take of a region, the sides of a label, an icon, what lies between two
#: columns, and the least room that words are broken into.
_MARGINS, _SIDES, _ICON, _BETWEEN, _LEAST = 46, 6, 26, 8, 70


def draw_problem(layout, text, width=None):
    """A sentence about something that went wrong, `width` characters to a line."""
    column = layout.column(align=True)
    column.alert = True
    _draw_lines(column, text, 'ERROR', width, 0)


def draw_note(layout, text, width=None, icon='INFO', beside=0):
    """A sentence that is no trouble, `width` characters to a line. beside: in pixels of an interface that is not scaled, what stands beside it."""
    _draw_lines(layout.column(align=True), text, icon, width, beside)


def _draw_lines(column, text, icon, width, beside):
    """Lines below the first one stand beside its icon, if it has one."""
    below = 'NONE' if icon == 'NONE' else 'BLANK1'
    said = say(text)
    broken = textwrap.wrap(said, width) if width else _broken(said, beside + (0 if icon == 'NONE' else _ICON))
    for i, line in enumerate(broken):
        column.label(text=line, icon=icon if i == 0 else below)


def draw_pairs(layout, pairs):
    """Labels with texts beside them, or below them where labels are long."""
    column, part = layout.column(align=True), share([say(label) for label, _ in pairs])
    for label, text in pairs:
        is_beside = part <= _LONG
        if label or is_beside:
            row = column.split(factor=part) if is_beside else column
            row.label(text=say(label))
        lines = row.column(align=True) if is_beside else column
        for line in _broken(say(text), share=1.0 - part if is_beside else 1.0):
            lines.label(text=line)


def _broken(text, beside=0, share=1.0):
    """The lines of a text that fit the region that is drawn."""
    width = _width(beside + (_BETWEEN if share < 1.0 else 0))
    if width is None:
        return textwrap.wrap(text, WIDTH)
    scale = bpy.context.preferences.system.ui_scale
    return wrapped(text, max(width * share - _SIDES * scale, _LEAST * scale), width_of)


def _width(beside=0):
    """The width of a panel in the region that is drawn, without what stands beside; None where none is drawn."""
    region, scale = bpy.context.region, bpy.context.preferences.system.ui_scale
    return None if region is None or region.width <= 1 else region.width - (_MARGINS + beside) * scale


def is_drawn():
    """Whether there is a region to fit."""
    return _width() is not None


def fits(words, beside=0):
    """Whether words have room in a line. beside: in pixels of an interface that is not scaled, what else is in it."""
    width = _width(beside)
    return width is None or width_of(words) <= width - _SIDES * bpy.context.preferences.system.ui_scale


def share(labels, beside=0, least=0.3):
    """Which part of a line the widest of some labels takes, at least and at most."""
    width = _width(beside + _BETWEEN)
    if width is None or not labels:
        return least
    needed = max(map(width_of, labels)) + (_SIDES + 1) * bpy.context.preferences.system.ui_scale
    return min(max(needed / max(width, 1.0), least), _MOST)


def wrapped(text, room, width_of):
    """The lines of a text, each no wider than there is room, as far as its words allow."""
    lines = []
    for paragraph in text.splitlines():
        lines.append("")
        for word in paragraph.split():
            longer = f"{lines[-1]} {word}".strip()
            if lines[-1] and width_of(longer) > room:
                lines.append(word)
            else:
                lines[-1] = longer
    return lines


def width_of(words):
    """In pixels, in the letters of the interface."""
    blf.size(0, bpy.context.preferences.ui_styles[0].widget.points * bpy.context.preferences.system.ui_scale)
    return blf.dimensions(0, words)[0]


def short(name):
    """A name that leaves room for words beside it in a button."""
    return name if len(name) <= _NAME else f"{name[:_NAME - 1]}…"


def pop_up(text):
    """A sentence about something that went wrong where no operator can report it, in a window and in the console."""
    print(f"Splinewright: {text}")
    windows = bpy.context.window_manager.windows
    if windows:
        with bpy.context.temp_override(window=windows[0]):
            bpy.context.window_manager.popup_menu(lambda menu, context: draw_problem(menu.layout, text, 80),
                                                  title=say("Splinewright"))
