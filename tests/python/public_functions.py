"""Every public function of the library, with arguments of any degree and size: public_calls.py has the methods."""

import numpy as np

import splinecore as sc
from splinecore import basis, build, conics, fit


def xyz(at, x, y=0.0, z=0.0):
    return at.size * np.array([x, y, z], dtype=float)


def cross(at):
    """Two lines that cross."""
    return sc.BezierCurve([xyz(at, -1), xyz(at, 1)]), sc.BezierCurve([xyz(at, 0, -1), xyz(at, 0, 1)])


def random_rows(count, *more, seed=1):
    return np.random.default_rng(seed).uniform(-1, 1, (count, *more, 3))


FUNCTIONS = {
    "sc.dumps": lambda at: sc.dumps([at.bezier, at.nurbs]),
    "sc.loads": lambda at: sc.loads(at.bezier.dumps()),
    "sc.nearest": lambda at: [sc.nearest([at.bezier, at.nurbs], at.size * random_rows(3)),
                              sc.nearest([at.patch, at.patch.translated(xyz(at, 1))], at.size * random_rows(3))],
    "sc.seam_continuity": lambda at: sc.seam_continuity(at.patch, "u_end", at.patch, "u_start"),
    "basis.bezier_matrix": lambda at: basis.bezier_matrix(at.degree),
    "basis.uniform_matrix": lambda at: basis.uniform_matrix(at.degree),
    "basis.uniform_to_bezier": lambda at: basis.uniform_to_bezier(at.degree),
    "basis.hermite_matrix": lambda at: basis.hermite_matrix(),
    "build.polynomial_through": lambda at: build.polynomial_through(at.points),
    "build.osculating_polynomial": lambda at: build.osculating_polynomial([at.points[:2], at.points[:1]], [0, 1]),
    "build.lagrange_evaluate": lambda at: build.lagrange_evaluate(at.points, np.linspace(0, 1, 7)),
    "build.catmull_rom": lambda at: [build.catmull_rom(at.points, closed=closed)
                                     for closed in (False, len(at.points) > 2)],
    "build.kochanek_bartels": lambda at: build.kochanek_bartels(at.points, 0.1, 0.2, 0.3),
    "fit.interpolate": lambda at: [fit.interpolate(at.points, degree, 'uniform', closed=closed)
                                   for degree in (1, 2, 3) for closed in (False, True)],
    "fit.interpolate_patch": lambda at: fit.interpolate_patch(np.stack([at.points, at.points[::-1]], 1), (2, 1), 'uniform',
                                                              closed=(True, False)),
    "fit.approximate": lambda at: [fit.approximate(at.points, tolerance=1e-3 * xyz(at, 0, 1).max() + 1e-300, degree=2,
                                                   parameters='uniform', corrections=1),
                                   fit.approximate(at.points, len(at.points), 1, 'uniform')],
    "fit.approximate_patch": lambda at: fit.approximate_patch(np.stack([at.points, at.points[::-1]], 1),
                                                              (len(at.points), 2), 1, 'uniform'),
    "fit.approximate_scattered": lambda at: fit.approximate_scattered(
        at.size * np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0.5], [0.5, 0.5, 0.1]]), 2, 1),
    "fit.project": lambda at: fit.project(lambda u: np.stack([u, u * u], -1), [0, 0, 0, 0.5, 1, 1, 1], 2),
    "build.chain_from_polygon": lambda at: build.chain_from_polygon(at.points),
    "build.polygon_of_chain": lambda at: build.polygon_of_chain(build.chain_from_polygon(at.points)),
    "build.join_beziers": lambda at: build.join_beziers(at.bezier.split(0.25)),
    "build.c2_pair": lambda at: build.c2_pair(xyz(at, 0), xyz(at, 1), xyz(at, 2, 2), xyz(at, 3), xyz(at, 4)),
    "build.curve_from_formulas": lambda at: build.curve_from_formulas(
        [f"a*t^{at.degree}", "a*sin(3*t)"], (0, 1), tolerance=1e-3 * at.size, constants={"a": at.size}),
    "build.patch_from_formulas": lambda at: build.patch_from_formulas(
        [f"a*u^{at.degree}", "a*v", "a*sin(u+v)"], (0, 1), (0, 1), tolerance=1e-2 * at.size, constants={"a": at.size}),
    "build.loft": lambda at: [build.loft([at.bezier, xyz(at, 0, 0, 3)], style=style).value for style in ('normal', 'straight')],
    "build.blend_patches": lambda at: build.blend_patches(
        build.extrude(at.bezier, xyz(at, 0, 0, 1)), "v_end", build.extrude(at.bezier, xyz(at, 0, 0, 1)).transformed(
            np.array([[1, 0, 0, 0], [0, 1, 0, 3 * at.size], [0, 0, 1, 3 * at.size]])), "v_start", "G1"),
    "build.coons": lambda at: [build.coons([sc.BezierCurve([xyz(at, *a), xyz(at, *b)]) for a, b in (
        ((0, 0), (1, 0)), ((1, 0), (1, 1)), ((1, 1), (0, 1)), ((0, 1), (0, 0)))], **across)
        for across in ({}, {"across": [None] * 4})],
    "build.network": lambda at: build.network(
        [sc.BezierCurve([xyz(at, 0, y), xyz(at, 1, y)]) for y in (0, 1)],
        [sc.BezierCurve([xyz(at, x, 0), xyz(at, x, 1)]) for x in (0, 1)]),
    "build.sweep": lambda at: build.sweep(sc.BezierCurve([xyz(at, 0), xyz(at, 1, 1), xyz(at, 2, 0)]), at.bezier, tolerance=1e-2 * at.size),
    "build.sweep_two_rails": lambda at: build.sweep_two_rails(
        sc.BezierCurve([xyz(at, 0), xyz(at, 1, 1), xyz(at, 2, 0)]), sc.BezierCurve([xyz(at, 0, 0, 2), xyz(at, 1, 1, 2), xyz(at, 2, 0, 2)]),
        sc.BezierCurve([xyz(at, 0, 0.1 * (0 < k < at.degree), 2 * k / at.degree) for k in range(at.degree + 1)]),
        tolerance=1e-2 * at.size),
    "build.rail_frames": lambda at: [build.rail_frames(sc.BezierCurve([xyz(at, 0), xyz(at, 1, 1), xyz(at, 2, 0)]), (0, 0.5, 1), frame=frame)
                                     for frame in ("minimal", "upright", "parallel")],
    "build.two_rail_frames": lambda at: build.two_rail_frames(
        sc.BezierCurve([xyz(at, 0), xyz(at, 1, 1), xyz(at, 2, 0)]), sc.BezierCurve([xyz(at, 0, 0, 2), xyz(at, 1, 1, 2), xyz(at, 2, 0, 2)]), 0.5),
    "build.joint_points": lambda at: [build.joint_points(
        [[*xyz(at, 0), 1], [*xyz(at, 1, 1), 2], [*xyz(at, 2, 0), 1]], at.degree + 1, (1, 2),
        [[*xyz(at, 0), 1], [*xyz(at, -1, 1), 1], [*xyz(at, -2, 3), 2]], 2, (1, 1), word, "both") for word in ("C0", "G1", "C1", "G2", "C2")],
    "build.joint_equations": lambda at: build.joint_equations(
        [[[*xyz(at, 0), 1]], [[*xyz(at, 1), 1]], [[*xyz(at, 2), 1]]], at.degree + 1, (1, 2),
        [[[*xyz(at, 0), 1]], [[*xyz(at, -1), 1]], [[*xyz(at, -2), 1]]], at.degree + 1, (1, 2), "C2"),
    "build.least_motion": lambda at: build.least_motion(
        [([[0, 1, 2]], [[[1, -2, 1]]])], [xyz(at, 0), xyz(at, 1), xyz(at, 0)], [True, False, True]),
    "build.pipe": lambda at: build.pipe(sc.BezierCurve([xyz(at, 0), xyz(at, 1, 1), xyz(at, 2, 0)]), 0.1 * at.size, caps="round",
                                        tolerance=1e-2 * at.size),
    "build.offset_patch": lambda at: build.offset_patch(build.sphere(xyz(at, 1), at.size), at.size),
    "build.thicken": lambda at: build.thicken(build.cylinder(xyz(at, 1), (0, 0, 1), at.size, at.size), 0, 0.5 * at.size),
    "build.extend_patch": lambda at: [build.extend_patch(build.extrude(at.bezier, xyz(at, 0, 0, 1)), "v_end", at.size, how)
                                      for how in ("natural", "straight")],
    "build.match_patch": lambda at: build.match_patch(
        build.extrude(at.bezier, xyz(at, 0, 0, 1)), "v_end", build.extrude(at.bezier, xyz(at, 0, 1, 1)), "v_start", "G1"),
    "build.fillet_patches": lambda at: build.fillet_patches(
        build.plane(xyz(at, 0), xyz(at, 1), xyz(at, 0, 1)), "u_end", build.plane(xyz(at, 1), xyz(at, 0, 1), xyz(at, 0, 0, 1)), "v_start",
        0.1 * at.size),
    "build.fillet_chain": lambda at: build.fillet_chain([
        (build.plane(xyz(at, 0, y), xyz(at, 1), xyz(at, 0, 1)), "u_end", build.plane(xyz(at, 1, y), xyz(at, 0, 1), xyz(at, 0, 0, 1)), "v_start")
        for y in (0, 1)], 0.1 * at.size),
    "build.fill": lambda at: build.fill([sc.BezierCurve([xyz(at, *a), xyz(at, *b)]) for a, b in (
        ((0, 0), (1, 0)), ((1, 0), (1, 1, 1)), ((1, 1, 1), (0, 0)))]),
    "build.corner_counts": lambda at: build.corner_counts([at.bezier, at.bezier.reversed()]),
    "build.fill_rim": lambda at: build.fill_rim([sc.BezierCurve([xyz(at, *a), xyz(at, *b)]) for a, b in (
        ((0, 0), (1, 0)), ((1, 0), (1, 1)), ((1, 1), (0, 0)))]),
    "build.open_ends": lambda at: build.open_ends([build.cylinder(xyz(at, 1), (0, 0, 1), at.size, at.size)]),
    "build.cap": lambda at: build.cap([build.cylinder(xyz(at, 1), (0, 0, 1), at.size, at.size)]),
    "build.catmull_clark": lambda at: build.catmull_clark(
        [xyz(at, *p) for p in ((0, 0), (1, 0), (1, 1), (0, 1), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))],
        [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (2, 3, 7, 6), (0, 4, 7, 3), (1, 2, 6, 5)]),
    "build.plane": lambda at: build.plane(xyz(at, 1), xyz(at, 1), xyz(at, 0, 1)),
    "build.cylinder": lambda at: build.cylinder(xyz(at, 1), (0, 0, 1), at.size, at.size),
    "build.cone": lambda at: build.cone(xyz(at, 1), (0, 0, 1), at.size, at.size),
    "build.disc": lambda at: build.disc(xyz(at, 1), (0, 0, 1), at.size),
    "build.sphere": lambda at: build.sphere(xyz(at, 1), at.size),
    "build.torus": lambda at: build.torus(xyz(at, 1), (0, 0, 1), 2 * at.size, at.size),
    "build.revolve": lambda at: build.revolve(at.nurbs, xyz(at, 9), (0, 1, 0)),
    "build.extrude": lambda at: build.extrude(at.bezier, xyz(at, 0, 0, 1)),
    "build.ruled": lambda at: build.ruled(at.bezier, at.nurbs),
    "build.join_patches": lambda at: [build.join_patches(at.patch, "u_end", at.patch, "u_start", word)
                                      for word in ("C0", "G1", "C2")],
    "conics.arc_about": lambda at: conics.arc_about(xyz(at, 0), xyz(at, 1), xyz(at, 0, 1)),
    "conics.arc_from_tangent": lambda at: conics.arc_from_tangent(xyz(at, 0), (1, 0, 0), xyz(at, 1, 1)),
    "conics.arc_through": lambda at: conics.arc_through(xyz(at, 0), xyz(at, 1), xyz(at, 1, 1)),
    "build.blend": lambda at: build.blend(at.bezier, sc.BezierCurve([xyz(at, 5), xyz(at, 6, 1)])),
    "build.fillets": lambda at: build.fillets(*cross(at), 0.25 * at.size),
    "build.chamfered": lambda at: build.chamfered(*cross(at), (0.25 * at.size, 0.5 * at.size), (0.9, 0.9)),
    "build.contour": lambda at: build.contour([xyz(at, 0), xyz(at, 1), xyz(at, 1, 1)], [0, 0.5, -0.2], True),
    "build.curve_on_patch": lambda at: build.curve_on_patch(
        build.sphere(xyz(at, 1), at.size), sc.BezierCurve([(0.5, 0.5), (2, 1), (3, 1.5)]), 0.1 * at.size),
    "build.filleted": lambda at: build.filleted(*cross(at), 0.25 * at.size, (0.9, 0.9)),
    "build.helix": lambda at: build.helix(cross(at)[0], 0.1 * at.size, 2),
    "build.join_curves": lambda at: build.join_curves(at.bezier.split(0.25), 1e-6 * at.size),
    "build.touching_circle": lambda at: build.touching_circle(
        *cross(at), sc.BezierCurve([xyz(at, -1, 0.5), xyz(at, 1, 0.5)]), (0.6, 0.6, 0.6)),
    "conics.arc": lambda at: conics.arc(xyz(at, 1), xyz(at, 1), xyz(at, 0, 1), 0.1, 2.0),
    "conics.as_hermite": lambda at: conics.as_hermite(conics.circle(xyz(at, 1), at.size), 1e-3 * at.size),
    "conics.by_foci": lambda at: conics.by_foci(xyz(at, 0), xyz(at, 1), 2 * at.size),
    "conics.circle": lambda at: [conics.circle(xyz(at, 1), at.size, form=form)
                                 for form in ("square", "triangle", "halves", "single")],
    "conics.class_of": lambda at: conics.class_of(conics.conic_arc(xyz(at, 0), xyz(at, 1), xyz(at, 1, 1), 2.0)),
    "conics.conic_arc": lambda at: conics.conic_arc(xyz(at, 0), xyz(at, 1), xyz(at, 1, 1), -0.3),
    "conics.ellipse": lambda at: conics.ellipse(xyz(at, 1), xyz(at, 2), xyz(at, 0, 1)),
    "conics.from_implicit": lambda at: conics.from_implicit(conics.by_foci(xyz(at, 0), xyz(at, 1), 2 * at.size)),
    "conics.hyperbola": lambda at: conics.hyperbola(xyz(at, 1), xyz(at, 2), xyz(at, 0, 1)),
    "conics.implicit": lambda at: conics.implicit(conics.conic_arc(xyz(at, 0), xyz(at, 1), xyz(at, 1, 1), 2.0)),
    "conics.parabola": lambda at: conics.parabola(xyz(at, 0, 1), xyz(at, 0), (1, 0, 0)),
    "conics.through_points": lambda at: conics.through_points(
        at.size * np.array([(1, 0), (0, 2), (-1, 0), (0, -2), (0.6, 1.6)])),
}
