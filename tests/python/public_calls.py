"""Every public call of the library, with arguments for shapes of any degree, size and weight.

METHODS has a function for each public method of each class, FUNCTIONS one for each public function of a module; what
is no method is a property and is read. A name that the library gains and these lack fails test_every_call.py.
"""

import copy
import math
import pickle
import types

import numpy as np

import splinecore as sc
from public_functions import FUNCTIONS, random_rows, xyz
from splinecore import basis, build, conics, fit

MODULES = {"sc": sc, "basis": basis, "build": build, "conics": conics, "fit": fit}
SIDES = ("u_start", "u_end", "v_start", "v_end")


def inside(domain, count=5):
    """Places of a domain, its ends among them."""
    start, end = domain
    return np.clip(start + (end - start) * np.linspace(0, 1, count), start, end)


def middle(domain):
    return float(inside(domain, 3)[1])


def inner_knot(knots, domain):
    found = [float(u) for u in knots if domain[0] < u < domain[1]]
    return found[len(found) // 2] if found else middle(domain)


def matrix(shift=0.0):
    turn = np.array([[0.8, -0.6, 0, shift], [0.6, 0.8, 0, 0], [0, 0, 1, 0]])
    return turn


def closed(one, at):
    """The curve, or where its ends are apart a line there and back of its class."""
    if np.array_equal(*one.evaluate(np.array(one.domain))):
        return one
    there, back = xyz(at, 1), xyz(at, 0, 1)
    if isinstance(one, sc.HermiteCurve):
        return sc.HermiteCurve([there, back, there], [there, back, there])
    if isinstance(one, sc.PowerCurve):
        return sc.PowerCurve([there, back, -back])
    line = sc.BezierCurve([there, back, there - back, there])
    return line if isinstance(one, sc.BezierCurve) else line.to_nurbs()


def open_form(one):
    return one.unrolled() if isinstance(one, sc.NurbsCurve) else one


def tip(one):
    return one.evaluate(one.domain[1])


def bar(place, at):
    """A line through a place."""
    return sc.BezierCurve([place - xyz(at, 0.1, 0.2, 0.3), place + xyz(at, 0.1, 0.2, 0.3)])


MOVED = {
    "transformed": lambda one, at: one.transformed(matrix(at.size)),
    "translated": lambda one, at: one.translated(xyz(at, 1, 2)),
    "rotated": lambda one, at: one.rotated(0.3, (1, 2, 3), xyz(at, 1)),
    "scaled": lambda one, at: [one.scaled(2), one.scaled((1, -1, 0.5), xyz(at, 1))],
}
RAYS = {
    "rays": lambda one, at: [one.rays(at.size * random_rows(3), (1, 2, 3), hits="all"),
                             one.rays(at.size * random_rows(3), (1, 2, 3)).touches],
}
CURVE = MOVED | {
    "join": lambda one, at: [open_form(one).join(open_form(one), word) for word in ("C0", "G1", "C2")],
    "continuity_to": lambda one, at: one.continuity_to(one),
    "least_distance": lambda one, at: one.least_distance(at.bezier, 0.1 * at.size),
    "evaluate": lambda one, at: [one.evaluate(inside(one.domain)), one.evaluate(inside(one.domain), side="left"),
                                 one.evaluate(inside(one.domain), dtype=np.float32) if at.fits_single else None],
    "derivatives": lambda one, at: one.derivatives(inside(one.domain), at.order),
    "pieces": lambda one, at: one.pieces(),
    "polylines": lambda one, at: [one.polylines(3), one.polylines(2, reach=at.size)],
    "split": lambda one, at: one.split(middle(one.domain)),
    "reversed": lambda one, at: one.reversed(),
    "to_bezier": lambda one, at: one.to_bezier(),
    "to_hermite": lambda one, at: one.to_hermite(),
    "to_nurbs": lambda one, at: one.to_nurbs(),
    "to_power": lambda one, at: one.to_power(),
    "length": lambda one, at: [one.length(tolerance=1e-6), one.length(middle(one.domain), tolerance=1e-3)],
    "parameter_at_length": lambda one, at: [one.parameter_at_length(0, tolerance=1e-3),
                                            one.parameter_at_length(one.length(tolerance=1e-6), tolerance=1e-3)],
    "divide": lambda one, at: one.divide(3, tolerance=1e-3),
    "divide_by_length": lambda one, at: one.divide_by_length(at.size, tolerance=1e-3),
    "curvature": lambda one, at: one.curvature(inside(one.domain)),
    "signed_curvature": lambda one, at: one.signed_curvature(inside(one.domain), (0, 0, 1)),
    "intersections": lambda one, at: one.intersections(at.bezier),
    "self_intersections": lambda one, at: one.self_intersections(),
    "offset": lambda one, at: one.offset(0.1 * at.size, tolerance=10 * at.size),
    "part": lambda one, at: one.part(*inside(one.domain, 4)[1:3]),
    "parts": lambda one, at: one.parts(inside(one.domain, 4)),
    "split_by": lambda one, at: one.split_by([at.bezier]),
    "trimmed": lambda one, at: one.trimmed([bar(one.evaluate(middle(one.domain)), at)], one.domain[0]),
    "extended": lambda one, at: [one.extended(0.1 * at.size, end, how) for end in ("start", "end")
                                 for how in ("natural", "arc", "straight")],
    "extended_to": lambda one, at: one.extended_to([bar(tip(one.extended(0.1 * at.size, how="straight")), at)],
                                                   how="straight"),
    "rounded": lambda one, at: one.rounded(1e-3 * at.size),
    "chamfered": lambda one, at: one.chamfered(1e-3 * at.size),
    "patch_intersections": lambda one, at: one.patch_intersections(at.patch),
    "plane_intersections": lambda one, at: one.plane_intersections(xyz(at, 0.3), (1, 2, 3)),
    "nearest": lambda one, at: one.nearest(at.size * random_rows(3)),
    "stationary_points": lambda one, at: one.stationary_points(xyz(at, 1, 2)),
    "nearest_all": lambda one, at: one.nearest_all(xyz(at, 1, 2), 0.1 * at.size),
    "rebuild": lambda one, at: [one.rebuild(12), one.rebuild(9, 4, ends="tangents"),
                                one.rebuild(40, tolerance=0.1 * at.size)],
    "fair": lambda one, at: one.fair(0.1 * at.size),
    "torsion": lambda one, at: one.torsion(inside(one.domain)),
    "inflections": lambda one, at: one.inflections((0, 1, 2)),
    "extrema": lambda one, at: one.extrema((0, 1, 2)),
    "bounding_box": lambda one, at: one.bounding_box(),
    "signed_area": lambda one, at: closed(one, at).signed_area(tolerance=1e-3),
    "winding_number": lambda one, at: closed(one, at).winding_number(xyz(at, 0.1, 0.2)),
    "frenet_frame": lambda one, at: one.frenet_frame(inside(one.domain)),
    "frames": lambda one, at: [one.frames(inside(one.domain)), one.frames(one.domain[0], start=(1, 2, 3)),
                               one.frames(one.domain[0], "frenet")],
}
DRAGGED = {
    "dragged": lambda one, at: [one.dragged(middle(one.domain), xyz(at, 0.5)),
                                one.dragged(middle(one.domain), xyz(at, 0.5), (0, 0), locality=2)],
}
COPIES = {"__copy__": lambda one, at: copy.copy(one), "__deepcopy__": lambda one, at: copy.deepcopy(one)}
EQUAL = COPIES | {"__eq__": lambda one, at: one == pickle.loads(pickle.dumps(one)),
                  "__hash__": lambda one, at: hash(one)}
VALUE = EQUAL | {"dumps": lambda one, at: sc.loads(one.dumps()) == one}
RATIONAL = {
    "with_points": lambda one, at: one.with_points(one.points),
    "with_weights": lambda one, at: one.with_weights(one.weights),
    "elevate": lambda one, at: one.elevate(),
    "reduce": lambda one, at: one.reduce(),
    "finite_arcs": lambda one, at: one.finite_arcs(at.size),
    "moebius": lambda one, at: one.moebius(0.7),
    "multiplied": lambda one, at: one.multiplied(0.7, 2.0),
    "standard_form": lambda one, at: one.standard_form(),
}
NURBS_CURVE = {
    "__init__": lambda one, at: sc.NurbsCurve(one.degree, one.knots, one.points, one.weights, one.periodic),
    "from_homogeneous": lambda one, at: sc.NurbsCurve.from_homogeneous(
        one.degree, one.knots, one.homogeneous_points, one.periodic),
    "insert_knot": lambda one, at: one.insert_knot(middle(one.domain)),
    "refine": lambda one, at: one.refine(inside(one.domain, 6)[1:-1]),
    "unrolled": lambda one, at: one.unrolled(),
    "remove_knot": lambda one, at: one.remove_knot(inner_knot(one.knots, one.domain)),
    "remove_knots": lambda one, at: one.remove_knots(1e-3 * at.size),
    "bezier_points": lambda one, at: one.bezier_points(),
    "with_domain": lambda one, at: one.with_domain((2, 5)),
    "clamped": lambda one, at: one.clamped(),
    "unclamped": lambda one, at: one.unclamped(),
    "to_periodic": lambda one, at: one.to_periodic(10 * at.size),
    "largest_distance": lambda one, at: one.largest_distance(one.reversed() if one.periodic else one.elevate()),
    "continuity": lambda one, at: one.continuity(inner_knot(one.knots, one.domain)),
    "joints": lambda one, at: one.joints(),
}
BEZIER_CURVE = {
    "__init__": lambda one, at: sc.BezierCurve(one.points, one.weights),
    "from_homogeneous": lambda one, at: sc.BezierCurve.from_homogeneous(one.homogeneous_points),
    "flatten": lambda one, at: one.flatten(1e-3 * at.size),
    "casteljau_triangle": lambda one, at: one.casteljau_triangle(0.3),
    "rational_casteljau_triangle": lambda one, at: one.rational_casteljau_triangle(0.3),
}
HERMITE_CURVE = {"__init__": lambda one, at: sc.HermiteCurve(one.points, one.tangents, one.parameters)}
POWER_CURVE = {
    "__init__": lambda one, at: sc.PowerCurve(one.coefficients, one.origin, one.domain),
    "from_homogeneous": lambda one, at: sc.PowerCurve.from_homogeneous(
        one.homogeneous_coefficients, one.origin, one.domain),
    "derivative": lambda one, at: one.derivative(),
    "with_origin": lambda one, at: one.with_origin(0.5),
    "with_domain": lambda one, at: one.with_domain((0.25, 0.75)),
}


def places_of(patch, count=3):
    return [inside(domain, count) for domain in patch.domain]


def pairs_of(patch):
    u, v = places_of(patch, 4)
    return u, v[::-1]


PATCH = MOVED | RAYS | {
    "least_distance": lambda one, at: one.least_distance(at.bezier, 0.1 * at.size),
    "evaluate": lambda one, at: [one.evaluate(*pairs_of(one)), one.evaluate(*pairs_of(one), side=("left", "right"))],
    "evaluate_grid": lambda one, at: one.evaluate_grid(*places_of(one)),
    "evaluate_grid_with_normals": lambda one, at: one.evaluate_grid_with_normals(*places_of(one)),
    "first_derivatives": lambda one, at: one.first_derivatives(*places_of(one)),
    "derivatives": lambda one, at: one.derivatives(*pairs_of(one), at.order),
    "split": lambda one, at: [one.split(axis, middle(domain)) for axis, domain in zip("uv", one.domain)],
    "reversed": lambda one, at: [one.reversed(axis) for axis in "uv"],
    "swapped": lambda one, at: one.swapped(),
    "to_bezier": lambda one, at: one.to_bezier(),
    "to_hermite": lambda one, at: one.to_hermite(),
    "to_nurbs": lambda one, at: one.to_nurbs(),
    "fundamental_forms": lambda one, at: one.fundamental_forms(*pairs_of(one)),
    "curvatures": lambda one, at: one.curvatures(*pairs_of(one)),
    "sections": lambda one, at: one.sections(at.patch.transformed(matrix(0.1 * at.size))),
    "plane_sections": lambda one, at: one.plane_sections(xyz(at, 0.3), (1, 2, 3)),
    "nearest": lambda one, at: one.nearest(at.size * random_rows(3)),
    "stationary_points": lambda one, at: one.stationary_points(xyz(at, 1, 2)),
    "nearest_all": lambda one, at: one.nearest_all(xyz(at, 1, 2), 0.1 * at.size),
    "rebuild": lambda one, at: one.rebuild((8, 7), (3, 2)),
    "flux": lambda one, at: one.flux(lambda points: points, tolerance=1e-1),
    "surface_centroid": lambda one, at: one.surface_centroid(tolerance=1e-1),
    "fair": lambda one, at: [one.fair(0.1 * at.size), one.fair(0.1 * at.size, ends=("tangents", "points"))],
    "area": lambda one, at: one.area(tolerance=1e-2),
    "bounding_box": lambda one, at: one.bounding_box(tolerance=1e-6),
    "isocurve": lambda one, at: [one.isocurve(axis, middle(domain)) for axis, domain in zip("uv", one.domain)],
    "boundary": lambda one, at: [one.boundary(side) for side in SIDES],
    "continuity_to": lambda one, at: one.continuity_to("v_end", one, "v_start"),
    "join": lambda one, at: one.join("u_end", at.patch.translated(xyz(at, 3)), "u_start", "C0"),
    "dragged": lambda one, at: one.dragged(*map(middle, one.domain), xyz(at, 0.5)),
}
RATIONAL_PATCH = {
    "with_points": lambda one, at: one.with_points(one.points),
    "with_weights": lambda one, at: one.with_weights(one.weights),
    "elevate": lambda one, at: [one.elevate(axis) for axis in "uv"],
    "reduce": lambda one, at: [one.reduce(axis) for axis in "uv"],
}
NURBS_PATCH = {
    "__init__": lambda one, at: sc.NurbsPatch(one.degree, one.knots, one.points, one.weights, one.periodic),
    "from_homogeneous": lambda one, at: sc.NurbsPatch.from_homogeneous(
        one.degree, one.knots, one.homogeneous_points, one.periodic),
    "insert_knot": lambda one, at: [one.insert_knot(axis, middle(domain)) for axis, domain in zip("uv", one.domain)],
    "refine": lambda one, at: [one.refine(axis, inside(domain, 5)[1:-1]) for axis, domain in zip("uv", one.domain)],
    "unrolled": lambda one, at: one.unrolled(),
    "remove_knot": lambda one, at: [one.remove_knot(axis, inner_knot(one.knots[k], one.domain[k]))
                                    for k, axis in enumerate("uv")],
    "remove_knots": lambda one, at: [one.remove_knots(axis, 1e-3 * at.size) for axis in "uv"],
    "with_domain": lambda one, at: [one.with_domain(axis, (2, 5)) for axis in "uv"],
    "clamped": lambda one, at: [one.clamped(axis) for axis in "uv"],
    "unclamped": lambda one, at: [one.unclamped(axis) for axis in "uv"],
    "to_periodic": lambda one, at: [one.to_periodic(axis, 100 * at.size) for axis in "uv"],
    "moebius": lambda one, at: [one.moebius(axis, 0.7) for axis in "uv"],
    "largest_distance": lambda one, at: one.largest_distance(one.elevate("v")),
}
BEZIER_PATCH = {"__init__": lambda one, at: sc.BezierPatch(one.points, one.weights)}
HERMITE_PATCH = {
    "__init__": lambda one, at: sc.HermitePatch(one.points, one.tangents_u, one.tangents_v, one.twists, one.parameters)}


def solid(one, at):
    """The set, or where it encloses nothing a patch and one beside it with the same sides, which do where the degree is
    more than 1."""
    if abs(one.volume(tolerance=1e-1)) / at.size / at.size > 1e-3 * at.size:
        return one
    points = np.array(at.patch.points)
    points[1, 1] += at.size
    return sc.PatchSet.from_patches([at.patch, sc.BezierPatch(points, at.patch.weights).swapped()])


PATCH_SET = MOVED | RAYS | {
    "least_distance": lambda one, at: one.least_distance(at.bezier, 0.1 * at.size),
    "oriented": lambda one, at: one.oriented(),
    "join": lambda one, at: [one.join(at.patch), one.join(one, merge=False)],
    "__init__": lambda one, at: sc.PatchSet(one.points, one.patches, one.weights),
    "from_patches": lambda one, at: sc.PatchSet.from_patches([one[0]]),
    "with_points": lambda one, at: one.with_points(one.points, one.weights),
    "flipped": lambda one, at: one.flipped(),
    "evaluate_grid": lambda one, at: sc.PatchSet.from_patches([one[0]]).evaluate_grid(*places_of(one[0])),
    "evaluate_grid_with_normals":
        lambda one, at: sc.PatchSet.from_patches([one[0]]).evaluate_grid_with_normals(*places_of(one[0])),
    "edge_counts": lambda one, at: one.edge_counts(),
    "seams": lambda one, at: one.seams(),
    "dragged": lambda one, at: one.dragged(0, *map(middle, one[0].domain), xyz(at, 0.5)),
    "__len__": lambda one, at: len(one),
    "__getitem__": lambda one, at: one[0],
    "area": lambda one, at: one.area(tolerance=1e-2),
    "bounding_box": lambda one, at: one.bounding_box(tolerance=1e-6),
    "volume": lambda one, at: one.volume(tolerance=1e-1),
    "flux": lambda one, at: one.flux(lambda points: points, tolerance=1e-1),
    "surface_centroid": lambda one, at: one.surface_centroid(tolerance=1e-1),
    "centroid": lambda one, at: solid(one, at).centroid(tolerance=1e-1),
    "second_moments": lambda one, at: solid(one, at).second_moments(tolerance=1e-1),
}
TESSELLATION = {
    "__init__": lambda one, at: sc.Tessellation(at.patch_set, 2),
    "adaptive": lambda one, at: [sc.Tessellation.adaptive(at.patch_set, tolerance=0.1 * at.size),
                                 sc.Tessellation.adaptive(at.patch_set, angle=1.0)],
    "fits": lambda one, at: one.fits(at.patch_set),
    "evaluate": lambda one, at: one.evaluate(at.patch_set) if at.fits_single else None,
    "evaluate_positions": lambda one, at: one.evaluate_positions(at.patch_set) if at.fits_single else None,
    "sharp_edges": lambda one, at: one.sharp_edges(np.tile((0.0, 0.0, 1.0), (len(one.corner_vertices), 1)), 0.5),
}
FORMULA = {
    "__init__": lambda one, at: sc.Formula(one.text, one.variables, one.constants),
    "evaluate": lambda one, at: one.evaluate(np.linspace(0, 1, 5)),
    "derivatives": lambda one, at: one.derivatives(0.5, at.order),
    "gradient": lambda one, at: one.gradient(0.5),
    "polynomial": lambda one, at: one.polynomial(),
}
REGION = MOVED | {
    "of": lambda one, at: sc.Region.of(one.outlines, one.normal, rule="nonzero"),
    "union": lambda one, at: one.union(disk(at, 0.5)),
    "intersection": lambda one, at: one.intersection(disk(at, 0.5)),
    "difference": lambda one, at: one.difference(disk(at, 0.5)),
    "symmetric_difference": lambda one, at: one.symmetric_difference(disk(at, 0.5)),
    "offset": lambda one, at: [one.offset(0.1 * at.size), one.offset(-0.1 * at.size, corner="sharp")],
    "contains": lambda one, at: one.contains(at.points),
    "area": lambda one, at: one.area(),
    "centroid": lambda one, at: one.centroid(),
    "second_moments": lambda one, at: one.second_moments(),
}
KNOT_VECTOR = {
    "__init__": lambda one, at: basis.KnotVector(one.degree, one.knots, one.periodic),
    "span": lambda one, at: one.span(inside(one.domain)),
    "functions": lambda one, at: one.functions(inside(one.domain)),
    "function": lambda one, at: one.function(one.count // 2, inside(one.domain)),
    "function_derivatives": lambda one, at: one.function_derivatives(one.count // 2, inside(one.domain), at.order),
    "triangle": lambda one, at: one.triangle(middle(one.domain)),
    "support": lambda one, at: one.support(one.count - 1),
    "multiplicity": lambda one, at: one.multiplicity(one.domain[0]),
}
SAMPLES = {
    "__init__": lambda one, at: basis.Samples(at.knots, inside(at.knots.domain), 1),
    "__len__": lambda one, at: len(one),
    "weights": lambda one, at: [one.weights(), one.weights(1)],
    "apply": lambda one, at: [one.apply(np.ones((at.knots.count, 2))), one.apply(np.ones(at.knots.count), 1)],
}
CONIC = {
    "__init__": lambda one, at: conics.ImplicitConic(one.coefficients, one.origin, one.x_axis, one.y_axis),
    "arc": lambda one, at: one.arc(0.1, 1.2),
}

PAIR = {"__iter__": lambda one, at: list(one), "__getitem__": lambda one, at: one[1], "__len__": lambda one, at: len(one)}
METHODS = {
    "NurbsCurve": CURVE | DRAGGED | RATIONAL | NURBS_CURVE | VALUE,
    "BezierCurve": CURVE | DRAGGED | RATIONAL | BEZIER_CURVE | VALUE,
    "HermiteCurve": CURVE | DRAGGED | HERMITE_CURVE | VALUE,
    "PowerCurve": CURVE | POWER_CURVE | VALUE,
    "NurbsPatch": PATCH | RATIONAL_PATCH | NURBS_PATCH | VALUE,
    "BezierPatch": PATCH | RATIONAL_PATCH | BEZIER_PATCH | VALUE,
    "HermitePatch": PATCH | HERMITE_PATCH | VALUE,
    "PatchSet": PATCH_SET | VALUE,
    "Tessellation": TESSELLATION | COPIES,
    "Region": REGION | VALUE,
    "Formula": FORMULA | EQUAL,
    "KnotVector": KNOT_VECTOR | EQUAL,
    "Samples": SAMPLES | COPIES,
    "ImplicitConic": CONIC | EQUAL,
    "Approximation": COPIES | PAIR,
    "Continuity": COPIES,
    "SeamContinuity": COPIES,
    "Curvatures": COPIES,
    "JoinedPatches": COPIES,
    "Filling": COPIES,
    "LoftSurface": COPIES | PAIR,
    "NetworkSurface": COPIES | PAIR,
    "RoundedEdge": COPIES,
    "SubdivisionPatches": COPIES,
    "Nearest": COPIES,
    "NearestAmong": COPIES,
    "Intersections": COPIES,
    "PatchIntersections": COPIES,
    "RayHits": COPIES,
    "LeastDistance": COPIES,
    "Sections": COPIES,
    "StationaryPoints": COPIES,
}


def random_weights(*shape, weight=1.0, seed=2):
    return weight * np.random.default_rng(seed).uniform(0.5, 2, shape)


def inner_knots(degree, count, spacing=1.0):
    """Clamped knots of `count` points."""
    return np.r_[[0.0] * degree, np.arange(count - degree + 1) * spacing, [spacing * (count - degree)] * degree]


def surroundings(degree, size=1.0, weight=1.0, spacing=1.0):
    """What the functions of modules take: shapes of a degree whose points are about `size` large."""
    points = size * random_rows(degree + 1)
    weights = random_weights(degree + 1, weight=weight)
    nurbs = sc.NurbsCurve(degree, inner_knots(degree, degree + 3, spacing), size * random_rows(degree + 3),
                          random_weights(degree + 3, weight=weight))
    patch = sc.BezierPatch(size * random_rows(degree + 1, 3), random_weights(degree + 1, 3, weight=weight))
    return types.SimpleNamespace(degree=degree, size=size, weight=weight, spacing=spacing, order=2, points=points,
                           fits_single=1e-30 < size < 1e30, bezier=sc.BezierCurve(points, weights), nurbs=nurbs,
                           patch=patch, patch_set=sc.PatchSet.from_patches([patch, patch.swapped()]),
                           knots=nurbs.knot_vector)


def curves(at):
    d, size, spacing = at.degree, at.size, at.spacing
    plain = sc.BezierCurve(at.points)
    yield from (lambda: plain, lambda: at.bezier, lambda: at.nurbs)
    yield lambda: sc.NurbsCurve(d, inner_knots(d, d + 3, spacing), size * random_rows(d + 3))
    yield lambda: sc.NurbsCurve(d, spacing * np.arange(d + 4), size * random_rows(d + 3),
                                random_weights(d + 3, weight=at.weight), periodic=True)
    yield lambda: sc.HermiteCurve(at.points, size / spacing * random_rows(d + 1, seed=3), spacing * np.arange(d + 1))
    rows = at.points / np.array([math.factorial(min(k, 20)) for k in range(d + 1)], dtype=float)[:, None]
    yield lambda: sc.PowerCurve(rows)
    yield lambda: sc.PowerCurve.from_homogeneous(at.weight * np.c_[rows, np.r_[1.0, rows[1:, 0] / (4 * size)]])


def patches(at):
    d, size, spacing = at.degree, at.size, at.spacing
    yield from (lambda: sc.BezierPatch(size * random_rows(d + 1, 3)), lambda: at.patch)
    yield lambda: sc.NurbsPatch((1, d), (inner_knots(1, 3, spacing), inner_knots(d, d + 3, spacing)),
                                size * random_rows(3, d + 3), random_weights(3, d + 3, weight=at.weight))
    yield lambda: sc.NurbsPatch((d, 2), (spacing * np.arange(d + 3), inner_knots(2, 4, spacing)),
                                size * random_rows(d + 2, 4), periodic=(True, False))
    yield lambda: sc.HermitePatch(size * random_rows(d + 1, 2), size * random_rows(d + 1, 2, seed=3),
                                  size * random_rows(d + 1, 2, seed=4))
    yield lambda: at.patch_set


def disk(at, x):
    return sc.Region.of([conics.circle(xyz(at, x), at.size)])


def others(at):
    yield lambda: disk(at, 0)
    yield lambda: sc.Tessellation(at.patch_set, 2)
    yield lambda: sc.Formula(f"a*t^{at.degree} + sin(t)", constants={"a": at.size})
    yield lambda: at.knots
    yield lambda: basis.KnotVector(at.degree, at.spacing * np.arange(at.degree + 4), periodic=True)
    yield lambda: basis.Samples(at.knots, inside(at.knots.domain), 1)
    yield lambda: conics.by_foci(xyz(at, 0), xyz(at, 1), 2 * at.size)
    yield lambda: conics.by_foci(xyz(at, 0), xyz(at, 2), at.size)
    yield lambda: sc.BezierPatch(at.size * random_rows(3, 3)).reduce("u")
    yield lambda: at.nurbs.continuity(inner_knot(at.nurbs.knots, at.nurbs.domain))
    flat = at.size * np.array([[(i, j, 0.0) for j in range(3)] for i in range(3)], dtype=float)
    yield lambda: sc.BezierPatch(flat).continuity_to("u_end", sc.BezierPatch(flat + xyz(at, 2)), "u_start")
    yield lambda: sc.BezierPatch(flat).curvatures(0.5, 0.5)
    yield lambda: sc.BezierPatch(flat).nearest((0, 0, 0))
    yield lambda: at.nurbs.stationary_points(xyz(at, 1, 2))
    line = sc.BezierCurve([xyz(at, 0, 0, -1), xyz(at, 1, 1, 1)])
    yield lambda: line.intersections(line.reversed())
    yield lambda: line.patch_intersections(sc.BezierPatch(flat))
    yield lambda: sc.BezierPatch(flat).least_distance(line)
    yield lambda: sc.nearest([sc.BezierPatch(flat)], (0, 0, 0))
    yield lambda: sc.BezierPatch(flat).rays(xyz(at, 0.3, 0.4, 1), (0, 0, -1), hits="all")
    yield lambda: sc.BezierPatch(flat).plane_sections(xyz(at, 0.3), (1, 2, 3))
    yield lambda: build.join_patches(sc.BezierPatch(flat), "u_end", sc.BezierPatch(flat + xyz(at, 2)), "u_start")
    upright = at.size * np.array([[(2, j, i) for j in range(3)] for i in range(3)], dtype=float)
    yield lambda: build.fillet_patches(sc.BezierPatch(flat), "u_end", sc.BezierPatch(upright), "u_start", 0.1 * at.size)
    edges = [sc.BezierPatch(flat).boundary(side) for side in ("v_start", "v_end", "u_start", "u_end")]
    yield lambda: build.loft(edges[:2])
    yield lambda: build.network(edges[:2], edges[2:])
    yield lambda: build.fill([sc.BezierPatch(flat).boundary(side) for side in ("u_start", "v_end", "u_end", "v_start")])
    yield lambda: build.catmull_clark(flat.reshape(9, 3), [(0, 3, 4, 1), (1, 4, 5, 2), (3, 6, 7, 4), (4, 7, 8, 5)])


def subjects(at):
    """Shapes of every public class, but those that are refused so large or small."""
    for kinds in (curves, patches, others):
        for make in kinds(at):
            try:
                one = make()
            except sc.Error:
                continue
            yield one


SPECIAL = {"__init__", "__len__", "__getitem__", "__iter__", "__eq__", "__hash__", "__copy__", "__deepcopy__"}


def public_methods(kind):
    """Names of what a class defines for its users, without its properties and without what Python fills in."""
    return {name for name, value in vars(kind).items()
            if (name in SPECIAL or not name.startswith("_")) and value is not None
            and not isinstance(value, (property, types.WrapperDescriptorType))}


def properties(kind):
    return [name for name, value in vars(kind).items() if isinstance(value, property) and not name.startswith("_")]


def calls_of(one, at):
    """(name, call) for all that a shape's class offers."""
    name = type(one).__name__
    for key in properties(type(one)):
        yield f"{name}.{key}", lambda key=key: getattr(one, key)
    yield f"repr({name})", lambda: repr(one)
    for key, call in METHODS[name].items():
        yield f"{name}.{key}", lambda call=call: call(one, at)


def all_calls(at):
    for one in subjects(at):
        yield from calls_of(one, at)
    for name, call in FUNCTIONS.items():
        yield name, lambda call=call: call(at)
