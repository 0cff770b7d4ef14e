"""Shapes that follow stay behind while a drag has no time for them, and nowhere else: a fake clock, and steps as a user makes them."""

import time

import bpy
import numpy as np
import pytest

from layouts import drawn
from shapes import activate, add, op, require_exact
from support import part, splinecore as sc

derived, file_state, follow, handlers, late, recipes, settings, store = (part(name) for name in (
    'bridge.follow.recipe_results', 'bridge.data.file_state', 'bridge.follow.follow', 'ui.handlers', 'bridge.recipes.late', 'bridge.recipes.recipes', 'bridge.data.settings', 'bridge.data.store'))
state = file_state.state
MODES = ('ALWAYS', 'ON_RELEASE', 'MANUAL')


class Clock:
    """Seconds that go by where a follower is made, and nowhere else."""

    def __init__(self):
        self.now, self.costs, self.made = 100.0, {}, []

    def __call__(self):
        return self.now

    def work(self, recipe, values, sources, *more, own=derived.work):
        """derived.work() of which the result takes the time that was set for the first source; what is called off ends then."""
        make, cost = own(recipe, values, sources, *more), self.costs.get(sources[0].name, 0.0)

        def slow(cancel):
            for _ in range(10):
                self.now += cost / 10
                if cancel and cancel():
                    raise sc.Cancelled("cancelled")
            self.made.append(sources[0].name)
            return make(cancel)
        return slow


@pytest.fixture
def clock(monkeypatch):
    """A window, in which Blender itself looks for changes between two mouse steps."""
    found = Clock()
    monkeypatch.setattr(late, 'clock', found)
    monkeypatch.setattr(derived, 'work', found.work)
    monkeypatch.setattr(handlers, '_budget', lambda caller: late.Budget())
    return found


def curve(name="curve", height=0.0):
    ob = add(sc.NurbsCurve(3, [0, 0, 0, 0, 1, 2, 2, 2, 2], [(0, 0, 0), (1, 2, 0), (2, -1, 0.3), (3, 1, 0), (4, 0, 0)]), name)
    ob.location.z = height
    return ob


def follower(source, mode='ALWAYS'):
    ob = follow.new_object(part('core.recipes.table').FOLLOW, {}, [source], (4, 4), bpy.context.evaluated_depsgraph_get())
    bpy.context.scene.collection.objects.link(ob)
    ob.data.splinewright.update_mode = mode
    bpy.context.view_layer.update()
    activate(ob)
    return ob


def step(source, by=0.1):
    """One of a drag."""
    value = source.data.splinewright.value
    points = np.array(value.points)
    points[1, 0] += by
    source.data.splinewright.value = sc.NurbsCurve(value.degree, value.knots, points)
    bpy.context.view_layer.update()


def rest():
    """The mouse rests and no button is down."""
    follow.finish(late.waiting(), bpy.context.evaluated_depsgraph_get())
    bpy.context.view_layer.update()


def is_exact(ob, source):
    return np.array_equal(store.read(ob.data).pool, store.read(source.data).pool)


def require_up_to_date(ob, source):
    assert is_exact(ob, source) and not late.is_late(ob.data) and not late.has_mark(ob.data)
    require_exact(ob)


def test_what_is_quick_follows_every_step(clock):
    source = curve()
    ob = follower(source)
    clock.costs["curve"] = 0.02
    for _ in range(4):
        step(source)
        require_up_to_date(ob, source)


def test_what_is_slow_is_called_off_once_then_waits_until_the_mouse_rests(clock):
    source = curve()
    ob = follower(source)
    before = store.read(ob.data).pool
    clock.costs["curve"] = 2.0
    clock.made.clear()
    start = clock.now
    step(source)
    assert late.BUDGET <= clock.now - start < 0.25, "an unknown one is tried"
    now = clock.now
    for _ in range(5):
        step(source)
    assert clock.now == now and not clock.made and store.read(ob.data).pool is before
    assert late.is_late(ob.data) and late.has_mark(ob.data) and "updated when the mouse rests" in drawn()
    rest()
    require_up_to_date(ob, source)
    assert clock.made == ["curve"], "once, and not again for what was written itself"
    assert "mouse rests" not in drawn()


def test_what_became_quick_follows_again(clock):
    source = curve()
    ob = follower(source)
    clock.costs["curve"] = 1.0
    step(source)
    rest()
    clock.costs["curve"] = 0.001
    step(source)
    assert late.is_late(ob.data), "by what it took the last time"
    rest()
    step(source)
    require_up_to_date(ob, source)


def test_once_slow_is_not_slow_for_good(clock):
    source = curve()
    ob = follower(source)
    for cost in (0.01, 0.02, 0.029, 0.01):
        clock.costs["curve"] = cost
        step(source)
        require_up_to_date(ob, source)
    late.note(ob.data, 1.0)
    step(source)
    require_up_to_date(ob, source)
    late.note(ob.data, 1.0)
    late.note(ob.data, 1.0)
    step(source)
    assert late.is_late(ob.data)


def test_all_of_a_step_have_one_budget_and_those_that_have_no_time_come_later(clock):
    source = curve()
    found = [follower(source) for _ in range(8)]
    clock.costs["curve"] = 0.008
    step(source)
    start = clock.now
    step(source)
    assert clock.now - start <= late.BUDGET + 0.001
    are_late = [late.is_late(ob.data) for ob in found]
    assert 1 <= are_late.count(False) <= 3
    rest()
    for ob in found:
        require_up_to_date(ob, source)


def test_followers_of_what_waits_come_after_it(clock):
    source = curve()
    first = follower(source)
    second = follower(first)
    clock.costs["curve"] = 1.0
    for _ in range(3):
        step(source)
    assert not is_exact(first, source) and is_exact(second, first) and not late.is_late(second.data)
    rest()
    require_up_to_date(first, source)
    require_up_to_date(second, first)


def test_on_release_waits_for_the_release(clock):
    source = curve()
    ob = follower(source, 'ON_RELEASE')
    step(source)
    assert late.is_late(ob.data) and not is_exact(ob, source)
    assert late.waiting(is_released=False) == [] and late.waiting(is_released=True) == [ob.data]
    clock.now += late.RELEASED + 0.1
    assert late.waiting(is_released=False) == [ob.data], "not all versions of Blender tell of a release"
    rest()
    require_up_to_date(ob, source)


def test_what_takes_very_long_is_not_made_in_the_middle_of_a_drag(clock):
    source = curve()
    ob = follower(source)
    clock.costs["curve"] = 2.0
    step(source)
    assert late.waiting(is_released=False) == [ob.data], "how long is not known yet"
    rest()
    step(source)
    assert late.waiting(is_released=False) == [] and late.waiting() == [ob.data]
    clock.now += late.RELEASED + 0.1
    assert late.waiting(is_released=False) == [ob.data], "the mouse rests for long"


def test_manual_waits_for_update_now(clock):
    source = curve()
    ob = follower(source, 'MANUAL')
    assert not bpy.ops.splinewright.update_now.poll()
    step(source)
    rest()
    clock.now += 1000
    rest()
    assert late.is_late(ob.data) and not is_exact(ob, source) and "waits for Update Now" in drawn()
    assert op(bpy.ops.splinewright.update_now) == {'FINISHED'}
    require_up_to_date(ob, source)
    assert not bpy.ops.splinewright.update_now.poll()


def test_update_now_says_why_nothing_comes_of_it(clock):
    source = curve()
    ob = follower(source, 'MANUAL')
    step(source)
    store.remove(source.data)
    bpy.context.view_layer.update()
    with pytest.raises(RuntimeError, match="not a Splinewright shape any more"):
        op(bpy.ops.splinewright.update_now)
    assert follow.problem(ob.data)


@pytest.mark.parametrize('mode', ('ALWAYS', 'ON_RELEASE'))
def test_another_choice_makes_it_at_once(clock, mode):
    source = curve()
    ob = follower(source, 'MANUAL')
    step(source)
    ob.data.splinewright.update_mode = mode
    require_up_to_date(ob, source)


@pytest.mark.parametrize('mode', MODES)
def test_a_saved_file_holds_nothing_that_is_late(clock, mode, tmp_path):
    source = curve()
    ob = follower(source, mode)
    clock.costs["curve"] = 1.0
    step(source)
    name, wanted = ob.name, store.read(source.data).pool.copy()
    assert late.is_late(ob.data)
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "file.blend"))
    require_up_to_date(ob, source)
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "file.blend"))
    ob = bpy.data.objects[name]
    assert np.array_equal(store.read(ob.data).pool, wanted) and not late.has_mark(ob.data)
    assert ob.data.splinewright.update_mode == mode


@pytest.mark.parametrize('mode', MODES)
def test_every_frame_is_right(clock, mode):
    source = curve()
    ob = follower(source, mode)
    clock.costs["curve"] = 1.0
    source.location.z = 1
    source.keyframe_insert('location', frame=1)
    source.location.z = 5
    source.keyframe_insert('location', frame=11)
    op(bpy.ops.splinewright.set_moving, how='WITH_INPUTS')
    for frame, height in ((1, 1), (11, 5), (1, 1)):
        bpy.context.scene.frame_set(frame)
        assert np.allclose(store.read(ob.data).pool[0, 2], height) and not late.is_late(ob.data)
    step(source)
    assert late.is_late(ob.data)
    bpy.context.scene.frame_set(1)
    assert not late.is_late(ob.data) and store.read(ob.data).pool[1, 0] == store.read(source.data).pool[1, 0]


@pytest.mark.parametrize('mode', MODES)
def test_a_rendered_still_is_right(clock, mode):
    source = curve()
    ob = follower(source, mode)
    clock.costs["curve"] = 1.0
    step(source)
    assert late.is_late(ob.data)
    handlers.render_begins(bpy.context.scene)
    require_up_to_date(ob, source)


@pytest.mark.parametrize('mode', ('ALWAYS', 'ON_RELEASE'))
def test_undo_and_redo_bring_back_no_follower_that_is_late(clock, mode):
    source = curve()
    name = follower(source, mode).name
    bpy.ops.ed.undo_push(message="follow")
    clock.costs["curve"] = 1.0
    step(source)
    first = store.read(source.data).pool.copy()
    bpy.ops.ed.undo_push(message="first drag")      # at its end, before the mouse rests
    rest()
    step(source, 0.7)
    bpy.ops.ed.undo_push(message="second drag")
    rest()
    for call in (bpy.ops.ed.undo, bpy.ops.ed.redo, bpy.ops.ed.undo):
        call()
        bpy.context.view_layer.update()
        rest()
        ob, source = bpy.data.objects[name], bpy.data.objects["curve"]
        require_up_to_date(ob, source)
    assert np.array_equal(store.read(ob.data).pool, first)


def test_undo_of_manual_keeps_what_waits(clock):
    source = curve()
    name = follower(source, 'MANUAL').name
    step(source)
    bpy.ops.ed.undo_push(message="drag")
    op(bpy.ops.splinewright.update_now)
    for is_late in (False, True, False):
        ob, source = bpy.data.objects[name], bpy.data.objects["curve"]
        assert late.is_late(ob.data) == is_late == (not is_exact(ob, source))
        (bpy.ops.ed.redo if is_late else bpy.ops.ed.undo)()
        bpy.context.view_layer.update()
    ob, source = bpy.data.objects[name], bpy.data.objects["curve"]
    assert late.is_late(ob.data)
    follow.finish(late.blocks(), bpy.context.evaluated_depsgraph_get())
    require_up_to_date(ob, source)


def test_a_file_that_blender_saved_by_itself_is_mended_when_it_is_opened(clock, tmp_path, monkeypatch):
    source = curve()
    name = follower(source).name
    clock.costs["curve"] = 1.0
    step(source)
    monkeypatch.setattr(state, 'late', {})          # auto-save calls no handler
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "auto.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "auto.blend"))
    bpy.context.view_layer.update()
    bpy.data.objects["curve"].location.x += 0       # Blender looks for changes
    bpy.context.scene.frame_set(2)
    require_up_to_date(bpy.data.objects[name], bpy.data.objects["curve"])


@pytest.mark.parametrize('how', ('renamed', 'deleted', 'made editable'))
def test_what_becomes_of_it_while_it_waits(clock, how):
    source = curve()
    ob = follower(source)
    clock.costs["curve"] = 1.0
    step(source)
    if how == 'renamed':
        ob.data.name = "another name"
        rest()
        bpy.context.view_layer.update()
        require_up_to_date(ob, source)
    elif how == 'deleted':
        bpy.data.objects.remove(ob)
        rest()
        assert not state.late
    else:
        op(bpy.ops.splinewright.make_editable)
        rest()
        assert not state.late and not recipes.has(ob.data)


def test_other_numbers_make_it_at_once(clock):
    sources = [curve(f"section {i}", i) for i in range(3)]
    activate(*sources)
    bpy.context.view_layer.update()
    op(bpy.ops.splinewright.add_loft)
    ob = bpy.context.object
    clock.costs.update({source.name: 1.0 for source in sources})
    for source in sources:
        step(source)
    assert late.is_late(ob.data)
    follow.set_parameters(ob.data, {}, bpy.context.evaluated_depsgraph_get())
    assert not late.is_late(ob.data) and not late.has_mark(ob.data)
    pool = store.read(ob.data).pool.copy()
    state.made.clear()
    follow.refresh_all(set(), bpy.context.evaluated_depsgraph_get())
    assert np.array_equal(store.read(ob.data).pool, pool)


def test_in_background_and_for_scripts_nothing_waits(monkeypatch):
    assert handlers._budget(None) is None and handlers._budget(object()) is None
    monkeypatch.setattr(handlers.bpy, 'app', type("App", (), {'background': False}), raising=False)
    awaited, dragged = handlers._budget(object()), handlers._budget(None)
    with part('ui.finishing').unawaited():
        assert handlers._budget(object())._end < np.inf, "what the add-on itself asks for"
    monkeypatch.undo()
    source = curve()
    ob = follower(source)
    state.costs[file_state.key(ob.data)] = (np.inf,)
    assert awaited.allows(ob.data) and not awaited.is_over() and not dragged.allows(ob.data)
    ob.data.splinewright.update_mode = 'ON_RELEASE'
    assert awaited.allows(ob.data) and not dragged.allows(ob.data)
    ob.data.splinewright.update_mode = 'MANUAL'
    assert not awaited.allows(ob.data)
    for mode in MODES:
        ob.data.splinewright.update_mode = mode
        step(source)
        require_up_to_date(ob, source)


def test_random_drags_leave_nothing_behind(clock):
    random = np.random.default_rng(21)
    sources = [curve(f"input {i}", i) for i in range(3)]
    found = []
    for i in range(9):
        source = (sources + found)[random.integers(len(sources) + len(found))]
        found.append(follower(source, MODES[random.integers(2)]))
    for source in sources + found:
        clock.costs[source.name] = random.choice([0.0, 0.004, 0.012, 0.5])
    for _ in range(25):
        for _ in range(random.integers(1, 4)):
            step(sources[random.integers(3)], random.uniform(-1, 1))
        rest()
        for ob in found:
            require_up_to_date(ob, recipes.pointers(ob.data)[0])


def test_the_real_clock_counts():
    start = late.clock()
    time.sleep(0.01)
    assert late.clock() - start >= 0.009
