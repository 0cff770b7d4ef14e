"""What the switches in the Overlays popover show: seen in the view, following a drag, kept while nothing changes."""

import os
import sys
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from window import (View, distances_measured, empty_file, into_net, mean_difference, out_of_net, part, redrawn, run,
                    save_picture, select_points, until)

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])
#: Of a picture, where shapes are and neither regions nor the legend.
PLACE = slice(100, 680), slice(260, 830)


def chosen():
    return bpy.context.scene.splinewright_sights


def switched_on(view, name, picture, least=0.05, **numbers):
    """Steps that switch something on and see that the view changes, by so much at least."""
    before = save_picture(OUTPUT / "sights-off.png")
    for number, value in numbers.items():
        setattr(chosen(), number, value)
    setattr(chosen(), name, True)
    yield from redrawn()
    after = save_picture(OUTPUT / f"sights-{picture}.png")
    assert mean_difference(before[PLACE], after[PLACE]) > least, picture


def alone(view, make, name):
    """Steps that leave one shape in the view, selected."""
    empty_file()
    with view.override():
        make()
        bpy.context.object.name = name
        bpy.ops.view3d.view_all()
    yield from redrawn()


def curves(view):
    def make():
        bpy.ops.splinewright.add_nurbs_curve('EXEC_DEFAULT', True, count=7)
        bpy.ops.view3d.view_axis(type='TOP')
    yield from alone(view, make, "curve")
    yield from switched_on(view, 'axes', "axes")
    chosen().axes = False
    yield from redrawn()
    yield from switched_on(view, 'polygon', "polygon")
    yield from switched_on(view, 'curve', "curve")
    yield from switched_on(view, 'knots', "knots")
    yield from switched_on(view, 'comb', "comb", comb_scale=0.25)
    chosen().comb = False
    yield from switched_on(view, 'frame', "frame", place=0.7)
    yield from switched_on(view, 'hodograph', "hodograph", hodograph_scale=1.0)
    chosen().frame = chosen().hodograph = False
    chosen().comb = True
    yield from redrawn()
    view.press('TAB')
    yield from into_net()
    with view.override():
        select_points(3)
    before = save_picture(OUTPUT / "sights-net.png")
    made = count_made()
    yield from redrawn()
    yield from redrawn()
    assert made() == 0, "something was worked out though nothing changed"
    with view.override():
        bpy.ops.transform.translate('EXEC_DEFAULT', True, value=(0, 1.5, 0))
    yield from redrawn()
    assert made() > 0
    assert mean_difference(before[PLACE], save_picture(OUTPUT / "sights-moved.png")[PLACE]) > 0.3
    view.press('TAB')
    yield from out_of_net()
    print("curves", flush=True)


def count_made():
    """A function that tells how often something was worked out for the view since it was made."""
    state = part('bridge.data.file_state').state
    known = {id(value) for values in state.sights.values() for value in values.values()}
    kept = [values.copy() for values in state.sights.values()]      # so that no id is given away again

    def found():
        return len({id(value) for values in state.sights.values() for value in values.values()} - known) if kept else 0
    return found


def patches(view):
    def make():
        bpy.ops.splinewright.add_teapot('EXEC_DEFAULT', True)
        bpy.ops.view3d.view_axis(type='FRONT')
        bpy.ops.view3d.view_orbit(angle=0.5, type='ORBITUP')
    for name in ('polygon', 'curve', 'knots', 'comb'):
        setattr(chosen(), name, False)
    yield from alone(view, make, "teapot")
    for kind in ('ZEBRA', 'REFLECTION', 'HIGHLIGHT'):
        yield from switched_on(view, 'stripes', kind.lower(), least=4.0, stripe_kind=kind)
        chosen().stripes = False
        yield from redrawn()
    for kind in ('GAUSS', 'MEAN'):
        yield from switched_on(view, 'curvature', kind.lower(), least=4.0, curvature_kind=kind)
        chosen().curvature = False
        yield from redrawn()
    yield from switched_on(view, 'isocurves', "isocurves", isocurve_count=2)
    yield from switched_on(view, 'knots', "knot-lines")
    yield from switched_on(view, 'normals', "normals", normal_length=0.1)
    chosen().normals = False
    yield from switched_on(view, 'polygon', "patch-net")
    view.press('TAB')
    yield from into_net()
    front = save_picture(OUTPUT / "sights-patch-edit.png")
    yield from switched_on(view, 'points_behind', "points-behind")
    chosen().points_behind = False
    yield from redrawn()
    assert mean_difference(front, save_picture(OUTPUT / "sights-patch-edit.png")) < 0.05
    view.press('TAB')
    yield from out_of_net()
    for name in ('polygon', 'isocurves', 'knots'):
        setattr(chosen(), name, False)
    print("patches", flush=True)


def shows(view, point, color):
    """Whether a place of the world has a color in the view as it is now."""
    view.area.tag_redraw()
    found = save_picture(OUTPUT / "sights-straight.png")
    x, y = view.pixel_of(point)
    row = found.shape[0] - 1 - y
    around = found[row - 2:row + 3, x - 2:x + 3].reshape(-1, 3)
    return np.abs(around - 255 * np.array(color[:3])).max(1).min() < 16


def straight(view):
    """Of a straight curve the curve lies above the polygon, in its net, too, and points above both."""
    sc, colors = part('core.base.library').sc, part('ui.colors')

    def make():
        data = part('bridge.shape.shape').new_data("line", sc.NurbsCurve(3, [0, 0, 0, 0, 1, 2, 2, 2, 2], [
            (i, 0.3 * i, 0) for i in range(5)]), (8, 8))
        ob = bpy.data.objects.new("line", data)
        bpy.context.scene.collection.objects.link(ob)
        bpy.context.view_layer.objects.active = ob
        ob.select_set(True)
        bpy.ops.view3d.view_axis(type='TOP')
    yield from alone(view, make, "line")
    view.move(420, 200)
    view.press('TAB')
    yield from into_net()
    yield from redrawn()                # without the switch
    view.press('A', alt=True)
    theme = bpy.context.preferences.themes[0].view_3d
    yield from until(lambda: shows(view, (1, 0.3, 0), theme.vertex), "a point above the curve")
    for place in (0.5, 1.5, 2.5, 3.5):
        assert shows(view, (place, 0.3 * place, 0), colors.CURVE), ("the polygon lies above the curve", place)
    view.press('A')
    yield from until(lambda: shows(view, (1, 0.3, 0), theme.vertex_select), "a selected point above the curve")
    chosen().curve = False
    view.press('TAB')
    yield from out_of_net()
    print("straight", flush=True)


def each(view):
    """Every switch follows a drag, works nothing out where nothing changes, and is free when it is off."""
    for make, switches in (
            (bpy.ops.splinewright.add_nurbs_curve, ('curve', 'polygon', 'axes', 'knots', 'comb', 'frame', 'hodograph', 'deviation')),
            (bpy.ops.splinewright.add_nurbs_patch, ('polygon', 'axes', 'knots', 'isocurves', 'normals', 'stripes', 'curvature',
                                                    'deviation'))):
        yield from alone(view, lambda make=make: make('EXEC_DEFAULT', True), "shape")
        other = bpy.data.objects.new("other", bpy.data.meshes.new("other"))
        other.data.from_pydata([(-9, -9, 4), (9, -9, 4), (0, 9, 4)], [], [(0, 1, 2)])
        bpy.context.scene.collection.objects.link(other)
        chosen().deviation_object = other
        view.press('TAB')
        yield from into_net()
        with view.override():
            select_points(2)
        for switch in switches:
            yield from one_switch(view, switch)
        view.press('TAB')
        yield from out_of_net()
        drawn = count_drawn()
        yield from redrawn()
        yield from redrawn()
        assert drawn() == 0, "something is drawn though all is off"
    print("each", flush=True)


def one_switch(view, switch):
    """In a net with a selected point; of a polygon Blender draws the net itself there."""
    setattr(chosen(), switch, True)
    yield from redrawn()
    if switch == 'deviation':
        yield from until(distances_measured, "distances measured in the end")
    made = yield from nothing_made(switch)
    with view.override():
        bpy.ops.transform.translate('EXEC_DEFAULT', True, value=(0, 0.1, 0.4))
    yield from redrawn()
    if switch != 'polygon':
        yield from until(lambda: made() > 0, f"{switch} follows")
    setattr(chosen(), switch, False)
    yield from redrawn()


def nothing_made(switch):
    """Steps until a redraw works nothing out, as soon as what the drag before left for a pause is done; count_made() from
    then on."""
    for _ in range(20):
        yield from redrawn()
        made = count_made()
        yield from redrawn()
        if made() == 0:
            return made
    raise AssertionError(f"{switch} is worked out though nothing changed")


def count_drawn():
    """A function that tells how often something was drawn over shapes since it was made."""
    count, rooms = [0], [(part('ui.line_batches'), '_draw'), (part('ui.surface_shader'), 'draw'), (part('ui.legend'), 'draw'),
                         (part('ui.analysis_overlay'), 'active_shapes')]

    def counted(own):
        def called(*given, **more):
            count[0] += 1
            return own(*given, **more)
        return called
    for room, name in rooms:
        setattr(room, name, counted(getattr(room, name)))
    return lambda: count[0]


def popover(view):
    """The switches stand in the popover, in words."""
    with view.override():
        bpy.ops.wm.call_panel(name="VIEW3D_PT_overlay", keep_open=True)
    yield from redrawn()
    save_picture(OUTPUT / "sights-popover.png")
    view.press('ESC')
    yield from redrawn()
    print("popover", flush=True)


def steps():
    view = View()
    view.move()
    yield from curves(view)
    yield from patches(view)
    yield from straight(view)
    yield from each(view)
    yield from popover(view)


run(steps())
