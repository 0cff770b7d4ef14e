"""Surfaces from curves and from others: what ours.py times of them, and keeps for deviations.py."""

import numpy as np
import splinecore as sc
from splinecore import build

import workloads


def numbers_of(patch):
    """Degrees, counts, knots along u and along v, rows x, y, z, w."""
    open_patch = patch.unrolled() if any(patch.periodic) else patch
    rows = np.concatenate([open_patch.points, open_patch.weights[..., None]], -1)
    return np.concatenate([open_patch.degree, rows.shape[:2], *open_patch.knots, rows.ravel()])


def surfaces(run, call, work, patches_of):
    patches = patches_of(work())
    count = sum(patch.points.size // 3 for patch in patches)
    degrees = " and ".join(str(degree) for degree in patches[0].degree)
    run.time(call, 1, work, f"{count} control points, degrees {degrees}" + f", {len(patches)} patches" * (len(patches) > 1))
    run.keep(call, np.concatenate([numbers_of(patch) for patch in patches]), 1)


def fitted(made):
    return made.value if isinstance(made.value, list) else [made.value]


def cubic(run, name):
    return sc.NurbsCurve(3, run.input(f"{name}.knots"), run.input(f"{name}.points", -1, 3))


def loft(run):
    knots, parameters = run.input("loft.knots"), run.input("loft.parameters")
    sections = [sc.NurbsCurve(3, knots, points) for points in run.input("loft.sections", len(parameters), -1, 3)]
    surfaces(run, "loft", lambda: build.loft(sections, parameters=parameters), fitted)


def sweep(run):
    rail, section, start = cubic(run, "rail"), cubic(run, "gutter"), run.input("rail.start")
    tolerance = workloads.TOLERANCES["W12 sweep"]
    surfaces(run, "sweep", lambda: build.sweep(rail, section, start=start, tolerance=tolerance), fitted)


def pipe(run):
    rail, tolerance = cubic(run, "rail"), workloads.TOLERANCES["W12 pipe"]
    surfaces(run, "pipe", lambda: build.pipe(rail, workloads.PIPE_RADIUS, tolerance=tolerance), fitted)


def coons(run):
    sides = [cubic(run, f"coons{k}") for k in range(4)]
    surfaces(run, "coons", lambda: build.coons(sides), fitted)


def fill(run, count):
    nets = run.input(f"fill {count}.neighbors", count, 3, 3, 4)
    knots = np.repeat([0.0, 1.0], 3)
    sides = [(sc.NurbsPatch((2, 2), (knots, knots), net[..., :3], net[..., 3]), "v_start", "G1") for net in nets]
    tolerance = workloads.TOLERANCES[f"W12 fill {count}"]
    surfaces(run, "fill", lambda: build.fill(sides, tolerance=tolerance, angle=workloads.ANGLE),
             lambda made: list(made.patches))


def offset(run):
    knots, tolerance = run.input("waves.knots"), workloads.TOLERANCES["W12 offset"]
    patch = sc.NurbsPatch((3, 3), (knots, knots), run.input("waves_a", 12, 12, 3))
    surfaces(run, "offset_patch", lambda: build.offset_patch(patch, workloads.OFFSET, tolerance=tolerance), fitted)


RUNS = {
    "W12 loft": loft,
    "W12 sweep": sweep,
    "W12 pipe": pipe,
    "W12 coons": coons,
    "W12 fill 4": lambda run: fill(run, 4),
    "W12 fill 5": lambda run: fill(run, 5),
    "W12 offset": offset,
}
