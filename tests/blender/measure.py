"""What following costs, in milliseconds, beside Blender's own NURBS surface in the same run; last what is aimed at.

    blender --background ... --python measure.py        (./run bench-live)
"""

import os
import statistics
import subprocess
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

fineness, handlers, live, native, shape = (part(name) for name in (
    'bridge.data.tessellate', 'ui.handlers', 'bridge.net.live', 'core.native.native', 'bridge.shape.shape'))

COUNT = 32
#: Points in a row of a large net, which is to be dragged at ten frames a second.
LARGE = 100
#: Faces in a span of ours, and Blender's resolution, for as many vertices: a hundred thousand and a million.
SIZES = ((11, 10), (35, 32))
#: Vertices of the adaptive mesh that is moved, about.
ADAPTIVE = 389_000
#: Steps of a drag before it is timed.
_WARM = 3
#: How many times as fast as Blender's own surface a step is to be: 3.4 evaluates every mesh anew as a whole.
RATIO = 2.5 if bpy.app.version < (4, 0, 0) else 20.0
#: (what, the median, the best, its unit, the least or most that is aimed at or None, whether that is the least).
FIGURES = []


def figure(what, found, unit, mark=None, is_least=False):
    """found: median and best, or one number."""
    median, best = found if isinstance(found, tuple) else (found, found)
    FIGURES.append((what, median, best, unit, mark, is_least))


def minus(one, other):
    return one[0] - other[0], one[1] - other[1]


def table():
    print(f"\nBlender {bpy.app.version_string}: what was measured, beside what is aimed at\n")
    print(f"| what | median | best | mark | |\n|{' --- |' * 5}")
    for what, median, best, unit, mark, is_least in FIGURES:
        aim = "" if mark is None else f"{'≥' if is_least else '≤'} {mark:g} {unit}"
        reached = [] if mark is None else [much >= mark if is_least else much <= mark for much in (median, best)]
        met = "" if mark is None else "met" if reached[0] else "met at best" if reached[1] else "missed"
        print(f"| {what} | {median:.3g} {unit} | {best:.3g} {unit} | {aim} | {met} |")


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


def net(count=COUNT):
    x, y = np.meshgrid(np.linspace(-2, 2, count), np.linspace(-2, 2, count), indexing='ij')
    return np.stack([x, y, 0.3 * np.cos(2 * x * y)], -1)


def clamped(count=COUNT):
    return np.concatenate([np.zeros(3), np.arange(count - 2.0), np.full(3, count - 3.0)])


def patch(count=COUNT):
    return sc.NurbsPatch((3, 3), (clamped(count), clamped(count)), net(count))


def idle():
    fill(2)
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
    figure("an update where nothing changed, 1000 shapes in the file", tuple(1e3 * t / calls for t in times), "µs", 20)

    def nudge():
        cube.location.x += 0.1
        bpy.context.view_layer.update()
    with Timed(handlers.updated) as shares:
        for _ in range(1000):
            nudge()
    figure("an update where another object moved, 1000 shapes in the file",
           (1e3 * statistics.median(shares), 1e3 * min(shares)), "µs", 20)
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


def by_count(resolution):
    """What gives a shape so many faces in a span."""
    return lambda data: data.splinewright.set_resolution(resolution, resolution)


def by_tolerance(count):
    """What gives a shape about so many vertices: their number is as one over the tolerance."""
    made = sc.PatchSet.from_patches([patch()])
    trial = 1e-5
    tolerance = trial * sc.Tessellation.adaptive(made, tolerance=trial).vertex_count / count

    def set_tolerance(data):
        data.splinewright.mode = 'TOLERANCE'
        data.splinewright.tolerance = tolerance
    return set_tolerance


def automatic(data):
    data.splinewright.mode = 'AUTOMATIC'


class Timed:
    """A handler in the place of the add-on's, with what it took at each call."""

    def __init__(self, handler):
        self.handler, self.times = handler, []

    def __enter__(self):
        self.chain = bpy.app.handlers.depsgraph_update_post
        self.chain[self.chain.index(handlers.updated)] = self._call
        return self.times

    def _call(self, *arguments):
        self.times.append(once(lambda: self.handler(*arguments)))

    def __exit__(self, *_):
        self.chain[self.chain.index(self._call)] = handlers.updated


def steps_of(held, count, handler=handlers.updated):
    """(what a handler takes, what a whole step takes) where one point of a net is dragged."""
    mesh = bmesh.from_edit_mesh(held.data)
    mesh.verts.ensure_lookup_table()

    def whole():
        mesh.verts[500 % len(mesh.verts)].co.z += 0.001
        bmesh.update_edit_mesh(held.data, loop_triangles=False, destructive=False)
        bpy.context.view_layer.update()
    with Timed(handler) as shares:
        steps = [once(whole) for _ in range(_WARM + count)]
    return [(statistics.median(times), min(times)) for times in (shares[_WARM:], steps[_WARM:])]


def bare(held, data):
    """A handler of nothing but the calls of Blender that no add-on can do without: the points of the net are read, those
    that the mesh has are written to it again, and Blender is told."""
    points, positions = np.empty(3 * len(held.data.vertices), np.float32), np.empty(3 * len(data.vertices), np.float32)

    def items():
        attribute = data.attributes.get('position')
        return (data.vertices, 'co') if attribute is None else (attribute.data, 'vector')
    vertices, field = items()
    vertices.foreach_get(field, positions)

    def handler(*_):
        held.update_from_editmode()
        held.data.vertices.foreach_get('co', points)
        vertices, field = items()
        vertices.foreach_set(field, positions)
        data.update()
    return handler


def drag(set_fineness, count=40, points=COUNT):
    """(vertices, what the handler takes, a whole step, bare() and a whole step with that alone, the end of the gesture)."""
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
    ob = add(patch(points))
    set_fineness(ob.data)
    held = enter()
    found = *steps_of(held, count), *steps_of(held, count, bare(held, ob.data))
    settled = once(lambda: live.finalize(ob.data))
    bpy.ops.splinewright.leave_net()
    return len(ob.data.vertices), *found, settled


def rival(resolution, count=12):
    """(vertices, what a whole step takes) of the same drag of Blender's own surface."""
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
    ob = surface_object(COUNT, COUNT)
    points = np.concatenate([net(), np.ones((COUNT, COUNT, 1))], -1)
    direction = native.Direction(COUNT, 3, native.Flags(endpoint=True))
    set_surface(ob, points, (direction, direction), (resolution, resolution))

    def whole():
        points[16, 16, 2] += 0.001
        set_net(ob, points)
        bpy.context.view_layer.update()
    times = milliseconds(whole, count)
    made = ob.evaluated_get(bpy.context.evaluated_depsgraph_get()).to_mesh()
    return len(made.vertices), times


def drags():
    """One point of a net of COUNT x COUNT is dragged: ours, and Blender's own surface beside it."""
    print(f"\none point of {COUNT} x {COUNT} is dragged, bicubic; medians (and least), milliseconds; "
          f"Blender {bpy.app.version_string}\n")
    print("| faces | vertices | the handler | Blender's calls in it | a whole step | with those calls alone "
          "| Blender's surface | its vertices | ratio of steps | ratio to the handler | the end of the gesture |")
    print(f"|{' --- |' * 11}")
    for most, (faces, resolution) in zip((0.5, 4.0), SIZES):
        ours, theirs = drag(by_count(faces)), rival(resolution)
        row(f"{faces} in a span", ours, theirs)
        vertices, share, whole, blenders, _, settled = ours
        figure(f"one point of {COUNT} x {COUNT}, {vertices} vertices: ours", minus(share, blenders), "ms", most)
        figure("    Blender's calls beside it", blenders, "ms")
        ratios = tuple(their / our for their, our in zip(theirs[1], whole))
        figure("    a whole step beside Blender's own surface, times as fast", ratios, "x", RATIO, True)
        figure("    the end of the gesture", settled, "ms")
    ours = drag(by_tolerance(ADAPTIVE))
    row("adaptive", ours, None)
    figure(f"{ours[0]} adaptive vertices: moved", ours[1], "ms", 8)
    figure("    the end of the gesture, with other faces", ours[-1], "ms")
    vertices, _, _, whole, *_ = drag(automatic, points=LARGE)
    figure(f"one point of {LARGE} x {LARGE}, automatic faces, {vertices} vertices: a whole step", whole, "ms", 100)
    adaptive()


def adaptive():
    """How long the faces by tolerance are made, and a shape is with them."""
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
    ob, made = add(patch()), sc.PatchSet.from_patches([patch()])
    whole = once(lambda: by_tolerance(ADAPTIVE)(ob.data))
    faces = milliseconds(lambda: fineness.tessellated(ob.data, made), 5)
    figure(f"{len(ob.data.vertices)} adaptive vertices: made", faces, "ms", 300)
    figure("    and written into a mesh, with normals", whole, "ms")


def row(faces, ours, theirs):
    vertices, share, whole, blenders, alone, settled = ours
    beside = ("", "", "", "")
    if theirs is not None:
        count, step = theirs
        ratios = f"{step[0] / whole[0]:.1f}x", f"{step[0] / share[0]:.0f}x"
        beside = f"{step[0]:.1f} ({step[1]:.1f})", f"{count}", *ratios
    ours = " | ".join(f"{median:.2f} ({least:.2f})" for median, least in (share, blenders, whole, alone))
    print(f"| {faces} | {vertices} | {ours} | {' | '.join(beside)} | {settled:.0f} |", flush=True)


def fill(resolution):
    """A thousand shapes."""
    for i in range(1000):
        data = shape.new_data("shape", sc.BezierPatch(net()[:4, :4] + (i % 40, i // 40, 0)), (resolution, resolution))
        bpy.context.scene.collection.objects.link(bpy.data.objects.new("shape", data))
    bpy.context.view_layer.update()


def choose_one():
    """One of a thousand is active, and a net can be put out of it."""
    ob = bpy.data.objects[500]
    ob.select_set(True)
    bpy.context.view_layer.objects.active = ob
    return ob


def make_plain(blocks):
    """Take all that is ours away from data-blocks: they are meshes as others."""
    for data in blocks:
        part('bridge.data.store').remove(data)
        for name in [layer.name for layer in data.attributes if layer.name in _OURS]:
            data.attributes.remove(data.attributes[name])


_OURS = ('parameters', 'patch', '.splinewright_sharp')


def dragged(resolution, plain):
    """What the handler and a whole step take where the net of one of a thousand shapes is dragged. plain: whether all others
    are plain meshes instead, for Blender to look at them takes what the processor had at hand."""
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
    fill(resolution)
    chosen = choose_one()
    if plain:
        make_plain(data for data in bpy.data.meshes if data != chosen.data)
    bpy.ops.splinewright.edit_net('EXEC_DEFAULT', True)
    found = steps_of(bpy.context.object, 150)
    bpy.ops.splinewright.leave_net('EXEC_DEFAULT', True)
    return found


def crowd(resolution):
    """A net among a thousand shapes, and their file beside one of the same meshes without anything of ours."""
    # In turns, so that both see the same machine.
    turns = [(dragged(resolution, True), dragged(resolution, False)) for _ in range(4)]
    plain, handler, step = (tuple(statistics.median(turn[which][part][k] for turn in turns) for k in range(2))
                            for which, part in ((0, 0), (1, 0), (1, 1)))
    opened, closed = [], []
    for _ in range(5):
        opened.append(once(lambda: bpy.ops.splinewright.edit_net('EXEC_DEFAULT', True)))
        closed.append(once(lambda: bpy.ops.splinewright.leave_net('EXEC_DEFAULT', True)))
    print(f"1000 shapes of {resolution} x {resolution} faces:")
    report("  a point of one is dragged: the handler", handler)
    report("  and where all others are plain meshes", plain)
    figure(f"1000 shapes of {resolution} x {resolution} faces, one is dragged: more than among plain meshes",
           minus(handler, plain), "ms", 0.1)
    report("  and a whole step", step)
    report("  a net opens", (statistics.median(opened), min(opened)))
    report("  and closes", (statistics.median(closed), min(closed)))
    ours = _megabytes()
    make_plain(bpy.data.meshes)
    plain = _megabytes()
    print(f"  the file: {ours:.1f} MB, of which {ours - plain:.1f} MB are definitions, stamps and where faces lie on patches")


def _megabytes():
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "crowd.blend"
        bpy.ops.wm.save_as_mainfile(filepath=str(path), compress=False)
        return path.stat().st_size / 1e6


def files():
    """What the add-on adds to opening a file with the shapes that are there, and to starting Blender."""
    with tempfile.TemporaryDirectory() as folder:
        path = str(Path(folder) / "crowd.blend")
        bpy.ops.wm.save_as_mainfile(filepath=path, compress=False)
        loads = [once(lambda: bpy.ops.wm.open_mainfile(filepath=path)) for _ in range(3)]
        report("  the file opens", (statistics.median(loads), min(loads)))
        ours = milliseconds(handlers.loaded, 5)
        report("  of which our handler takes", ours)
        figure("a file with 1000 shapes opens", (statistics.median(loads), min(loads)), "ms")
        figure("    of which ours", ours, "ms")
    ui = part('ui')

    def again():
        ui.unregister()
        return once(ui.register)
    times = [again() for _ in range(5)]
    report("the add-on registers, its modules loaded", (statistics.median(times), min(times)))
    figure("the add-on registers, its modules loaded", (statistics.median(times), min(times)), "ms", 20)
    if bpy.app.binary_path:
        starts = sorted(started() for _ in range(6))
        report("the add-on is switched on in a Blender that has NumPy", (statistics.median(starts), starts[0]))
        figure("    and is switched on in a new Blender that has NumPy", (statistics.median(starts), starts[0]), "ms")


def started():
    """How long a Blender of its own takes to switch the add-on on, NumPy being there."""
    package = shape.__name__.partition('.bridge')[0]
    script = ("import addon_utils, time, numpy; start = time.perf_counter(); "
              f"addon_utils.enable({package!r}); print('took', time.perf_counter() - start)")
    environment = {name: value for name, value in os.environ.items() if name != 'PYTHONDONTWRITEBYTECODE'}
    said = subprocess.run([bpy.app.binary_path, '--background', '--factory-startup', '--python-expr', script],
                          env=environment, capture_output=True, text=True, check=True).stdout
    return 1e3 * float(said.partition('took ')[2].split()[0])


print("median and least of each, milliseconds", bpy.app.version_string)
bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
idle()
drags()
for resolution in (8, 24):
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
    crowd(resolution)
bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
fill(8)
files()
table()
