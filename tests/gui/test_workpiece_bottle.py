"""A bottle by menus and keys: circles scaled to ellipses, a loft through them, caps; a section is scaled, undone, saved, opened."""

import os
import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).parent))
import by_keys
from window import part, redrawn, run, save_picture, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])
SECTIONS = ("S 0.8 Enter", "S 0.9 Enter G Z 1 Enter", "S 0.8 Enter G Z 2 Enter", "S 0.4 Enter G Z 2.6 Enter")
NAMES = []


def picture(name):
    return save_picture(OUTPUT / f"bottle-{name}.png")


def value():
    return bpy.data.objects[NAMES[-1]].data.splinewright.value


def open_ends():
    """How many rims are open."""
    sc, found = part('core.base.library').sc, value()
    patches = [found[i] for i in range(len(found))] if isinstance(found, sc.PatchSet) else [found]
    return len(sc.build.open_ends(patches))


def sections(view):
    for transforms in SECTIONS:
        before = len(bpy.data.objects)
        yield from by_keys.add(view, "Curve > NURBS > Circle")
        yield from until(lambda: len(bpy.data.objects) == before + 1, "Shift+A adds a circle")
        NAMES.append(bpy.context.object.name)
        yield from by_keys.keys(view, transforms + " S Y 0.6 Enter")
    heights = [bpy.data.objects[name].matrix_world.translation.z for name in NAMES]
    assert [round(height, 5) for height in heights] == [0, 1, 2, 2.6], heights


def lofted(view):
    view.press('A')
    yield from until(lambda: len(bpy.context.selected_objects) == 4, "A selects all")
    yield from by_keys.add(view, "Surface > NURBS > Surface from Curves > Loft")
    yield from until(lambda: len(bpy.data.objects) == 5, "a loft")
    NAMES.append(bpy.context.object.name)
    with view.override():
        bpy.ops.view3d.view_all(center=False)
    yield from redrawn()
    assert open_ends() == 2
    picture("loft")
    yield from by_keys.search(view, "cap holes")
    yield from until(lambda: open_ends() == 0, "caps at both ends")
    assert len(value()) == 3 and value().volume() > 0
    yield from redrawn()
    picture("capped")


def scaled(view):
    before = value()
    yield from by_keys.choose(view, NAMES[1])
    view.press('S')
    yield from redrawn()
    view.move(view.x + 90)
    yield from until(lambda: value() != before, "the loft follows the drag")
    yield from by_keys.keys(view, "Click")
    yield from redrawn()
    assert open_ends() == 0 and len(value()) == 3
    after = value()
    yield from by_keys.keys(view, "Ctrl+Z")
    yield from until(lambda: value() == before, "Ctrl+Z puts it back")
    yield from by_keys.keys(view, "Ctrl+Shift+Z")
    yield from until(lambda: value() == after, "Ctrl+Shift+Z")


def kept(view):
    def is_whole():
        assert open_ends() == 0
    yield from by_keys.followed_when_opened(view, OUTPUT / "bottle.blend", value, is_whole, NAMES[3], "G Z 0.2 Enter")
    assert part('bridge.follow.follow').problem(bpy.data.objects[NAMES[-1]].data) == ""
    picture("opened")


run(by_keys.one_by_one(sections, lofted, scaled, kept))
