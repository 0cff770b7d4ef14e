"""The Mode menu, Ctrl+Tab, workspaces and Tab lead into nets, and undo leads out; what is refused there is said."""

import os
import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).parent))
from window import View, empty_file, in_net, into_net, is_out, out_of_net, part, redrawn, run, save_picture, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])


def add(view, name, **settings):
    with view.override():
        getattr(bpy.ops.splinewright, name)('EXEC_DEFAULT', True, **settings)
    return bpy.context.object


def by_the_mode_menu(view):
    """Its operator, as the menu and the pie of Ctrl+Tab call it; one undo takes all of it back."""
    empty_file()
    name = add(view, 'add_nurbs_patch').name
    yield from redrawn()
    with view.override():
        bpy.ops.object.mode_set('INVOKE_DEFAULT', True, mode='EDIT')
    yield from into_net()
    save_picture(OUTPUT / "detour-net.png")
    with view.override():
        bpy.ops.ed.undo()
    yield from until(is_out, "Object Mode again")
    yield from redrawn()
    assert bpy.context.object.name == name and bpy.context.mode == 'OBJECT'
    assert not part('bridge.shape.shape').is_touched(bpy.context.object.data)
    print("mode menu", flush=True)


def by_a_workspace(view):
    empty_file()
    add(view, 'add_nurbs_patch')
    yield from redrawn()
    before = view.window.workspace
    view.window.workspace = bpy.data.workspaces["Modeling"]
    yield from until(in_net, "a net in Edit Mode")
    view.window.workspace = before
    yield from redrawn()
    print("workspace", flush=True)


def by_tab(view):
    """On a revolve into the net of its profile."""
    empty_file()
    profile = add(view, 'add_line')
    surface = add(view, 'add_revolve')
    view.move(420, 420)
    yield from redrawn()
    view.press('TAB')
    yield from into_net()
    assert part('bridge.cage.net_object').shape_of(bpy.context.object) == profile
    save_picture(OUTPUT / "detour-profile.png")
    view.press('TAB')
    yield from out_of_net()
    assert bpy.context.object == profile and not part('bridge.shape.shape').is_touched(surface.data)
    add(view, 'add_circle')
    yield from redrawn()
    view.press('TAB')
    yield from redrawn()
    assert bpy.context.mode == 'OBJECT'
    save_picture(OUTPUT / "detour-choice.png")
    view.press('ESC')
    yield from redrawn()
    print("tab", flush=True)


def refused(view):
    """The Mode menu on a shape of a newer version and on a damaged one: Object Mode, and a pop-up says why."""
    store, texts = part('bridge.data.store'), part('ui.texts')
    said, pop_up = [], texts.pop_up
    texts.pop_up = lambda text: (said.append(text), pop_up(text))
    for harm, why in ((lambda kept: kept.update({"version": store.VERSION + 1}), "newer Splinewright"),
                      (lambda kept: kept.update({"knots": list(kept["knots"])[:-1]}), "damaged")):
        empty_file()
        harm(add(view, 'add_nurbs_patch').data[store.KEY])
        yield from redrawn()
        said.clear()
        with view.override():
            bpy.ops.object.mode_set('INVOKE_DEFAULT', True, mode='EDIT')
        yield from until(lambda: said, "it says why")
        assert bpy.context.mode == 'OBJECT' and len(said) == 1 and why in said[0], said
        yield from redrawn()
        save_picture(OUTPUT / "detour-refused.png")
        view.press('ESC')
        yield from redrawn()
    texts.pop_up = pop_up
    print("refused", flush=True)


def steps():
    for part_of_it in (by_tab, by_the_mode_menu, by_a_workspace, refused):
        yield from part_of_it(View())
    print("every way leads into the net:", bpy.app.version_string, flush=True)


run(steps())
