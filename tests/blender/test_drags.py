"""While points are dragged: the mesh has the bits of one made anew, no faces are built, others are left alone."""

import bpy
import numpy as np
import pytest

from shapes import VALUES, add, enter, leave, move, require_exact, select
from support import part, splinecore as sc, vertices

fineness, live, net_object, recipes, shape, store, versions = (part(name) for name in (
    'bridge.data.tessellate', 'bridge.net.live', 'bridge.cage.net_object', 'bridge.recipes.recipes', 'bridge.shape.shape', 'bridge.data.store',
    'bridge.data.versions'))


@pytest.mark.parametrize('name', ('nurbs patch', 'teapot', 'mixed set', 'ferguson', 'patch with a point at infinity'))
def test_every_step_shows_what_an_evaluation_from_nothing_shows(name):
    ob, random = add(VALUES[name]()), np.random.default_rng(8)
    held = enter()
    for step in range(12):
        count = len(live.session(held.data).net.rows)
        select(held, *random.choice(count, (1, 1, 3)[step % 3]).reshape(-1).tolist())
        move(*random.normal(0, 0.1, 3))
        require_exact(ob)
        if step % 4 == 3:
            bpy.ops.ed.undo()
            ob, held = bpy.data.objects["shape"], bpy.context.object
            require_exact(ob)
        if step == 6:
            live.finalize(ob.data)
            require_exact(ob)
    leave()
    require_exact(ob)


def squares():
    """Two patches side by side, on rows of their own."""
    x, y = np.meshgrid(range(3), range(3), indexing='ij')
    net = np.stack([x, y, 0 * x], -1).astype(float)
    return sc.PatchSet.from_patches([sc.BezierPatch(net), sc.BezierPatch(net + (2, 0, 0))], merge=False)


def built(monkeypatch):
    """How often faces are built from now on."""
    calls = []

    def tessellated(*arguments, work=fineness.tessellated):
        calls.append(arguments)
        return work(*arguments)
    monkeypatch.setattr(fineness, 'tessellated', tessellated)
    return calls


def test_a_drag_and_its_end_build_no_faces_once_they_are_known(monkeypatch):
    ob = add(VALUES['teapot']())
    held = enter()
    select(held, 40)
    writes = []
    monkeypatch.setattr(part('bridge.mesh.write_mesh'), 'write', lambda *arguments: writes.append(arguments))
    move(0, 0, 0.1)                     # makes them known
    assert not writes
    calls = built(monkeypatch)
    for row in (40, 3, 0, 200):
        select(held, row)
        move(0.01, 0, 0.02)
    assert not writes and not calls and store.is_draft(ob.data)
    monkeypatch.undo()
    calls = built(monkeypatch)
    live.finalize(ob.data)
    assert not calls
    leave()


def test_sides_that_come_apart_show_it_at_that_move_and_are_one_again_when_they_meet(monkeypatch):
    ob = add(squares())
    held = enter()
    select(held, 4)
    move(0, 0, 0.1)
    joined = len(ob.data.vertices)
    calls = built(monkeypatch)
    session = live.session(held.data)
    there = session.net.definition.pool[:, :3]
    corner = int(np.flatnonzero((there == (2, 0, 0)).all(1))[0])
    select(held, corner)
    move(0, 0, 0.5)
    assert len(calls) == 1 and len(ob.data.vertices) > joined
    require_exact(ob)
    move(0, 0, -0.5)
    live.finalize(ob.data)
    assert len(ob.data.vertices) == joined
    leave()
    require_exact(ob)


def test_a_shape_that_is_dragged_among_many_is_the_only_one_that_is_read(monkeypatch):
    for i in range(30):
        other = bpy.data.objects.new("other", shape.new_data("other", squares(), (2, 2)))
        bpy.context.scene.collection.objects.link(other)
    ob = add(squares())
    held = enter()
    select(held, 4)
    move(0, 0, 0.1)
    seen = set()
    for name in ('pool', 'read', 'read_stamp', 'digest', 'is_draft', 'has_definition'):
        def noted(data, work=getattr(store, name)):
            seen.add(data.name)
            return work(data)
        monkeypatch.setattr(store, name, noted)
    monkeypatch.setattr(part('ui.editing'), 'block_of', None)       # which Blender looks through all objects for
    move(0, 0, 0.1)
    live.finalize(ob.data)
    assert seen <= {ob.data.name, held.data.name} and ob.data.name in seen
    monkeypatch.undo()
    leave()


def test_a_shape_that_is_hidden_follows_its_net_and_one_in_no_scene_does_not():
    ob = add(squares())
    held = enter()
    ob.hide_set(True)
    select(held, 4)
    move(0, 0, 0.1)
    require_exact(ob)
    before = vertices(ob.data)
    bpy.context.scene.collection.objects.unlink(ob)
    move(0, 0, 0.1)
    assert "in no scene" in live.problem(held) and np.array_equal(vertices(ob.data), before)
    bpy.context.scene.collection.objects.link(ob)
    move(0, 0, 0.1)
    assert live.problem(held) == ""
    require_exact(ob)
    leave()


def test_the_attribute_that_is_chosen_stays_chosen_through_a_drag_and_other_faces():
    """From 4.5 on a drag takes an attribute away, and Blender counts those behind it anew."""
    ob = add(squares())
    names = [attribute.name for attribute in ob.data.attributes if not attribute.name.startswith('.')]
    for name in (*names, "mine"):
        if name == "mine":
            ob.data.attributes.new(name, 'FLOAT', 'POINT')
        ob.data.attributes.active = ob.data.attributes[name]
        held = enter()
        select(held, 4)
        for _ in range(2):
            move(0, 0, 0.1)
            assert name == 'custom_normal' or ob.data.attributes.active.name == name
        leave()
        assert ob.data.attributes.active.name == name
    ob.data.splinewright.resolution_u += 1
    assert ob.data.attributes.active.name == "mine"
    require_exact(ob)


def test_what_was_chosen_is_chosen_again_after_a_drag_unless_another_was_chosen_since():
    """Exact normals, where they are an attribute, are not there meanwhile."""
    ob, name = add(squares()), 'custom_normal' if versions.keeps_exact_normals else 'patch'
    ob.data.attributes.active = ob.data.attributes[name]
    keys = {net_object.EDITED_BY, *ob.data.keys()}
    held = enter()
    select(held, 4)
    move(0, 0, 0.1)
    move(0, 0, 0.1)
    assert 'custom_normal' not in ob.data.attributes
    bpy.ops.ed.undo()
    ob, held = bpy.data.objects["shape"], bpy.context.object
    live.finalize(ob.data)
    assert ob.data.attributes.active.name == name and set(ob.data.keys()) == keys
    move(0, 0, 0.1)
    ob.data.attributes.active = ob.data.attributes["parameters"]
    move(0, 0, 0.1)
    leave()
    assert ob.data.attributes.active.name == "parameters" and set(ob.data.keys()) < keys
    ob.data.splinewright.resolution_u += 1
    assert ob.data.attributes.active.name == "parameters"
    require_exact(ob)


@pytest.mark.parametrize('is_by_hand', (False, True))
def test_a_shape_that_is_detached_within_a_drag_has_its_normals_and_nothing_of_ours(is_by_hand):
    ob, name = add(squares()), 'custom_normal' if versions.keeps_exact_normals else 'patch'
    ob.data.attributes.active = ob.data.attributes[name]
    held = enter()
    select(held, 4)
    move(0, 0, 0.1)
    move(0, 0, 0.1)
    assert store.is_draft(ob.data)
    exact = shape.evaluated(ob.data, store.read(ob.data)).tessellation
    if is_by_hand:
        ob.data.vertices[0].co.x -= 0.5
        ob.data.update()
    shape.detach(ob.data)
    assert set(ob.data.keys()) <= {net_object.EDITED_BY, 'splinewright'}
    assert is_by_hand or ob.data.has_custom_normals and ob.data.attributes.active.name == name
    assert len(ob.data.loops) == len(exact.corner_vertices)
    net_object.remove(held)


def test_the_end_of_a_gesture_reads_the_faces_of_a_mesh_once_and_says_how_far_it_is(monkeypatch):
    ob = add(squares())
    held = enter()
    select(held, 4)
    move(0, 0, 0.1)
    move(0, 0, 0.1)
    reads, steps, mesh_layers = [], [], part('bridge.mesh.mesh_layers')

    def read(mesh, work=mesh_layers.corner_vertices):
        reads.append(mesh.name)
        return work(mesh)
    monkeypatch.setattr(mesh_layers, 'corner_vertices', read)
    live.finalize(ob.data, steps.append)
    assert len(reads) == 1 and steps == [1, 2]
    monkeypatch.undo()
    assert not shape.is_touched(ob.data)
    leave()
    require_exact(ob)


def test_slow_steps_of_a_drag_are_no_pauses_and_a_pause_is_one(monkeypatch):
    """What others did to a shape is looked for in a pause. Steps take long where a mesh is large."""
    session = live.Session(net_object.net_of(store.read(add(squares()).data)))
    now, looks = [100.0], []
    monkeypatch.setattr(live.time, 'monotonic', lambda: now[0])

    def look(_):
        looks.append(now[0])
        now[0] += 0.1
    monkeypatch.setattr(shape, 'require_untouched', look)
    for seconds in (0.01, *[0.6] * 10, 5.0, *[0.6] * 5):
        now[0] += seconds
        session.require_alone(None, None)
    assert [round(look - 100) for look in looks] == [0, 1, 11]


def test_a_shape_by_tolerance_is_not_read_for_faces_that_it_would_not_keep(monkeypatch):
    ob = add(squares())
    ob.data.splinewright.mode = 'TOLERANCE'
    monkeypatch.setattr(store, 'read', None)
    assert shape.faces_of(ob.data) is None
