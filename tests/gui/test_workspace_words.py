"""Words of modelers that F3 finds: the first entry is chosen, and does it, or is the tool for it."""

import os
import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).parent))
import by_keys
from window import View, empty_file, redrawn, run, save_picture, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])


def added(view, *names):
    with view.override():
        for i, name in enumerate(names):
            getattr(bpy.ops.splinewright, name)('EXEC_DEFAULT', True, location=(0, 0, i))
        bpy.ops.object.select_all(action='SELECT')
        bpy.ops.ed.undo_push(message="added")
    yield from redrawn()


def curve(view):
    yield from added(view, 'add_nurbs_curve')


def sections(view):
    yield from added(view, 'add_circle', 'add_circle')


def profile_and_rail(view):
    yield from added(view, 'add_circle', 'add_nurbs_curve')


def patch(view):
    yield from added(view, 'add_nurbs_patch')


def tool(*names):
    """Whether one of these tools is in use."""
    def holds():
        found = bpy.context.workspace.tools.from_space_view3d_mode(bpy.context.mode, create=False)
        return found is not None and found.idname in {f"splinewright.{name}" for name in names}
    return holds


def sight(name):
    return lambda: getattr(bpy.context.scene.splinewright_sights, name)


def made(kind):
    return lambda: bpy.context.object is not None and bpy.context.object.type == kind and len(bpy.data.objects) == 3


WORDS = (("loft", sections, made('MESH')), ("sweep", profile_and_rail, made('MESH')), ("trim", curve, tool('trim')), ("fillet", curve, tool('fillet')),
         ("zebra", patch, sight('stripes')), ("stripes", patch, sight('stripes')), ("comb", curve, sight('comb')))


def steps():
    view = View()
    for word, begin, holds in WORDS:
        empty_file()
        bpy.context.scene.splinewright_sights.stripes = False      # "zebra" has switched them on
        yield from begin(view)
        assert not holds(), word
        view.move(420, 420)
        yield from by_keys.search(view, word)
        save_picture(OUTPUT / f"f3-{word}.png")
        yield from until(holds, f"F3 finds {word}")
        print(word, flush=True)


run(steps())
