"""Sentences in a layout, broken into lines."""

import textwrap

import bpy

from ..core.base.words import say

#: Characters that fit a line beside an icon in the sidebar as it opens, and the least that one is broken into.
WIDTH, _LEAST = 23, 12
#: Characters of a name beside words.
_NAME = 12
#: In pixels of an interface that is not scaled: a character, and what margins, an icon and tabs take of a region.
_CHARACTER, _BESIDE = 6.4, 76


def draw_problem(layout, text, width=None):
    """A sentence about something that went wrong, `width` characters to a line."""
    column = layout.column(align=True)
    column.alert = True
    _draw_lines(column, text, 'ERROR', width)


def draw_note(layout, text, width=None, icon='INFO'):
    """A sentence that is no trouble, `width` characters to a line."""
    _draw_lines(layout.column(align=True), text, icon, width)


def _draw_lines(column, text, icon, width):
    """Lines below the first one stand beside its icon, if it has one."""
    below = 'NONE' if icon == 'NONE' else 'BLANK1'
    for i, line in enumerate(textwrap.wrap(say(text), width or _fitting())):
        column.label(text=say(line), icon=icon if i == 0 else below)


def lines(text):
    """A text in lines that fit the sidebar as it opens, without an icon and beside a label; figures are narrow."""
    text = say(text)
    return textwrap.wrap(text, WIDTH - 5 if any(map(str.isalpha, text)) else WIDTH - 1)


def short(name):
    """A name that leaves room for words beside it in a button."""
    return name if len(name) <= _NAME else f"{name[:_NAME - 1]}…"


def _fitting():
    """How many characters fit a line of the region that is drawn."""
    region, scale = bpy.context.region, bpy.context.preferences.system.ui_scale
    if region is None or region.width <= 1:
        return WIDTH
    return max(int((region.width / scale - _BESIDE) / _CHARACTER), _LEAST)


def pop_up(text):
    """A sentence about something that went wrong where no operator can report it, in a window and in the console."""
    print(f"Splinewright: {text}")
    windows = bpy.context.window_manager.windows
    if windows:
        with bpy.context.temp_override(window=windows[0]):
            bpy.context.window_manager.popup_menu(lambda menu, context: draw_problem(menu.layout, text, 80),
                                                  title=say("Splinewright"))
