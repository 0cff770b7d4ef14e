"""Times splinecore through its Python module: ours.py DATA KEPT WORKLOAD, as the rivals' programs do."""

import contextlib
import inspect
import os
import sys
import time

import numpy as np
import splinecore as sc
from splinecore import fit

import ours_surfaces
import workloads
from timing import Run


def takes(function, argument):
    return argument in inspect.signature(function).parameters


def alone(function):
    """One thread, where a function can have more."""
    return {"threads": 1} if takes(function, "threads") else {}


@contextlib.contextmanager
def on_all_cores():
    """run.py keeps its programs on one core."""
    one = os.sched_getaffinity(0)
    os.sched_setaffinity(0, range(os.cpu_count()))
    try:
        yield
    finally:
        os.sched_setaffinity(0, one)


class Ours(Run):
    def fresh_and_reused(self, function, arguments, shapes, items, rows, dtype=None):
        """`function` into fresh arrays, and into reused ones where it takes them; rows(result) is what is kept."""
        kind = {} if dtype is None else {"dtype": dtype}
        prefix = "" if dtype is None else f"{np.dtype(dtype)}, "
        options = alone(function)
        self.time(prefix + "fresh", items, lambda: function(*arguments, **kind, **options))
        self.keep(prefix + "fresh", rows(function(*arguments, **kind, **options)))
        if takes(function, "out"):
            made = [np.empty(shape, dtype or float) for shape in shapes]
            out = made[0] if len(made) == 1 else tuple(made)
            self.time(prefix + "out=", items, lambda: function(*arguments, out=out, **options))
            self.keep(prefix + "out=", rows(out))
            if options and dtype is None:
                with on_all_cores():
                    self.time("all cores", items, lambda: function(*arguments, out=out), clock=time.perf_counter)


def curve(run):
    rows = run.input("curve.points", -1, 4)
    return sc.NurbsCurve(3, run.input("curve.knots"), rows[:, :3], rows[:, 3])


def long_curve(run):
    return sc.NurbsCurve(3, run.input("long.knots"), run.input("long.points", -1, 4)[:, :3])


def surface(run):
    rows = run.input("surface.points", 32, 32, 4)
    knots = run.input("surface.knots_u"), run.input("surface.knots_v")
    return sc.NurbsPatch((3, 3), knots, rows[..., :3], rows[..., 3])


def teapot(run):
    return [sc.BezierPatch(net) for net in run.input("teapot", -1, 4, 4, 3)]


def points(run, shape, parameters):
    count = len(parameters)
    run.fresh_and_reused(shape.evaluate, (parameters,), [(count, 3)], count, lambda out: out)


def second_derivatives(run):
    u = run.input("sorted")
    run.fresh_and_reused(curve(run).derivatives, (u, 2), [(len(u), 3, 3)], len(u), lambda out: out.reshape(-1, 9))


def grid_points(run):
    patch, line = surface(run), run.input("grid")
    n = len(line)
    for dtype in (None, np.float32):
        run.fresh_and_reused(patch.evaluate_grid, (line, line), [(n, n, 3)], n * n,
                             lambda out: out.reshape(-1, 3), dtype)


def pair_rows(made):
    return np.concatenate([part.reshape(-1, 3) for part in made], 1)


def grid_normals(run):
    patch, line = surface(run), run.input("grid")
    n = len(line)
    for dtype in (None, np.float32):
        run.fresh_and_reused(patch.evaluate_grid_with_normals, (line, line), [(n, n, 3)] * 2, n * n, pair_rows, dtype)


def first_derivatives(run):
    pairs = run.input("pairs", -1, 2)
    u, v = pairs[:, 0].copy(), pairs[:, 1].copy()

    run.fresh_and_reused(surface(run).first_derivatives, (u, v), [(len(u), 3, 3)], len(u),
                         lambda out: out.reshape(-1, 9))


def verb(run, call, items, work, rows):
    run.time(call, items, work)
    run.keep(call, rows(work()), 7)


def refine(run):
    shape, knots = long_curve(run), run.input("inserted")
    verb(run, "refine", len(knots), lambda: shape.refine(knots), lambda made: made.points)


def elevate(run):
    shape = long_curve(run)
    verb(run, "elevate", 1000, lambda: shape.elevate(2), lambda made: made.points)


def beziers(run):
    shape = long_curve(run)
    verb(run, "bezier_points", 997, shape.bezier_points, lambda made: made[..., :3].reshape(-1, 3))


def interpolated_curve(run, count):
    """With the knots that SISL takes. What is kept is the curve at the parameters of its points."""
    rows = run.input(f"coil{count}", -1, 3)
    run.time("interpolate", count, lambda: fit.interpolate(rows, ends="not_a_knot"))
    steps = np.linalg.norm(np.diff(rows, axis=0), axis=1)
    curve = fit.interpolate(rows, ends="not_a_knot").value
    parameters = np.clip(np.concatenate([[0.0], np.cumsum(steps)]), *curve.domain)
    run.keep("interpolate", curve.evaluate(parameters), 7)


def interpolated_surface(run):
    """With the knots that SISL takes, too."""
    rows, line = run.input("sheet300", 300, 300, 3), run.input("line300")

    def made():
        return fit.interpolate_patch(rows, parameters=(line, line), ends="not_a_knot").value

    run.time("interpolate_patch", rows.size // 3, made)
    patch = made()
    run.keep("interpolate_patch", patch.evaluate_grid(line, line).reshape(-1, 3), 7)


def least_squares(run):
    knots, parameters, points = run.input("lsq.knots"), run.input("lsq.parameters"), run.input("coil100000", -1, 3)

    def work():
        return fit.approximate(points, parameters=parameters, knots=knots, fixed_ends=False)

    run.time("approximate", len(points), work)
    run.keep("approximate", work().value.points, 1)


def many_patches(run):
    patches, line = teapot(run), run.input("patch_grid")
    n, count = len(line), len(patches)
    together = sc.PatchSet.from_patches(patches)
    if hasattr(together, "evaluate_grid_with_normals"):
        run.fresh_and_reused(together.evaluate_grid_with_normals, (line, line), [(count, n, n, 3)] * 2,
                             count * n * n, pair_rows)
    else:
        def each():
            return [patch.evaluate_grid_with_normals(line, line) for patch in patches]

        run.time("a call a patch", count * n * n, each)
        run.keep("a call a patch", np.concatenate([pair_rows(made) for made in each()]))


def nearest(run, shape, name):
    places = run.input(name, -1, 3)
    run.time("nearest", len(places), lambda: shape.nearest(places, threads=1))
    run.keep("nearest", shape.nearest(places).distances, workloads.NEAREST_STEP)
    with on_all_cores():
        run.time("all cores", len(places), lambda: shape.nearest(places), clock=time.perf_counter)


def crossings(run):
    knots = run.input("zigzag.knots")
    a, b = (sc.NurbsCurve(3, knots, run.input(name, -1, 3)) for name in ("zigzag_a", "zigzag_b"))
    found = a.intersections(b)
    run.time("intersections", 1, lambda: a.intersections(b), f"{len(found.parameters)} crossings")
    run.keep("intersections", np.sort(found.parameters[:, 0]), step=1)


def sections(run):
    knots = run.input("waves.knots")
    a, b = (sc.NurbsPatch((3, 3), (knots, knots), run.input(name, 12, 12, 3)) for name in ("waves_a", "waves_b"))
    found = a.sections(b, 1e-5)
    run.time("sections", 1, lambda: a.sections(b, 1e-5),
             f"{len(found.curves)} curves, {sum(len(curve.points) for curve in found.curves)} control points, within 1e-5")
    rows = []
    for curve, on_a, on_b in zip(found.curves, found.on_a, found.on_b):
        t = np.linspace(*curve.domain, workloads.BRANCH_SAMPLES)
        apart = [patch.evaluate(*np.clip(image.evaluate(t)[:, :2], 0, 1).T) - curve.evaluate(t)
                 for patch, image in ((a, on_a), (b, on_b))]
        rows.append(np.linalg.norm(apart, axis=-1).max(0))
    run.keep("sections", np.concatenate(rows), step=1)


def rays(run, hits):
    """Kept is how far the place of the patch is from that on the ray, for each hit."""
    knots, rows = run.input("waves.knots"), run.input("rays", -1, 6)
    lens = sc.PatchSet.from_patches([sc.NurbsPatch((3, 3), (knots, knots), run.input(name, 12, 12, 3))
                                     for name in ("lens_front", "lens_back")])
    origins, directions = rows[:, :3].copy(), rows[:, 3:].copy()
    found = lens.rays(origins, directions, hits=hits)
    met = found.patches >= 0
    run.time("rays", len(rows), lambda: lens.rays(origins, directions, hits=hits, threads=1), f"{met.sum()} hits")
    with on_all_cores():
        run.time("all cores", len(rows), lambda: lens.rays(origins, directions, hits=hits), clock=time.perf_counter)
    places = np.array([lens[patch].evaluate(u, v) for patch, (u, v) in zip(found.patches[met], found.parameters[met])])
    of_ray = found.rays[met]
    on_ray = origins[of_ray] + found.along[met][:, None] * directions[of_ray]
    run.keep("rays", np.linalg.norm(places - on_ray, axis=1), step=1)


def length(run):
    shape = curve(run)
    run.time("length", 1, lambda: shape.length(tolerance=1e-9))
    run.keep("length", [shape.length(tolerance=1e-9)])


def adaptive(run):
    """The mesh with its points: a mesh for a modeler has both."""
    patch_set = sc.PatchSet.from_patches(teapot(run))
    options = alone(sc.Tessellation.adaptive)

    def mesh():
        made = sc.Tessellation.adaptive(patch_set, tolerance=1e-3, **options)
        return made, made.evaluate_positions(patch_set)

    made, _ = mesh()
    triangles = len(made.corner_vertices) - 2 * len(made.face_patches)
    run.time("adaptive", 1, mesh, f"{made.vertex_count} vertices, {triangles} triangles")


def picture(run):
    """What notebooks show of a surface."""
    patch = surface(run)
    run.time("_repr_svg_", 1, patch._repr_svg_, f"{len(patch._repr_svg_()):,} bytes")


RUNS = {
    "W1 sorted": lambda run: points(run, curve(run), run.input("sorted")),
    "W1 random": lambda run: points(run, curve(run), run.input("random")),
    "W2": second_derivatives,
    "W3 points": grid_points,
    "W3 normals": grid_normals,
    "W4": first_derivatives,
    "W5 degree 11": lambda run: points(run, sc.BezierCurve(run.input("bezier11.points", -1, 3)), run.input("sorted")),
    "W5 degree 25": lambda run: points(run, sc.BezierCurve(run.input("bezier25.points", -1, 3)), run.input("sorted")),
    "W6 refine": refine,
    "W6 elevate": elevate,
    "W6 Beziers": beziers,
    "W7 curve 1e3": lambda run: interpolated_curve(run, 1000),
    "W7 curve 1e4": lambda run: interpolated_curve(run, 10_000),
    "W7 curve 1e5": lambda run: interpolated_curve(run, 100_000),
    "W7 surface": interpolated_surface,
    "W7 least squares": least_squares,
    "W8 curve": lambda run: nearest(run, curve(run), "near_curve"),
    "W8 patch": lambda run: nearest(run, surface(run), "near_surface"),
    "W9 curves": crossings,
    "W9 surfaces": sections,
    "W10": many_patches,
    "W11": length,
    **ours_surfaces.RUNS,
    "W13 first": lambda run: rays(run, "first"),
    "W13 all": lambda run: rays(run, "all"),
    "adaptive": adaptive,
    "picture": picture,
}

if __name__ == "__main__":
    RUNS[sys.argv[3]](Ours("splinecore", *sys.argv[1:]))
