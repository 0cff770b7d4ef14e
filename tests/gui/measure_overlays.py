"""What a redraw costs with what is drawn over shapes of about 1e5 vertices where nothing changed, in milliseconds: our own work
in our callbacks (of their thread, without what waits for others), the handing over to be painted, and the whole beside the same
redraw without it. Without a graphics card a program paints, much of it while things are handed over: these figures tell how
much there is to paint, the first one what is ours.

    run.sh ZIP OUTPUT measure_overlays.py       (./run bench-live)
"""

import statistics
import sys
import time
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from window import View, distances_measured, empty_file, into_net, nets, out_of_net, part, redrawn, run, until

drawing, sights, sc = part('ui.drawing'), part('bridge.analysis.overlays'), part('core.base.library').sc
state = part('bridge.data.file_state').state
REDRAWS = 5
#: Of each callback of the last redraw, milliseconds.
_spent = {}


def timed(draw):
    def measured():
        start = time.thread_time()
        draw()
        _spent[draw] = 1e3 * (time.thread_time() - start)
    return measured


class Batch:
    """Measures how long another one takes to be handed over."""

    def __init__(self, own):
        self.own = own

    def draw(self, shader):
        start, own_start = time.perf_counter(), time.thread_time()
        self.own.draw(shader)
        _spent['painting'] = _spent.get('painting', 0.0) + 1e3 * (time.perf_counter() - start)
        _spent['handing'] = _spent.get('handing', 0.0) - 1e3 * (time.thread_time() - own_start)


def time_callbacks():
    """From now on ours are called by others that measure them, and so is what they draw."""
    for name in ('ui.line_batches', 'ui.surface_shader', 'ui.legend'):
        room = part(name)
        room.batch_for_shader = lambda *given, make=room.batch_for_shader, **more: Batch(make(*given, **more))
    drawing.unregister()
    drawing._handles = tuple(bpy.types.SpaceView3D.draw_handler_add(timed(draw), (), 'WINDOW', when)
                             for draw, when in drawing._DRAWS)


def redraw(view):
    """Milliseconds of (all our callbacks but for painting, painting, the whole): the medians of some."""
    inside, painting, whole = [], [], []
    for _ in range(REDRAWS):
        _spent.clear()
        view.area.tag_redraw()
        start = time.perf_counter()
        with view.override():
            bpy.ops.wm.redraw_timer(type='DRAW_WIN', iterations=1)
        whole.append(1e3 * (time.perf_counter() - start))
        painting.append(_spent.pop('painting', 0.0))
        inside.append(sum(_spent.values()))
    return statistics.median(inside), statistics.median(painting), statistics.median(whole)


def sheet(count, shift=0.0):
    x, y = np.meshgrid(np.linspace(-2, 2, count), np.linspace(-2, 2, count), indexing='ij')
    knots = np.concatenate([np.zeros(3), np.arange(count - 2.0), np.full(3, count - 3.0)])
    return sc.NurbsPatch((3, 3), (knots, knots), np.stack([x, y, 0.3 * np.cos(2 * x * y) + shift], -1))


def wave(count):
    t = np.linspace(0, 40, count)
    knots = np.concatenate([np.zeros(3), np.arange(count - 2.0), np.full(3, count - 3.0)])
    return sc.NurbsCurve(3, knots, np.stack([0.1 * t - 2, np.sin(t), np.cos(t)], -1))


def added(value, name, resolution):
    data = part('bridge.shape.shape').new_data(name, value, (resolution, resolution))
    ob = bpy.data.objects.new(name, data)
    bpy.context.scene.collection.objects.link(ob)
    bpy.context.view_layer.objects.active = ob
    ob.select_set(True)
    return ob


def alone(view, value, resolution):
    empty_file()
    with view.override():
        ob = added(value, "shape", resolution)
        bpy.ops.view3d.view_selected()
    yield from redrawn()
    return ob


def report(what, view, switch_off):
    """Steps that print a line; switch_off: takes away what is measured."""
    inside, painting, whole = redraw(view)
    switch_off()
    yield from redrawn()
    print(f"  {what:44} {inside:9.3f} {painting:9.1f} {whole:9.1f} {redraw(view)[2]:9.1f}", flush=True)


def with_switch(view, what, switch, **numbers):
    chosen = bpy.context.scene.splinewright_sights
    for name, value in numbers.items():
        setattr(chosen, name, value)
    setattr(chosen, switch, True)
    yield from redrawn()
    if switch == 'deviation':
        yield from until(distances_measured, "distances measured in the end")
        yield from redrawn()
    yield from report(what, view, lambda: setattr(chosen, switch, False))


def of_curve(view):
    ob = yield from alone(view, wave(1600), 12)
    print(f"  a curve of {len(ob.data.splines[0].points)} points as Blender has it; all off {redraw(view)[0]:.3f} ms")
    yield from with_switch(view, "curve: 1e5 vertices", 'curve')
    yield from with_switch(view, "control net", 'polygon')
    yield from with_switch(view, "knots", 'knots')
    yield from with_switch(view, "curvature comb: 1e5 vertices", 'comb', comb_density=16)
    yield from with_switch(view, "osculating circle", 'frame')
    yield from with_switch(view, "hodograph: 1e5 vertices", 'hodograph')
    other = added(wave(200), "other", 12)
    other.location.z = 1
    bpy.context.view_layer.objects.active = ob
    other.select_set(False)
    yield from with_switch(view, "distances: 1e5 vertices", 'deviation', deviation_object=other)


def of_surface(view):
    ob = yield from alone(view, sheet(32), 11)
    print(f"  a surface of {len(ob.data.vertices)} vertices; all off {redraw(view)[0]:.3f} ms")
    yield from with_switch(view, "isocurves: 1e5 vertices", 'isocurves', isocurve_count=2)
    yield from with_switch(view, "knot lines", 'knots')
    yield from with_switch(view, "normals: 1e5 vertices", 'normals', normal_count=8)
    yield from with_switch(view, "stripes: 1e5 vertices", 'stripes')
    yield from with_switch(view, "curvature colors: 1e5 vertices", 'curvature')
    bpy.ops.mesh.primitive_monkey_add(location=(0, 0, 2))
    other = bpy.context.object
    other.select_set(False)
    other.hide_set(True)
    bpy.context.view_layer.objects.active = ob
    ob.select_set(True)
    yield from with_switch(view, "distances: 1e5 vertices", 'deviation', deviation_object=other)
    with view.override():
        bpy.ops.object.mode_set(mode='OBJECT')
    ob = yield from alone(view, sheet(310), 1)
    yield from with_switch(view, "control net: 1e5 points", 'polygon')


def of_seams(view):
    flat = np.array(sheet(4).points) * (1, 1, 0)
    patches = [sc.BezierPatch(flat + (4 * i, 4 * j, 0)) for i in range(15) for j in range(15)]
    ob = yield from alone(view, sc.PatchSet.from_patches(patches), 21)
    ob.data.splinewright.show_seams = True
    yield from redrawn()
    yield from report(f"420 seams on {len(ob.data.vertices)} vertices", view,
                      lambda: setattr(ob.data.splinewright, 'show_seams', False))


def of_net(view):
    ob = yield from alone(view, sheet(32), 11)
    view.move(420, 420)
    view.press('TAB')
    yield from into_net()
    space = view.area.spaces.active
    yield from report(f"a net of {len(nets()[0].data.vertices)} points in Edit Mode; without all overlays", view,
                      lambda: setattr(space.overlay, 'show_overlays', False))
    space.overlay.show_overlays = True
    yield from redrawn()
    yield from with_switch(view, "curvature colors beside the net", 'curvature')
    view.press('TAB')
    yield from out_of_net()


def steps():
    view = View()
    view.move()
    time_callbacks()
    print(f"{bpy.app.version_string + ': medians, ms':46}      ours  painting  a redraw   without", flush=True)
    yield from of_curve(view)
    yield from of_surface(view)
    yield from of_seams(view)
    yield from of_net(view)


run(steps())
