"""Late followers are made beside Blender: what is shown in the end, what is stopped, and that nothing comes of inputs that changed meanwhile."""

import threading
from types import SimpleNamespace

import bpy
import numpy as np
import pytest

from layouts import drawn
from shapes import op
from support import part, splinecore as sc
from test_updates import curve, follower, is_exact, require_up_to_date, step

(file_state, finishing, follow, handlers, late, problems, results, stopped, store, update_now) = (part(name) for name in (
    'bridge.data.file_state', 'ui.finishing', 'bridge.follow.follow', 'ui.handlers', 'bridge.recipes.late', 'bridge.data.problems',
    'bridge.follow.recipe_results', 'ui.stopped', 'bridge.data.store', 'ui.operators.update_now'))
state = file_state.state


class Gate:
    """Works on another thread wait for it, by the name of their first source, until it is open or they are to end."""

    def __init__(self):
        self.open, self.begun, self.ended, self.made = threading.Event(), threading.Event(), threading.Event(), []

    def work(self, recipe, values, sources, *more, own=results.work):
        make, name = own(recipe, values, sources, *more), sources[0].name

        def waits(cancel):
            if threading.current_thread() is not threading.main_thread():
                self.begun.set()
                while not self.open.wait(0.005):
                    if cancel():
                        self.ended.set()
                        raise sc.Cancelled("cancelled")
                self.made.append(name)
            return make(cancel)
        return waits


@pytest.fixture
def gate(monkeypatch):
    """All that follows is taken for slow in a drag."""
    found = Gate()
    monkeypatch.setattr(results, 'work', found.work)
    monkeypatch.setattr(late, 'BUDGET', -1.0)
    monkeypatch.setattr(handlers, '_budget', lambda caller: late.Budget())
    yield found
    found.open.set()


def begun(gate):
    """A go of which the first work is under way, and waits."""
    found = finishing.Finishing()
    assert not found.go_on(0.01) and gate.begun.wait(30)
    return found


def ends(go):
    """Go on until nothing is left, with Blender looking for changes as it does between two events."""
    for _ in range(200):
        is_done = go.go_on(5.0)
        bpy.context.view_layer.update()
        if is_done:
            return True
    return False


def test_what_is_late_is_made_on_another_thread_each_after_what_it_follows(gate):
    source = curve()
    first = follower(source)
    second = follower(first)
    step(source)
    assert late.is_late(first.data) and not is_exact(first, source)
    go = begun(gate)
    assert not is_exact(first, source)
    gate.open.set()
    assert ends(go)
    require_up_to_date(first, source)
    require_up_to_date(second, first)
    assert gate.made == ["curve", first.name]


def test_many_are_made_once_each(gate):
    source = curve()
    found = [follower(source) for _ in range(30)]
    step(source)
    gate.open.set()
    assert ends(finishing.Finishing())
    for ob in found:
        require_up_to_date(ob, source)
    assert gate.made == ["curve"] * 30


def test_stopped_it_stays_as_it_was_and_says_how_it_is_made(gate):
    source = curve()
    ob, other = follower(source), follower(source)
    before = store.read(ob.data).pool
    step(source)
    go = begun(gate)
    go.drop()
    assert go.stop() == [ob.name, other.name] and gate.ended.wait(30)
    assert store.read(ob.data).pool is before and late.is_late(ob.data) and late.waiting() == []
    assert "Update Now" in problems.of(ob.data, problems.FOLLOWING) and "Update Now" in stopped.in_status(bpy.context.view_layer)
    assert "Update Now" in drawn() and "mouse rests" not in drawn()
    assert op(bpy.ops.splinewright.update_now) == {'FINISHED'}
    require_up_to_date(other, source)
    assert late.is_stopped(ob.data) and not late.is_late(other.data) and not problems.of(other.data, problems.FOLLOWING)


def test_stopped_it_is_made_after_the_next_change(gate):
    source = curve()
    ob = follower(source)
    step(source)
    go = begun(gate)
    go.drop()
    go.stop()
    step(source)
    assert late.waiting() == [ob.data] and not problems.of(ob.data, problems.FOLLOWING)
    gate.open.set()
    assert ends(finishing.Finishing())
    require_up_to_date(ob, source)


def test_nothing_comes_of_inputs_that_changed_meanwhile(gate):
    source = curve()
    ob = follower(source)
    before = store.read(ob.data).pool
    step(source)
    go = begun(gate)
    step(source, 0.4)
    assert gate.ended.wait(30), "the library's call ends by itself"
    assert store.read(ob.data).pool is before
    gate.open.set()
    assert ends(go)
    require_up_to_date(ob, source)
    assert gate.made == ["curve"]


@pytest.mark.parametrize('how', ('renamed', 'deleted', 'made editable', 'made by others', 'undone', 'of a damaged input'))
def test_what_becomes_of_it_while_it_is_made(gate, how):
    source = curve()
    ob = follower(source)
    name = ob.name
    bpy.ops.ed.undo_push(message="before")
    step(source)
    bpy.ops.ed.undo_push(message="step")
    go = begun(gate)
    if how == 'renamed':
        ob.data.name = "another name"
    elif how == 'deleted':
        bpy.data.meshes.remove(ob.data) if ob.type == 'MESH' else bpy.data.curves.remove(ob.data)
    elif how == 'made editable':
        op(bpy.ops.splinewright.make_editable)
    elif how == 'made by others':
        follow.finish(late.blocks(), bpy.context.evaluated_depsgraph_get())
        assert gate.made == []
    elif how == 'undone':
        bpy.ops.ed.undo()
    else:
        store.assign(source.data, store.KEY, "nothing")
    gate.open.set()
    assert ends(go)
    assert not state.late and late.waiting() == []
    if how in ('made by others', 'undone'):
        require_up_to_date(bpy.data.objects[name], bpy.data.objects["curve"])
    if how == 'renamed':
        require_up_to_date(ob, source)


def test_why_it_cannot_be_made_is_told(gate, monkeypatch):
    source = curve()
    ob = follower(source)
    step(source)
    own = results.work

    def fails(*given):
        make = own(*given)

        def failing(cancel):
            make(cancel)
            raise sc.InvalidShape("it is no curve any more")
        return failing
    monkeypatch.setattr(results, 'work', fails)
    gate.open.set()
    assert ends(finishing.Finishing())
    assert "no curve any more" in problems.of(ob.data, problems.FOLLOWING) and not late.is_late(ob.data)


def test_esc_is_the_drags_while_one_is_under_way(gate, monkeypatch):
    source = curve()
    follower(source)
    step(source)
    go = begun(gate)
    state.costs[next(iter(state.late))] = (4.0,)
    texts = []
    context = SimpleNamespace(workspace=SimpleNamespace(status_text_set=texts.append))
    lets_pass = update_now.SPLINEWRIGHT_OT_update_late.lets_pass
    for is_free in (False, True):
        monkeypatch.setattr(update_now, 'has_esc', lambda: is_free)
        one = SimpleNamespace(_finishing=go, _said=None)
        update_now.SPLINEWRIGHT_OT_update_late._tell(one, context)
        assert "of about 4 s" in texts[-1] and ("Esc" in texts[-1]) == is_free
        assert lets_pass(one, SimpleNamespace(type='ESC')) != is_free
        assert lets_pass(one, SimpleNamespace(type='MOUSEMOVE')) and not lets_pass(one, SimpleNamespace(type='TIMER'))
    go.drop()
    assert gate.ended.wait(30)


def test_random_drags_while_it_is_made_leave_nothing_behind(gate):
    random = np.random.default_rng(31)
    sources = [curve(f"input {i}", i) for i in range(3)]
    found = []
    for i in range(8):
        found.append(follower((sources + found)[random.integers(3 + len(found))]))
    gate.open.set()
    go = finishing.Finishing()
    for _ in range(25):
        step(sources[random.integers(3)], random.uniform(-1, 1))
        for _ in range(random.integers(3)):
            go.go_on(random.choice([0.0, 0.001, 0.01]))
            bpy.context.view_layer.update()
    assert ends(go)
    for ob in found:
        require_up_to_date(ob, part('bridge.recipes.recipes').pointers(ob.data)[0])


def test_a_script_has_all_of_it_at_once(gate):
    source = curve()
    ob = follower(source)
    step(source)
    assert bpy.ops.splinewright.update_late() == {'FINISHED'}
    require_up_to_date(ob, source)
    assert gate.made == []
