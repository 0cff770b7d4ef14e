"""What following costs, in milliseconds, beside Blender's own NURBS surface in the same run.

    blender --background ... --python measure.py        (./run bench-live)
"""

import statistics
import sys
import tempfile
import time
from pathlib import Path

import bmesh
import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from blender_objects import set_net, set_surface, surface_object
from shapes import add, enter
from support import part, splinecore as sc

handlers, live, native, shape = (part(name) for name in ('ui.handlers', 'bridge.net.live', 'core.native.native', 'bridge.shape'))

COUNT, RESOLUTION = 32, 11


def once(action):
    """Milliseconds."""
    start = time.perf_counter()
    action()
    return 1e3 * (time.perf_counter() - start)


def milliseconds(action, repeats=30):
    """Median and least of an action's times."""
    action()
    times = [once(action) for _ in range(repeats)]
    return statistics.median(times), min(times)


def report(what, times):
    print(f"{what:68} {times[0]:8.3f}  {times[1]:8.3f}", flush=True)


def net():
    x, y = np.meshgrid(np.linspace(-2, 2, COUNT), np.linspace(-2, 2, COUNT), indexing='ij')
    return np.stack([x, y, 0.3 * np.cos(2 * x * y)], -1)


def clamped():
    return np.concatenate([np.zeros(3), np.arange(COUNT - 2.0), np.full(3, COUNT - 3.0)])


def patch():
    return sc.NurbsPatch((3, 3), (clamped(), clamped()), net())


def idle():
    for i in range(1000):
        data = shape.new_data("shape", sc.BezierPatch(net()[:4, :4]), (2, 2))
        bpy.context.scene.collection.objects.link(bpy.data.objects.new("shape", data))
    cube = bpy.data.objects.new("cube", None)
    bpy.context.scene.collection.objects.link(cube)
    bpy.context.view_layer.update()
    graph = bpy.context.evaluated_depsgraph_get()
    calls = 1000

    def often():
        for _ in range(calls):
            handlers.updated(bpy.context.scene, graph)
    times = milliseconds(often, 5)
    report("handler, nothing changed, 1000 shapes in the file (µs)", [1e3 * t / calls for t in times])

    def nudge():
        cube.location.x += 0.1
        bpy.context.view_layer.update()
    # In turns, so that both see the same machine.
    with_handler, without = [], []
    chain = bpy.app.handlers.depsgraph_update_post
    for _ in range(1000):
        with_handler.append(once(nudge))
        chain.remove(handlers.updated)
        without.append(once(nudge))
        chain.append(handlers.updated)
    with_handler, without = ((statistics.median(times), min(times)) for times in (with_handler, without))
    report("moving one object of 1001: with the handler", with_handler)
    report("moving one object of 1001: without it", without)
    print(f"{'so the handler costs (µs)':68} {1e3 * (with_handler[0] - without[0]):8.1f}  "
          f"{1e3 * (with_handler[1] - without[1]):8.1f}")


def drag():
    ob = add(patch())
    ob.data.splinewright.set_resolution(RESOLUTION, RESOLUTION)
    held = enter()
    mesh = bmesh.from_edit_mesh(held.data)
    mesh.verts.ensure_lookup_table()

    def move():
        mesh.verts[500].co.z += 0.001
        live.pull(held)
    print(f"a net of {COUNT} x {COUNT} points, {len(ob.data.vertices)} vertices:")
    report("  our share: read the net, evaluate, write the mesh", milliseconds(move, 60))

    def whole():
        mesh.verts[500].co.z += 0.001
        bmesh.update_edit_mesh(held.data, loop_triangles=False, destructive=False)
        bpy.context.view_layer.update()
    times = milliseconds(whole)
    report("  a whole step: handler, and Blender's evaluation of net and mesh", times)
    bpy.ops.splinewright.leave_net()
    return times


def rival():
    """The same drag of Blender's own surface."""
    ob = surface_object(COUNT, COUNT)
    points = np.concatenate([net(), np.ones((COUNT, COUNT, 1))], -1)
    direction = native.Direction(COUNT, 3, native.Flags(endpoint=True))
    set_surface(ob, points, (direction, direction), (10, 10))

    def whole():
        points[16, 16, 2] += 0.001
        set_net(ob, points)
        bpy.context.view_layer.update()
    times = milliseconds(whole)
    report(f"  Blender's own surface with {(10 * COUNT) ** 2} vertices: a whole step", times)
    return times


def crowd(resolution):
    """A net among a thousand shapes, and their file beside one of the same meshes without anything of ours."""
    for i in range(1000):
        data = shape.new_data("shape", sc.BezierPatch(net()[:4, :4] + (i % 40, i // 40, 0)), (resolution, resolution))
        bpy.context.scene.collection.objects.link(bpy.data.objects.new("shape", data))
    bpy.context.view_layer.update()
    ob = bpy.data.objects[500]
    ob.select_set(True)
    bpy.context.view_layer.objects.active = ob
    opened, closed = [], []
    for _ in range(5):
        opened.append(once(lambda: bpy.ops.splinewright.edit_net('EXEC_DEFAULT', True)))
        closed.append(once(lambda: bpy.ops.splinewright.leave_net('EXEC_DEFAULT', True)))
    print(f"1000 shapes of {resolution} x {resolution} faces:")
    report("  a net opens", (statistics.median(opened), min(opened)))
    report("  and closes", (statistics.median(closed), min(closed)))
    ours = _megabytes()
    for data in bpy.data.meshes:
        part('bridge.store').remove(data)
        for name in [layer.name for layer in data.attributes if layer.name in ('parameters', 'patch', '.splinewright_sharp')]:
            data.attributes.remove(data.attributes[name])
    plain = _megabytes()
    print(f"  the file: {ours:.1f} MB, of which {ours - plain:.1f} MB are definitions, stamps and where faces lie on patches")


def _megabytes():
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "crowd.blend"
        bpy.ops.wm.save_as_mainfile(filepath=str(path), compress=False)
        return path.stat().st_size / 1e6


print("median and least of each, milliseconds", bpy.app.version_string)
bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
idle()
bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
ours = drag()
bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
theirs = rival()
print(f"  ours takes {ours[0] / theirs[0]:.2f} of the time of Blender's own")
for resolution in (8, 24):
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
    crowd(resolution)
