"""Long calls can be ended; values can be read by many threads."""

import subprocess
import sys
import textwrap
import threading
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

import splinecore as sc
from shapes import circle, random_points, torus, wavy_patch

MANY = np.linspace(0, 4, 400_000)
MORE = np.linspace(0, 4, 4_000_000)
#: On one thread: on several the one that may be ended shares the work.
CALLS = {
    "curve.evaluate": lambda cancel: circle().evaluate(MORE, cancel=cancel, threads=1),
    "curve.derivatives": lambda cancel: circle().derivatives(MORE, 1, cancel=cancel, threads=1),
    "patch.evaluate": lambda cancel: torus().evaluate(MORE[::4], MORE[::4], cancel=cancel, threads=1),
    "patch.derivatives": lambda cancel: torus().derivatives(MANY, MANY, 1, cancel=cancel, threads=1),
    "Tessellation.adaptive":
        lambda cancel: sc.Tessellation.adaptive(sc.PatchSet.from_patches([torus()]), tolerance=1e-5, cancel=cancel,
                                                threads=1),
    "patch.evaluate_grid": lambda cancel: torus().evaluate_grid(MANY[::200], MANY[::200], cancel=cancel, threads=1),
    "patch.evaluate_grid_with_normals":
        lambda cancel: torus().evaluate_grid_with_normals(MANY[::200], MANY[::200], cancel=cancel, threads=1),
}


@pytest.mark.parametrize("name", CALLS)
def test_cancel_ends_a_call_when_it_returns_true(name):
    asked = []

    def after_two():
        asked.append(1)
        return len(asked) >= 2

    with pytest.raises(sc.Cancelled, match="cancel"):
        CALLS[name](after_two)
    assert len(asked) == 2


def closed():
    """A torus of many spans."""
    whole = torus()
    for axis, (start, end) in zip("uv", whole.domain):
        whole = whole.refine(axis, start + (end - start) * np.linspace(0, 1, 42)[1:-1])
    return sc.PatchSet.from_patches([whole])


MEASURES = {
    "curve.length": lambda **options: sc.fit.interpolate(random_points(20_000, seed=2)).value.length(**options),
    "patch.area": lambda **options: wavy_patch().area(tolerance=1e-13, **options),
    "PatchSet.area": lambda **options: sc.PatchSet.from_patches([wavy_patch()]).area(tolerance=1e-13, **options),
    "PatchSet.volume": lambda **options: closed().volume(**options),
    "PatchSet.centroid": lambda **options: closed().centroid(**options),
    "PatchSet.second_moments": lambda **options: closed().second_moments(**options),
}


@pytest.mark.parametrize("name", MEASURES)
def test_measures_are_ended_and_are_the_same_where_they_are_not(name):
    with pytest.raises(sc.Cancelled, match="cancel"):
        MEASURES[name](cancel=lambda: True)
    assert np.array_equal(MEASURES[name](cancel=lambda: False), MEASURES[name]())
    with pytest.raises(TypeError, match="cancel = 3 is not callable"):
        MEASURES[name](cancel=3)


@pytest.mark.parametrize("answer", [False, None, 0, np.bool_(False), []])
def test_cancel_that_says_no_changes_nothing(answer):
    kept = circle().evaluate(MANY)
    assert np.array_equal(circle().evaluate(MANY, cancel=lambda: answer), kept)


def test_an_error_in_cancel_comes_through():
    with pytest.raises(ZeroDivisionError):
        circle().evaluate(MANY, cancel=lambda: 1 / 0)
    with pytest.raises(ValueError, match="truth value"):
        circle().evaluate(MANY, cancel=lambda: np.zeros(2))


@pytest.mark.parametrize("bad", [3, "stop", True])
def test_cancel_must_be_callable(bad):
    with pytest.raises(TypeError, match="cancel = .* is not callable"):
        circle().evaluate([], cancel=bad)


@pytest.mark.parametrize("call", [
    "patch.evaluate_grid(row, row, out=out)", "patch.evaluate(row[:, None], row, out=out)"])
def test_ctrl_c_ends_a_call(call):
    script = textwrap.dedent(f"""
        import _thread, signal, sys, time
        import numpy as np
        import splinecore as sc
        patch = sc.BezierPatch(np.random.default_rng(0).random((30, 30, 3)))
        row = np.linspace(0, 1, 3000)
        out = np.empty((3000, 3000, 3), "f4")
        signal.signal(signal.SIGALRM, signal.default_int_handler)
        signal.setitimer(signal.ITIMER_REAL, 0.2)
        try:
            while True:
                {call}
        except KeyboardInterrupt:
            print("ended")
    """)
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=60)
    assert done.stdout.strip() == "ended", done.stderr


def test_a_call_in_the_middle_of_its_work_hears_ctrl_c():
    import signal
    import time

    start = time.process_time()
    patch = sc.BezierPatch(random_points(20, 20, seed=1))
    u = np.linspace(0, 1, 2_000_000)
    old = signal.signal(signal.SIGALRM, signal.default_int_handler)
    signal.setitimer(signal.ITIMER_REAL, 0.05)
    try:
        with pytest.raises(KeyboardInterrupt):
            patch.evaluate(u, u)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, old)
    assert time.process_time() - start < 2


def test_many_threads_read_one_value():
    patch, curve = wavy_patch(), circle()
    u, v = np.linspace(0, 2, 300), np.linspace(0, 5, 200)
    expected = np.array(patch.evaluate_grid_with_normals(u, v))
    round_trip = curve.evaluate(MANY)
    barrier = threading.Barrier(8)

    def work(i):
        barrier.wait()
        got = patch.evaluate_grid_with_normals(u, v) if i % 2 else curve.evaluate(MANY)
        return np.array_equal(got, expected if i % 2 else round_trip)

    with ThreadPoolExecutor(8) as pool:
        assert all(pool.map(work, range(8)))


def test_the_first_readers_of_a_value_may_be_many():
    for seed in range(20):
        curve = sc.NurbsCurve(3, range(204), random_points(200, seed=seed))
        barrier = threading.Barrier(4)

        def work(_, curve=curve, barrier=barrier):
            barrier.wait()
            return curve.evaluate(np.linspace(3, 200, 500)).tobytes()

        with ThreadPoolExecutor(4) as pool:
            assert len(set(pool.map(work, range(4)))) == 1


def test_other_threads_run_during_a_long_call():
    patch = sc.BezierPatch(random_points(200, 200, seed=1))
    u = np.linspace(0, 1, 1000)
    ticks, stop = [], threading.Event()

    def tick():
        while not stop.wait(0.001):
            ticks.append(1)

    thread = threading.Thread(target=tick)
    thread.start()
    patch.evaluate_grid(u, u)
    stop.set()
    thread.join()
    assert len(ticks) >= 3
