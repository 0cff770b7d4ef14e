"""What is measured: the same numbers on every machine, written as raw float64 for the programs that time them."""

import json
from pathlib import Path

import numpy as np

WORKLOADS = ("W1 sorted", "W1 random", "W2", "W3 points", "W3 normals", "W4", "W5 degree 11", "W5 degree 25",
             "W6 refine", "W6 elevate", "W6 Beziers", "W7 curve 1e3", "W7 curve 1e4", "W7 curve 1e5", "W7 surface",
             "W7 least squares", "W8 curve", "W8 patch", "W9 curves", "W9 surfaces", "W10", "W11", "W12 loft", "W12 sweep",
             "W12 pipe", "W12 coons", "W12 fill 4", "W12 fill 5", "W12 offset",
             "W13 first", "W13 all", "adaptive", "picture")
PARAMETERS = 1_000_000
GRID = 1000
PATCH_GRID = 64
RAYS = 2000
SAMPLE_STEP = 2503
NEAREST_STEP = 37
BRANCHES = 4
BRANCH_SAMPLES = 50
#: How far surfaces made from curves and from others may be from what they should be, and fillings from tangent planes.
TOLERANCES = {"W12 loft": 1e-6, "W12 sweep": 1e-4, "W12 pipe": 1e-4, "W12 coons": 1e-9, "W12 fill 4": 1e-4,
              "W12 fill 5": 1e-4, "W12 offset": 1e-5}
ANGLE = 1e-2
PIPE_RADIUS = 0.2
OFFSET = 0.03
TEAPOT = Path(__file__).parents[2] / "addon/splinewright/core/shape/teapot.json"


def random(seed, count):
    """Numbers of [0, 1) from splitmix64 (Steele, Lea, Flood 2014), reproducible in any language."""
    with np.errstate(over="ignore"):
        z = np.uint64(seed << 32) + np.arange(1, count + 1, dtype=np.uint64) * np.uint64(0x9E3779B97F4A7C15)
        z = (z ^ (z >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
        z = (z ^ (z >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
        z = z ^ (z >> np.uint64(31))
    return (z >> np.uint64(11)).astype(float) * 2.0**-53


def uneven_knots(seed, count, degree=3):
    """Clamped simple knots on [0, 1] whose spans are from 0.5 to 1.5 of the mean."""
    ends = np.cumsum(0.5 + random(seed, count - degree))
    return np.concatenate([np.zeros(degree + 1), ends[:-1] / ends[-1], np.ones(degree + 1)])


def helix(count, seed):
    """Rows x, y, z, w of a helix with noise, weights from 0.5 to 2."""
    t = np.linspace(0, 1, count)
    noise = 0.1 * (random(seed, 3 * count).reshape(count, 3) - 0.5)
    points = np.stack([np.cos(12 * t), np.sin(12 * t), 2 * t], 1) + noise
    return np.column_stack([points, 0.5 + 1.5 * random(seed + 1, count)])


def coil(count, seed):
    """Points of a helix at uneven places: (count, 3)."""
    t = (np.arange(count) + 0.5 * random(seed, count)) / count
    return np.stack([np.cos(40 * t), np.sin(40 * t), 4 * t], 1)


def chord_parameters(points):
    """From 0 to 1, by the distances of points."""
    sums = np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))
    return np.concatenate([[0.0], sums / sums[-1]])


def sheet(count):
    """Rows x, y, z, w of a wavy sheet with noise, (count, count, 4), weights from 0.5 to 2."""
    u, v = np.meshgrid(*[np.linspace(0, 1, count)] * 2, indexing="ij")
    noise = random(7, 3 * count * count).reshape(count, count, 3) - 0.5
    step = 0.3 / (count - 1)
    z = 0.2 * np.sin(9 * u) * np.cos(7 * v) + 0.02 * noise[..., 2]
    weights = 0.5 + 1.5 * random(8, count * count).reshape(count, count)
    return np.stack([u + step * noise[..., 0], v + step * noise[..., 1], z, weights], -1)


def uniform_knots(count, degree=3):
    return np.concatenate([np.zeros(degree + 1), np.arange(1, count - degree) / (count - degree), np.ones(degree + 1)])


def zigzag(count, side):
    """Points of a plane cubic that goes up and down: (count, 3)."""
    noise = random(20, 2 * count).reshape(2, count)[0 if side > 0 else 1]
    sign = np.where(np.arange(count) % 2 == 0, 1.0, -1.0)
    return np.stack([np.linspace(0, 1, count), side * 0.1 * sign * (0.8 + 0.4 * noise), np.zeros(count)], 1)


def waves(count, height):
    """Points of a sheet over the unit square of heights by a function of both coordinates: (count, count, 3)."""
    x, y = np.meshgrid(*[np.linspace(0, 1, count)] * 2, indexing="ij")
    return np.stack([x, y, height(x, y)], -1)


def paraboloid(x, y):
    """Heights of a face of a lens over the unit square."""
    return 0.3 - 0.5 * ((x - 0.5)**2 + (y - 0.5)**2)


def rays(count):
    """From above through the middle of the unit square, not quite down: (count, 6), origins and directions of length 1."""
    places, slopes = 0.3 + 0.4 * random(40, 2 * count).reshape(count, 2), 0.2 * random(41, 2 * count).reshape(count, 2) - 0.1
    directions = np.column_stack([slopes, np.full(count, -1.0)])
    return np.column_stack([places, np.full(count, 2.0), directions / np.linalg.norm(directions, axis=1, keepdims=True)])


def bezier(degree, seed):
    noise = random(seed, 2 * (degree + 1)).reshape(-1, 2)
    return np.stack([0.3 + noise[:, 0], 0.2 * noise[:, 1], 3 * np.linspace(0, 1, degree + 1)], 1)


def teapot():
    """Newell's 32 bicubic patches: (32, 4, 4, 3)."""
    data = json.loads(TEAPOT.read_text())
    return np.array(data["points"])[np.array(data["patches"])].reshape(32, 4, 4, 3)


def about(points, seed, count):
    """Random points in the box of others, blown up by 20 % a side."""
    low, high = points.min(0), points.max(0)
    return low - 0.2 * (high - low) + 1.4 * (high - low) * random(seed, 3 * count).reshape(count, 3)


def hull(count, size):
    """Control points of sections at uneven distances: (count, size, 3)."""
    t = np.linspace(-1.2, 1.2, size)
    depth = 1 + 0.3 * np.sin(0.6 * np.arange(count))[:, None]
    x = np.cumsum(0.7 + 0.6 * random(21, count))[:, None] + 0 * t
    noise = 0.02 * (random(22, 3 * count * size).reshape(count, size, 3) - 0.5)
    return np.stack([x, depth * np.sin(t), -depth * np.cos(t)], -1) + noise


def averages(parameters, degree=3):
    """Clamped knots of a spline through points at parameters (de Boor)."""
    inner = [parameters[i:i + degree].mean() for i in range(1, len(parameters) - degree)]
    return np.concatenate([np.full(degree + 1, parameters[0]), inner, np.full(degree + 1, parameters[-1])])


def across(direction):
    """A unit vector at right angles to another, level."""
    level = np.cross(direction, (0, 0, 1))
    return level / np.linalg.norm(level)


def gutter(count):
    """Control points of a plane section about the origin: (count, 3)."""
    t = np.linspace(-2.2, 2.2, count)
    return 0.25 * np.stack([np.cos(t), np.sin(t) + 0.3 * np.cos(3 * t), 0 * t], 1)


def border(start, end, count, seed):
    """Control points from one place to another, which bulges and waves: (count, 3)."""
    t = np.linspace(0, 1, count)[:, None]
    start, end = np.array(start, float), np.array(end, float)
    outwards = np.cross(end - start, (0, 0, 1))
    noise = 0.02 * (random(seed, 3 * count).reshape(count, 3) - 0.5)
    waves = 0.1 * np.sin(np.pi * t) * outwards + 0.15 * np.sin(3 * np.pi * t) * np.array([0, 0, 1.0])
    return start + t * (end - start) + waves + np.where((t > 0) & (t < 1), noise, 0)


def polygon(count, seed):
    """Corners of an irregular convex one: (count, 2)."""
    turns, sizes = random(seed, 2 * count).reshape(2, count)
    angles = 2 * np.pi * (np.arange(count) + 0.3 * turns) / count
    return (0.3 + 0.1 * sizes[:, None]) * np.stack([np.cos(angles), np.sin(angles)], 1)


def bilinear_product(a, b):
    """Biquadratic coefficients of the product of bilinear functions of coefficients (2, 2)."""
    made = np.zeros((3, 3))
    for (i, j), value in np.ndenumerate(a):
        made[i:i + 2, j:j + 2] += value * b
    return made / np.outer([1, 2, 1], [1, 2, 1])


def on_sphere(corners):
    """Rows x, y, z, w, (3, 3, 4), of the part of the unit sphere whose stereographic image is this quadrangle, (2, 2, 2)."""
    s, t = corners[..., 0], corners[..., 1]
    one = np.ones((2, 2))
    square = bilinear_product(s, s) + bilinear_product(t, t)
    weights = 1 + square
    parts = [2 * bilinear_product(s, one), 2 * bilinear_product(t, one), 1 - square]
    return np.stack([part / weights for part in parts] + [weights], -1)


def around_hole(corners):
    """Patches of the unit sphere beyond each side of a hole, v away from it: (sides, 3, 3, 4)."""
    following = np.roll(corners, -1, 0)
    return np.stack([on_sphere(np.array([[a, 2 * a], [b, 2 * b]])) for a, b in zip(corners, following, strict=True)])


def of_surfaces():
    """The inputs of surfaces from curves and from others."""
    sections, rail = hull(12, 32), helix(16, 24)[:, :3]
    steps = np.linalg.norm(np.diff(sections, axis=0), axis=-1).mean(1)
    parameters = np.concatenate([[0.0], np.cumsum(steps) / steps.sum()])
    corners = np.array([(0, 0, 0), (1, 0, 0.1), (1, 1, -0.1), (0, 1, 0.2)])
    sides = {k: (corners[k], corners[(k + 1) % 4], 32 if k % 2 == 0 else 24) for k in range(4)}
    return {
        "loft.sections": sections, "loft.knots": uneven_knots(23, 32),
        "loft.parameters": parameters, "loft.knots_v": averages(parameters),
        "rail.points": rail, "rail.knots": uneven_knots(25, 16), "rail.start": across(rail[1] - rail[0]),
        "gutter.points": gutter(8), "gutter.knots": uniform_knots(8),
        **{f"coons{k}.points": border(*side, 26 + k) for k, side in sides.items()},
        **{f"coons{k}.knots": uneven_knots(30 + k, side[2]) for k, side in sides.items()},
        **{f"fill {count}.neighbors": around_hole(polygon(count, 34 + count)) for count in (4, 5)},
        "offset": np.array([OFFSET]), "pipe_radius": np.array([PIPE_RADIUS]), "angle": np.array([ANGLE]),
        **{f"{name}.tolerance": np.array([tolerance]) for name, tolerance in TOLERANCES.items()},
    }


def inputs():
    """Every array by its name."""
    scattered = random(4, PARAMETERS)
    return {
        "curve.knots": uneven_knots(1, 64), "curve.points": helix(64, 2),
        "random": scattered, "sorted": np.sort(scattered),
        "surface.knots_u": uneven_knots(5, 32), "surface.knots_v": uneven_knots(6, 32), "surface.points": sheet(32),
        "grid": np.linspace(0, 1, GRID), "pairs": random(9, 2 * PARAMETERS).reshape(-1, 2),
        "bezier11.points": bezier(11, 10), "bezier25.points": bezier(25, 11),
        "long.knots": uneven_knots(12, 1000), "long.points": helix(1000, 13), "inserted": np.sort(random(15, 1000)),
        **{f"coil{count}": coil(count, 16) for count in (1000, 10_000, 100_000)},
        "lsq.parameters": chord_parameters(coil(100_000, 16)),
        "lsq.knots": np.concatenate([np.zeros(3), np.linspace(0, 1, 198), np.ones(3)]),
        "sheet300": sheet(300)[..., :3], "line300": np.linspace(0, 1, 300),
        "near_curve": about(helix(64, 2)[:, :3], 18, 10_000),
        "near_surface": about(sheet(32)[..., :3].reshape(-1, 3), 19, 1000),
        "zigzag.knots": uniform_knots(64), "zigzag_a": zigzag(64, 1.0), "zigzag_b": zigzag(64, -1.0),
        "waves.knots": uniform_knots(12),
        "waves_a": waves(12, lambda x, y: 0.15 * np.sin(8 * x) * np.cos(6 * y)),
        "waves_b": waves(12, lambda x, y: 0.1 * np.sin(5 * y + 1) * np.cos(7 * x) + 0.02),
        "lens_front": waves(12, paraboloid), "lens_back": waves(12, lambda x, y: -paraboloid(x, y)), "rays": rays(RAYS),
        "teapot": teapot(), "patch_grid": np.linspace(0, 1, PATCH_GRID), **of_surfaces(),
    }


def write(folder):
    folder.mkdir(parents=True, exist_ok=True)
    for name, array in inputs().items():
        np.ascontiguousarray(array, dtype="<f8").tofile(folder / f"{name}.f64")
