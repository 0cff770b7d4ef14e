"""The kernels: one value gives one set of bits however it is asked for, and nearly the same on every processor."""

import itertools
import json
import os
import platform
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import splinecore as sc

RNG = np.random.default_rng(13)
SETS = ['baseline', 'x86-64-v3', 'x86-64-v4']


def knots(degree, spans, kind, rng):
    """Knots with a double one inside, for spans + degree points or, where periodic, so many as spans."""
    inner = np.sort(rng.uniform(0.0, 1.0, spans - 1))
    if spans > 3 and degree > 1:
        inner[1] = inner[0]
    if kind == 'periodic':
        return np.concatenate([[0.0], inner, [1.0]])
    if kind == 'clamped':
        return np.concatenate([np.zeros(degree + 1), inner, np.ones(degree + 1)])
    return np.concatenate([-np.sort(rng.uniform(0.0, 1.0, degree))[::-1], [0.0], inner, [1.0],
                           1.0 + np.sort(rng.uniform(0.0, 1.0, degree))])


def weights(shape, rational, rng):
    return rng.uniform(0.5, 2.0, shape) if rational else None


def curves(rng):
    for degree in [*range(1, 10), 25]:
        for kind in ('clamped', 'unclamped', 'periodic'):
            for spans in (1, 7) if kind != 'periodic' else (degree + 3,):
                for rational in (False, True):
                    values = knots(degree, spans, kind, rng)
                    count = len(values) - (1 if kind == 'periodic' else degree + 1)
                    yield sc.NurbsCurve(degree, values, rng.normal(size=(count, 3)), weights(count, rational, rng),
                                        periodic=kind == 'periodic')


def patches(rng):
    for degree in ((1, 1), (2, 3), (3, 3), (3, 1), (5, 4), (7, 9)):
        for kind in ('clamped', 'unclamped', 'periodic'):
            for rational in (False, True):
                pair = [knots(p, p + 3 if kind == 'periodic' else 5, kind, rng) for p in degree]
                shape = tuple(len(k) - (1 if kind == 'periodic' else p + 1) for k, p in zip(pair, degree))
                yield sc.NurbsPatch(degree, pair, rng.normal(size=(*shape, 3)), weights(shape, rational, rng),
                                    (kind == 'periodic',) * 2)


def parameters(count, rng):
    """Sorted stretches, single ones, knots and both ends."""
    places = np.concatenate([np.sort(rng.uniform(0.0, 1.0, count // 2)), rng.uniform(0.0, 1.0, count // 2), [0.0, 1.0]])
    return places


@pytest.mark.parametrize('curve', list(curves(np.random.default_rng(1))), ids=str)
def test_a_curve_gives_the_same_bits_however_it_is_asked(curve):
    u = np.concatenate([parameters(60, RNG), np.unique(curve.knots.clip(0.0, 1.0))])
    points = curve.evaluate(u)
    for order in range(5):
        derivatives = curve.derivatives(u, order)
        np.testing.assert_array_equal(derivatives[:, 0], points)
        np.testing.assert_array_equal(derivatives[:, :3], curve.derivatives(u, 6)[:, :order + 1][:, :3])
    np.testing.assert_array_equal([curve.evaluate(one) for one in u], points)
    order = RNG.permutation(len(u))
    np.testing.assert_array_equal(curve.evaluate(u[order]), points[order])
    np.testing.assert_array_equal(curve.evaluate(u, dtype=np.float32), points.astype(np.float32))
    for size in (1, 2, 3, 5, 63, 64, 65):
        parts = [curve.evaluate(u[i:i + size]) for i in range(0, len(u), size)]
        np.testing.assert_array_equal(np.concatenate(parts), points)


@pytest.mark.parametrize('patch', list(patches(np.random.default_rng(2))), ids=str)
def test_a_patch_gives_the_same_bits_however_it_is_asked(patch):
    u, v = parameters(20, RNG), parameters(30, RNG)
    grid = patch.evaluate_grid(u, v)
    np.testing.assert_array_equal(patch.evaluate(u[:, None], v[None, :]), grid)
    points, normals = patch.evaluate_grid_with_normals(u, v)
    np.testing.assert_array_equal(points, grid)
    first = patch.first_derivatives(u[:, None], v[None, :])
    np.testing.assert_array_equal(first[:, :, 0], grid)
    for order in (1, 2, 3):
        derivatives = patch.derivatives(u[:, None], v[None, :], order)
        np.testing.assert_array_equal(derivatives[:, :, 0, 0], grid)
        np.testing.assert_array_equal(derivatives[:, :, 1, 0], first[:, :, 1])
        np.testing.assert_array_equal(derivatives[:, :, 0, 1], first[:, :, 2])
    rows, columns = RNG.permutation(len(u)), RNG.permutation(len(v))
    np.testing.assert_array_equal(patch.evaluate_grid(u[rows], v[columns]), grid[rows][:, columns])
    turned = patch.evaluate_grid_with_normals(u[rows], v[columns])[1]
    np.testing.assert_array_equal(turned, normals[rows][:, columns])
    np.testing.assert_array_equal(patch.evaluate_grid(u[:1], v), grid[:1])
    np.testing.assert_array_equal(patch.evaluate_grid(u, v[:1]), grid[:, :1])
    np.testing.assert_array_equal(patch.evaluate_grid(u, v, dtype=np.float32), grid.astype(np.float32))


def test_a_grid_that_is_long_in_either_direction_has_the_bits_of_its_pairs():
    """Long ones are computed in parts of 32,768."""
    patch = next(iter(patches(np.random.default_rng(5))))
    few, many = np.linspace(0.0, 1.0, 3), np.linspace(0.0, 1.0, 40_000)
    np.testing.assert_array_equal(patch.evaluate_grid(few, many), patch.evaluate(few[:, None], many[None, :]))
    np.testing.assert_array_equal(patch.evaluate_grid(many, few), patch.evaluate(many[:, None], few[None, :]))


@pytest.mark.parametrize('rational', [False, True])
def test_columns_of_several_spans_have_the_bits_of_pairs_zeros_with_their_signs(rational):
    rng = np.random.default_rng(7)
    for degree in (1, 2, 3, 5):
        values = np.concatenate([np.zeros(degree + 1), np.arange(1.0, 12.0), [11.5, 11.5], np.full(degree + 1, 12.0)])
        count = len(values) - degree - 1
        points = rng.normal(size=(3, count, 3))
        points[..., 1] = np.where(rng.random((3, count)) < 0.5, -0.0, 0.0)
        points[..., 2] = -0.0
        patch = sc.NurbsPatch((2, degree), [[0.0, 0, 0, 1, 1, 1], values], points, weights((3, count), rational, rng))
        u = rng.uniform(0.0, 1.0, 3)
        for most in range(1, 11):
            places = [np.sort(rng.uniform(i, i + 1, rng.integers(0, most + 1))) for i in range(12)]
            v = np.concatenate(places)
            if not len(v):
                continue
            for at in (v, v[::-1], rng.permutation(v)):
                pairs = patch.evaluate(u[:, None], at[None, :])
                assert patch.evaluate_grid(u, at).tobytes() == pairs.tobytes()
                normals = patch.evaluate_grid_with_normals(u, at)[1]
                alone = [patch.evaluate_grid_with_normals(u, at[i:i + 1])[1] for i in range(len(at))]
                assert normals.tobytes() == np.concatenate(alone, axis=1).tobytes()


def test_a_grid_that_no_cache_holds_has_the_bits_of_its_pairs():
    patch = next(iter(patches(np.random.default_rng(8))))
    u, v = np.linspace(0.0, 1.0, 800), np.linspace(0.0, 1.0, 1001)
    grid, normals = patch.evaluate_grid_with_normals(u, v)
    assert grid.nbytes > 1 << 24
    assert grid.tobytes() == patch.evaluate_grid(u, v).tobytes() == patch.evaluate(u[:, None], v[None, :]).tobytes()
    some = slice(300, 303)
    assert normals[some].tobytes() == patch.evaluate_grid_with_normals(u[some], v)[1].tobytes()


@pytest.mark.parametrize('rational', [False, True])
def test_a_grid_lying_down_is_the_standing_one_of_the_swapped_patch(rational):
    """The functions along u are summed first, so the last bits may differ: 4 ulp of the largest coordinate at most."""
    rng = np.random.default_rng(6)
    patch = sc.NurbsPatch((3, 4), [knots(3, 5, 'clamped', rng), knots(4, 5, 'unclamped', rng)],
                          rng.normal(size=(8, 9, 3)), weights((8, 9), rational, rng))
    u, v = parameters(298, rng), parameters(39_998, rng)
    lying, standing = patch.evaluate_grid(u, v), patch.swapped().evaluate_grid(v, u)
    assert lying.shape == (300, 40_000, 3) and standing.shape == (40_000, 300, 3)
    bound = 4 * np.spacing(np.abs(patch.points).max())
    assert max(np.abs(row - standing[:, i]).max() for i, row in enumerate(lying)) <= bound


def test_a_set_gives_the_bits_of_its_patches():
    rng = np.random.default_rng(4)
    nets = [rng.normal(size=(4, 4, 3)) for _ in range(3)] + [rng.normal(size=(3, 5, 3))]
    patches = [sc.BezierPatch(net) for net in nets[:2]] + [sc.BezierPatch(nets[2], rng.uniform(0.5, 2.0, (4, 4)))]
    patches.append(sc.BezierPatch(nets[3]))
    together = sc.PatchSet.from_patches(patches)
    u, v = parameters(10, rng), parameters(14, rng)
    points, normals = np.empty((2, 4, len(u), len(v), 3))
    together.evaluate_grid_with_normals(u, v, out=(points, normals))
    for i, patch in enumerate(patches):
        expected = patch.evaluate_grid_with_normals(u, v)
        np.testing.assert_array_equal(points[i], expected[0])
        np.testing.assert_array_equal(normals[i], expected[1])
    np.testing.assert_array_equal(together.evaluate_grid(u, v), points)
    np.testing.assert_array_equal(together.evaluate_grid(u, v, dtype=np.float32), points.astype(np.float32))
    with pytest.raises(sc.InvalidShape, match=r"patches\[0\]: u\[1\] = 2 is outside"):
        together.evaluate_grid([0.5, 2.0], v)
    with pytest.raises(sc.InvalidShape, match="out has shape"):
        together.evaluate_grid(u, v, out=np.empty((3, len(u), len(v), 3)))
    with pytest.raises(sc.InvalidShape, match="share memory"):
        together.evaluate_grid_with_normals(u, v, out=(points, points))
    with pytest.raises(TypeError, match="not one dtype"):
        together.evaluate_grid_with_normals(u, v, out=(points, normals.astype(np.float32)))


def found_by_sets(program):
    """What a program prints with each set of instructions that this processor has, the baseline first: numbers."""
    found = {}
    for name in SETS:
        made = subprocess.run([sys.executable, "-c", program, os.path.dirname(__file__)], capture_output=True,
                              text=True, check=True, env={**os.environ, "SPLINECORE_KERNELS": name})
        chosen, numbers = json.loads(made.stdout)
        if chosen == name:
            found[name] = np.array(numbers)
    if len(found) == 1:
        pytest.skip(f"this processor has none of {', '.join(SETS[1:])}")
    return list(found.values())


PROGRAM = """
import json, sys
import numpy as np
sys.path[:0] = json.loads(sys.argv[1])
import test_kernels
import splinecore
np.savez(sys.argv[2], set=splinecore.__instruction_set__, **test_kernels.what_kernels_give())
"""


def what_kernels_give():
    """{what, of which shape: numbers}; a size is the largest coordinate of that shape."""
    rng = np.random.default_rng(3)
    found = {}
    for i, curve in enumerate(curves(np.random.default_rng(1))):
        u = parameters(200, rng)
        found[f'size curve{i}'] = np.abs(curve.points).max()
        found[f'points curve{i}'], found[f'single curve{i}'] = curve.evaluate(u), curve.evaluate(u, dtype=np.float32)
        found[f'derivatives curve{i}'] = curve.derivatives(u, 2)
    shapes = list(patches(np.random.default_rng(2)))
    shapes.append(sc.PatchSet.from_patches(shapes))
    for i, shape in enumerate(shapes):
        u, v = parameters(20, rng), parameters(30, rng)
        found[f'size patch{i}'] = np.abs(shape.points).max()
        found[f'points patch{i}'], found[f'normals patch{i}'] = shape.evaluate_grid_with_normals(u, v)
        found[f'single patch{i}'] = shape.evaluate_grid(u, v, dtype=np.float32)
        if not isinstance(shape, sc.PatchSet):
            found[f'derivatives patch{i}'] = shape.first_derivatives(u[:, None], v[None, :])
    return found


def allowed(what, size, numbers):
    """How far two sets of instructions may be apart."""
    return {'points': 4 * np.spacing(size), 'single': np.spacing(np.float32(size)), 'normals': 1e-9,
            'derivatives': 1e-9 * np.abs(numbers).max()}[what]


def test_every_set_of_instructions_gives_nearly_the_same(tmp_path):
    """Points within 4 ulp of the largest coordinate, which single precision rounds to neighbors at most; derivatives by
    as much of theirs, normals by what they are worth."""
    found = {}
    for name in SETS:
        target = tmp_path / f"{name}.npz"
        subprocess.run([sys.executable, '-c', PROGRAM, json.dumps(sys.path), str(target)], check=True,
                       env={**os.environ, 'SPLINECORE_KERNELS': name})
        made = dict(np.load(target))
        if made.pop('set') == name:
            found[name] = made
    if len(found) == 1:
        pytest.skip(f"this processor has none of {', '.join(SETS[1:])}")
    baseline = found.pop('baseline')
    for name, (key, ours) in itertools.product(found, baseline.items()):
        what, shape = key.split()
        if what != 'size':
            bound = allowed(what, baseline[f'size {shape}'], ours)
            np.testing.assert_allclose(found[name][key], ours, rtol=0, atol=bound, err_msg=f"{key} of {name}")


@pytest.mark.parametrize('degree, size', [(1, 1e308), (3, 5.9e307), (25, 1e301), (255, 1e233)])
def test_points_near_the_largest_numbers_are_finite(degree, size):
    curve = sc.BezierCurve(np.full((degree + 1, 3), size))
    u = np.linspace(0.0, 1.0, 9)
    np.testing.assert_allclose(curve.evaluate(u), size, rtol=1e-13)
    np.testing.assert_array_equal(np.isfinite(curve.derivatives(u, 1)), True)


@pytest.mark.parametrize('scale', [5e-324, 1e-310, 1e-300, 1e300])
def test_pieces_and_removal_keep_curves_of_any_weights(scale):
    rng = np.random.default_rng(5)
    weights = rng.integers(1, 8, 10) * scale
    curve = sc.NurbsCurve(3, [0, 0, 0, 0, 1, 2, 3, 4, 5, 6, 8, 8, 8, 8], rng.normal(size=(10, 3)), weights)
    for piece, start, end in zip(curve.to_bezier(), [0, 1, 2, 3, 4, 5, 6], [1, 2, 3, 4, 5, 6, 8]):
        t = np.linspace(0.0, 1.0, 5)
        np.testing.assert_allclose(piece.evaluate(t), curve.evaluate(start + t * (end - start)), rtol=0, atol=1e-13)
    plain = sc.NurbsCurve(3, np.arange(30.0), rng.normal(size=(26, 3)), rng.integers(1, 8, 26) * scale)
    tripled = plain.insert_knot(15, 2)
    u = np.linspace(*plain.domain, 200)
    np.testing.assert_allclose(tripled.remove_knot(15, 2).value.evaluate(u), plain.evaluate(u), rtol=0, atol=1e-12)


@pytest.mark.skipif(platform.machine() != "x86_64" or not Path("/proc/cpuinfo").exists(), reason="processors of x86-64 under Linux")
def test_what_the_processor_can_is_used():
    """By the flags that the system lists. Some compilers' runtimes find none of them."""
    flags = set(re.search(r"^flags\s*: (.*)$", Path("/proc/cpuinfo").read_text(), re.M)[1].split())
    best = "baseline"
    if {"avx2", "fma", "bmi1", "bmi2", "movbe", "f16c", "abm"} <= flags:
        best = "x86-64-v4" if {"avx512f", "avx512vl", "avx512dq", "avx512bw", "avx512cd"} <= flags else "x86-64-v3"
    environment = {name: value for name, value in os.environ.items() if name != "SPLINECORE_KERNELS"}
    found = subprocess.run([sys.executable, "-c", "import splinecore; print(splinecore.__instruction_set__)"], check=True,
                           capture_output=True, text=True, env=environment)
    assert found.stdout.strip() == best
