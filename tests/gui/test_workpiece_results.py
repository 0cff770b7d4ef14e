"""Results of every kind beside one another: moved, rotated, mirrored by a negative scale, taken back and done again, copied by
Shift+D and Alt+D, given a parent, their transforms applied, saved, opened; their inputs change between. All by keys."""

import os
import sys
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
import by_keys
from window import part, redrawn, run, save_picture, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])
sc = part('core.base.library').sc
#: Names of results, of the objects that each is made from, and of copies.
MADE, INPUTS, COPIES = {}, {}, {}


def line(*points):
    return sc.BezierCurve(np.array(points, float))


def sheet(height, across=0.0):
    """A patch of 2 × 2 over the plane, from x = across on."""
    places = np.linspace(0.0, 2.0, 4)
    return sc.BezierPatch(np.array([[(x + across, y, height(x, y)) for y in places] for x in places]))


def quarters():
    return (line((0, 0, 0), (1, 0, 0.5), (2, 0, 0)), line((0, 2, 0), (1, 2, 0.5), (2, 2, 0)),
            line((0, 0, 0), (0, 1, 0.5), (0, 2, 0)), line((2, 0, 0), (2, 1, 0.5), (2, 2, 0)))


WAVE = line((0, 0, 0), (1, 1, 0), (2, -1, 0), (3, 0, 0))
HILL = sheet(lambda x, y: 0.2 * x * y)
WALL = sc.BezierPatch([[(0, 0, 0), (0, 2, 0)], [(0, 0, 2), (0, 2, 2)]])
KINDS = {
    'revolve': (line((0.3, 0, 0), (1.2, 0, 0), (0.4, 0, 1.2), (0.9, 0, 2)),),
    'extrude': (WAVE,),
    'ruled': (WAVE, line((0, 0, 2), (1, -1, 2), (3, 0, 2))),
    'loft': tuple(sc.conics.circle((0, 0, height), radius) for height, radius in ((0, 1), (1, 0.5), (2, 1.2))),
    'sweep': (line((0, 0, 0), (0, 0, 1), (1, 0, 2), (2, 0, 2)), sc.conics.circle((0, 0, 0), 0.4)),
    'two_rails': (line((0, 0, 0), (1, -0.3, 0), (2, 0, 0)), line((0, 2, 0), (1, 2.5, 0), (2, 2, 0)),
                  line((0, 0, 0), (0, 1, 1), (0, 2, 0))),
    'pipe': (line((0, 0, 0), (1, 2, 0), (2, -2, 1), (3, 0, 1)),),
    'network': quarters(),
    'filling': quarters(),
    'surface_blend': (sheet(lambda x, y: 0.2 * y), sheet(lambda x, y: 1 + 0.1 * y, 3.0)),
    'matched': (sheet(lambda x, y: 0.2 * y), sheet(lambda x, y: 0.25 * y, 2.1)),
    'rounded_edge': (sheet(lambda x, y: 0.0), WALL),
    'offset_surface': (HILL,),
    'thickened': (HILL,),
    'extended_surface': (HILL,),
    'mirror': (sheet(lambda x, y: 1.0 - 0.2 * x * x),),
    'offset': (WAVE,),
    'blend': (line((0, 0, 0), (1, 1, 0)), line((2, 1, 0), (3, 0, 0.5))),
    'about': (line((0, 0, 0), (0, 0.5, 1), (0, 0, 2)),),
    'section': (HILL, sheet(lambda x, y: 0.5 - 0.2 * x)),
    'planes': (HILL,),
    'on_patch': (line((0.2, 0.2, 0), (0.5, 0.9, 0), (0.8, 0.3, 0)), HILL),
    'projected': (line((0.2, 0.2, 1), (1, 1, 1), (1.8, 0.5, 1)), HILL),
    'follow': (WAVE,),
}
_VERBS = {'follow': 'follow_object'}
_ROW = 6


def picture(name):
    return save_picture(OUTPUT / f"results-{name}.png")


def seen(name):
    """The vertices or control points of an object in the world."""
    ob = bpy.data.objects[name]
    if ob.type == 'MESH':
        flat = np.empty(3 * len(ob.data.vertices), np.float32)
        ob.data.vertices.foreach_get('co', flat)
        points = flat.reshape(-1, 3)
    else:
        points = np.array([point.co[:3] for spline in ob.data.splines for point in spline.bezier_points or spline.points])
    return under(points, ob.matrix_world)


def under(points, matrix):
    matrix = np.array(matrix)
    return points @ matrix[:3, :3].T + matrix[:3, 3]


def all_seen():
    bpy.context.view_layer.update()
    return {kind: seen(name) for kind, name in MADE.items()}


def boxes():
    """Where they lie, whatever the order of their points, which a mirroring that is applied exchanges."""
    return {kind: np.array([points.min(axis=0), points.mean(axis=0), points.max(axis=0)])
            for kind, points in all_seen().items()}


def matrices():
    bpy.context.view_layer.update()
    return {kind: np.array(bpy.data.objects[name].matrix_world) for kind, name in MADE.items()}


def unlike(found, wanted, tolerance=1e-4):
    """The kinds that do not lie where they should."""
    return {kind: float(np.abs(found[kind] - points).max()) if found[kind].shape == points.shape else "another shape"
            for kind, points in wanted.items()
            if found[kind].shape != points.shape or np.abs(found[kind] - points).max() > tolerance}


def require_whole():
    """All follow, and nobody's hand is said to have changed one."""
    for name in MADE.values():
        data = bpy.data.objects[name].data
        assert part('bridge.follow.follow').problem(data) == "", (name, part('bridge.follow.follow').problem(data))
        assert not part('bridge.shape.shape').is_touched(data), name


def made(view):
    for number, (kind, values) in enumerate(KINDS.items()):
        place = 5.0 * (number % _ROW), 5.0 * (number // _ROW), 0.0
        with view.override():
            bpy.ops.object.select_all(action='DESELECT')
            for i, value in enumerate(values):
                ob = bpy.data.objects.new(f"{kind} {i}", part('bridge.shape.shape').new_data(f"{kind} {i}", value, (8, 8)))
                bpy.context.collection.objects.link(ob)
                ob.location = place
                ob.select_set(True)
            INPUTS[kind] = [f"{kind} {i}" for i in range(len(values))]
            bpy.context.view_layer.objects.active = bpy.data.objects[f"{kind} 0"]
            bpy.context.view_layer.update()
            verb = getattr(bpy.ops.splinewright, _VERBS.get(kind, f"add_{kind}"))
            known = set(bpy.data.objects.keys())
            verb('EXEC_DEFAULT', True)
            MADE[kind], = set(bpy.data.objects.keys()) - known
            bpy.data.objects[MADE[kind]].data.splinewright.mode = 'COUNT'   # the same points wherever they lie
    with view.override():
        bpy.ops.view3d.view_axis(type='TOP')
        bpy.context.space_data.region_3d.view_rotation = (0.9, 0.42, 0.05, 0.1)
        bpy.ops.view3d.view_all(center=False)
        bpy.ops.ed.undo_push(message="made")
    yield from redrawn()
    require_whole()
    scales = {kind: np.linalg.norm(matrix[:3, :3], axis=0) for kind, matrix in matrices().items()}
    assert {kind: scale for kind, scale in scales.items() if np.abs(scale - 1.0).max() > 1e-6} == {}
    picture("made")


def transformed(view):
    """Each goes with its matrix; then all the way back, and forth again."""
    yield from by_keys.choose(view, *MADE.values())
    places, found = [matrices()], [all_seen()]
    for text in ("G X 2 Enter", "R Z 30 Enter", "S X -0.8 Enter"):
        yield from by_keys.keys(view, text)
        yield from until(lambda: unlike(matrices(), places[-1], 1e-6), text)
        places.append(matrices())
        found.append(all_seen())
        assert set(unlike(places[-1], places[-2], 1e-6)) == set(MADE), text
        wanted = {kind: under(points, places[-1][kind] @ np.linalg.inv(places[-2][kind]))
                  for kind, points in found[-2].items()}
        assert unlike(found[-1], wanted) == {}, text
        require_whole()
    picture("transformed")
    for keys, numbers in (("Ctrl+Z", (2, 1, 0)), ("Ctrl+Shift+Z", (1, 2, 3))):
        for number in numbers:
            yield from by_keys.keys(view, keys)
            yield from until(lambda: not unlike(matrices(), places[number], 1e-6), keys)
            assert unlike(all_seen(), found[number]) == {}, (keys, number)
    require_whole()


def copied(view):
    """Copies alone follow the same inputs; linked ones are the shape in another place."""
    for key, linked in (({'shift': True}, False), ({'alt': True}, True)):
        yield from by_keys.choose(view, *MADE.values())
        before = all_seen()
        view.press('D', **key)
        yield from by_keys.keys(view, "Z 12 Enter" if linked else "Z 6 Enter")
        names = {ob.name for ob in bpy.context.selected_objects}
        assert len(names) == len(MADE) and not names & set(MADE.values())
        for kind, name in MADE.items():
            original = bpy.data.objects[name]
            copy, = (bpy.data.objects[one] for one in names if one.partition(".")[0] == name.partition(".")[0])
            assert (copy.data == original.data) == linked, kind
            COPIES.setdefault(kind, []).append(copy.name)
        yield from copies_follow()
        assert unlike(all_seen(), before) == {}
    picture("copied")


def copies_apart():
    """The copies that do not lie above what they are copies of."""
    bpy.context.view_layer.update()
    return [name for kind, names in COPIES.items() for name, height in zip(names, (6.0, 12.0))
            if unlike({kind: seen(name)}, {kind: seen(MADE[kind]) + (0.0, 0.0, height)}, 1e-3)]


def copies_follow():
    """Steps until they do: what takes long is done after what is seen at once."""
    yield from until(lambda: not copies_apart(), "the copies follow")


def visible_inputs():
    return [name for names in INPUTS.values() for name in names if bpy.data.objects[name].visible_get()]


def inputs_changed(view):
    """All follow where they have been moved to, and so do the copies."""
    before = all_seen()
    yield from by_keys.choose(view, *visible_inputs())
    followers = {kind for kind, names in INPUTS.items() if set(names) & set(visible_inputs())}
    assert followers == set(KINDS) - {'rounded_edge', 'thickened', 'extended_surface', 'mirror'}     # they hide theirs, Match one of two
    bpy.context.scene.tool_settings.transform_pivot_point = 'INDIVIDUAL_ORIGINS'
    yield from by_keys.keys(view, "S 1.2 Enter")
    yield from until(lambda: set(unlike(all_seen(), before)) == followers, "all follow")
    require_whole()
    yield from copies_follow()
    yield from by_keys.keys(view, "Ctrl+Z")
    yield from until(lambda: not unlike(all_seen(), before), "Ctrl+Z")
    yield from copies_follow()


def parented(view):
    """A parent that is moved takes each along once."""
    with view.override():
        bpy.ops.object.empty_add(location=(10, 10, 0))
        parent = bpy.context.object.name
        bpy.ops.ed.undo_push(message="parent")
    yield from by_keys.choose(view, parent, *MADE.values())
    before = all_seen()
    view.press('P', ctrl=True)
    yield from redrawn()
    view.press('RET')
    yield from until(lambda: all(bpy.data.objects[name].parent for name in MADE.values()), "Ctrl+P")
    assert unlike(all_seen(), before) == {}
    yield from by_keys.choose(view, parent)
    yield from by_keys.keys(view, "G Y 3 Enter")
    wanted = {kind: points + (0, 3, 0) for kind, points in before.items()}
    yield from until(lambda: not unlike(all_seen(), wanted), "each moves once")
    require_whole()


def applied(view):
    yield from by_keys.choose(view, *MADE.values())
    view.press('P', alt=True)
    yield from redrawn()
    view.press('C', "c")                        # Clear and Keep Transformation
    yield from until(lambda: not any(bpy.data.objects[name].parent for name in MADE.values()), "Alt+P")
    copies = [name for names in COPIES.values() for name in names]
    yield from by_keys.choose(view, *copies)
    view.press('X')
    yield from redrawn()
    view.press('RET')
    yield from until(lambda: not set(copies) & set(bpy.data.objects.keys()), "X deletes the copies")
    yield from by_keys.choose(view, *MADE.values())
    before = boxes()
    view.press('A', ctrl=True)
    yield from redrawn()
    view.press('A', "a")                        # All Transforms
    identity = {kind: np.eye(4) for kind in MADE}
    yield from until(lambda: not unlike(matrices(), identity, 1e-6), "Ctrl+A")
    yield from until(lambda: not unlike(boxes(), before), "all stay where they are seen")
    yield from redrawn()
    require_whole()


def kept(view):
    before = all_seen()
    view = yield from by_keys.saved_and_opened(view, OUTPUT / "results.blend")
    assert unlike(all_seen(), before) == {}
    require_whole()
    view.move(420, 420)
    with view.override():
        for names in INPUTS.values():
            for name in names:
                bpy.data.objects[name].hide_set(False)
    yield from by_keys.choose(view, *visible_inputs())
    yield from by_keys.keys(view, "S 1.1 Enter")
    yield from until(lambda: set(unlike(all_seen(), before)) == set(MADE), "all follow in the opened file")
    require_whole()
    picture("opened")


run(by_keys.one_by_one(made, transformed, copied, inputs_changed, parented, applied, kept))
