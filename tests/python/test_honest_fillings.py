"""Fillings of random holes: what is said of gap and angle is what a second, dense look finds; or a sentence says why not."""

import numpy as np

import splinecore as sc
from splinecore import build

TOLERANCE = 1e-3


def random_knots(rng, degree, spans):
    """Some nearly equal, some as often as they may be."""
    inner = []
    for _ in range(spans - 1):
        kind = rng.integers(4)
        near = inner[-1] + 10 ** rng.uniform(-5, -2) if inner and kind == 0 else rng.uniform(0.05, 0.95)
        inner += [near] * (degree if kind == 1 else 1)
    return np.r_[[0] * (degree + 1), np.sort(inner), [1] * (degree + 1)]


def random_side(rng, start, end):
    degree = int(rng.integers(1, 10))
    knots = random_knots(rng, degree, int(rng.choice([1, 1, 2, 4])))
    count = len(knots) - degree - 1
    t = np.array([knots[i + 1:i + degree + 1].mean() for i in range(count)])
    points = np.outer(1 - t, start) + np.outer(t, end) + np.outer(4 * t * (1 - t), rng.normal(0, 0.1, 3))
    points[1:-1] += rng.normal(0, rng.choice([0, 0.2]) / count, (count - 2, 3))
    return sc.NurbsCurve(degree, knots, points, np.exp(rng.normal(0, 1, count) * rng.choice([0, 0, 0.3, 1])))


def beyond(rng, curve, noise, slope):
    points = np.array(curve.points)
    out = points / np.linalg.norm(points, axis=1)[:, None]
    rows = [points, points + 0.3 * out + rng.normal(0, noise, points.shape), points + 0.6 * out + (0, 0, slope)]
    weights = np.repeat(np.array(curve.weights)[:, None], 3, 1)
    return sc.NurbsPatch((curve.degree, 2), (curve.knots, [0, 0, 0, 1, 1, 1]), np.stack(rows, 1), weights)


def random_sides(rng):
    count = int(rng.integers(3, 7))
    angles = 2 * np.pi * (np.arange(count) + rng.uniform(-0.2, 0.2, count)) / count
    corners = np.exp(rng.uniform(-0.3, 0.3, count))[:, None] * np.c_[np.cos(angles), np.sin(angles), rng.normal(0, 0.1, count)]
    share, noise, slope = rng.choice([0, 0.5, 1]), rng.choice([0, 0.02, 0.1]), rng.choice([0, -0.5])
    sides = []
    for start, end in zip(corners, np.roll(corners, -1, 0)):
        curve = random_side(rng, start, end)
        if rng.random() >= share:
            sides.append(curve)
            continue
        patch, word = beyond(rng, curve, noise, slope), str(rng.choice(["G0", "G1", "G2"]))
        parts = patch.split("u", rng.uniform(0.2, 0.8)) if rng.random() < 0.3 else [patch]
        sides += [(part, "v_start", word) for part in parts]
    return sides


def moved(side, matrix):
    return (side[0].transformed(matrix), *side[1:]) if isinstance(side, tuple) else side.transformed(matrix)


def curve_of(side):
    return side[0].boundary(side[1]) if isinstance(side, tuple) else side


def inside_spans(knots, count):
    """Not at knots: there are two sides of these."""
    knots = np.unique(knots)
    return np.concatenate([a + (b - a) * np.linspace(1e-6, 1 - 1e-6, count) for a, b in zip(knots[:-1], knots[1:])])


def outer_borders(filling):
    if len(filling.patches) == 1:
        return [(filling.patches[0], name) for name in ("v_start", "u_end", "v_end", "u_start")]
    is_round = filling.patches[0].degree[0] != filling.patches[0].degree[1]
    return [(patch, name) for patch in filling.patches for name in (("v_start",) if is_round else ("v_start", "u_start"))]


def normals_along(patch, name, t):
    u, v = patch.domain
    at = {"u_start": (u[0] + 0 * t, t), "u_end": (u[1] + 0 * t, t), "v_start": (t, v[0] + 0 * t), "v_end": (t, v[1] + 0 * t)}[name]
    derivatives = np.asarray(patch.first_derivatives(*at)).reshape(-1, 3, 3)
    return np.cross(derivatives[:, 1], derivatives[:, 2])


def angles_between(a, b):
    return np.arctan2(np.linalg.norm(np.cross(a, b), axis=1), np.abs((a * b).sum(1)))


def found_at(sides, filling):
    """The largest distance between borders and sides, and the largest angle to neighbors, each from the nearest side."""
    curves = [curve_of(side) for side in sides]
    borders = [(patch, name, patch.boundary(name)) for patch, name in outer_borders(filling)]
    gap = angle = 0.0
    for curve in curves:
        points = curve.evaluate(inside_spans(curve.knots, 33))
        gap = max(gap, np.min([np.linalg.norm(b.nearest(points).points - points, axis=1) for *_, b in borders], axis=0).max())
    for patch, name, border in borders:
        t = inside_spans(border.knots, 9)
        points = border.evaluate(t)
        nearest = [curve.nearest(points) for curve in curves]
        off = np.array([np.linalg.norm(one.points - points, axis=1) for one in nearest])
        own = normals_along(patch, name, t)
        angles = np.zeros((len(sides), len(t)))
        for i, (side, one) in enumerate(zip(sides, nearest)):
            if isinstance(side, tuple) and side[2] != "G0":
                angles[i] = angles_between(own, normals_along(side[0], side[1], np.asarray(one.parameters)))
        angles[off > off.min(0) + 2 * TOLERANCE] = np.inf  # of those that are as near, the least
        angle = max(angle, np.min(angles, axis=0).max())
    return gap, angle


def filled(sides, tolerance):
    """None where a sentence says why not."""
    try:
        return build.fill(sides, tolerance=tolerance)
    except (sc.InvalidShape, sc.ToleranceNotReached) as refusal:
        assert any(word in str(refusal) for word in ("back over", "reach its sides", "without a corner", "zero derivative", "not seen whole", "3 to 8"))
        return None


def test_what_is_said_is_what_is_found(inputs):
    rng = np.random.default_rng(40)
    wanted = inputs(120)
    made = 0
    for _ in range(wanted):
        size = 10.0 ** rng.integers(-6, 7)
        matrix = size * np.c_[np.linalg.qr(rng.normal(size=(3, 3)))[0], rng.normal(0, 1, 3) * rng.choice([0, 1, 100])]
        sides = [moved(side, matrix) for side in random_sides(rng)]
        filling = filled(sides, TOLERANCE * size)
        if filling is None:
            continue
        made += 1
        gap, angle = found_at(sides, filling)
        assert filling.gap >= 0.98 * gap - 1e-11 * size * (1 + np.abs(matrix[:, 3]).max() / size)
        assert filling.angle >= 0.98 * angle - 1e-5
    assert made >= 0.3 * wanted
