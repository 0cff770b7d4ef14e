"""The tab of the sidebar in every state, at the width it opens with."""

import contextlib
import os
import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).parent))
from window import View, empty_file, into_net, out_of_net, part, redrawn, run, save_picture, select_points, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])


def last():
    return bpy.context.window_manager.operators[-1]


def select(*obs):
    for ob in bpy.context.view_layer.objects:
        ob.select_set(ob in obs)
    bpy.context.view_layer.objects.active = obs[-1] if obs else None


@contextlib.contextmanager
def unfolded(*names):
    """Some panels open and above the others, as a user opens and drags them."""
    changed = [getattr(bpy.types, f"SPLINEWRIGHT_PT_{name}") for name in names]
    def again(options, order):
        for cls in changed:
            bpy.utils.unregister_class(cls)
            cls.bl_options, cls.bl_order = options, order
            cls.bl_idname = cls.bl_idname + "_open" if not options else cls.bl_idname.removesuffix("_open")
            bpy.utils.register_class(cls)
    again(set(), 0)
    yield
    again({'DEFAULT_CLOSED'}, 9)


def pictures(view):
    """Of each state."""
    def add(name, **settings):
        with view.override():
            getattr(bpy.ops.splinewright, name)('EXEC_DEFAULT', True, **settings)
        return bpy.context.object

    def native():
        with view.override():
            bpy.ops.curve.primitive_bezier_curve_add('EXEC_DEFAULT', True)
        return bpy.context.object

    def seen(name, *obs):
        select(*obs)
        yield from redrawn()
        save_picture(OUTPUT / f"sidebar-{name}.png")

    empty_file()
    yield from seen("nothing")
    yield from seen("native", native())
    curve, line = add('add_nurbs_curve'), add('add_line')
    yield from seen("curve", curve)
    yield from seen("curves", line, curve)
    tube = add('add_nurbs_patch', knots_u='PERIODIC')
    yield from seen("patch", tube)
    yield from seen("recipe", add('add_circle'))
    yield from seen("cone", add('add_cone'))
    yield from seen("formula", add('add_surface_formula'))
    select(line)
    yield from seen("revolve", add('add_revolve'))
    yield from seen("teapot", add('add_teapot'))
    rings = []
    for z in (0.0, 1.0, 2.0, 3.0):
        rings.append(add('add_circle'))
        rings[-1].location.z = z
    select(*rings)
    loft = add('add_loft')
    yield from seen("loft", loft)
    bpy.context.scene.splinewright_sights.stripes = True
    yield from redrawn()
    with unfolded("analysis", "measure"):
        yield from redrawn()
        save_picture(OUTPUT / "sidebar-analysis.png")
    bpy.context.scene.splinewright_sights.stripes = False
    select(curve)
    view.press('TAB')
    yield from into_net()
    select_points(1, 2, 3)
    yield from redrawn()
    save_picture(OUTPUT / "sidebar-net.png")
    view.press('TAB')
    yield from out_of_net()


def following(view):
    """The panel of the last operator shows what is followed, and takes another."""
    empty_file()
    with view.override():
        for name in ("first", "second"):
            bpy.ops.splinewright.add_nurbs_curve('EXEC_DEFAULT', True)
            bpy.context.object.name = name
        bpy.ops.splinewright.follow_object('INVOKE_DEFAULT', True)
    yield from redrawn()
    assert last().properties.source == "second", last().properties.source
    panel = view._region('HUD')
    view.move(panel.x + panel.width // 2, panel.y + panel.height // 2)
    yield from redrawn()
    view.press('LEFTMOUSE')
    yield from until(lambda: panel.height > 60, "the open panel of the last operator")
    yield from redrawn()
    save_picture(OUTPUT / "sidebar-follow.png")
    last().properties.source = "first"
    with view.override():
        bpy.ops.ed.undo_redo()
    yield from redrawn()
    recipes = part('bridge.recipes.recipes')
    found = {data.name: recipes.read_inputs(data)[0].name for data in bpy.data.curves if recipes.follows(data)}
    assert list(found.values()) == ["first"] and len(bpy.context.scene.objects) == 3, found
    print("following", flush=True)


def mending(view):
    """A tolerance that was too small is changed in the panel of the last operator, which says what comes of it."""
    empty_file()
    with view.override():
        bpy.ops.splinewright.add_nurbs_curve('EXEC_DEFAULT', True)
        bpy.ops.splinewright.make_periodic('INVOKE_DEFAULT', True)
    yield from redrawn()
    assert last().bl_idname == 'SPLINEWRIGHT_OT_make_periodic' and "do not meet" in last().properties.result
    assert not bpy.context.object.data.splinewright.value.periodic
    save_picture(OUTPUT / "sidebar-mending.png")
    last().properties.tolerance = 10.0
    with view.override():
        bpy.ops.ed.undo_redo()
    yield from redrawn()
    assert bpy.context.object.data.splinewright.value.periodic
    assert "periodic" in last().properties.result and "largest distance" in last().properties.result
    save_picture(OUTPUT / "sidebar-mended.png")
    print("mending", flush=True)


def steps():
    yield from View().in_sidebar(pictures, following, mending)
    print("the sidebar has something in every state:", bpy.app.version_string, flush=True)


run(steps())
