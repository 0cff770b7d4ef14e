"""Steps of a drag that go by the step before: with the bits of whole ones, and none where anything else is other."""

import bmesh
import bpy
import numpy as np
import pytest
from mathutils import Vector

from shapes import VALUES, add, enter, leave, move, require_exact, select
from support import part, splinecore as sc

cage, dragging, file_state, live, net_object, store = (part(name) for name in (
    'bridge.cage.cage', 'bridge.net.dragging', 'bridge.data.file_state', 'bridge.net.live', 'bridge.cage.net_object', 'bridge.data.store'))


def step(held, *rows, by=(0.0, 0.0, 0.01)):
    mesh = bmesh.from_edit_mesh(held.data)
    mesh.verts.ensure_lookup_table()
    for row in rows:
        mesh.verts[row].co += Vector(by)
    bmesh.update_edit_mesh(held.data, loop_triangles=False, destructive=False)
    bpy.context.view_layer.update()


@pytest.fixture
def pulls(monkeypatch):
    """How often a net was pulled as a whole."""
    found = []

    def pull(*arguments, work=live.sync_from_cage):
        found.append(arguments)
        return work(*arguments)
    monkeypatch.setattr(live, 'sync_from_cage', pull)
    return found


def dragged(value, row=7):
    """A shape and its net, of which a point has been dragged until steps go by the step before."""
    ob, held = add(value), enter()
    for _ in range(5):
        step(held, row)
    return ob, held


def as_whole(held):
    """The pool of the shape that the net says, read from nothing."""
    session = live.session(held.data)
    net = session.net
    read = part('core.net.reading').read(net, net_object.present(held, net), net_object.typed(held.data, net), None)
    return part('core.net.exact_net').read(net, read.state).pool


def two_patches():
    return sc.PatchSet.from_patches([VALUES['bezier patch'](), VALUES['nurbs patch']()])


@pytest.mark.parametrize('name', ('nurbs patch', 'bezier patch', 'teapot', 'two patches'))
def test_steps_go_by_the_step_before_with_its_bits(name, pulls):
    ob, held = dragged(two_patches() if name == 'two patches' else VALUES[name]())
    pulls.clear()
    random = np.random.default_rng(4)
    for _ in range(10):
        step(held, 7, by=random.normal(0, 0.1, 3))
        require_exact(ob)
    assert not pulls and store.is_draft(ob.data)
    assert store.pool(ob.data).tobytes() == as_whole(held).tobytes()
    assert live.session(held.data).points.tobytes() == cage.snapshot(held).positions.tobytes()
    step(held, 7, 2, 11)
    require_exact(ob)
    live.finalize(ob.data)
    require_exact(ob)
    assert not store.is_draft(ob.data)
    leave()
    require_exact(ob)


def test_where_a_point_returns_the_shape_has_its_own_digits_again():
    value = VALUES['nurbs patch']()
    ob, held = dragged(value)
    net = live.session(held.data).net
    mesh = bmesh.from_edit_mesh(held.data)
    mesh.verts.ensure_lookup_table()
    mesh.verts[7].co = net.single[7]
    step(held)
    assert store.pool(ob.data).tobytes() == net.source.pool.tobytes()
    leave()


def other_settings(ob, held):
    ob.data.splinewright.resolution_u = 9


def another_definition(ob, held):
    store.write(ob.data, store.read(ob.data))


def a_weight(ob, held):
    mesh = bmesh.from_edit_mesh(held.data)
    mesh.verts.ensure_lookup_table()
    mesh.verts[7][mesh.verts.layers.float[cage.WEIGHT]] = 3.0


def a_new_point(ob, held):
    bmesh.from_edit_mesh(held.data).verts.new((5, 5, 5))


def an_end(ob, held):
    live.finalize(ob.data)


@pytest.mark.parametrize('what', (other_settings, another_definition, a_weight, a_new_point, an_end))
def test_what_else_is_other_is_seen_at_the_next_step(what, pulls):
    ob, held = dragged(VALUES['nurbs patch']())
    what(ob, held)
    held = bpy.context.object
    pulls.clear()
    step(held, 7)
    assert pulls
    require_exact(ob)
    leave()
    require_exact(ob)


def test_a_shape_that_may_not_be_written_meanwhile_is_left_alone_and_says_why():
    ob, held = dragged(VALUES['nurbs patch']())
    before = store.pool(ob.data)
    ob.shape_key_add(name="Basis")
    step(held, 7)
    assert "shape keys" in live.problem(held) and file_state.state.drag is None
    assert store.pool(ob.data).tobytes() == before.tobytes()
    ob.shape_key_clear()
    step(held, 7)
    assert live.problem(held) == ""
    require_exact(ob)
    leave()


def test_an_operator_and_undo_end_a_drag(pulls):
    ob, held = dragged(VALUES['nurbs patch']())
    select(held, 7)
    move(0, 0, 0.5)
    assert file_state.state.drag is None or file_state.state.drag.occasion[0] == file_state.ended_operators()
    require_exact(ob)
    bpy.ops.ed.undo()
    assert file_state.state.drag is None
    require_exact(bpy.data.objects["shape"])
    leave()


def test_a_shape_that_was_deleted_ends_a_drag():
    ob, held = dragged(VALUES['nurbs patch']())
    data = ob.data
    bpy.data.objects.remove(ob)
    bpy.data.meshes.remove(data)
    step(held, 7)
    assert "deleted" in live.problem(held) and file_state.state.drag is None
    bpy.ops.object.mode_set(mode='OBJECT')


@pytest.mark.parametrize('name', ('ferguson', 'mixed set', 'patch with a point at infinity'))
def test_nets_with_handles_go_by_whole_steps(name):
    ob, held = dragged(VALUES[name](), 0)
    assert file_state.state.drag is None
    require_exact(ob)
    leave()


def test_keys_are_seen_to_at_every_step():
    ob = add(VALUES['nurbs patch']())
    ob.data.splinewright.keyframe_insert('resolution_u')
    held = enter()
    for _ in range(3):
        step(held, 7)
    assert file_state.state.drag is None
    leave()


def test_a_point_too_far_away_is_said_and_the_shape_kept():
    ob, held = dragged(VALUES['nurbs patch']())
    before = store.pool(ob.data)
    step(held, 7, by=(np.inf, 0, 0))
    assert "not finite" in live.problem(held) and file_state.state.drag is None
    require_exact(ob)
    assert np.isfinite(store.pool(ob.data)).all() and len(before) == len(store.pool(ob.data))
    step(held, 7, by=(0, 0, 1))
    bpy.ops.object.mode_set(mode='OBJECT')
