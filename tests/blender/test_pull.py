"""A point of a shape is pulled: in its net and in Object Mode; by numbers here, by the mouse in a window."""

from types import SimpleNamespace

import bpy
import numpy as np
import pytest

import patches
from curves import run, value_of
from shapes import activate, add, enter, leave, numbers_of, op, require_exact, select
from support import part, splinecore as sc

live, pulling, pull_keys, store, shape = (part(name) for name in (
    'bridge.net.live', 'core.deform.pulling', 'ui.pull_keys', 'bridge.data.store', 'bridge.shape.shape'))
CURVES = ('cubic', 'rational cubic', 'quintic', 'semicircle', 'hermite', 'hermite with corners', 'closed hermite', 'nurbs',
          'periodic', 'uniform', 'circle', 'three knots')
PATCHES = ('bezier patch', 'hermite patch', 'ferguson', 'nurbs patch', 'rational nurbs', 'both periodic', 'bicubic',
           'sphere', 'torus', 'patch with a point at infinity')
BY = (0.5, -0.25, 1.0)


def shape_of(kind):
    """A shape in a place of its own, turned and scaled."""
    ob = add(value_of(kind) if kind in CURVES else patches.value_of(kind))
    ob.location, ob.rotation_euler, ob.scale = (1, 2, 3), (0.1, 0.2, 0.3), (1, 2, 0.5)
    bpy.context.view_layer.update()
    bpy.ops.ed.undo_push(message="place")
    return ob


def middle(ob, number=1):
    """Where it is pulled: parameters that float32 holds."""
    piece = pieces(ob)[number - 1]
    domains = (piece.domain,) if ob.type == 'CURVE' else piece.domain
    return [float(np.float32(start + 0.375 * (end - start))) for start, end in domains]


def pieces(ob):
    return part('core.verbs.verbs').pieces_of(store.read(ob.data))


def world(ob, number, at):
    matrix = np.array(ob.matrix_world)
    return matrix[:3, :3] @ pieces(ob)[number - 1].evaluate(*at) + matrix[:3, 3]


def pull(ob, by=BY, number=1, at=None, **settings):
    at = at or middle(ob, number)
    return run('pull_here', piece=number, parameter_u=at[0], parameter_v=(*at, 0.5)[1], vector=by, **settings)


def moved_rows(before, after):
    return (before.pool != after.pool).any(1)


@pytest.mark.parametrize('kind', [*CURVES, *PATCHES])
def test_in_object_mode_the_point_arrives(kind):
    ob = shape_of(kind)
    name, before, start = ob.name, store.read(ob.data), world(ob, 1, middle(ob))
    assert pull(ob) == {'FINISHED'}
    after = store.read(ob.data)
    assert np.allclose(world(ob, 1, middle(ob)) - start, BY, rtol=0, atol=1e-6)
    assert (after.pool[:, 3] == before.pool[:, 3]).all() and moved_rows(before, after).any()
    assert part('core.shape.definition').have_same_pieces(before, after)
    require_exact(ob)
    bpy.ops.ed.undo()
    ob = bpy.data.objects[name]
    assert store.read(ob.data).pool.tobytes() == before.pool.tobytes()
    require_exact(ob)


@pytest.mark.parametrize('kind', [*CURVES, *PATCHES])
def test_in_the_net_it_is_the_same_and_one_step_of_undo(kind):
    ob = shape_of(kind)
    before = store.read(ob.data)
    expected = pulling.pulled(before, 0, middle(ob), np.linalg.inv(np.array(ob.matrix_world, float)[:3, :3]) @ BY)
    name, net = ob.name, enter()
    assert pull(ob) == {'FINISHED'}
    after = store.read(ob.data)
    assert live.problem(net) == "" and np.allclose(after.pool, expected.pool, rtol=0, atol=1e-6)
    still = ~moved_rows(before, expected)
    assert after.pool[still].tobytes() == before.pool[still].tobytes()
    require_exact(ob)
    bpy.ops.ed.undo()
    ob = bpy.data.objects[name]
    live.sync_from_cage(bpy.context.object)
    assert bpy.context.mode.startswith('EDIT') and store.read(ob.data).pool.tobytes() == before.pool.tobytes()
    bpy.ops.ed.redo()
    live.sync_from_cage(bpy.context.object)
    assert store.read(bpy.data.objects[name].data).pool.tobytes() == after.pool.tobytes()
    leave()
    require_exact(bpy.data.objects[name])


@pytest.mark.parametrize('in_net', [False, True])
def test_neighbors_go_along(in_net):
    ob = add(patches.value_of('four around a corner'))
    before = [patch.points for patch in pieces(ob)]
    counts = store_edges(ob)
    if in_net:
        enter()
    for number in (1, 3):
        assert pull(ob, number=number, at=[0.5, 0.5]) == {'FINISHED'}
    assert store_edges(ob) == counts
    assert all((patch.points != old).any() for patch, old in zip(pieces(ob), before))
    require_exact(ob)


def store_edges(ob):
    return part('core.shape.definition').to_patch_set(store.read(ob.data)).edge_counts()


def test_a_closed_surface_of_one_patch_stays_closed():
    ob = add(patches.value_of('sphere'))
    counts = store_edges(ob)
    (u, _), (v, v_end) = pieces(ob)[0].domain
    enter()
    for at in ([u, v + (v_end - v) / 4], [u, v]):
        start = world(ob, 1, at)
        assert pull(ob, at=at) == {'FINISHED'}
        assert store_edges(ob) == counts and np.allclose(world(ob, 1, at) - start, BY, atol=1e-6)


def test_a_closed_chain_stays_closed_and_smooth():
    ob = add(value_of('closed hermite'))
    enter()
    for at in (0.0, 0.25, 2.5):
        assert pull(ob, at=[at]) == {'FINISHED'}
    (curve,) = pieces(ob)
    assert np.array_equal(curve.points[0], curve.points[-1])
    assert np.array_equal(curve.tangents[:, 0], curve.tangents[:, 1]) and np.array_equal(curve.tangents[0], curve.tangents[-1])


def test_one_of_many_curves_is_pulled_alone():
    ob = add(value_of('many curves'))
    before = pieces(ob)
    enter()
    assert pull(ob, number=2) == {'FINISHED'}
    after = pieces(ob)
    assert [one == other for one, other in zip(before, after)] == [True, False, True, True]


def test_locality_and_the_tangent():
    ob = add(value_of('nurbs'))
    before, at = pieces(ob)[0], middle(ob)
    spreads = []
    for locality in (0.0, 2.0, 20.0):
        assert pull(ob, locality=locality) == {'FINISHED'}
        far = np.linalg.norm(pieces(ob)[0].points - before.points, axis=1)
        spreads.append(far.sum() / far.max())
        bpy.ops.ed.undo()
        ob = bpy.context.object
    assert spreads[0] > 1.2 * spreads[1] and spreads[1] > 1.2 * spreads[2]
    assert pull(ob, keep_tangent=True) == {'FINISHED'}
    gained = pieces(ob)[0].derivatives(at[0], 1) - before.derivatives(at[0], 1)
    assert np.allclose(gained, [BY, (0, 0, 0)], atol=1e-6)


def test_several_pulls_after_other_edits_keep_what_does_not_move():
    """Also where the net was edited by hand before."""
    ob = add(value_of('uniform'))
    net = enter()
    select(net, 7)
    bpy.ops.transform.translate('EXEC_DEFAULT', True, value=(0, 0, 1))
    live.sync_from_cage(net)
    before = store.read(ob.data)
    (start, _) = pieces(ob)[0].domain
    for _ in range(3):
        assert pull(ob, at=[float(start)]) == {'FINISHED'}
    after = store.read(ob.data)
    assert moved_rows(before, after).tolist() == [True] * 3 + [False] * 5
    assert after.pool[3:].tobytes() == before.pool[3:].tobytes()


def test_a_net_that_has_gained_points_is_pulled_with_them():
    ob = add(value_of('uniform'))
    net = enter()
    select(net, 2, 3)
    assert bpy.ops.curve.subdivide('EXEC_DEFAULT', True) == {'FINISHED'}
    live.sync_from_cage(net)
    before = pieces(ob)[0]
    assert len(before.points) == 9
    u = float(np.float32(before.knots[5]))
    assert pull(ob, at=[u]) == {'FINISHED'}
    after = pieces(ob)[0]
    assert len(after.points) == 9 and np.allclose(after.evaluate(u) - before.evaluate(u), BY, atol=1e-6)
    require_exact(ob)


def test_both_nets_that_are_out_can_be_pulled():
    first, second = add(value_of('nurbs'), "first"), add(value_of('uniform'), "second")
    activate(first, second)
    enter()
    before = [store.read(ob.data) for ob in (first, second)]
    assert pull(second, shape_name="second") == {'FINISHED'}
    assert [moved_rows(old, store.read(ob.data)).any() for old, ob in zip(before, (first, second))] == [False, True]
    assert pull(first, shape_name="first") == {'FINISHED'}
    assert moved_rows(before[0], store.read(first.data)).any()
    refused("no longer active", shape_name="third", vector=BY)


def refused(words, **settings):
    with pytest.raises(RuntimeError, match=words):
        run('pull_here', **settings)


@pytest.mark.parametrize('in_net', [False, True])
def test_refusals_change_nothing(in_net):
    ob = add(sc.BezierCurve([(0, 0, 0), (1, 1, 0), (1, 0, 0)], [0, 1, 0]), "arc")
    other = add(sc.BezierPatch(np.random.default_rng(0).uniform(-1, 1, (3, 3, 3))), "sheet")
    for held in (ob, other):
        activate(held)
        before = store.read(held.data)
        if in_net:
            enter()
        refused("no piece|none of number 2", vector=BY, piece=2)
        refused("u = 7", vector=BY, parameter_u=7.0)
        if held == ob:
            refused("tangent at u = 0.5 cannot be chosen", vector=BY, keep_tangent=True)
            refused("infinity at u = 0", vector=BY, parameter_u=0.0)
        else:
            refused("farther away", vector=(3e38, 3e38, 3e38), parameter_u=0.25, parameter_v=0.25)
        assert store.read(held.data).pool.tobytes() == before.pool.tobytes()
        require_exact(held)
        if in_net:
            live.sync_from_cage(bpy.context.object)
            assert live.problem(bpy.context.object) == ""
            leave()
    other.scale = (0, 1, 1)
    bpy.context.view_layer.update()
    refused("scaled to nothing", vector=BY)


def test_what_comes_of_numbers_or_of_nothing_cannot_be_pulled():
    assert not bpy.ops.splinewright.pull_here.poll()
    op(bpy.ops.splinewright.add_circle)
    with pytest.raises(RuntimeError, match="Apply Construction"):
        bpy.ops.splinewright.pull_here()
    ob = add(value_of('nurbs'))
    ob.data.splines[0].points[0].co.x += 1
    before = store.read(ob.data)
    refused("changed by hand", vector=BY)
    assert store.read(ob.data).pool.tobytes() == before.pool.tobytes()
    # A net that does not tell what its shape has.
    ob = add(value_of('nurbs'), "net")
    net = enter()
    net.data.splines.remove(net.data.splines[0])
    refused("lost points", vector=BY)


def key(kind, text="", value='PRESS'):
    return SimpleNamespace(type=kind, unicode=text, value=value)


def typed(*events):
    keys = pull_keys.Keys()
    assert all(keys.take(event) for event in events)
    return keys


def test_keys_mean_axes_distances_and_steps():
    free, sight = np.array([0.33, 0.0, 0.47]), np.array([0.0, 1.0, 0.0])
    digits = [key('ONE', "1"), key('PERIOD', "."), key('FIVE', "5")]
    assert np.array_equal(typed().vector(free, sight, 0.1), free)
    assert np.allclose(typed(key('X')).vector(free, sight, 0.1), (0.33, 0, 0))
    assert np.allclose(typed(key('X'), key('X')).vector(free, sight, 0.1), free)
    assert np.allclose(typed(key('Z'), *digits).vector(free, sight, 0.1), (0, 0, 1.5))
    assert np.allclose(typed(*digits, key('MINUS', "-")).vector(free, sight, 0.1), -1.5 * free / np.linalg.norm(free))
    assert np.allclose(typed(*digits, key('BACK_SPACE')).vector(0 * free, sight, 0.1), (1, 0, 0))
    # An axis that is seen obliquely follows the mouse; one that is seen from its end does what can be done.
    oblique = np.array([0.6, 0.8, 0.0])
    assert np.allclose(typed(key('Y')).vector(np.array([-0.48, 0.36, 0.0]), oblique, 0.1), (0, 1, 0))
    assert np.allclose(typed(key('Y')).vector(free, sight, 0.1), 0)
    keys = typed(key('Z'))
    keys.snaps = True
    assert np.allclose(keys.vector(free, sight, 0.1), (0, 0, 0.5))
    keys.take(key('Z'))
    assert np.allclose(keys.vector(free, sight, 0.1), (0.3, 0, 0.5))
    assert not keys.take(key('A', "a")) and not keys.take(key('ONE', "1", 'RELEASE'))
    keys = typed(key('ONE', "1"), key('PERIOD', "."))
    assert not keys.take(key('PERIOD', ".")) and keys.distance == 1
    for text in ("-", ".", "9" * 400):
        keys = typed(*(key('KEY', letter) for letter in text))
        assert keys.distance is None and np.array_equal(keys.vector(free, sight, 0.1), free)
    assert "along X" in typed(key('X'), *digits).words() and "[1.5|]" in typed(*digits).words()


def test_what_follows_is_told_with_how_far():
    ob = add(value_of('uniform'))
    before = store.read(ob.data)
    after = pulling.pulled(before, 0, middle(ob), np.array(BY))
    points, parts = pulling.followers(before, after)
    rows = moved_rows(before, after)
    assert np.array_equal(points, after.pool[rows, :3]) and len(points) == 4
    assert parts.max() == 1 and (parts > 0).all()
    assert len(pulling.followers(before, before)[0]) == 0
