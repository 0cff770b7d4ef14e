"""What tells whether the library works on a machine: closed forms, bits that are the same everywhere, speed."""

import hashlib
import platform
import time
from typing import NamedTuple

import numpy as np

from .library import sc

#: Of results(), by the instructions that add up: the same on every system, for no function of a system's own enters. Those of
#: ARM add up as x86-64-v3 does.
DIGESTS = {'x86-64-v4': "ace39ed667dc4d07", 'x86-64-v3': "cb19f37bc09b0666", 'baseline': "141a1c7608c6d1ab"}
DEGREES = range(1, 8)


class Check(NamedTuple):
    """Something that was tried, what came out, and whether that is as it should be."""

    name: str
    found: str
    passed: bool


def curves(seed=2026):
    """A rational curve of each degree, on uneven knots."""
    random = np.random.default_rng(seed)
    return [_curve(random, degree, 2 * degree + 5) for degree in DEGREES]


def patches(seed=2027):
    """Rational patches of these degrees along u, and of others along v."""
    random = np.random.default_rng(seed)
    return [_patch(random, degree, 8 - degree) for degree in DEGREES]


def _knots(random, degree, count):
    inner = np.cumsum(random.uniform(0.5, 1.5, count - degree))
    return np.concatenate([np.zeros(degree + 1), inner[:-1] / inner[-1], np.ones(degree + 1)])


def _curve(random, degree, count):
    return sc.NurbsCurve(degree, _knots(random, degree, count), random.uniform(-1, 1, (count, 3)),
                         random.uniform(0.5, 2, count))


def _patch(random, degree_u, degree_v):
    counts = degree_u + 3, degree_v + 3
    places = np.stack(np.meshgrid(*[np.arange(count) for count in counts], indexing='ij'), axis=-1)
    points = np.concatenate([places + random.uniform(-0.2, 0.2, places.shape), random.uniform(-1, 1, (*counts, 1))], axis=-1)
    return sc.NurbsPatch((degree_u, degree_v), [_knots(random, degree_u, counts[0]), _knots(random, degree_v, counts[1])],
                         points, random.uniform(0.5, 2, counts))


def results():
    """Arrays that every part of the library had a hand in."""
    at = np.random.default_rng(2028).uniform(0, 1, 100)
    for curve in curves():
        yield from (curve.evaluate(at), curve.derivatives(at, 2), curve.refine(np.sort(at[:5])).points,
                    curve.elevate().points, np.array([curve.length()]))
    for patch in patches():
        yield from (patch.evaluate_grid(at[:20], at[20:40]), np.array([patch.area(tolerance=1e-6)]))
        patch_set = sc.PatchSet.from_patches([patch])
        for mesh in (sc.Tessellation(patch_set, 3), sc.Tessellation.adaptive(patch_set, tolerance=0.01)):
            yield from (*mesh.evaluate(patch_set), mesh.corner_vertices, mesh.face_starts)
        yield from (section.points for section in patch.plane_sections((0, 0, 0.1), (0, 0, 1)).curves)


def digest():
    """Of the bits of all results."""
    found = hashlib.sha256()
    for array in results():
        found.update(np.ascontiguousarray(array).tobytes())
    return found.hexdigest()[:16]


def checks():
    """Each Check of the library alone, as it is done."""
    yield _closed_forms()
    yield _bits()
    yield _speed()


def _closed_forms():
    """Points of the unit circle and of a ball, lengths and areas."""
    circle, ball = sc.conics.circle((0, 0, 0), 1), sc.build.sphere((0, 0, 0), 1)
    at = np.linspace(0, 1, 1001)
    points = circle.evaluate(np.interp(at, (0, 1), circle.domain)), ball.evaluate_grid(
        *[np.linspace(*domain, 101) for domain in ball.domain]).reshape(-1, 3)
    wrong = max(*[np.abs(np.linalg.norm(part, axis=-1) - 1).max() for part in points],
                abs(circle.length() / (2 * np.pi) - 1), abs(ball.area() / (4 * np.pi) - 1))
    return Check("Circle and ball, against their formulas", f"off by {wrong:.1e} of the radius", bool(wrong < 1e-14))


def _bits():
    is_arm = platform.machine().lower() in {'aarch64', 'arm64'}
    found, wanted = digest(), DIGESTS['x86-64-v3' if is_arm else sc.__instruction_set__]
    same = found == wanted
    return Check("Results, bit for bit", f"{found}, as on every system" if same else f"{found}, not {wanted}", same)


def _speed():
    """Of a cubic curve and a bicubic patch; no speed is wrong."""
    curve, patch = curves()[2], sc.PatchSet.from_patches([patches()[2]])
    at, mesh = np.linspace(0, 1, 100_000), sc.Tessellation(patch, 100)
    points = len(at) / _seconds(lambda: curve.evaluate(at))
    vertices = mesh.vertex_count / _seconds(lambda: mesh.evaluate(patch))
    return Check("Speed", f"{points / 1e6:.0f} million points of a cubic a second, {vertices / 1e6:.0f} million vertices of a "
                 "mesh with normals", True)


def _seconds(call):
    """The least of some runs."""
    found = []
    for _ in range(5):
        began = time.perf_counter()
        call()
        found.append(time.perf_counter() - began)
    return min(found)
