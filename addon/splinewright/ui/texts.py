"""Sentences in a layout, broken into lines."""

import textwrap

import bpy

#: Characters that fit a line of the sidebar.
_WIDTH = 40


def draw_problem(layout, text, width=_WIDTH):
    """A sentence about something that went wrong, `width` characters to a line."""
    column = layout.column(align=True)
    column.alert = True
    for i, line in enumerate(textwrap.wrap(text, width)):
        column.label(text=line, icon='ERROR' if i == 0 else 'BLANK1')


def draw_note(layout, text, width=_WIDTH):
    """A sentence that is no trouble, `width` characters to a line."""
    column = layout.column(align=True)
    for i, line in enumerate(textwrap.wrap(text, width)):
        column.label(text=line, icon='INFO' if i == 0 else 'BLANK1')


def pop_up(text):
    """A sentence about something that went wrong where no operator can report it, in a window and in the console."""
    print(f"Splinewright: {text}")
    windows = bpy.context.window_manager.windows
    if windows:
        with bpy.context.temp_override(window=windows[0]):
            bpy.context.window_manager.popup_menu(lambda menu, context: draw_problem(menu.layout, text, 80),
                                                  title="Splinewright")
