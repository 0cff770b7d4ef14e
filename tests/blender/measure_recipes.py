"""What live recipes cost at each mouse step at their default settings, and in a drag, where slow ones wait; and what it costs to draw
panels and overlays anew where nothing changed: in milliseconds of ours.

    blender --background ... --python measure_recipes.py [WORD...]        (./run bench-live): WORD: only rows with it
"""

import hashlib
import statistics
import sys
import time
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from layouts import panels
from shapes import VALUES, activate, add
from support import part, splinecore as sc

follow, handlers, late, sections_overlay, axis_overlay, state, table = (part(name) for name in (
    'bridge.follow.follow', 'ui.handlers', 'bridge.recipes.late', 'ui.sections_overlay', 'ui.axis_overlay', 'bridge.data.file_state', 'core.recipes.table'))
#: Automatic faces, as operators begin with.
FINENESS = (12, 12, 'AUTOMATIC')
#: What a mouse step and a redraw of ours may take.
STEP, REDRAW = 33.0, 1.0
STEPS, REDRAWS = 8, 15
ROWS, WORDS = [], sys.argv[sys.argv.index('--') + 1:] if '--' in sys.argv else []


def once(action):
    """Milliseconds, or those of the processor where they are fewer: others do not count that work on the machine, and not twice what
    two threads do at once."""
    starts = time.perf_counter(), time.process_time()
    action()
    return 1e3 * min(time.perf_counter() - starts[0], time.process_time() - starts[1])


def row(what, times, most):
    ROWS.append((what, statistics.median(times), max(times), most))
    print(f"  {what:60} {statistics.median(times):9.3f}", flush=True)


def print_table():
    print(f"\nBlender {bpy.app.version_string}: ours, milliseconds\n\n| what | median | worst | goal | |\n|{' --- |' * 5}")
    for what, median, worst, most in ROWS:
        goal, said = ("", "") if most is None else (f"≤ {most:g}", 'met' if median <= most else 'missed')
        print(f"| {what} | {median:.3g} | {worst:.3g} | {goal} | {said} |")


def empty():
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)


def made(kind, *sources, **changes):
    """What a recipe makes at its default settings, but for these, of objects."""
    recipe = table.RECIPES[kind]
    graph = bpy.context.evaluated_depsgraph_get()
    ob = follow.new_object(recipe, {**recipe.defaults, **changes}, sources, FINENESS, graph)
    bpy.context.scene.collection.objects.link(ob)
    bpy.context.view_layer.update()
    activate(ob)
    return ob


def own_share(step):
    """Milliseconds of the handler at one step."""
    spent = []

    def measured(*arguments):
        spent.append(once(lambda: handlers.updated(*arguments)))
    chain = bpy.app.handlers.depsgraph_update_post
    chain[chain.index(handlers.updated)] = measured
    try:
        step()
        bpy.context.view_layer.update()
    finally:
        chain[chain.index(measured)] = handlers.updated
    return sum(spent)


def moved(ob):
    def step():
        ob.location.z += 0.01
    return step


def sculpted(ob):
    def step():
        ob.data.vertices[0].co.z += 0.001
        ob.data.update()
    return step


def lifted(ob):
    """Another pool that stays in a plane."""
    return edited(ob, 1)


def edited(ob, axis=2):
    """What gives a shape another definition, as its net does at each step of a drag."""
    shape = part('bridge.shape.shape')

    def step():
        definition = shape.store.read(ob.data)
        pool = definition.pool.copy()
        pool[len(pool) // 2, axis] += 0.001
        shape.set_definition(ob.data, replace(definition, pool=pool))
    return step


def wave(shift=0.0, count=8):
    t = np.linspace(0, 6, count)
    knots = np.concatenate([np.zeros(3), np.arange(count - 2.0), np.full(3, count - 3.0)])
    return sc.NurbsCurve(3, knots, np.stack([t, np.sin(t + shift), np.zeros(count) + shift], -1))


def flat_wave(count=8):
    return add(sc.NurbsCurve(3, np.concatenate([np.zeros(3), np.arange(count - 2.0), np.full(3, count - 3.0)]),
                             np.stack([np.linspace(0, 6, count), np.sin(np.linspace(0, 6, count)), np.zeros(count)], -1)), "plane curve")


def sheet(count, shift=0.0):
    x, y = np.meshgrid(np.linspace(-2, 2, count), np.linspace(-2, 2, count), indexing='ij')
    knots = np.concatenate([np.zeros(3), np.arange(count - 2.0), np.full(3, count - 3.0)])
    return sc.NurbsPatch((3, 3), (knots, knots), np.stack([x, y, 0.3 * np.cos(2 * x * y) + shift], -1))


def upright(ob):
    ob.rotation_euler.x = 1.4
    bpy.context.view_layer.update()
    return ob


def monkey():
    bpy.ops.mesh.primitive_monkey_add()
    return bpy.context.object


def crossing():
    one, other = add(sheet(12), "sheet"), upright(add(sheet(12, 0.1), "other"))
    return made('section', one, other), moved(other)


def teapot_sections():
    pot = add(VALUES['teapot'](), "pot")
    ob = made('planes', pot, **{name: 10 for name in ('count',) if name in table.RECIPES['planes'].defaults})
    return ob, edited(pot)


def of_one(kind, make, step=edited, **changes):
    def begin():
        source = make()
        return made(kind, source, **changes), step(source)
    return begin


def loft(count):
    def begin():
        sources = [add(wave(0.1 * i), f"section {i}") for i in range(count)]
        for i, source in enumerate(sources):
            source.location.z = 0.3 * i
        return made('loft', *sources), edited(sources[0])
    return begin


def followers(count):
    """So many followers of one curve, and another curve with one: that is changed."""
    def begin():
        crowd = add(wave(), "crowd's")
        for _ in range(count):
            ob = follow.new_object(table.FOLLOW, {}, [crowd], FINENESS, bpy.context.evaluated_depsgraph_get())
            bpy.context.scene.collection.objects.link(ob)
        source = add(wave(), "other")
        return made('follow', source), edited(source)
    return begin


def crowd(count):
    """So many followers of one curve, which is changed: a row for each of them."""
    def begin():
        ob, step = followers(count)()
        return ob, edited(bpy.data.objects["crowd's"])
    return begin


RECIPES = {
    "Suzanne to NURBS": of_one('of_mesh', monkey, sculpted),
    "Offset of a plane curve": of_one('offset', flat_wave, lifted),
    "Offset Surface, 12 × 12": of_one('offset_surface', lambda: add(sheet(12))),
    "Thicken, 12 × 12": of_one('thickened', lambda: add(sheet(12))),
    "ten sections of the teapot": teapot_sections,
    "section of two patches": crossing,
    "loft of 4": loft(4),
    "loft of 30": loft(30),
    "Extrude": of_one('extrude', flat_wave, lifted),
    "Revolve": of_one('revolve', flat_wave),
    "Pipe": of_one('pipe', flat_wave),
    "Extend Surface": of_one('extended_surface', lambda: add(sheet(12))),
    "Mirror of the teapot": of_one('mirror', lambda: add(VALUES['teapot']())),
    "one follower": followers(0),
    "one follower, 200 of another curve": followers(200),
    "one follower, 1000 of another curve": followers(1000),
    "1000 followers of one curve": crowd(1000),
}


def steps_of(step):
    """What the handler takes in steps, after a first one."""
    first = max(own_share(step), own_share(step))
    return [own_share(step) for _ in range(STEPS if first < 500 else 2)]


def recipes():
    """Each as it is made, and as in a drag, where what takes longer waits until the mouse rests."""
    for what, begin in RECIPES.items():
        if WORDS and not any(word in what for word in WORDS):
            continue
        empty()
        ob, step = begin()
        times = steps_of(step)
        problem = part('bridge.data.problems').of(ob.data, 'following')
        row(what + (f" ({problem})" if problem else ""), times, None)
        own, handlers._budget = handlers._budget, lambda caller: late.Budget()
        row("    in a drag", steps_of(step), STEP)
        handlers._budget = own


class Counted:
    """Counts how often something is hashed."""

    def __enter__(self):
        self.count, self._own = 0, hashlib.blake2b

        def counted(*given, **more):
            self.count += 1
            return self._own(*given, **more)
        hashlib.blake2b = counted
        return self

    def __exit__(self, *_):
        hashlib.blake2b = self._own


class Blank:
    """Stands for Blender's UILayout, whose own work is not counted."""

    def _part(self, *_, **__):
        return self

    label = prop = operator = separator = popover = menu = context_pointer_set = template_list = row = column = box = split = grid_flow = _part


def panel_drawn(panel):
    """What draws a panel once."""
    own = {name: getattr(panel, name) for name in dir(panel) if not name.startswith('__')}
    stand_in = SimpleNamespace(**{**own, 'layout': Blank()})
    return lambda: panel.draw(stand_in, bpy.context)


def sidebar():
    return [panel for panel in panels() if getattr(panel, 'bl_region_type', '') == 'UI' and panel.poll(bpy.context)]


def redraws(what, draw):
    draw()
    with Counted() as hashed:
        draw()
    row(f"{what}; hashed {hashed.count} times", [once(draw) for _ in range(REDRAWS)], REDRAW)


def drawn():
    shapes = {"teapot": VALUES['teapot'], "patch of 150 × 150": lambda: sheet(150), "curve of 8": wave}
    for name, value in shapes.items():
        if WORDS and not any(word in name for word in WORDS):
            continue
        empty()
        add(value())
        for panel in sidebar():
            redraws(f"{name}: panel {panel.bl_label}", panel_drawn(panel))
    for count in (8, 30, 100):
        what = f"numbers of {count} sections"
        if WORDS and not any(word in what for word in WORDS):
            continue
        empty()
        loft(count)()
        redraws(what, lambda: sections_overlay.shown(bpy.context.object))
    empty()
    ob = made('revolve', flat_wave())
    redraws("the axis of a revolved surface", lambda: axis_overlay.line_of(ob))


if not WORDS or 'drawn' not in WORDS:
    recipes()
drawn()
print_table()
