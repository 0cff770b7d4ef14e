"""F1 over a button and a field, and the question mark in the panel's header, ask the browser for pages of the manual."""

import os
import sys
import webbrowser
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).parent))
from window import View, empty_file, part, redrawn, run, save_picture, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])
asked = []


def is_asked(page):
    return bool(asked) and asked[-1] == part('ui.manual').address_of(page)


def go_to_page(view, page, places):
    """Steps that bring the mouse over what F1 leads to a page from."""
    yield from view.search(places, lambda: is_asked(page), f"F1 leads to {page}", 'F1')


def steps():
    webbrowser.open = lambda address, *_, **__: not asked.append(address)
    view = View()
    empty_file()
    with view.override():
        bpy.ops.splinewright.add_nurbs_patch('EXEC_DEFAULT', True)
    view.open_sidebar()
    yield from redrawn()
    yield from view.show_tab("NURBS", (1044, 537))
    sidebar = view._region('UI')
    middle, top = sidebar.x + sidebar.width // 2, sidebar.y + sidebar.height
    downwards = [(middle, y) for y in range(top - 20, sidebar.y, -9)]
    yield from go_to_page(view, "nets.html#in-and-out", downwards)
    yield from go_to_page(view, "surfaces.html#faces", downwards)
    right = sidebar.x + sidebar.width
    header = [(x, y) for y in range(top - 10, top - 300, -8) for x in range(right - 24, right - 60, -7)]
    yield from go_to_page(view, "index.html#splinewright", header)
    save_picture(OUTPUT / "manual.png")
    asked.clear()
    view.press('LEFTMOUSE')
    yield from until(lambda: asked, "the question mark opens the manual")
    assert is_asked("surfaces.html"), asked
    print("F1 did what it should:", bpy.app.version_string, flush=True)


run(steps())
