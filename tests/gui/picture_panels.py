"""Pictures of every panel of the sidebar and of every tool's header and status line, in three states, to be looked at. Since
Blender 4.0, for before a tab of the sidebar is shown by clicks only.

    SPLINEWRIGHT_SCREEN=1920x1080 tests/gui/run.sh ZIP OUTPUT tests/gui/picture_panels.py
"""

import os
import sys
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from window import View, write_png, empty_file, into_net, part, redrawn, run, save_picture, select_points

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])
#: Rows of the screen that a tool's header and the status bar have.
_HEADER, _STATUS = 52, 22


def curve(view):
    with view.override():
        bpy.ops.splinewright.add_nurbs_curve('EXEC_DEFAULT', True)
    yield from redrawn()


def loft(view):
    with view.override():
        for z in range(4):
            bpy.ops.splinewright.add_circle('EXEC_DEFAULT', True, location=(0, 0, z), radius=1 + z % 2)
        bpy.ops.object.select_all(action='SELECT')
        bpy.ops.splinewright.add_loft('EXEC_DEFAULT', True)
    yield from redrawn()


def net(view):
    with view.override():
        bpy.ops.splinewright.add_nurbs_patch('EXEC_DEFAULT', True)
        bpy.ops.ed.undo_push(message="added")
        bpy.ops.splinewright.edit_net()
    yield from into_net()
    select_points(5, 6)
    yield from redrawn()


STATES = {'curve': curve, 'loft': loft, 'net': net}


def below(panel, panels):
    """A panel and those within it."""
    found = [panel]
    for one in panels:
        if getattr(one, 'bl_parent_id', None) == panel.bl_idname:
            found += below(one, panels)
    return found


def panels_of_sidebar():
    shown = [cls for cls in bpy.types.Panel.__subclasses__() if cls.__module__.startswith(part('ui').__name__)]
    shown = [cls for cls in shown if getattr(cls, 'bl_region_type', '') == 'UI' and getattr(cls, 'bl_category', '') == "NURBS"]
    return sorted(set(shown), key=lambda cls: getattr(cls, 'bl_order', 0))


class Alone:
    """One panel of the sidebar, open, with those within it. Blender keeps a panel closed that was, unless it has another name."""

    def __init__(self, wanted, panels):
        self._wanted, self._panels = below(wanted, panels), panels
        self._own = {cls: (cls.bl_idname, set(getattr(cls, 'bl_options', set())), getattr(cls, 'bl_parent_id', "")) for cls in panels}

    def __enter__(self):
        for cls in reversed(self._panels):
            bpy.utils.unregister_class(cls)
        for cls in self._wanted:
            name, options, parent = self._own[cls]
            self._register(cls, f"{name}_open", options - {'DEFAULT_CLOSED'}, parent and f"{parent}_open")

    def __exit__(self, *_):
        for cls in reversed(self._wanted):
            bpy.utils.unregister_class(cls)
        for cls in self._panels:
            self._register(cls, *self._own[cls])

    @staticmethod
    def _register(cls, name, options, parent):
        cls.bl_idname, cls.bl_options = name, options
        if parent:
            cls.bl_parent_id = parent
        bpy.utils.register_class(cls)


def sidebar_of(view, picture):
    region = view._region('UI')
    height = picture.shape[0]
    return picture[height - region.y - region.height:height - region.y, region.x:region.x + region.width]


def sheet(pictures):
    """Beside one another."""
    height = max(one.shape[0] for one in pictures)
    return np.concatenate([np.pad(one, ((0, height - one.shape[0]), (0, 6), (0, 0))) for one in pictures], 1)


def used(picture):
    """Without the empty rows below."""
    rows = np.flatnonzero((picture != picture[-3:-2, 8:9]).any(axis=(1, 2)))
    return picture[:max(rows[rows < picture.shape[0] - 8], default=20) + 12]


def panels(view, name):
    found, pictures = panels_of_sidebar(), []
    roots = [cls for cls in found if not getattr(cls, 'bl_parent_id', None)]
    ordered = [each for root in roots for each in below(root, found)]
    for root in (cls for cls in roots if not hasattr(cls, 'poll') or cls.poll(bpy.context)):
        with Alone(root, ordered):
            yield from view.show_tab("NURBS", None)
            yield from redrawn()
            pictures.append(sidebar_of(view, save_picture(OUTPUT / "panel.png")))
    yield from redrawn()
    write_png(OUTPUT / f"panels-{name}.png", sheet(pictures))


def tools(view, name):
    rows, toolbar = [], part('ui.toolbar')
    for tool in [tool for tool in toolbar.TOOLS.values() if bpy.context.mode in tool.modes]:
        with view.override():
            if bpy.ops.splinewright.use_tool('EXEC_DEFAULT', tool=tool.name) != {'FINISHED'}:
                continue
        view.move(420, 420)
        for _ in range(2):
            yield from redrawn()
        picture = save_picture(OUTPUT / "tool.png")
        rows += [picture[:_HEADER + 26], picture[-_STATUS:]]
    write_png(OUTPUT / f"tools-{name}.png", np.concatenate(rows))
    with view.override():
        bpy.ops.wm.tool_set_by_id(name='builtin.select_box')


def everything():
    view = View()
    view.open_sidebar()
    yield from redrawn()
    yield from view.show_tab("NURBS", (1270, 400))
    for name, begin in STATES.items():
        empty_file()
        yield from begin(view)
        yield from panels(view, name)
        yield from tools(view, name)
        if bpy.context.mode != 'OBJECT':
            view.move(420, 420)
            view.press('TAB')
            yield from redrawn()


run(everything())
