"""Every tolerance that is promised, on 1000 random inputs, by dense samples; and memory that grows as the points do.

A kind of input is a function that draws one, checks it and returns whether it was refused."""

import subprocess
import sys

import numpy as np
import pytest

import splinecore as sc
from splinecore import fit

import random_curves
import random_patches
from random_curves import random_curve

ROUNDING = 1e-12


def lengths(vectors):
    return np.sqrt((vectors**2).sum(-1))


def dense(domain, count=4001):
    return np.linspace(*domain, count)


def apart(a, b):
    """The largest distance of two curves at equal parts of their domains, and the size of the first."""
    points = a.evaluate(dense(a.domain))
    return lengths(points - b.evaluate(dense(b.domain))).max(), np.abs(points).max()


def wave(rng, count):
    t = np.sort(rng.uniform(0, 1, count))
    turns = rng.uniform(1, 12, 3)
    points = np.stack([4 * t, np.sin(turns[0] * t), np.cos(turns[1] * t * t) * np.sin(turns[2] * t)], -1)
    return points + 10.0**rng.uniform(-6, -2) * rng.standard_normal(points.shape)


def height(rng, u, v):
    a, b, c = rng.uniform(1, 5, 3)
    return np.stack([u, v, 0.2 * np.sin(a * u + b * v) + 0.1 * np.cos(c * u * v)], -1)


def keeps(found, error, tolerance, size):
    """size: of the control points, whose rounding counts; where a single point decides about one it may lie far away."""
    assert error <= tolerance
    assert found <= error * (1 + 1e-9) + ROUNDING * size


def is_near(found, error, share):
    """Whether an error is no more than promised above the truth, of which a little is between the samples."""
    return error <= (1 + share) * 1.001 * found + ROUNDING


def near_points(rng):
    points = 10.0**rng.uniform(-100, 100) * wave(rng, int(rng.integers(12, 300)))
    size = np.ptp(points)
    tolerance = size * 10.0**rng.uniform(-5, -1)
    made = fit.approximate(points, None, int(rng.integers(1, 8)), tolerance=tolerance, closed=bool(rng.random() < 0.3))
    keeps(made.value.nearest(points).distances.max() / size, made.error / size, tolerance / size, 1.0)


def near_points_otherwise(rng):
    """With weights, ends that move, parameters that are corrected, and smoothing, which may keep them from it."""
    points = wave(rng, int(rng.integers(12, 300)))
    tolerance = 10.0**rng.uniform(-4, -1)
    drawn = {"weights": 10.0**rng.uniform(-2, 2, len(points)), "fixed_ends": False,
             "corrections": int(rng.integers(1, 4)), "smoothing": 10.0**rng.uniform(-12, -9)}
    given = {name: value for name, value in drawn.items() if rng.random() < 0.4}
    try:
        made = fit.approximate(points, None, int(rng.integers(2, 8)), tolerance=tolerance, **given)
    except sc.ToleranceNotReached:
        assert "smoothing" in given
        return True
    keeps(made.value.nearest(points).distances.max(), made.error, tolerance, max(1.0, np.abs(made.value.points).max()))


def rebuilt(rng):
    curve = random_curve(rng, degree=int(rng.integers(2, 7)))
    tolerance = 10.0**rng.uniform(-1.5, 0)
    try:
        made = curve.rebuild(tolerance=tolerance, degree=int(rng.integers(3, 7)))
    except sc.ToleranceNotReached:          # even knots are not where a curve has corners
        assert min(joint.c for _, joint in curve.joints()) < 1
        return True
    found, size = apart(curve, made.value)
    keeps(found, made.error, tolerance, size)
    assert is_near(random_curves.sampled_distance(curve, made.value) / size, made.error / size, 0.01)


def faired(rng):
    curve = random_curve(rng, degree=int(rng.integers(2, 7)))
    tolerance = 10.0**rng.uniform(-4, 0)
    made = curve.fair(tolerance)
    found, size = apart(curve, made.value)
    keeps(found, made.error, tolerance, size)
    assert is_near(random_curves.sampled_distance(curve, made.value) / size, made.error / size, 0.01)


def without_knots(rng):
    curve = random_curve(rng)
    tolerance = 10.0**rng.uniform(-4, 0)
    made = curve.remove_knots(tolerance)
    found, size = apart(curve, made.value)
    keeps(found, made.error, tolerance, size)


def patch_without_knots(rng):
    patch = random_patches.random_patch(rng, degree=int(rng.integers(1, 6)), spans=4)
    tolerance = 10.0**rng.uniform(-4, 1)
    made = patch.remove_knots("uv"[rng.integers(2)], tolerance)
    keeps(random_patches.sampled_distance(patch, made.value, 20), made.error, tolerance, np.abs(patch.points).max())


def of_a_grid(rng):
    u, v = (np.sort(rng.uniform(0, 1, int(rng.integers(8, 40)))) for _ in range(2))
    points = height(rng, *np.meshgrid(u, v, indexing="ij"))
    tolerance = 10.0**rng.uniform(-4, -1)
    try:
        made = fit.approximate_patch(points, degrees=int(rng.integers(1, 5)), parameters=(u, v), tolerance=tolerance)
    except sc.InvalidShape as refused:      # parameters that lie next to each other, and as many control points
        assert "do not determine the shape as far as numbers can tell" in str(refused)
        return True
    keeps(lengths(made.value.evaluate_grid(u, v) - points).max(), made.error, tolerance, 1.0)


def of_scattered_points(rng):
    points = height(rng, *rng.uniform(0, 1, (2, int(rng.integers(100, 400)))))
    tolerance = 10.0**rng.uniform(-3, -1)
    try:
        made = fit.approximate_scattered(points, degrees=int(rng.integers(2, 4)), tolerance=tolerance)
    except sc.ToleranceNotReached as refused:          # more control points than points decide about
        assert "determine" in str(refused)
        return True
    keeps(made.value.nearest(points).distances.max(), made.error, tolerance, max(1.0, np.abs(made.value.points).max()))


def long(rng):
    curve = random_curve(rng)
    tolerance = 10.0**rng.uniform(-12, -2)
    rough, finest = (sum(dense_length(curve, span, parts) for span in spans(curve)) for parts in (2000, 4000))
    found, slack = curve.length(tolerance=tolerance), abs(finest - rough) + 1e-13 * finest
    if slack > tolerance * finest:      # the judge cannot tell
        return True
    assert abs(found - finest) <= tolerance * finest + slack + 1e-15 * np.abs(curve.points).max()


def spans(curve):
    start, end = curve.domain
    knots = np.unique(np.r_[start, curve.knots[(curve.knots > start) & (curve.knots < end)], end])
    return zip(knots[:-1], knots[1:])


def dense_length(curve, span, parts):
    """By Gauss's rule of 6 nodes on so many parts, which are short where a curve turns back."""
    nodes, shares = np.polynomial.legendre.leggauss(6)
    ends = np.linspace(*span, parts + 1)
    half = 0.5 * np.diff(ends)[:, None]
    at = 0.5 * (ends[1:] + ends[:-1])[:, None] + half * nodes
    slopes = curve.derivatives(at.ravel(), 1)[:, 1].reshape(*at.shape, 3)
    return (half * shares * lengths(slopes)).sum()


def divided(rng):
    curve = random_curve(rng)
    count = int(rng.integers(2, 9))
    whole = curve.length()
    if whole == 0:
        return
    parameters = curve.divide(count)
    for k, u in enumerate(parameters):
        assert abs(curve.length(curve.domain[0], u) - k * whole / count) <= 2e-10 * whole


def placed(rng):
    """A parameter by the length up to it, to 1e-10."""
    curve = random_curve(rng)
    whole = curve.length()
    for length in whole * rng.uniform(0, 1, 3) if whole > 0 else []:
        u = float(curve.parameter_at_length(length))
        assert abs(curve.length(curve.domain[0], u) - length) <= 2e-10 * whole


def rebuilt_patch(rng):
    """Its error is no tolerance, but the largest distance, at most 2 % above the truth."""
    patch = random_patches.random_patch(rng, degree=int(rng.integers(1, 6)))
    counts, degrees = rng.integers(5, 14, 2).tolist(), rng.integers(1, 5, 2).tolist()
    made = patch.rebuild(counts, degrees)
    assert made.value.points.shape[:2] == tuple(counts) and made.value.degree == tuple(degrees)
    found, size = random_patches.sampled_distance(patch, made.value, 80), np.abs(patch.points).max()
    keeps(found, made.error, np.inf, size)
    assert is_near(found / size, made.error / size, 0.02)


def faired_patch(rng):
    patch = random_patches.random_patch(rng, degree=int(rng.integers(2, 6)), spans=3)
    tolerance = 10.0**rng.uniform(-4, 0)
    made = patch.fair(tolerance, ends=("points", "tangents")[rng.integers(2)])
    found, size = random_patches.sampled_distance(patch, made.value, 80), np.abs(patch.points).max()
    keeps(found, made.error, tolerance, size)
    assert is_near(found / size, made.error / size, 0.02)


KINDS = (near_points, near_points_otherwise, rebuilt, faired, without_knots, patch_without_knots, of_a_grid,
         of_scattered_points, long, divided, placed, rebuilt_patch, faired_patch)
PARTS = 10
#: A rebuilt curve takes a quarter of a second: `--inputs 1000` draws as many of those, too.
FEW = {rebuilt: 100}


def refused(kind, part, inputs):
    """How many are, of how many."""
    rng = np.random.default_rng([part, KINDS.index(kind)])
    count = inputs(FEW.get(kind, 1000)) // PARTS
    return sum(bool(kind(rng)) for _ in range(count)), count


@pytest.mark.parametrize("part", range(PARTS))
@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.__name__)
def test_every_promise_is_kept(kind, part, inputs):
    few = {rebuilt: 0.6, near_points_otherwise: 0.3, of_scattered_points: 0.2, long: 0.1, of_a_grid: 0.01}.get(kind, 0)
    found, count = refused(kind, part, inputs)
    assert found <= few * count + 3 * np.sqrt(few * (1 - few) * count)


MEMORY = """
import re, sys
from pathlib import Path
import numpy as np
from splinecore import fit
def most():                                             # that of resource begins with what the parent had
    return int(re.search(r"VmHWM:\\s+(\\d+)", Path("/proc/self/status").read_text())[1])
def grid_of(p):
    u, v = np.meshgrid(np.linspace(0, 1, len(p) // 100), np.linspace(0, 1, 100), indexing="ij")
    return np.stack([u, v, np.sin(5 * u) * np.cos(3 * v)], -1)
t = np.linspace(0, 1, 200_000)
points = np.stack([np.cos(40 * t), np.sin(30 * t), t], -1)
calls = {"interpolate": lambda p: fit.interpolate(p), "count": lambda p: fit.approximate(p, 200),
         "tolerance": lambda p: fit.approximate(p, tolerance=1e-3),
         "scattered": lambda p: fit.approximate_scattered(np.random.default_rng(1).uniform(0, 1, p.shape) * [1, 1, 0.01], 20),
         "grid": lambda p: fit.interpolate_patch(grid_of(p)), "grid count": lambda p: fit.approximate_patch(grid_of(p), (15, 20)),
         "grid tolerance": lambda p: fit.approximate_patch(grid_of(p), tolerance=1e-2)}
call = calls[sys.argv[1]]
call(points[::100])
before = most()
call(points[::200_000 // int(sys.argv[2])])
print(most() - before)
"""


@pytest.mark.parametrize("call", [
    "interpolate", "count", "tolerance", "scattered", "grid", "grid count", "grid tolerance"])
def test_memory_grows_as_the_points_do(call):
    """In kilobytes: 100,000 points take no more than their share of what 200,000 take, and 500 bytes each."""
    taken = [int(subprocess.run([sys.executable, "-c", MEMORY, call, str(count)], capture_output=True, text=True,
                                check=True).stdout) for count in (100_000, 200_000)]
    assert 0 < taken[0] <= 50_000 and taken[1] <= 2.3 * taken[0] + 4_000
