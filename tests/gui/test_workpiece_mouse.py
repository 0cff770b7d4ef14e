"""A computer mouse by menus and keys: half of it is a loft through arcs, Mirror makes the other half, G2 across the plane; a net is
dragged and grown, undone, saved, opened."""

import os
import sys
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
import by_keys
from window import into_net, nets, out_of_net, part, redrawn, run, save_picture, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])
#: From the plane outwards: all stand on the floor.
RIBS = ("", "G Y 0.4 Enter S 0.9 Enter", "G Y 0.8 Enter S 0.55 Enter")
NAMES = []


def picture(name):
    return save_picture(OUTPUT / f"mouse-{name}.png")


def value(name=None):
    return bpy.data.objects[name or NAMES[-1]].data.splinewright.value


def require_smooth():
    """One seam, in the plane, G2 by the library's own measure."""
    found = value()
    ((first, side), (second, other)), = found.seams()
    seam = part('core.base.library').sc.seam_continuity(found[first], side, found[second], other)
    assert seam.g >= 2 and seam.gap < 1e-9, seam
    edge = found[first].boundary(side)
    matrix = np.array(bpy.data.objects[NAMES[-1]].matrix_world)
    there = edge.evaluate(np.linspace(*edge.domain, 9)) @ matrix[:3, :3].T + matrix[:3, 3]
    assert np.abs(there[:, 1]).max() < 1e-6


def ribs(view):
    for transforms in RIBS:
        before = len(bpy.data.objects)
        yield from by_keys.add(view, "Curve > NURBS > NURBS Curve")
        yield from until(lambda: len(bpy.data.objects) == before + 1, "Shift+A adds a curve")
        NAMES.append(bpy.context.object.name)
        yield from by_keys.keys(view, f"R X 90 Enter {transforms}")


def mirrored(view):
    yield from by_keys.choose(view, *NAMES)         # what is made lies where the active one does: in the plane
    yield from by_keys.search(view, "loft")
    yield from until(lambda: len(bpy.data.objects) == 4, "F3 finds Loft")
    NAMES.append(bpy.context.object.name)
    yield from by_keys.command(view, "Construction > Mirror")
    yield from until(lambda: len(bpy.data.objects) == 5, "a mirror")
    NAMES.append(bpy.context.object.name)
    with view.override():
        bpy.ops.view3d.view_all(center=False)
    yield from redrawn()
    picture("mirrored")
    require_smooth()


def take(view, number):
    """Select one point of the net."""
    with view.override():
        bpy.ops.curve.select_all(action='DESELECT')
        nets()[0].data.splines[0].points[number].select = True
        nets()[0].data.update_tag()
        bpy.ops.ed.undo_push(message="choose")


def dragged(view):
    """The rib in the plane is dragged in its net, and grows by E."""
    yield from by_keys.choose(view, NAMES[0])
    before = value()
    view.press('TAB')
    yield from into_net()
    take(view, -2)
    yield from redrawn()
    yield from by_keys.keys(view, "G Z")            # in the plane
    view.move(view.x, view.y + 60)
    yield from until(lambda: value() != before, "the mouse follows the drag")
    yield from by_keys.keys(view, "Click")
    require_smooth()
    shaped = value()
    take(view, -1)
    view.move(420, 420)
    yield from redrawn()
    yield from by_keys.keys(view, "E X 0.3 Enter")
    yield from until(lambda: value() != shaped, "E makes a point more")
    yield from redrawn()
    require_smooth()
    picture("grown")
    yield from by_keys.keys(view, "Ctrl+Z")
    yield from until(lambda: value() == shaped, "Ctrl+Z takes it back")
    yield from redrawn()
    view.press('TAB')
    yield from out_of_net()
    require_smooth()


def kept(view):
    yield from by_keys.followed_when_opened(view, OUTPUT / "mouse.blend", value, require_smooth, NAMES[1], "S 1.1 Enter")
    picture("opened")


run(by_keys.one_by_one(ribs, mirrored, dragged, kept))
