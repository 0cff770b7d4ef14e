"""Work beside Blender: what comes of it, what it raises, and that it ends when it is stopped; operators take what was made."""

import threading
import time
from functools import partial
from types import SimpleNamespace

import bpy
import numpy as np
import pytest

from curves import run, value_of
from shapes import add
from support import part, splinecore as sc

long_work = part('ui.operators.long_work')
verbs, patch_verbs = part('core.verbs.verbs'), part('core.verbs.patch_verbs')
POINTS = np.random.default_rng(5).random((40_000, 3))


class Operator(long_work.LongWork):
    def __init__(self, work=None):
        self._work = work


def test_tasks_are_done_on_another_thread_one_after_the_other():
    work = long_work.Work({'a': lambda cancel: threading.current_thread(), 'b': lambda cancel: cancel()})
    assert work.is_done(30) and work.results['a'] is not threading.main_thread() and work.results['b'] is False
    assert Operator(work).result_of('b', None) is False


def test_what_was_not_made_is_made_now():
    assert Operator().result_of('a', lambda cancel: (3, cancel)) == (3, None)
    work = long_work.Work({})
    assert work.is_done(30) and Operator(work).result_of('a', lambda cancel: 4) == 4


def test_what_a_task_raises_is_raised_where_it_is_asked_for():
    work = long_work.Work({'a': lambda cancel: sc.NurbsCurve([], [], 3), 'b': lambda cancel: 1 / 0, 'c': lambda cancel: 5})
    assert work.is_done(30) and work.results['c'] == 5
    with pytest.raises(sc.Error):
        Operator(work).result_of('a', None)
    with pytest.raises(ZeroDivisionError):
        Operator(work).result_of('b', None)


def test_a_call_of_the_library_is_stopped_and_the_next_is_not_begun():
    begun = threading.Event()

    def fit(cancel):
        begun.set()
        return sc.fit.approximate_scattered(POINTS, (60, 60), smoothing=1e-6, corrections=1000, cancel=cancel)
    work = long_work.Work({'a': fit, 'b': lambda cancel: 5})
    assert begun.wait(30) and not work.is_done()
    began = time.monotonic()
    work.stop()
    assert work.is_done(30) and time.monotonic() - began < 10
    assert isinstance(work.results['a'], sc.Cancelled) and 'b' not in work.results


@pytest.mark.parametrize('verb', (
    partial(verbs.rebuild, 6, 3, 'points'), partial(verbs.rebuild_within, 0.01, 3, 'points'), partial(verbs.fair, 0.25, 'points'),
    partial(patch_verbs.rebuild, (5, 4), (3, 3)), partial(patch_verbs.fair, 0.25, 'points')))
def test_long_verbs_hand_the_cancel_on(verb):
    """Calls on small shapes end before they ask."""
    handed = []

    class Piece:
        def to_nurbs(self):
            return self

        def rebuild(self, *_, cancel, **__):
            handed.append(cancel)
            return SimpleNamespace(value=None, error=0.0)
        fair = rebuild
    verb(time.monotonic)(Piece())
    assert handed == [time.monotonic]


def test_operators_whose_work_may_take_long():
    names = ('rebuild', 'fair', 'fit_patch', 'patch_through_grid', 'fit_curve',
             'add_projected', 'project_points', 'divide_equally', 'add_offset', 'add_about', 'add_section', 'add_planes',
             'add_on_patch', 'intersections', 'add_touching_circle', 'trim_curve', 'extend_curve', 'split_where_met')
    assert all(issubclass(getattr(bpy.types, f"SPLINEWRIGHT_OT_{name}"), long_work.LongWork) for name in names)


def test_a_verb_takes_what_was_made_beforehand():
    ob = add(value_of('nurbs'))
    run('rebuild', count_u=6)
    wanted = ob.data.splinewright.value
    before = part('bridge.data.store').read(add(value_of('nurbs'), "other").data)
    work = long_work.Work({'a': lambda cancel: verbs.changed(before, 0, verbs.rebuild(6, 3, 'points', cancel), "")})
    assert work.is_done(30)
    assert verbs.pieces_of(Operator(work).result_of('a', None).definition) == [wanted]
