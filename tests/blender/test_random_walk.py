"""Ten thousand random steps of a careless user: nothing breaks, and every shape is what its definition says."""

import collections
import os
import sys
import traceback

import bpy
import numpy as np

from shapes import OF_CURVES, OF_PATCHES, VALUES, activate, add, names_of, numbers_of, require_exact
from support import part, splinecore as sc

editing, handlers, live, net_object, selection, recipes, shape, store = (part(name) for name in (
    'ui.editing', 'ui.handlers', 'bridge.net.live', 'bridge.cage.net_object', 'bridge.net.selection', 'bridge.recipes.recipes',
    'bridge.shape.shape', 'bridge.data.store'))

STEPS = int(os.environ.get('SPLINEWRIGHT_STEPS', 10_000))
SEED = int(os.environ.get('SPLINEWRIGHT_SEED', 20261121))
MOST_OBJECTS = 9
LARGEST = 400                           # points of a shape that is still refined
VERBS = sorted({*names_of(OF_CURVES), *names_of(OF_PATCHES)})
KINDS = [name for name in VALUES if name != 'teapot']


class Walk:
    """A user who chooses each step by lot."""

    def __init__(self, seed, folder):
        self.random = np.random.default_rng(seed)
        self.path, self.library = str(folder / "walk.blend"), str(folder / "library.blend")
        self.saved = False
        self.log = []
        self.done = collections.Counter()
        self.checked = 0
        self.choices = {mode: self._choices(f"{mode}_", "any_") for mode in ('object', 'edit')}

    def _choices(self, *prefixes):
        """Steps whose names begin so, and their odds."""
        names = [name for name in dir(self) if name.startswith(prefixes)]
        odds = np.array([self.ODDS.get(name.partition('_')[2], 1.0) for name in names])
        return [getattr(self, name) for name in names], odds / odds.sum()

    #: How often a step is chosen; others have 1.
    ODDS = {'move_points': 8, 'edit': 6, 'gesture': 4, 'undo': 3, 'add': 2, 'redo': 2, 'add_native': 1.5, 'leave': 0.6, 'delete': 0.5,
            'to_native': 0.5, 'leave_otherwise': 0.4, 'by_hand': 0.4, 'detach': 0.3, 'paste': 0.3, 'harm_the_net': 0.3,
            'delete_a_shape_whatever_the_mode': 0.3, 'exclude_a_collection': 0.2, 'remesh': 0.1, 'save': 0.1,
            'bring_from_a_file': 0.1, 'delete_the_net': 0.1, 'reopen': 0.05, 'toggle_the_add_on': 0.05, 'new_file': 0.01}

    def walk(self, count):
        for _ in range(count):
            steps, odds = self.choices['object' if bpy.context.mode == 'OBJECT' else 'edit']
            step = self.random.choice(steps, p=odds)
            self.log.append(step.__name__)
            self.done[step.__name__] += 1
            try:
                step()
            except RuntimeError as error:
                # A refusal in words is what a user may get; a traceback is not.
                assert "Traceback" not in str(error), str(error)
            bpy.context.view_layer.update()
            # Timers never run in background.
            if self.random.random() < 0.7:
                editing.sweep()
            assert not Failures.seen, Failures.seen
            if len(self.log) % 20 == 0:
                self.check()

    def check(self):
        """Every shape that no hand has changed is what its definition evaluates to, in Edit Mode, too, when gestures are over."""
        for ob in self.shapes():
            ours = ob.mode == 'OBJECT' and not (ob.library or ob.data.library or ob.data.shape_keys)
            if ours and not shape.is_touched(ob.data):
                live.finalize(ob.data)
                require_exact(ob)
                self.checked += 1

    # What is at hand

    def any(self, things):
        things = list(things)
        return things[self.random.integers(len(things))] if things else None

    def shapes(self):
        layer = bpy.context.view_layer
        return [ob for ob in bpy.data.objects if shape.has_shape(ob) and layer.objects.get(ob.name) == ob]

    def choose(self, most=1):
        """Make some shapes selected, in Object Mode; the active one, or None."""
        shapes = self.shapes()
        if not shapes:
            return None
        chosen = [self.any(shapes) for _ in range(self.random.integers(1, most + 1))]
        activate(*dict.fromkeys(chosen))
        return chosen[0]

    def op(self, operator, **settings):
        return operator('EXEC_DEFAULT', True, **settings)

    def push(self, what):
        bpy.ops.ed.undo_push(message=what)

    # Steps

    def object_add(self):
        if len(bpy.data.objects) < MOST_OBJECTS:
            add(VALUES[self.any(KINDS)](), "shape")

    def object_add_by_operator(self):
        if len(bpy.data.objects) < MOST_OBJECTS:
            self.op(self.any((bpy.ops.splinewright.add_nurbs_patch, bpy.ops.splinewright.add_hermite_curve,
                              bpy.ops.splinewright.add_bezier_patch)))

    def object_delete(self):
        if self.choose(2):
            self.op(bpy.ops.object.delete)

    def object_edit(self):
        if self.choose(3) and bpy.ops.splinewright.edit_net.poll():
            self.op(bpy.ops.splinewright.edit_net)

    def edit_move_points(self):
        for ob in editing.nets_in_edit_mode(bpy.context):
            count = len(numbers_of(ob).rows)
            try:
                selection.select(ob, numbers_of(ob), self.random.integers(0, count, 3).tolist())
            except (KeyError, IndexError):
                return                  # the net has lost its points
        self.op(self.any((bpy.ops.transform.translate, bpy.ops.transform.resize)),
                value=tuple(self.random.uniform(-0.5, 0.7, 3)))

    def edit_type_numbers(self):
        for ob in editing.nets_in_edit_mode(bpy.context)[:1]:
            if live.problem(ob) == "":
                numbers = np.array(ob.data.splinewright_points.numbers)
                numbers[self.random.integers(0, 4)] = self.random.uniform(0.5, 2)
                ob.data.splinewright_points.numbers = numbers
                self.push("type")

    def edit_verb(self):
        nets = editing.nets_in_edit_mode(bpy.context)
        if any(len(session.net.rows) > LARGEST for session in map(live.known_session, (ob.data for ob in nets)) if session):
            return
        operator = getattr(bpy.ops.splinewright, self.any(VERBS))
        if operator.poll():
            self.op(operator)

    def edit_leave(self):
        if bpy.ops.splinewright.leave_net.poll():
            self.op(bpy.ops.splinewright.leave_net)

    def edit_leave_otherwise(self):
        self.op(bpy.ops.object.mode_set, mode='OBJECT')

    def edit_harm_the_net(self):
        if bpy.context.mode == 'EDIT_MESH':
            self.op(bpy.ops.mesh.delete, type='VERT')
        elif bpy.context.mode == 'EDIT_CURVE':
            self.op(bpy.ops.curve.subdivide)

    def select_whole(self, is_ring):
        """The rings or the loops of the selected edges."""
        mesh = bpy.ops.mesh
        if 'loop_multi_select' in dir(mesh):        # later versions have one for each
            self.op(mesh.loop_multi_select, ring=is_ring)
        else:
            self.op(mesh.select_edge_ring_multi if is_ring else mesh.select_edge_loop_multi)

    def edit_gesture(self):
        """Points more or less, sensibly or not, by what Blender has for it."""
        count = int(self.random.integers(1, 4))
        way = tuple(self.random.uniform(-0.5, 0.5, 3))
        session = next((live.known_session(ob.data) for ob in editing.nets_in_edit_mode(bpy.context)), None)
        if session is None or len(session.net.rows) > LARGEST:
            return
        if bpy.context.mode == 'EDIT_MESH':
            mesh = bpy.ops.mesh
            mesh.select_mode(type=str(self.random.choice(['VERT', 'EDGE', 'FACE'])))
            if self.random.random() < 0.6:
                self.select_whole(bool(self.random.integers(2)))
            self.any((lambda: self.op(mesh.extrude_region_move, TRANSFORM_OT_translate={'value': way}),
                      lambda: self.op(mesh.subdivide_edgering, number_cuts=count),
                      lambda: self.op(mesh.subdivide, number_cuts=count),
                      lambda: self.op(mesh.dissolve_edges), lambda: self.op(mesh.delete, type='EDGE'),
                      lambda: self.op(mesh.delete, type='FACE'), lambda: self.op(mesh.duplicate)))()
        elif bpy.context.mode == 'EDIT_CURVE':
            curve = bpy.ops.curve
            if self.random.random() < 0.4:
                curve.de_select_last()
            self.any((lambda: self.op(curve.extrude_move, TRANSFORM_OT_translate={'value': way}),
                      lambda: self.op(curve.subdivide, number_cuts=count), lambda: self.op(curve.make_segment),
                      lambda: self.op(curve.split), lambda: self.op(curve.delete, type='VERT'),
                      lambda: self.op(curve.delete, type='SEGMENT'), lambda: self.op(curve.dissolve_verts),
                      lambda: self.op(curve.cyclic_toggle), lambda: self.op(curve.switch_direction),
                      lambda: self.op(curve.duplicate)))()

    def edit_delete_the_net(self):
        for ob in list(editing.nets())[:1]:
            bpy.data.objects.remove(ob)
            self.push("delete net")

    def any_delete_a_shape_whatever_the_mode(self):
        shapes = self.shapes()
        if len(shapes) > 4:
            bpy.data.objects.remove(self.any(shapes))
            self.push("delete shape")

    def any_undo(self):
        for _ in range(self.random.integers(1, 4)):
            if bpy.ops.ed.undo.poll():
                bpy.ops.ed.undo()

    def any_redo(self):
        for _ in range(self.random.integers(1, 4)):
            if bpy.ops.ed.redo.poll():
                bpy.ops.ed.redo()

    def any_set_knots(self):
        owner = self.choose() if bpy.context.mode == 'OBJECT' else next(
            (net_object.shape_of(ob) for ob in editing.nets_in_edit_mode(bpy.context) if ob == bpy.context.object), None)
        if owner and bpy.ops.splinewright.set_knots.poll():
            piece = store.read(owner.data).pieces[0]
            if piece.knots:
                knots = np.sort(piece.knots[0] + self.random.choice([0, 0.125], len(piece.knots[0])))
                self.op(bpy.ops.splinewright.set_knots, knots=" ".join(map(repr, knots.tolist())))

    def object_duplicate(self):
        if len(bpy.data.objects) < MOST_OBJECTS and self.choose():
            self.op(bpy.ops.object.duplicate, linked=bool(self.random.integers(2)))

    def object_single_user(self):
        if self.choose():
            self.op(bpy.ops.object.make_single_user, object=True, obdata=True)

    def object_transform(self):
        ob = self.choose()
        if ob:
            ob.location, ob.rotation_euler = self.random.uniform(-1, 1, 3), self.random.uniform(-1, 1, 3)
            ob.scale = self.random.uniform(0.5, 1.5, 3) * self.random.choice([-1, 1], 3)
            self.push("transform")

    def object_parent(self):
        ob, parent = self.choose(), self.any(self.shapes())
        if ob and parent and parent != ob and parent.type == 'MESH' and ob not in parent.children_recursive:
            above = parent
            while above is not None and above != ob:
                above = above.parent
            ob.parent = parent if above is None else None
            self.push("parent")

    def object_apply_transform(self):
        if self.choose():
            self.op(bpy.ops.splinewright.apply_transform, location=bool(self.random.integers(2)))

    def object_blenders_own_apply(self):
        ob = self.choose()
        if ob and ob.data.users == 1:
            self.op(bpy.ops.object.transform_apply)
            if self.random.random() < 0.8:
                self.op(bpy.ops.splinewright.adopt_transform)

    def object_resolution(self):
        ob = self.choose()
        if ob:
            ob.data.splinewright.resolution_u = int(self.random.integers(1, 6))
            self.push("resolution")

    def object_value(self):
        ob = self.choose()
        if ob and not recipes.has(ob.data):
            try:
                value = ob.data.splinewright.value
                ob.data.splinewright.value = value[0] if isinstance(value, (list, sc.PatchSet)) else value
            except ValueError:
                pass                    # changed by hand
            self.push("value")

    def object_by_hand(self):
        ob = self.choose()
        if ob:
            self.op(bpy.ops.object.mode_set, mode='EDIT')
            select = bpy.ops.mesh if ob.type == 'MESH' else bpy.ops.curve
            select.select_all(action='SELECT')
            self.op(bpy.ops.transform.resize, value=(1, 1, 1.1))
            if self.random.random() < 0.7:
                self.op(bpy.ops.object.mode_set, mode='OBJECT')

    def object_remesh(self):
        ob = self.choose()
        if ob and ob.type == 'MESH' and ob.data.users == 1:
            ob.modifiers.new("displace", 'DISPLACE')
            self.op(bpy.ops.object.modifier_apply, modifier="displace")

    def object_restore(self):
        if self.choose(2):
            self.op(bpy.ops.splinewright.restore)

    def object_detach(self):
        if self.choose():
            self.op(bpy.ops.splinewright.detach)

    def object_join(self):
        if self.choose(3) and bpy.ops.splinewright.join.poll():
            if len(store.read(bpy.context.object.data).pieces) < 12:
                self.op(bpy.ops.splinewright.join)

    def object_follow(self):
        if self.choose(2) and len(bpy.data.objects) < MOST_OBJECTS:
            self.op(bpy.ops.splinewright.follow_object)

    def object_add_native(self):
        if len(bpy.data.objects) < MOST_OBJECTS:
            self.op(self.any((bpy.ops.curve.primitive_bezier_curve_add, bpy.ops.curve.primitive_nurbs_circle_add,
                              bpy.ops.surface.primitive_nurbs_surface_torus_add,
                              bpy.ops.surface.primitive_nurbs_surface_surface_add)))

    def natives(self):
        layer = bpy.context.view_layer
        return [ob for ob in bpy.data.objects if ob.type in ('CURVE', 'SURFACE') and not shape.has_shape(ob)
                and not net_object.is_net(ob) and layer.objects.get(ob.name) == ob]

    def object_make_exact(self):
        natives = self.natives()
        if natives:
            activate(self.any(natives))
            self.op(bpy.ops.splinewright.make_exact)

    def object_to_native(self):
        if self.choose():
            self.op(bpy.ops.splinewright.to_native)

    def object_follow_native(self):
        natives = self.natives()
        if natives and len(bpy.data.objects) < MOST_OBJECTS:
            activate(self.any(natives))
            self.op(bpy.ops.splinewright.follow_object)

    def object_move_native(self):
        natives = self.natives()
        if natives:
            self.any(natives).location = self.random.uniform(-1, 1, 3)
            self.push("move native")

    def object_edit_native(self):
        natives = self.natives()
        if natives:
            activate(self.any(natives))
            self.op(bpy.ops.object.mode_set, mode='EDIT')
            bpy.ops.curve.select_all(action='SELECT')
            self.op(bpy.ops.transform.resize, value=(1.1, 1, 1))
            self.op(bpy.ops.object.mode_set, mode='OBJECT')

    def object_paste(self):
        if self.choose(2) and len(bpy.data.objects) < MOST_OBJECTS:
            bpy.ops.view3d.copybuffer()
            self.op(bpy.ops.view3d.pastebuffer)

    def object_bring_from_a_file(self):
        if self.saved and len(bpy.data.objects) < MOST_OBJECTS:
            with bpy.data.libraries.load(self.library, link=bool(self.random.integers(2))) as (inside, target):
                target.objects = inside.objects[:1]
            for ob in target.objects:
                if ob is not None and ob.name not in bpy.context.scene.collection.objects:
                    bpy.context.scene.collection.objects.link(ob)
                    if ob.library and self.random.random() < 0.5:
                        ob.override_create(remap_local_usages=True)
            self.push("bring")

    def object_exclude_a_collection(self):
        collection = bpy.data.collections.get("own")
        if collection is None:
            collection = bpy.data.collections.new("own")
            bpy.context.scene.collection.children.link(collection)
            if self.choose():
                collection.objects.link(bpy.context.object)
        for layer in bpy.context.view_layer.layer_collection.children:
            layer.exclude = not layer.exclude
        self.push("exclude")

    def object_make_editable(self):
        if self.choose(2):
            self.op(bpy.ops.splinewright.make_editable)

    def object_key_points(self):
        if self.choose(2):
            self.edit_key_points()

    def edit_key_points(self):
        self.op(self.any((bpy.ops.splinewright.key_points,) * 3 + (bpy.ops.splinewright.clear_point_keys,)))

    def any_frame(self):
        bpy.context.scene.frame_set(int(self.random.integers(1, 100)))

    def any_rename(self):
        ob = self.any(self.shapes() + list(editing.nets()))
        if ob and not ob.library and not ob.data.library:       # 4.2 keeps the names of what is linked
            ob.name, ob.data.name = f"name {self.random.integers(20)}", f"data {self.random.integers(20)}"
            self.push("rename")

    def any_hide(self):
        ob = self.any(self.shapes())
        if ob and bpy.context.mode == 'OBJECT':
            ob.hide_set(not ob.hide_get())
            self.push("hide")

    def any_save(self):
        bpy.ops.wm.save_as_mainfile(filepath=self.path)
        # A library must be another file than the one that is open, and stay as it is once linked.
        if not self.saved:
            bpy.ops.wm.save_as_mainfile(filepath=self.library, copy=True)
        self.saved = True

    def any_reopen(self):
        if self.saved:
            bpy.ops.wm.open_mainfile(filepath=self.path)
            handlers.loaded()
            self.push("open")

    def any_new_file(self):
        bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
        self.push("new")

    def any_toggle_the_add_on(self):
        part('ui').unregister()
        part('ui').register()
        handlers.loaded()


class Failures:
    """Tracebacks that Blender would only print."""

    seen = []

    def __enter__(self):
        self.before = sys.excepthook
        sys.excepthook = lambda *error: self.seen.append("".join(traceback.format_exception(*error)))

    def __exit__(self, *_):
        sys.excepthook = self.before
        self.seen.clear()


def test_the_hook_would_notice_a_traceback_of_a_handler():
    def broken(*_):
        raise KeyError("on purpose")
    bpy.app.handlers.depsgraph_update_post.append(broken)
    try:
        with Failures():
            bpy.data.objects.new("any", None)
            add(VALUES['cubic']())
            bpy.context.view_layer.update()
            assert any("on purpose" in text for text in Failures.seen)
    finally:
        bpy.app.handlers.depsgraph_update_post.remove(broken)


def run(walk, steps):
    """Take the steps and come back to Object Mode; nothing fails, in no handler either."""
    bpy.ops.ed.undo_push(message="start")
    with Failures():
        try:
            walk.walk(steps)
        except BaseException:
            print(f"seed {SEED}, after {len(walk.log)} steps, the last: {' '.join(walk.log[-40:])}")
            raise
        if bpy.context.mode != 'OBJECT':
            bpy.ops.object.mode_set(mode='OBJECT')
        editing.sweep()
        assert not Failures.seen, Failures.seen


def test_ten_thousand_random_steps(tmp_path):
    walk = Walk(SEED, tmp_path)
    run(walk, STEPS)
    kept = {ob.name for ob in editing.nets()}
    assert kept == {ob.name for ob in bpy.data.objects if net_object.is_net(ob) and not ob.library}
    assert all(live.unread(bpy.data.objects[name]) for name in kept), "a net that holds nothing more is there still"
    shapes = [ob for ob in bpy.data.objects if shape.has_shape(ob)]
    touched = [ob for ob in shapes if shape.is_touched(ob.data)]
    for ob in shapes:
        if ob.data.library:
            continue
        if ob not in touched:
            require_exact(ob)
        elif not ob.data.shape_keys:
            shape.restore(ob.data)
            require_exact(ob)
    print(f"{STEPS} steps of seed {SEED}, {walk.done['edit_move_points']} of them moves of a net, {walk.checked} shapes "
          f"compared on the way; {len(shapes)} shapes at the end, {len(touched)} of them changed by hand")
    assert STEPS < 10_000 or walk.done['edit_move_points'] > 1000 and walk.checked > 1000
