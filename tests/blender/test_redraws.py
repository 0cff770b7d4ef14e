"""A redraw in which nothing changed hashes no definition and works nothing out again, and a change costs what follows it."""

import contextlib
import hashlib

import bpy
import numpy as np
import pytest

from curves import value_of
from layouts import drawn_by, panels
from shapes import VALUES, activate, add, enter, leave, move, op, require_exact, select
from support import part, splinecore as sc

causes, derived, follow, held, placing, readings, recipes, sections, sections_overlay, store, surveys = (part(name) for name in (
    'bridge.recipes.causes', 'bridge.follow.recipe_results', 'bridge.follow.follow', 'core.joints.held', 'bridge.recipes.placing', 'bridge.data.readings', 'bridge.recipes.recipes', 'core.surfaces.sections',
    'ui.sections_overlay', 'bridge.data.store', 'bridge.analysis.surveys'))
state = part('bridge.data.file_state').state


@contextlib.contextmanager
def counted(monkeypatch, owner, name):
    """A list with an entry for each call of a function meanwhile."""
    calls, own = [], getattr(owner, name)

    def called(*given, **more):
        calls.append(given)
        return own(*given, **more)
    with monkeypatch.context() as patched:
        patched.setattr(owner, name, called)
        yield calls


def sidebar():
    for panel in panels():
        if getattr(panel, 'bl_region_type', '') == 'UI' and panel.poll(bpy.context):
            drawn_by(panel, bpy.context)


def other_pool(ob, by=0.25):
    """Give a shape other points, as its net does."""
    part('bridge.shape.shape').set_value(ob.data, _moved(part('bridge.shape.shape').value_of(ob.data), by))
    bpy.context.view_layer.update()


def _moved(curve, by):
    points = np.array(curve.points)
    points[1, 0] += by
    return sc.NurbsCurve(curve.degree, curve.knots, points, periodic=curve.periodic)


def curve(name="curve", height=0.0):
    ob = add(sc.NurbsCurve(3, [0, 0, 0, 0, 1, 2, 2, 2, 2], [(0, 0, 0), (1, 2, 0), (2, -1, 0.3), (3, 1, 0), (4, 0, 0)]), name)
    ob.location.z = height
    return ob


def loft(count):
    sources = [curve(f"section {i}", i) for i in range(count)]
    activate(*sources)
    bpy.context.view_layer.update()
    assert op(bpy.ops.splinewright.add_loft) == {'FINISHED'}
    bpy.context.view_layer.update()
    return bpy.context.object, sources


def followers(count, source):
    found = [follow.new_object(part('core.recipes.table').FOLLOW, {}, [source], (4, 4), bpy.context.evaluated_depsgraph_get())
             for _ in range(count)]
    for ob in found:
        bpy.context.scene.collection.objects.link(ob)
    bpy.context.view_layer.update()
    return found


@pytest.mark.parametrize('name', ('teapot', 'mixed set', 'many curves', 'nurbs', 'hermite'))
def test_the_sidebar_hashes_and_decodes_nothing_where_nothing_changed(name, monkeypatch):
    add(VALUES[name]())
    sidebar()
    with counted(monkeypatch, hashlib, 'blake2b') as hashed, counted(monkeypatch, store, 'decoded') as decoded, \
            counted(monkeypatch, held, 'can_hold') as asked:
        sidebar()
    assert not hashed and not decoded and not asked


def test_what_holds_is_asked_again_after_a_change(monkeypatch):
    ob = add(VALUES['teapot']())
    before = surveys.ways_of(ob.data)
    assert len(before) == surveys.SHOWN and all(way.is_open != bool(way.why_not) for way in before.values())
    op(bpy.ops.splinewright.reverse)
    with counted(monkeypatch, held, 'can_hold') as asked:
        surveys.ways_of(ob.data)
        assert asked
    bpy.ops.ed.undo()
    with counted(monkeypatch, held, 'can_hold') as asked:
        assert surveys.ways_of(bpy.context.object.data) == before and not asked


@pytest.mark.parametrize('name', ('version', 'form', 'structure', 'pool', 'indices', 'knots'))
def test_a_script_that_writes_into_a_definition_is_seen_at_once(name):
    ob = add(value_of('nurbs'))
    group = ob.data[store.KEY]
    first = store.reading(ob.data)
    assert store.reading(ob.data) is first
    if isinstance(group[name], str):
        group[name] = group[name] + " "
    elif name == 'version':
        group[name] = 1
    else:
        group[name][0] = group[name][0] + 1
    assert store.reading(ob.data) is not first and store.digest(ob.data) != first.digest


@pytest.mark.parametrize('before, after', ((0.0, -0.0), (np.nan, 1.0), (1.0, np.nan), (1.0, np.nextafter(1.0, 2.0))))
def test_readings_are_compared_by_their_bytes(before, after):
    ob = add(value_of('nurbs'))
    ob.data[store.KEY]['pool'][0] = before
    known = store.reading(ob.data)
    assert store.reading(ob.data) is known, "also what is no number is the same as itself"
    ob.data[store.KEY]['pool'][0] = after
    assert store.reading(ob.data) is not known


def test_another_block_of_the_same_name_is_another():
    ob = add(value_of('nurbs'), "one")
    assert not store.read(ob.data).pieces[0].kind == 'bezier'
    name = ob.data.name
    bpy.data.objects.remove(ob)
    bpy.data.curves.remove(bpy.data.curves[name])
    other = add(value_of('cubic'), "one")
    assert other.data.name == name and store.read(other.data).pieces[0].kind == 'bezier'


def test_a_hundred_shapes_do_not_push_each_other_out(monkeypatch):
    shapes = [add(sc.BezierCurve([(i, 0), (i, 1)]), f"shape {i}") for i in range(100)]
    for ob in shapes:
        store.read(ob.data)
    with counted(monkeypatch, store, 'decoded') as decoded, counted(monkeypatch, hashlib, 'blake2b') as hashed:
        for ob in shapes:
            store.read(ob.data)
    assert not decoded and not hashed and len(state.readings) <= readings._KEPT


def test_what_is_kept_of_readings_has_a_limit(monkeypatch):
    monkeypatch.setattr(readings, '_NUMBERS', 200)
    monkeypatch.setattr(readings, '_KEPT', 5)
    for i in range(12):
        ob = add(sc.BezierCurve(np.random.default_rng(i).uniform(size=(3, 3))), f"shape {i}")
        store.read(ob.data)
        assert len(state.readings) <= 5
    big = add(sc.BezierCurve(np.random.default_rng(5).uniform(size=(60, 3))), "big")
    assert len(store.read(big.data).pool) == 60 and list(state.readings) == [part('bridge.data.file_state').key(big.data)]


def test_numbers_of_sections_are_worked_out_at_changes_alone(monkeypatch):
    ob, sources = loft(30)
    first = sections_overlay.shown(ob)
    assert len(first) == 30
    with counted(monkeypatch, recipes, 'read') as read, counted(monkeypatch, store, 'reading') as compared:
        assert sections_overlay.shown(ob) is first
    assert not read and not compared
    with counted(monkeypatch, sections, 'samples') as sampled:
        sources[3].location.x += 1
        bpy.context.view_layer.update()
        seen = sections_overlay.shown(ob)
        assert not sampled, "a curve that moved is the same curve"
        assert np.allclose(seen[3].foot - first[3].foot, (1, 0, 0)) or sum(
            not np.allclose(a.foot, b.foot) for a, b in zip(seen, first)) == 1
        other_pool(sources[3])
        sections_overlay.shown(ob)
        assert len(sampled) <= 2


@pytest.mark.parametrize('change', ('hide', 'remove', 'undo', 'frame'))
def test_numbers_of_sections_follow_every_change(change):
    ob, sources = loft(4)
    bpy.ops.ed.undo_push(message="before")
    name = ob.name
    assert len(sections_overlay.shown(ob)) == 4
    if change == 'hide':
        sources[0].hide_set(True)
        bpy.context.view_layer.update()
        assert len(sections_overlay.shown(ob)) == 3
        return
    if change == 'remove':
        bpy.data.objects.remove(sources[0])
        bpy.context.view_layer.update()
        assert len(sections_overlay.shown(ob)) == 3
        return
    sources[0].location.x = 5
    if change == 'frame':
        sources[0].keyframe_insert('location', frame=1)
        sources[0].location.x = 7
        sources[0].keyframe_insert('location', frame=2)
        bpy.context.scene.frame_set(1)
    bpy.context.view_layer.update()
    assert max(one.foot[0] for one in sections_overlay.shown(ob)) == pytest.approx(5)
    if change == 'frame':
        bpy.context.scene.frame_set(2)
        assert max(one.foot[0] for one in sections_overlay.shown(ob)) == pytest.approx(7)
    else:
        bpy.ops.ed.undo_push(message="after")
        bpy.ops.ed.undo()
        assert max(one.foot[0] for one in sections_overlay.shown(bpy.data.objects[name])) == pytest.approx(0)


def test_followers_are_sorted_when_others_follow_and_not_at_every_step(monkeypatch):
    one, other = curve("one"), curve("other")
    followers(6, one)
    follower, = followers(1, other)
    other_pool(other)
    with counted(monkeypatch, causes, '_in_order') as sorted_, counted(monkeypatch, causes, 'addresses') as asked, \
            counted(monkeypatch, derived, 'work') as made:
        other_pool(other)
        other_pool(other)
    assert not sorted_ and len(made) == 2
    assert {given[0].name for given in asked} == {follower.data.name}, "others are not looked at"
    require_exact(follower)
    assert np.array_equal(store.read(follower.data).pool, store.read(other.data).pool)


def test_many_followers_of_one_curve_are_evaluated_once_each(monkeypatch):
    source = curve()
    found = followers(20, source)
    with counted(monkeypatch, derived, 'work') as made:
        other_pool(source)
        bpy.context.view_layer.update()
        bpy.context.view_layer.update()
    assert len(made) == 20
    assert all(np.array_equal(store.read(ob.data).pool, store.read(source.data).pool) for ob in found)


def to_other_input(ob, sources):
    follow.set_inputs(ob.data, sources, (), bpy.context.evaluated_depsgraph_get())


@pytest.mark.parametrize('how', ('another input', 'other data', 'remapped', 'renamed', 'an undone input'))
def test_whatever_changes_what_is_followed_is_noticed(how):
    ob, sources = loft(3)
    spare = curve("spare", 2)
    bpy.ops.ed.undo_push(message="start")
    bpy.context.view_layer.update()
    other_pool(sources[0])              # the index is there
    name, source = ob.name, sources[2]
    if how == 'another input':
        to_other_input(ob, [*sources[:2], spare])
        source = spare
    elif how == 'other data':
        source.data = spare.data
    elif how == 'remapped':
        source.user_remap(spare)
        source = spare
    elif how == 'renamed':
        ob.data.name, source.data.name = "another name", "its input"
    else:
        to_other_input(ob, [*sources[:2], spare])
        bpy.ops.ed.undo_push(message="other input")
        bpy.ops.ed.undo()
        ob, source = bpy.data.objects[name], bpy.data.objects[source.name]
    bpy.context.view_layer.update()
    before = store.read(ob.data).pool.copy()
    other_pool(source, 0.5)
    now = store.read(ob.data).pool
    assert now.shape != before.shape or not np.array_equal(now, before)
    follow.refresh_all(set(), bpy.context.evaluated_depsgraph_get())
    assert np.array_equal(store.read(ob.data).pool, now)


def test_random_changes_leave_followers_as_if_all_were_made_anew():
    random = np.random.default_rng(8)
    inputs = [curve(f"input {i}", i) for i in range(4)]
    found = []
    for i in range(10):
        found += followers(1, (inputs + found)[random.integers(len(inputs) + len(found))])
    for step in range(30):
        ob = inputs[random.integers(4)]
        if random.integers(3) == 0:
            ob.location = random.uniform(-1, 1, 3)
            bpy.context.view_layer.update()
        elif random.integers(4) == 0 and len(found) > 5:
            index = random.integers(len(found))
            gone = found[index]
            if not any(gone in recipes.pointers(other.data) for other in found):
                found.remove(gone)
                bpy.data.objects.remove(gone)
        else:
            other_pool(ob, random.uniform(0.1, 1))
        if step % 5 == 4:
            bpy.ops.ed.undo_push(message="step")
        now = {each.name: store.read(each.data).pool.copy() for each in found}
        state.made.clear()
        follow.refresh_all(set(), bpy.context.evaluated_depsgraph_get())
        for each in found:
            assert np.array_equal(store.read(each.data).pool, now[each.name]), (step, each.name)


def test_a_follower_that_was_changed_by_hand_is_still_told_so():
    source = curve()
    ob, = followers(1, source)
    other_pool(source)
    ob.data.splines[0].points[0].co.z += 1
    ob.data.update_tag()
    bpy.context.view_layer.update()
    assert "changed by hand" in follow.problem(ob.data)


def test_while_a_net_is_dragged_its_followers_go_along():
    source = curve()
    ob, = followers(1, source)
    activate(source)
    net = enter()
    select(net, 1)
    for _ in range(3):
        move(0, 0.5, 0)
        assert np.array_equal(store.read(ob.data).pool, store.read(source.data).pool)
    leave()
