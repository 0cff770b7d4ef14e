"""Several threads read one value at a time: they evaluate, tessellate and pickle it."""

import pickle
import threading
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

import splinecore as sc
from shapes import circle, curves, random_points, torus, wavy_patch

THREADS = 4


def patch_set(seed):
    return sc.PatchSet.from_patches([torus(), wavy_patch(), sc.BezierPatch(random_points(4, 3, seed=seed))])


def mesh(value):
    tessellation = sc.Tessellation(value, 4)
    return [array.tobytes() for array in tessellation.evaluate(value)]


def fine_mesh(value):
    tessellation = sc.Tessellation.adaptive(value, tolerance=0.05)
    return [array.tobytes() for array in tessellation.evaluate(value)]


READINGS = {
    "curve evaluated": (lambda seed: sc.NurbsCurve(3, range(64), random_points(60, seed=seed)),
                        lambda curve: curve.evaluate(np.linspace(3, 60, 400)).tobytes()),
    "curve measured": (lambda seed: sc.NurbsCurve(3, range(24), random_points(20, seed=seed)),
                       lambda curve: (curve.length(), curve.curvature(4.5), len(curve.pieces()))),
    "grid evaluated": (lambda seed: sc.BezierPatch(random_points(6, 5, seed=seed)),
                       lambda patch: patch.evaluate_grid(np.linspace(0, 1, 40), np.linspace(0, 1, 40)).tobytes()),
    "set tessellated": (patch_set, mesh),
    "set tessellated adaptively": (patch_set, fine_mesh),
    "set pickled": (patch_set, lambda value: pickle.loads(pickle.dumps(value)) == value),
    "set written": (patch_set, lambda value: (sc.dumps(value), hash(value), repr(value))),
    "formula evaluated": (lambda seed: sc.Formula(f"sin(t)^2 + {seed}*t"),
                          lambda formula: formula.evaluate(np.linspace(0, 1, 200)).tobytes()),
}


@pytest.mark.parametrize("name", READINGS)
def test_many_first_readers_read_what_one_reads(name):
    make, read = READINGS[name]
    for seed in range(4):
        value = make(seed)
        gate = threading.Barrier(THREADS)

        def work(_, value=value, gate=gate):
            gate.wait()
            return [read(value) for _ in range(3)]

        with ThreadPoolExecutor(THREADS) as pool:
            found = list(pool.map(work, range(THREADS)))
        assert found == [[read(value)] * 3] * THREADS


@pytest.mark.parametrize("curve", curves(), ids=lambda curve: type(curve).__name__)
def test_readers_of_all_kinds_at_once(curve):
    work = [lambda: curve.length(), lambda: sc.dumps(curve), lambda: pickle.dumps(curve),
            lambda: curve.evaluate(np.linspace(*curve.domain, 300)).tobytes()]
    gate = threading.Barrier(len(work))

    def several_times(job):
        gate.wait()
        return [job() for _ in range(5)]

    with ThreadPoolExecutor(len(work)) as pool:
        found = list(pool.map(several_times, work))
    assert found == [[job()] * 5 for job in work]


def test_threads_change_what_the_others_hold_by_no_verb():
    start = circle()
    kept = sc.dumps(start)

    def work(i):
        curve = start
        for step in range(1, 7):
            curve = curve.elevate() if i % 2 else curve.insert_knot(0.1 * step + 0.01 * i)
        return curve.evaluate(np.linspace(*curve.domain, 50))

    with ThreadPoolExecutor(THREADS) as pool:
        found = list(pool.map(work, range(THREADS)))
    for points in found:
        assert np.allclose(points, start.evaluate(np.linspace(*start.domain, 50)), rtol=0, atol=1e-13)
    assert sc.dumps(start) == kept
