"""A step of a drag reads the points that moved: with the bits of a whole reading, and what else is changed is noticed."""

import bmesh
import bpy
import numpy as np
import pytest

from shapes import VALUES, add, enter, leave, move, require_exact, select
from support import part

cage, editing, exact_net, live, net_object, reading, store = (part(name) for name in (
    'bridge.cage.cage', 'ui.editing', 'core.net.exact_net', 'bridge.net.live', 'bridge.cage.net_object', 'core.net.reading',
    'bridge.data.store'))


def layer(held, name, kind='float'):
    mesh = bmesh.from_edit_mesh(held.data)
    mesh.verts.ensure_lookup_table()
    return mesh.verts, getattr(mesh.verts.layers, kind)[name]


def tell(held):
    bmesh.update_edit_mesh(held.data, loop_triangles=False, destructive=False)
    bpy.context.view_layer.update()


def require_as_whole(held):
    """What a session goes on with is what a reading from nothing gives."""
    session, net = live.session(held.data), live.session(held.data).net
    found = reading.read(net, net_object.present(held, net), net_object.typed(held.data, net), None)
    for name in ('positions', 'weights', 'kept', 'kept_weights'):
        assert getattr(session.state, name).tobytes() == getattr(found.state, name).tobytes(), name
    owner = net_object.shape_of(held)
    assert store.pool(owner.data).tobytes() == exact_net.read(net, found.state).pool.tobytes()


@pytest.fixture
def sheet():
    yield add(VALUES['nurbs patch']()), enter()
    leave()


@pytest.mark.parametrize('name', ('nurbs patch', 'bezier patch', 'teapot', 'ferguson'))
def test_every_step_has_the_bits_of_a_whole_reading(name):
    ob, held, random = add(VALUES[name]()), enter(), np.random.default_rng(3)
    net = live.session(held.data).net
    for step in range(25):
        verts, weight = layer(held, cage.WEIGHT)
        for i in random.choice(len(verts), (1, 3, len(verts))[step % 3], replace=False).tolist():
            place = np.array(verts[i].co) + random.normal(0, 0.1, 3)
            verts[i].co = net.single[i] if step % 5 == 4 else place         # back to where it was
            if step % 4 == 3 and net.weighted[i]:
                verts[i][weight] *= 1.25
        tell(held)
        require_as_whole(held)
        if name != 'teapot':            # whose poles, where they meet again, are one at the end only
            require_exact(ob)
    leave()
    require_exact(ob)


def test_points_that_move_alone_are_read(sheet, monkeypatch):
    ob, held = sheet
    select(held, 7)
    move(0, 0, 0.1)
    verts, _ = layer(held, cage.WEIGHT)

    def whole(*_):
        raise AssertionError("the whole net was read")
    monkeypatch.setattr(reading, 'read', whole)
    monkeypatch.setattr(cage, 'present', whole)
    for _ in range(3):
        verts[7].co.z += 0.1
        tell(held)
    monkeypatch.undo()
    assert live.problem(held) == ""
    require_as_whole(held)
    require_exact(ob)


def test_a_weight_that_is_changed_with_the_place_counts(sheet):
    ob, held = sheet
    for factor in (2, 3):
        verts, weight = layer(held, cage.WEIGHT)
        verts[5].co.x += 0.1
        verts[5][weight] *= factor
        tell(held)
        require_as_whole(held)
        require_exact(ob)


@pytest.mark.parametrize('how', ('settle', 'leave', 'update'))
def test_a_weight_that_is_changed_where_another_point_moves_counts_at_the_end_at_the_latest(how):
    ob, held = add(VALUES['nurbs patch']()), enter()
    verts, weight = layer(held, cage.WEIGHT)
    verts[5].co.x += 0.1
    tell(held)
    verts, weight = layer(held, cage.WEIGHT)
    verts[5].co.x += 0.1
    verts[9][weight] = 7.0
    tell(held)
    if how == 'settle':
        editing.finalize()
    elif how == 'update':
        tell(held)
    if how == 'leave':
        leave()
    row = live.session(held.data).net.rows[9] if how != 'leave' else 9
    assert store.pool(ob.data)[row, 3] == 7.0
    require_exact(ob)
    if how != 'leave':
        leave()


def test_points_that_change_places_in_the_list_are_the_same(sheet):
    ob, held = sheet
    select(held, 4)
    move(0, 0, 0.1)
    before = store.pool(ob.data)
    bpy.ops.mesh.select_all(action='SELECT')
    bpy.ops.mesh.sort_elements('EXEC_DEFAULT', True, type='REVERSE', elements={'VERT'})
    assert np.array_equal(store.pool(ob.data), before)
    select(held, 2)
    for _ in range(2):
        move(0, 0.1, 0)
        require_as_whole(held)
    changed = (store.pool(ob.data) != before).any(1)
    assert changed.sum() == 1
    require_exact(ob)


def test_undo_is_read_whole(sheet):
    ob, held = sheet
    select(held, 4)
    before = store.pool(ob.data)
    for _ in range(3):
        move(0, 0, 0.1)
    for _ in range(3):
        bpy.ops.ed.undo()
    ob, held = bpy.data.objects["shape"], bpy.context.object
    require_as_whole(held)
    assert np.array_equal(store.pool(ob.data), before)
    move(0, 0, 0.1)
    require_as_whole(held)
