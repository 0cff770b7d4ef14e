"""Batches on several threads: the same bits, the same errors, and no thread is left over."""

import os
import signal
import subprocess
import sys
import textwrap
import threading

import numpy as np
import pytest

import splinecore as sc
from shapes import circle, torus, wavy_patch

RNG = np.random.default_rng(22)
COUNT = 20_011
U = np.sort(RNG.uniform(0.0, 4.0, COUNT))
MIXED = RNG.permutation(U)
ROWS, COLUMNS = np.linspace(0.0, 4.0, 173), np.linspace(0.0, 4.0, 131)


def tori():
    return sc.PatchSet.from_patches([torus(), torus(3.0, 0.7), torus(2.0, 0.5)] * 4)


def far_off():
    """Normals of it are found on a copy that is moved to the origin."""
    patch = wavy_patch()
    return sc.NurbsPatch(patch.degree, patch.knots, patch.points + 1e9, patch.weights, (False, True))


CALLS = {
    "curve.evaluate": lambda **how: circle().evaluate(MIXED, **how),
    "curve.evaluate, sorted, float32": lambda **how: circle().evaluate(U, dtype=np.float32, **how),
    "curve.derivatives": lambda **how: circle().derivatives(U, 2, **how),
    "curve.derivatives, high": lambda **how: circle().derivatives(MIXED, 5, **how),
    "patch.evaluate": lambda **how: torus().evaluate(U, MIXED, **how),
    "patch.first_derivatives": lambda **how: torus().first_derivatives(U, MIXED, **how),
    "patch.derivatives": lambda **how: torus().derivatives(U, MIXED, 2, **how),
    "patch.evaluate_grid": lambda **how: torus().evaluate_grid(ROWS, COLUMNS, **how),
    "patch.evaluate_grid, float32": lambda **how: torus().evaluate_grid(ROWS, COLUMNS, dtype=np.float32, **how),
    "patch.evaluate_grid_with_normals":
        lambda **how: np.array(torus().evaluate_grid_with_normals(ROWS, COLUMNS, **how)),
    "far patch.evaluate_grid_with_normals":
        lambda **how: np.array(far_off().evaluate_grid_with_normals(ROWS / 4, COLUMNS / 4, **how)),
    "set.evaluate_grid": lambda **how: tori().evaluate_grid(ROWS, COLUMNS, **how),
    "set.evaluate_grid_with_normals": lambda **how: np.array(tori().evaluate_grid_with_normals(ROWS, COLUMNS, **how)),
}


@pytest.mark.parametrize("name", CALLS)
def test_the_bits_are_the_same_on_any_number_of_threads(name):
    alone = CALLS[name](threads=1)
    assert np.isfinite(alone).all()
    for threads in (0, 2, 3, 7, np.int64(2)):
        assert np.array_equal(CALLS[name](threads=threads), alone), threads


@pytest.mark.parametrize("degree", [3, 4])
@pytest.mark.parametrize("order", [0, 1, 2])
def test_the_bits_of_many_spans_are_the_same_in_any_batch(degree, order):
    """Many parameters a span and few, in order and not: kernels take them at once or each for itself."""
    rng = np.random.default_rng(degree)
    inner = np.sort(rng.uniform(0.0, 1.0, 199))
    knots = np.concatenate([np.zeros(degree + 1), inner, np.ones(degree + 1)])
    count = len(inner) + degree + 1
    curve = sc.NurbsCurve(degree, knots, rng.normal(size=(count, 3)), rng.uniform(0.3, 3.0, count))
    u = np.sort(rng.uniform(0.0, 1.0, COUNT))
    wanted = curve.derivatives(u, order, threads=1)
    for threads in (3, 64):
        assert np.array_equal(curve.derivatives(u, order, threads=threads), wanted), threads
    mixed = rng.permutation(COUNT)
    assert np.array_equal(curve.derivatives(u[mixed], order), wanted[mixed])
    assert np.array_equal(curve.derivatives(u[::-1].copy(), order), wanted[::-1])
    assert np.array_equal(np.array([curve.derivatives(one, order) for one in u[:3000]]), wanted[:3000])
    assert np.array_equal(curve.derivatives(u, 3)[:, :order + 1], wanted)


@pytest.mark.parametrize("fineness", [{"tolerance": 1e-3}, {"angle": 0.05}, {"tolerance": 1e-2, "angle": 0.1}])
def test_an_adaptive_mesh_is_the_same_on_any_number_of_threads(fineness):
    shapes = sc.PatchSet.from_patches([torus(), wavy_patch(), torus(2.0, 0.5)])
    alone = sc.Tessellation.adaptive(shapes, threads=1, **fineness)
    for threads in (0, 2, 5):
        mesh = sc.Tessellation.adaptive(shapes, threads=threads, **fineness)
        assert np.array_equal(mesh.corner_vertices, alone.corner_vertices)
        assert np.array_equal(mesh.evaluate_positions(shapes), alone.evaluate_positions(shapes))


@pytest.mark.parametrize("count", [0, 1, 2, 5])
def test_few_parameters_have_few_threads(count):
    places = np.linspace(0.0, 4.0, count)
    assert np.array_equal(circle().evaluate(places, threads=8), circle().evaluate(places, threads=1))
    assert torus().evaluate_grid(places, places, threads=8).shape == (count, count, 3)


@pytest.mark.parametrize("bad", [(0.25, 0.75), (0.75, 0.25), (0.4, 0.4)])
@pytest.mark.parametrize("threads", [1, 2, 5])
def test_the_first_bad_parameter_is_named(bad, threads):
    places = U.copy()
    for share in bad:
        places[int(share * COUNT)] = np.nan
    first = int(min(bad) * COUNT)
    for call in (lambda: circle().evaluate(places, threads=threads),
                 lambda: torus().evaluate(places, U, threads=threads),
                 lambda: torus().evaluate(U, places, threads=threads)):
        with pytest.raises(sc.InvalidShape, match=rf"\[{first}\]"):
            call()


@pytest.mark.parametrize("threads", [1, 2, 5])
def test_the_first_place_at_infinity_is_named(threads):
    line = sc.NurbsCurve(1, [0, 0, 1, 2, 2], [[0, 0, 0], [1, 0, 0], [2, 1, 0]], [1.0, -1.0, 1.0])
    places = np.full(COUNT, 0.1)
    places[[700, 15_000]] = [0.5, 1.5]
    with pytest.raises(sc.PointAtInfinity, match="u = 0.5"):
        line.evaluate(places, threads=threads)
    found = line.evaluate(places, at_infinity="nan", threads=threads)
    assert np.isnan(found).all(axis=1).nonzero()[0].tolist() == [700, 15_000]


@pytest.mark.parametrize("gap", [1, 5, 63, 64, 200])
@pytest.mark.parametrize("threads", [1, 2, 5, 64])
def test_of_unlike_errors_the_first_is_named(threads, gap):
    line = sc.NurbsCurve(1, [0, 0, 1, 2, 2], [[0, 0, 0], [1, 0, 0], [2, 1, 0]], [1.0, -1.0, 1.0])
    sheet = sc.NurbsPatch((1, 1), ([0, 0, 1, 2, 2], [0, 0, 2, 2]),
                          [[[0, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 0]], [[2, 1, 0], [2, 2, 0]]],
                          [[1.0, 1.0], [-1.0, -1.0], [1.0, 1.0]])
    calls = [lambda: line.evaluate(places, threads=threads), lambda: line.derivatives(places, 1, threads=threads),
             lambda: sheet.evaluate(places, U % 2, threads=threads),
             lambda: sheet.first_derivatives(places, U % 2, threads=threads)]
    for first in (0, 1, 700, 7_777):
        places = np.linspace(0.1, 0.3, COUNT)
        places[first], places[first + gap] = 0.5, 3.0
        for call in calls:
            with pytest.raises(sc.PointAtInfinity, match=r"u = 0\.5"):
                call()
        places[first], places[first + gap] = 3.0, 0.5
        for call in calls:
            with pytest.raises(sc.InvalidShape, match=rf"u\[{first}\]"):
                call()


@pytest.mark.parametrize("threads", [-1, 1025, 10**30, 1.5, "2", None, [2]])
def test_a_number_of_threads_that_is_none_is_refused(threads):
    with pytest.raises((sc.InvalidShape, TypeError), match="threads"):
        circle().evaluate(U, threads=threads)
    with pytest.raises((sc.InvalidShape, TypeError), match="threads"):
        torus().evaluate_grid(ROWS, COLUMNS, threads=threads)
    with pytest.raises((sc.InvalidShape, TypeError), match="threads"):
        sc.Tessellation.adaptive(sc.PatchSet.from_patches([torus()]), tolerance=0.1, threads=threads)


@pytest.mark.skipif(not os.path.isdir("/proc/self/task"), reason="counts threads in /proc")
def test_no_thread_outlives_its_call():
    before = len(os.listdir("/proc/self/task"))
    for name in CALLS:
        CALLS[name](threads=6)
    assert len(os.listdir("/proc/self/task")) == before


def test_calls_on_threads_of_the_caller():
    wanted = {name: CALLS[name](threads=1) for name in CALLS}
    wrong = []

    def compare(name):
        if not np.array_equal(CALLS[name](threads=3), wanted[name]):
            wrong.append(name)

    workers = [threading.Thread(target=compare, args=(name,)) for name in CALLS]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    assert wrong == []


@pytest.mark.parametrize("threads", [2, 4])
def test_cancel_ends_a_call_on_several_threads(threads):
    many = np.linspace(0.0, 4.0, 1_000_000)
    asked = []

    def after_two():
        asked.append(threading.get_ident())
        return len(asked) >= 2

    with pytest.raises(sc.Cancelled):
        torus().derivatives(many, many, 5, threads=threads, cancel=after_two)
    assert set(asked) == {threading.get_ident()}


@pytest.mark.skipif(sys.platform == "win32", reason="sends a signal to itself")
def test_ctrl_c_ends_a_call_on_several_threads():
    program = textwrap.dedent("""
        import signal, sys
        import numpy as np
        signal.signal(signal.SIGINT, signal.default_int_handler)
        sys.path[:0] = {path!r}
        from shapes import torus
        many = np.linspace(0.0, 4.0, 300_000)
        surface = torus()
        surface.derivatives(many[:9], many[:9], 6)
        try:
            print("ready", flush=True)
            surface.derivatives(many, many, 12, threads=4)
        except KeyboardInterrupt:
            print("stopped", flush=True)
    """).format(path=[os.path.dirname(__file__), os.path.dirname(os.path.dirname(sc.__file__))])
    process = subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True)
    assert process.stdout.readline() == "ready\n"
    process.send_signal(signal.SIGINT)
    out, _ = process.communicate(timeout=120)
    assert out == "stopped\n"


def test_ctrl_c_is_not_taken_for_shapes_that_do_not_fit(monkeypatch):
    """An interrupt may come inside of numpy, too."""
    def interrupted(*_):
        raise KeyboardInterrupt

    monkeypatch.setattr(np, "broadcast_arrays", interrupted)
    with pytest.raises(KeyboardInterrupt):
        torus().evaluate(U, U)
    with pytest.raises(KeyboardInterrupt):
        sc.Formula("s + t", ["s", "t"]).evaluate(U, U)
