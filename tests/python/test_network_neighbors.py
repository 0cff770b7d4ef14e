"""Networks that go on from neighbors: tangent planes along whole borders, curves stay, what cannot be is refused."""

import math

import numpy as np
import pytest

import splinecore as sc
from splinecore import build

BORDERS = ("v_start", "u_end", "v_end", "u_start")


def hills(rng, count=9):
    """A smooth bicubic surface over [-1, 2]²."""
    knots = np.r_[[-1] * 3, np.linspace(-1, 2, count - 2), [2] * 3]
    places = np.array([knots[i + 1:i + 4].mean() for i in range(count)])
    x, y = np.meshgrid(places, places, indexing="ij")
    return sc.NurbsPatch((3, 3), (knots, knots), np.stack([x, y, rng.uniform(-0.4, 0.4, x.shape)], -1))


def cut_out(patch, u, v):
    """The part over intervals of both parameters."""
    for axis, (start, end) in (("u", u), ("v", v)):
        if patch.domain["uv".index(axis)][1] > end:
            patch = patch.split(axis, end)[0]
        if patch.domain["uv".index(axis)][0] < start:
            patch = patch.split(axis, start)[1]
    return patch


def parts_beyond(patch, over=(0, 1)):
    """The surface beyond each border of the unit square, longer than that by what `over` says."""
    return {"v_start": (cut_out(patch, over, (-1, 0)), "v_end", "G1"), "v_end": (cut_out(patch, over, (1, 2)), "v_start", "G1"),
            "u_start": (cut_out(patch, (-1, 0), over), "u_end", "G1"), "u_end": (cut_out(patch, (1, 2), over), "u_start", "G1")}


def isocurves(patch, count_u, count_v):
    """Over the unit square."""
    along_u = [patch.isocurve("v", v).part(0, 1) for v in np.linspace(0, 1, count_u)]
    along_v = [patch.isocurve("u", u).part(0, 1) for u in np.linspace(0, 1, count_v)]
    return along_u, along_v


def normals(patch, u, v):
    jets = patch.derivatives(u, v, 1, side="left")
    found = np.cross(jets[:, 1, 0], jets[:, 0, 1])
    return found / np.linalg.norm(found, axis=1, keepdims=True)


def angle_to(made, border, beyond, count=60):
    """The largest between tangent planes along a border of a patch and those of the nearest points beyond."""
    edge = made.boundary(border)
    at = np.linspace(*edge.domain, count)
    ends = {"v_start": (at, 0 * at + made.domain[1][0]), "v_end": (at, 0 * at + made.domain[1][1]),
            "u_start": (0 * at + made.domain[0][0], at), "u_end": (0 * at + made.domain[0][1], at)}
    own = normals(made, *ends[border])
    place = beyond.nearest(edge.evaluate(at, side="left"))
    assert place.distances.max() <= 1e-4
    other = normals(beyond, *place.parameters.T)
    return np.arcsin(np.clip(np.linalg.norm(np.cross(own, other), axis=1), 0, 1)).max()


def test_the_hole_in_a_smooth_surface_goes_on_from_any_neighbors(inputs):
    rng = np.random.default_rng(1)
    for trial in range(inputs(1000)):
        patch = hills(rng)
        along_u, along_v = isocurves(patch, *rng.integers(2, 6, 2))
        beyond = parts_beyond(patch, (-0.5, 1.5) if trial % 2 else (0, 1))
        chosen = [border for border in BORDERS if rng.random() < 0.6] or ["v_start"]
        made, error = build.network(along_u, along_v, neighbors=[beyond[border] for border in chosen], tolerance=1e-3)
        assert error <= 1e-3
        for border in chosen:
            assert angle_to(made, border, beyond[border][0]) <= 1e-4
        for curve in along_u + along_v:
            points = curve.evaluate(np.linspace(*curve.domain, 21), side="left")
            assert made.nearest(points).distances.max() <= 1e-3


def test_without_neighbors_it_does_not_go_on():
    """Otherwise the test above could not fail."""
    patch = hills(np.random.default_rng(1))
    made = build.network(*isocurves(patch, 3, 3), tolerance=1e-3).value
    assert angle_to(made, "v_start", parts_beyond(patch)["v_start"][0]) > 1e-3


@pytest.mark.parametrize("scale, shift", [(1e-100, 0), (1e100, 0), (1.0, 1e6)])
def test_sizes_and_places(scale, shift):
    patch = hills(np.random.default_rng(2))
    matrix = np.column_stack([scale * np.eye(3), (shift, -shift, shift)])
    far = patch.transformed(matrix)
    made, _ = build.network(*isocurves(far, 3, 4), neighbors=[parts_beyond(far)["v_end"]], tolerance=1e-3 * scale)
    back = made.transformed(np.column_stack([np.eye(3), (-shift, shift, -shift)])).transformed(np.eye(3) / scale)
    assert angle_to(back, "v_end", parts_beyond(patch)["v_end"][0]) <= 1.1e-4


def test_rings_and_ribs_go_on_from_a_tube():
    """Closed curves, rational ones; the tube has the planes of a cylinder."""
    def ring(radius, height):
        return sc.conics.circle((0, 0, height), radius)

    ribs = []
    for angle in np.linspace(0, 2 * math.pi, 7)[:-1]:
        c, s = math.cos(angle), math.sin(angle)
        ribs.append(sc.BezierCurve([(c, s, 0), (c, s, 0.6), (0.7 * c, 0.7 * s, 1.2), (0.5 * c, 0.5 * s, 2)]))
    tube = build.cylinder((0, 0, -1), (0, 0, 1), 1.0, 1.0)
    made, error = build.network([ring(1, 0), ring(0.5, 2)], ribs, neighbors=[(tube, "v_end", "G1")], tolerance=1e-3)
    assert error <= 1e-3
    closed, open_ = ("u", "v") if made.periodic[0] else ("v", "u")
    assert angle_to(made, f"{open_}_start", tube) <= 3e-4


def flat(x0, x1, y0, y1, rise=0.0):
    return sc.BezierPatch([[(x0, y0, 0), (x0, y1, rise * (y1 - y0))], [(x1, y0, 0), (x1, y1, rise * (y1 - y0))]])


def lines(slope=0.0):
    along_u = [sc.BezierCurve([(0, y, slope * y), (1, y, slope * y)]) for y in (0, 1)]
    along_v = [sc.BezierCurve([(x, 0, 0), (x, 1, slope)]) for x in (0, 1)]
    return along_u, along_v


@pytest.mark.parametrize("neighbors, error, words", [
    ([(flat(0, 1, -1, -0.5), "v_end", "G1")], sc.InvalidShape, r"neighbors\[0\] lies along none .* 0.5"),
    ([(flat(0, 1, 1, 0), "v_end", "G1")], sc.InvalidShape, r"along_v\[0\] turns back over neighbors\[0\]"),
    ([(flat(0, 1, -1, 0), "v_end", "G1")] * 2, sc.InvalidShape, r"neighbors\[1\] lies along a curve that has"),
    ([(flat(0, 1, -1, 0), "v_end", "G2")], sc.InvalidShape, r"neighbors\[0\] has continuity 2"),
    ([(sc.BezierPatch([[(0, 0, 0)] * 2, [(1, 0, 0)] * 2]), "v_end", "G1")], sc.InvalidShape, "no tangent plane"),
    (flat(0, 1, -1, 0), TypeError, "list of"),
    ([None], TypeError, "None"),
])
def test_what_is_no_neighbor_is_refused_by_name(neighbors, error, words):
    with pytest.raises(error, match=words):
        build.network(*lines(), neighbors=neighbors)


def test_curves_that_leave_the_tangent_planes_are_refused_and_it_is_said_how_far():
    with pytest.raises(sc.ToleranceNotReached, match=r"along_v\[\d\] is missed: it does not leave neighbors\[0\] in its tangent plane"):
        build.network(*lines(0.8), neighbors=[(flat(0, 1, -1, 0), "v_end", "G1")])
