"""The menus as they are seen: none is higher than 500 pixels, whatever is selected; ten jobs are done by the menus alone."""

import os
import sys
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
import by_keys
from window import View, empty_file, into_net, part, redrawn, run, save_picture, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])
HIGHEST = 500
#: In pixels. Blender 4.3 shows other keys there while a menu is open.
STATUS_BAR = 26


def picture(name):
    return save_picture(OUTPUT / f"menus-{name}.png")


def height_of(before, after):
    """Of what has changed between two pictures, above the status bar."""
    rows = np.flatnonzero((before != after)[:-STATUS_BAR].any(axis=(1, 2)))
    return int(rows[-1] - rows[0] + 1) if len(rows) else 0


def added(view, *names):
    with view.override():
        for i, name in enumerate(names):
            getattr(bpy.ops.splinewright, name)('EXEC_DEFAULT', True, location=(0, 0, i))
        bpy.ops.object.select_all(action='SELECT')
        bpy.ops.ed.undo_push(message="added")
    yield from redrawn()


def follower(view):
    yield from added(view, 'add_circle')
    with view.override():
        bpy.ops.splinewright.add_extrude('EXEC_DEFAULT', True)
    yield from redrawn()


def net(name):
    def begin(view):
        yield from added(view, name)
        with view.override():
            bpy.ops.splinewright.edit_net()
        yield from into_net()
    return begin


STATES = {'nothing': lambda view: added(view), 'curve': lambda view: added(view, 'add_nurbs_curve'),
          'patch': lambda view: added(view, 'add_nurbs_patch'), 'follower': follower, 'patch-net': net('add_nurbs_patch')}


def shown(menu):
    """A menu and those below it that it shows now."""
    table, menus = part('ui.menu_table'), part('ui.menus')
    below = [entry for entry in menu.entries if isinstance(entry, table.Menu) and menus._is_shown(entry, bpy.context)]
    return [menu, *(one for entry in below for one in shown(entry))]


def heights(view):
    """Each menu in each state, opened in the middle of the view, lies within 500 pixels."""
    table, tallest = part('ui.menu_table'), {}
    for state, begin in STATES.items():
        empty_file()
        yield from begin(view)
        tops = [table.NET] if state.endswith('net') else [table.ADD_CURVE, table.ADD_SURFACE, *([table.OBJECT] if state != 'nothing' else [])]
        for menu in (one for top in tops for one in shown(top)):
            view.move(420, 690)
            yield from redrawn()
            before = picture("closed")
            with view.override():
                bpy.ops.wm.call_menu(name=menu.idname)
            yield from redrawn()
            tallest[state, menu.name] = height_of(before, picture(f"{state}-{menu.name}"))
            view.press('ESC')
            yield from redrawn()
        if bpy.context.mode != 'OBJECT':
            with view.override():
                bpy.ops.splinewright.leave_net()
            yield from redrawn()
    print({key: height for key, height in tallest.items() if height > HIGHEST * 0.6}, max(tallest.values()), flush=True)
    assert all(20 < height <= HIGHEST for height in tallest.values()), tallest


def value():
    return bpy.context.object.data.splinewright.value


def last():
    return bpy.context.window_manager.operators[-1].bl_idname


def done(view, path, begin, holds):
    """Steps that do a job by a menu, and until it is done."""
    empty_file()
    yield from begin(view)
    view.move(420, 690)
    yield from by_keys.command(view, path)
    yield from until(holds, path)
    print(path, flush=True)


def jobs(view):
    curve, patch, circle = STATES['curve'], STATES['patch'], lambda view: added(view, 'add_circle')
    two = lambda view: added(view, 'add_circle', 'add_circle')
    for path, begin, holds in (
            ("Modify > Degree > Elevate Degree", curve, lambda: value().degree == 4),
            ("Modify > Knots > Insert Knot", patch, lambda: value().points.shape[0] > 4),
            ("Modify > Rebuild", curve, lambda: len(value().points) == 10),
            ("Modify > Switch Direction", curve, lambda: last() == 'SPLINEWRIGHT_OT_reverse'),
            ("Modify > Split", patch, lambda: len(value()) == 2),
            ("Convert > Convert to Bezier", curve, lambda: len(value()) > 1),
            ("Surface from Curves > Extrude", circle, lambda: bpy.context.object.type == 'MESH'),
            ("Surface from Curves > Loft", two, lambda: bpy.context.object.type == 'MESH'),
            ("Surface from Surfaces > Thicken", patch, lambda: len(bpy.data.objects) == 2),
            ("Construction > Mirror", patch, lambda: len(bpy.data.objects) == 2)):
        yield from done(view, path, begin, holds)


def steps():
    view = View()
    yield from jobs(view)
    yield from heights(view)
    empty_file()
    yield from added(view, 'add_nurbs_patch')
    assert picture("header").any()


run(steps())
