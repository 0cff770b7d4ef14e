"""The span of a parameter: found alike for one and for many, by every set of kernels, wherever the knots lie."""

import os
import subprocess
import sys

import numpy as np
import pytest

import splinecore as sc

SETS = ['baseline', 'x86-64-v3', 'x86-64-v4']
RNG = np.random.default_rng(7)


def evenly(count):
    return np.arange(count + 1.0)


def randomly(count):
    return np.cumsum(RNG.uniform(0.5, 1.5, count + 1))


def crowded(count):
    return np.unique(np.concatenate([[0.0, 1.0], 0.7 + 1e-9 * RNG.uniform(size=count)]))


def in_many_scales(count):
    return np.concatenate([[0.0], 10.0 ** np.sort(RNG.uniform(-200, 3, count))])


def far_away(count):
    return 1e15 + np.arange(count + 1.0)


def tiny(count):
    return 1e-300 * np.cumsum(RNG.uniform(0.5, 1.5, count + 1))


KNOTS = [evenly, randomly, crowded, in_many_scales, far_away, tiny]


def polyline(knots):
    """Each span has a slope of its own."""
    y = np.cumsum(RNG.uniform(1.0, 2.0, len(knots)) * (-1.0) ** np.arange(len(knots)))
    points = np.stack([np.zeros_like(y), y, np.zeros_like(y)], 1)
    return sc.NurbsCurve(1, np.concatenate([knots[:1], knots, knots[-1:]]), points), y


def places(knots):
    """Knots, their neighbors, and what lies between, in no order."""
    between = RNG.uniform(knots[0], knots[-1], 300)
    inside = knots[:-1] + RNG.uniform(size=len(knots) - 1) * np.diff(knots)
    found = np.concatenate([knots, np.nextafter(knots, np.inf), np.nextafter(knots, -np.inf), between, inside])
    return RNG.permutation(found[(found >= knots[0]) & (found <= knots[-1])])


@pytest.mark.parametrize('count', [1, 2, 7, 8, 61, 3000])
@pytest.mark.parametrize('kind', KNOTS, ids=lambda kind: kind.__name__)
@pytest.mark.parametrize('side', ['right', 'left'])
def test_a_parameter_lies_in_its_span(kind, count, side):
    knots = kind(count)
    curve, y = polyline(knots)
    u = places(knots)
    spans = np.clip(np.searchsorted(knots, u, side='right' if side == 'right' else 'left') - 1, 0, len(knots) - 2)
    up = curve.derivatives(u, 1, side=side)[:, 1, 1]
    rises = np.diff(y)[spans]
    np.testing.assert_array_equal(np.sign(up), np.sign(rises))
    np.testing.assert_allclose(up * np.diff(knots)[spans], rises, rtol=1e-12)
    one_by_one = [curve.derivatives(at, 1, side=side)[1, 1] for at in u[:200]]
    np.testing.assert_array_equal(one_by_one, up[:200])


@pytest.mark.parametrize('kernels', SETS)
def test_each_set_of_kernels_finds_them(kernels):
    asked = subprocess.run([sys.executable, '-c', 'import splinecore; print(splinecore.__instruction_set__)'], text=True,
                           capture_output=True, env={**os.environ, 'SPLINECORE_KERNELS': kernels}, check=True)
    if asked.stdout.strip() != kernels:
        pytest.skip(f'this processor has no {kernels}')
    chosen = [sys.executable, '-m', 'pytest', '-q', '-p', 'no:cacheprovider', __file__, '-k', 'lies_in_its_span']
    run = subprocess.run(chosen, env={**os.environ, 'SPLINECORE_KERNELS': kernels}, text=True, capture_output=True)
    assert run.returncode == 0, run.stdout[-3000:]
