"""Surfaces that touch along curves, or are one in a part: closed forms, polynomial graphs, every scale, and near misses."""

from math import comb

import numpy as np
import pytest
from numpy.polynomial import polynomial

import splinecore as sc
from splinecore import build
from test_sections import CYLINDER, SPHERE, TORUS, check, lengths

SCALES = [1e-150, 1e-6, 1.0, 1e6, 1e150]


def bernstein(degree, t):
    return np.stack([comb(degree, i) * t**i * (1 - t)**(degree - i) for i in range(degree + 1)], -1)


def graph(coefficients):
    """The Bezier patch (x, y, z(x, y)) over [-1, 1]² of a polynomial, coefficients of x^i y^j."""
    degree = np.array(coefficients.shape) - 1
    nodes = [np.cos(np.pi * (np.arange(n + 1) + 0.5) / (n + 1)) for n in degree]
    of_x, of_y = (bernstein(n, (at + 1) / 2) for n, at in zip(degree, nodes))
    heights = np.linalg.solve(of_x, polynomial.polygrid2d(*nodes, coefficients)) @ np.linalg.inv(of_y).T
    x, y = np.meshgrid(*(np.linspace(-1, 1, n + 1) for n in degree), indexing="ij")
    return sc.BezierPatch(np.stack([x, y, heights], -1))


def product(a, b):
    out = np.zeros(np.array(a.shape) + b.shape - 1)
    for i, j in np.ndindex(a.shape):
        out[i:i + b.shape[0], j:j + b.shape[1]] += a[i, j] * b
    return out


def plus(a, b):
    out = np.zeros(np.maximum(a.shape, b.shape))
    out[:a.shape[0], :a.shape[1]] += a
    out[:b.shape[0], :b.shape[1]] += b
    return out


BASE = np.array([[0.1, 0.3, -0.2], [-0.2, 0.4, 0.1], [0.3, -0.1, 0.2]])
LINE = np.array([[0.1, 0.7], [1.0, 0.0]])
PARABOLA = np.array([[-0.3, 1.0], [0.2, 0.0], [0.8, 0.0]])
CIRCLE = np.array([[-0.36, 0.0, 1.0], [0.0, 0.0, 0.0], [1.0, 0.0, 0.0]])
CROSS = np.array([[0.0, 0.0], [0.0, 1.0]])


def test_a_torus_on_a_plane():
    turn = np.array([[1, 0, 0], [0, 0.8, -0.6], [0, 0.6, 0.8]])
    for matrix in (np.eye(3), turn):
        patch = TORUS.transformed(np.c_[matrix, (7, 8, 9)])
        normal = matrix @ (0, 0, 1)
        for tolerance in (1e-3, 1e-6, 1e-9):
            origin = matrix @ (0, 0, 1) + (7, 8, 9)
            found = patch.plane_sections(origin, normal, tolerance)
            check(patch, (origin, normal), found, tolerance)
            assert lengths(found) == pytest.approx([6 * np.pi], abs=10 * tolerance)
            assert found.kinds == ("touching",) and found.closed.all() and not found.are_one


def test_a_sphere_in_a_cylinder_and_cylinders_side_by_side():
    found = SPHERE.sections(CYLINDER)
    check(SPHERE, CYLINDER, found, 1e-5)
    assert lengths(found) == pytest.approx([2 * np.pi], abs=1e-5) and found.kinds == ("touching",)
    for other, inside in ((build.cylinder((2, 0, -2), (0, 0, 1), 1, 3), False), (build.cylinder((-1, 0, -2), (0, 0, 1), 2, 3), True)):
        found = CYLINDER.sections(other)
        check(CYLINDER, other, found, 1e-5)
        assert lengths(found) == pytest.approx([3], abs=1e-6) and found.kinds == ("touching",), inside
    found = CYLINDER.plane_sections((1, 0, 0), (1, 0, 0))
    assert lengths(found) == pytest.approx([6]) and found.kinds == ("touching",)


def test_a_pipe_within_a_torus():
    pipe = build.torus((0, 0, 0), (0, 0, 1), 3.5, 0.5)
    found = TORUS.sections(pipe)
    check(TORUS, pipe, found, 1e-5)
    assert lengths(found) == pytest.approx([8 * np.pi], abs=1e-4) and found.kinds == ("touching",)


@pytest.mark.parametrize("scale", SCALES)
@pytest.mark.parametrize("curve, length", [(LINE, None), (PARABOLA, None), (CIRCLE, 2 * np.pi * 0.6)])
@pytest.mark.parametrize("factor", [0.3, -1.0, 5.0])
def test_graphs_that_touch_along_a_plane_curve(curve, length, factor, scale):
    a, b = graph(BASE), graph(plus(BASE, factor * product(curve, curve)))
    a, b = (patch.with_points(scale * patch.points) for patch in (a, b))
    found = a.sections(b, 1e-6 * scale)
    assert found.kinds == ("touching",) and not found.are_one and not len(found.points)
    check(a, b, found, 1e-6 * scale)
    points = found.curves[0].evaluate(np.linspace(*found.curves[0].domain, 500)) / scale
    assert np.abs(polynomial.polyval2d(points[:, 0], points[:, 1], curve)).max() < 1e-4
    assert found.closed[0] == (length is not None)
    flat = np.linalg.norm(np.diff(points[:, :2], axis=0), axis=1).sum()
    if length:
        assert flat == pytest.approx(length, rel=1e-4)
    else:
        ends = np.abs(points[[0, -1], :2]).max(axis=1)
        assert ends == pytest.approx(1, abs=1e-4)


def test_graphs_that_touch_rationally_and_far_from_the_origin():
    view = np.array([[1, 0, 0, 0.2], [0, 1, 0, 0.1], [0, 0, 1, 0.3], [0.1, 0.2, 0.15, 1.2]])
    for matrix in (view, np.c_[np.eye(3), (1e6, -2e6, 3e5)]):
        a, b = (graph(z).transformed(matrix) for z in (BASE, plus(BASE, product(PARABOLA, PARABOLA))))
        found = a.sections(b, 1e-6)
        assert found.kinds == ("touching",)
        check(a, b, found, 2e-6)


def test_on_many_spans():
    a, b = (graph(z).to_nurbs().refine("u", [0.2, 0.5, 0.8]).refine("v", [0.4, 0.7, 0.7])
            for z in (BASE, plus(BASE, product(CIRCLE, CIRCLE))))
    found = a.sections(b, 1e-6)
    assert found.kinds == ("touching",) and found.closed.all()
    check(a, b, found, 1e-6)
    assert len(found.curves) == 1


def test_two_curves_of_touch():
    both = product(LINE, np.array([[0.1, 0.7], [1.0, 0.0]]) + [[0.9, 0], [0, 0]])
    a, b = graph(BASE), graph(plus(BASE, product(both, both)))
    found = a.sections(b, 1e-7)
    assert found.kinds == ("touching",) * 2
    check(a, b, found, 1e-7)


@pytest.mark.parametrize("gap", [1e-2, 1e-4, 1e-6])
def test_what_nearly_touches_crosses_twice_or_not_at_all(gap):
    """z + c (g² - e) crosses in the two curves g = √e and g = -√e; above there is nothing."""
    square = product(LINE, LINE)
    crossing = graph(plus(BASE, plus(square, np.array([[-gap]]))))
    found = graph(BASE).sections(crossing, 1e-8)
    assert found.kinds == ("crossing",) * 2 and not len(found.points)
    for curve in found.curves:
        points = curve.evaluate(np.linspace(*curve.domain, 300))
        values = polynomial.polyval2d(points[:, 0], points[:, 1], LINE)
        assert np.abs(values) == pytest.approx(np.sqrt(gap), abs=1e-8 / np.sqrt(gap) + 1e-7)
    above = graph(BASE).sections(graph(plus(BASE, plus(square, np.array([[gap]])))), 1e-8)
    assert not len(above.curves) and not len(above.points) and not above.are_one


def test_planes_that_are_one_in_a_part_have_its_border():
    a, b = build.plane((0, 0, 0), (2, 0, 0), (0, 2, 0)), build.plane((1, 1, 0), (2, 0.5, 0), (-0.3, 2, 0))
    found = a.sections(b)
    check(a, b, found, 1e-5)
    assert found.are_one and set(found.kinds) == {"border"}
    ring, = build.join_curves(found.curves, 1e-5)
    assert np.array_equal(*ring.evaluate(np.array(ring.domain)))
    # Corners of the common part: (1, 1), where sides cross x = 2 and y = 2, and (2, 2).
    assert ring.length() == pytest.approx(np.hypot(1, 0.25) + 0.75 + 1.15 + np.hypot(0.15, 1))
    for corner in ((1, 1, 0), (2, 1.25, 0), (2, 2, 0), (0.85, 2, 0)):
        assert ring.nearest(corner).distances < 1e-5


def test_a_part_of_a_patch_is_one_with_it():
    whole = graph(plus(BASE, product(PARABOLA, PARABOLA))).to_nurbs()
    part = whole.split("u", 0.3)[1].split("v", 0.6)[0]
    for other in (part, part.reversed("u"), part.swapped(), part.elevate("u", 2)):
        found = whole.sections(other)
        check(whole, other, found, 1e-5)
        assert found.are_one and set(found.kinds) == {"border"}
        ring, = build.join_curves(found.curves, 1e-5)
        around = sum(side.length() for side in (part.boundary(name) for name in ("u_start", "u_end", "v_start", "v_end")))
        assert ring.length() == pytest.approx(around, rel=1e-4)


def test_cylinders_that_are_one_in_a_part_have_two_circles():
    found = CYLINDER.sections(build.cylinder((0, 0, -1), (0, 0, 1), 1, 9))
    assert found.are_one and found.kinds == ("border",) * 2 and found.closed.all()
    assert lengths(found) == pytest.approx([2 * np.pi] * 2, abs=1e-5)


def test_a_surface_is_one_with_itself():
    for other in (SPHERE, build.sphere((0, 0, 0), 1, axis=(1, 0, 0))):
        found = SPHERE.sections(other)
        assert found.are_one and not len(found.curves) and not len(found.points)
