"""What is true of the pictures of the second and the fifth lecture, as lecture_checks has it for the others."""

import bpy
import numpy as np

from lecture_checks import CHECKS, NEAR, at, inside, labels, labels_of, named, names, of, require_functions, require_sum, same, store, values
from support import part

sights_of = part('bridge.data.settings').overlays_of


def shown():
    """The overlays that are on."""
    sights = sights_of(bpy.context.scene)
    return {name for name in ('polygon', 'labels', 'knots', 'comb', 'hodograph', 'isocurves', 'frame') if getattr(sights, name)}


def arrows(ob):
    """[(foot, vector)] of the arrows of a picture."""
    return [(curve.points[0], curve.points[1] - curve.points[0]) for curve in named(ob, "arrow")]


def joints_of(ob):
    """[(end of one, start of the next)] as (3, 3), point, first and second derivative: of pieces, and at inner knots of one curve."""
    curves = values(ob)
    found = [(one.derivatives([one.domain[1]], 2)[0], other.derivatives([other.domain[0]], 2)[0]) for one, other in zip(curves, curves[1:])]
    for curve in curves:
        start, end = curve.domain
        inner = [u for u in np.unique(curve.knots) if start < u < end] if hasattr(curve, 'knots') else []
        found += [(curve.derivatives([u], 2, side="left")[0], curve.derivatives([u], 2)[0]) for u in inner]
    return found


def curvature(derivatives):
    _, first, second = derivatives
    return np.cross(first, second) / np.linalg.norm(first) ** 3


def parallel(one, other):
    return same(one / np.linalg.norm(one), other / np.linalg.norm(other))


def require_graph(curve, function, within=1e-5):
    x, y, z = at(curve, inside(curve, 33)).T
    assert np.allclose(y, function(x), atol=within) and same(z, 0.0)


@of("001.1")
def teapots(obs):
    counts = [len(ob.data.polygons) for ob in obs]
    assert len(obs) == 4 and counts[0] == counts[1] and counts[2] == counts[3]
    assert 800 < counts[0] < 1300 and 8000 < counts[2] < 13000
    assert [{face.use_smooth for face in ob.data.polygons} for ob in obs] == [{False}, {True}, {False}, {True}]


@of("001.2")
def motivation(obs):
    t = np.linspace(*values(obs[0])[0].domain, 15)
    assert np.allclose(at(values(obs[0])[0], t), np.stack([np.cos(3 * t), np.sin(2 * t), 0 * t], -1), atol=1e-5)


@of("001.6")
def oscillates(obs):
    polynomial, spline = values(obs[0])
    nodes = np.linspace(-1, 1, 11)
    runge = 1 / (1 + 25 * nodes * nodes)
    for curve in (polynomial, spline):
        start, end = curve.domain
        assert same(at(curve, np.linspace(start, end, 11))[:, 1], runge)
    u = np.linspace(*polynomial.domain, 201)
    assert at(polynomial, u)[:, 1].max() > 1.9 and polynomial.degree == 10


@of("001.15")
def double(obs):
    require_graph(values(obs[0])[0], lambda x: 2 * x)
    assert "axis" in names(obs[1])


@of("001.16")
def sine(obs):
    require_graph(values(obs[0])[0], np.sin)
    assert "axis" in names(obs[1])


@of("001.20")
def implicit(obs):
    line, circle = (np.concatenate([at(curve, inside(curve)) for curve in values(ob)]) for ob in obs[:2])
    assert same(line[:, 0] + 2 * line[:, 1], 1.0) and np.ptp(line[:, 0]) > 0.5
    assert same((circle[:, :2] ** 2).sum(1), 4.0)


@of("001.26")
def corner(obs):
    curve, = values(obs[0])
    found = dict(zip([name for name in names(obs[1]) if name.startswith("arrow")], arrows(obs[1])))
    sides = [curve.points[3] - curve.points[2], curve.points[4] - curve.points[3]]
    for name, side in zip(("arrow T_{-}", "arrow T_{+}"), sides):
        assert same(found[name][0], curve.points[3]) and parallel(found[name][1], side)
    assert not parallel(*sides)
    assert any(parallel(vector, curve.points[1] - curve.points[0]) for name, (_, vector) in found.items() if "R_" in name)


@of("001.29")
def geometric(obs):
    (corner,), (tangent,), (smooth,) = map(joints_of, obs)
    for before, after in (corner, tangent, smooth):
        assert same(before[0], after[0])
    assert not parallel(corner[0][1], corner[1][1]) and parallel(tangent[0][1], tangent[1][1]) and parallel(smooth[0][1], smooth[1][1])
    assert not np.allclose(*map(curvature, tangent), atol=1e-2) and np.allclose(*map(curvature, smooth), atol=1e-4)
    assert 'comb' in shown()


@of("001.38", "004.10")
def ducks(obs):
    strip, = named(obs[0], "strip")
    assert len(named(obs[0], "end")) == 2 and any(label.startswith("E = ") for label in labels_of(obs[0]))
    for u in strip.domain:
        assert same(strip.derivatives([u], 2)[0, 2], 0.0), "it is natural"
    u = np.linspace(*strip.domain, 4001)
    for mark in named(obs[0], "mark")[:-1]:
        middle = (mark.points.min(0) + mark.points.max(0)) / 2
        assert np.linalg.norm(at(strip, u) - middle, axis=1).min() < 1e-2


@of("001.40", "001.43", "004.17")
def hermite(obs):
    curve, = values(obs[0])
    assert type(curve).__name__ == 'HermiteCurve'
    found = arrows(obs[1])
    assert len(found) == 2
    for (foot, vector), u in zip(found, curve.domain):
        point, tangent = curve.derivatives([u], 1)[0]
        assert same(foot, point) and same(vector, tangent) and np.linalg.norm(vector) > 1
    assert {"R_0", "R_1"} <= set(labels_of(obs[1]))


@of("001.49", "004.21")
def hermite_functions(obs):
    t = inside(named(obs[0], "H_{0}")[0])
    wanted = {"H_{0}": 2 * t**3 - 3 * t**2 + 1, "H_{1}": -2 * t**3 + 3 * t**2, "H_{2}": t**3 - 2 * t**2 + t, "H_{3}": t**3 - t**2}
    for name, heights in wanted.items():
        assert same(at(named(obs[0], name)[0], t)[:, 1], 2.0 * heights), name
    if "sum" in names(obs[0]):
        require_sum(obs[0], 2.0, (0.0, 1.0))


@of("001.50")
def family(obs):
    curves = [values(ob)[0] for ob in obs]
    tangents = np.array([curve.derivatives([curve.domain[0]], 1)[0, 1] for curve in curves])
    assert np.allclose(tangents, [(k, 2 * k, 0) for k in (1, 3, 6, 10)], atol=1e-5)
    for curve in curves:
        assert same(at(curve, curve.domain), [(0, 0, 0), (3, 0, 0)])
        assert np.allclose(curve.derivatives([curve.domain[1]], 1)[0, 1], (2, -2, 0), atol=1e-5) and curve.degree == 3


@of("001.51")
def one_direction(obs):
    (before, after), = joints_of(obs[0])
    assert same(before[0], after[0]) and parallel(before[1], after[1])
    ratio = np.linalg.norm(after[1]) / np.linalg.norm(before[1])
    assert abs(ratio - 0.7 / 0.3) < 1e-6 and len(arrows(obs[1])) == 4


@of("001.57", "004.37")
def bernstein(obs):
    u = inside(named(obs[0], "B_{0,3}")[0])
    for i, binomial in enumerate((1, 3, 3, 1)):
        heights = at(named(obs[0], f"B_{{{i},3}}")[0], u)[:, 1]
        assert same(heights, 2.0 * binomial * u**i * (1 - u)**(3 - i)) and (heights > 0).all()
    require_sum(obs[0], 2.0, (0.0, 1.0))


@of("001.60", "001.62", "004.22")
def bezier(obs):
    curve, = values(obs[0])
    n = curve.degree
    assert same(at(curve, (0, 1)), curve.points[[0, -1]]) and n in (3, 5)
    for u, leg in ((0.0, curve.points[1] - curve.points[0]), (1.0, curve.points[-1] - curve.points[-2])):
        assert same(curve.derivatives([u], 1)[0, 1], n * leg)
    assert {'polygon', 'labels'} <= shown()


@of("001.61", "004.38")
def chain(obs):
    curves = values(obs[0])
    assert len(curves) in (2, 3) and {curve.degree for curve in curves} == {3} and 'polygon' in shown()
    for one, other in zip(curves, curves[1:]):
        assert same(one.points[3], other.points[0]) and same(one.points[3] - one.points[2], other.points[1] - other.points[0])


@of("001.63")
def orders(obs):
    points = values(obs[0])[0].points
    found = [name for name in names(obs[1]) if name.startswith("order")]
    assert len(found) == 12 and len({*found}) == 12
    for name in found:
        order = [int(digit) for digit in name.split(" ")[1]]
        curve, = [value for known, value in zip(names(obs[1]), values(obs[1])) if known == name]
        steps = np.diff(points[order], axis=0)
        assert same(np.diff(curve.points, axis=0), steps)


@of("001.64")
def three_degrees(obs):
    assert [len(values(ob)[0].points) for ob in obs] == [3, 4, 5] and 'polygon' in shown()
    for ob in obs:
        curve, = values(ob)
        assert same(at(curve, (0, 1)), curve.points[[0, -1]])


def levels(last):
    """A check that the levels up to this one are drawn and named, and no others."""
    wanted = ({"M_01", "M_12", "M_23"}, {"M_012", "M_123"}, {"M_0123"})

    def check(obs):
        rows = values(obs[0])[0].points
        drawn = named(obs[1], "level")
        found = {label for label in labels_of(obs[1]) if label.startswith("M_")}
        assert found == set().union(*wanted[:last])
        for level in range(1, 4):
            rows = (rows[1:] + rows[:-1]) / 2
            if len(rows) > 1:
                is_there = any(len(curve.points) == len(rows) and same(curve.points, rows) for curve in drawn)
                assert is_there == (level <= last), level
        assert same(at(values(obs[0])[0], 0.5), rows)
        places = {label.below: label.point for label in labels.of(store.read(obs[1].data)) if label.base == "M"}
        assert last < 3 or same(places["0123"], rows[0])
    return check


CHECKS |= {"001.65a": levels(1), "001.65b": levels(2), "001.65c": levels(3)}


@of("001.65d")
def halved(obs):
    curve, = values(obs[0])
    steps = [named_curve.points for named_curve in named(obs[1], "step")]
    assert [len(points) for points in steps] == [4, 7, 13, 25]
    flat = []
    for number, points in enumerate(steps):
        points = points - (2.4 * number, 0, 0)
        assert same(points[::3], at(curve, np.linspace(0, 1, 2**number + 1)))
        flat.append(np.linalg.norm(np.diff(points, 2, axis=0), axis=1).max())
    assert (np.diff(flat) < 0).all()


@of("001.66")
def compared(obs):
    bezier, chain = values(obs[0])[0], values(obs[1])[0]
    assert type(bezier).__name__ == 'BezierCurve' and type(chain).__name__ == 'HermiteCurve'
    u = np.linspace(0, 1, 9)
    assert same(at(bezier, u), at(chain, u))
    (_, start), (_, end) = arrows(obs[2])
    assert same(start, 3 * (bezier.points[1] - bezier.points[0])) and same(end, 3 * (bezier.points[3] - bezier.points[2]))


@of("001.68")
def touches_none(obs):
    curve, = values(obs[0])
    p = curve.points
    assert same(at(curve, curve.domain), [(p[0] + 4 * p[1] + p[2]) / 6, (p[1] + 4 * p[2] + p[3]) / 6])
    near = np.linalg.norm(at(curve, np.linspace(*curve.domain, 201))[:, None] - p, axis=2)
    assert near.min() > 0.05 and 'polygon' in shown()


@of("001.72")
def begins(obs):
    require_functions(obs[0], 3, range(8), height=2.0, width=6.0)
    require_sum(obs[0], 2.0, (3.0, 4.0))
    total, = named(obs[0], "sum")
    assert at(total, [2.5])[0, 1] < 2.0 - 1e-3
    places = np.concatenate([curve.points for curve in named(obs[0], "domain")])[:, 0]
    assert same((places.min(), places.max()), (3.0 * 6.0 / 7.0, 4.0 * 6.0 / 7.0))


def in_hull(points, hull):
    """Whether plane points (n, 3) lie in the hull of others."""
    center = hull[:, :2].mean(0)
    for a in hull[:, :2]:
        for b in hull[:, :2]:
            normal = np.array([a[1] - b[1], b[0] - a[0]])
            sides = (hull[:, :2] - a) @ normal
            if np.abs(normal).max() > NEAR and (sides <= NEAR).all() and ((points[:, :2] - a) @ normal > NEAR).any():
                return False
    return bool(np.isfinite(center).all())


def spans(curve):
    knots = np.unique(curve.knots)
    start, end = curve.domain
    return [(a, b) for a, b in zip(knots, knots[1:]) if start <= a and b <= end]


@of("001.75", "001.76", "001.77", "001.78")
def hulls(obs):
    curve, = values(obs[0])
    for number, span in enumerate(spans(curve)):
        rows = curve.points[number:number + 4]
        assert in_hull(at(curve, np.linspace(*span, 33)), rows), number
        hull = np.concatenate([part.points for part in named(obs[1], "hull")])
        assert hull.shape[1] == 3
        if not len({tuple(np.round(row, 6)) for row in rows}) < 4:
            outer = [row for row in rows if any(same(row, corner) for corner in hull)]
            assert len(outer) >= 3
    assert sum(name.startswith("hull") for name in names(obs[1])) >= len(spans(curve))


@of("001.76")
def two_hulls(obs):
    hulls(obs)
    curve, = values(obs[0])
    common, = named(obs[1], "intersection")
    assert in_hull(at(curve, [4.0]), common.points)


def require_meeting(obs, count, where):
    """So many control points are one; the joint there lies as it must."""
    curve, = values(obs[0])
    assert same(curve.points[1:1 + count], curve.points[1])
    hulls(obs)
    assert named(obs[1], "intersection")
    for u in np.unique(curve.knots):
        if curve.domain[0] < u < curve.domain[1]:
            assert same(curve.derivatives([u], 2, side="left")[0], curve.derivatives([u], 2)[0]), "the curve is C2 all the same"
    where(curve)


@of("001.77")
def doubled(obs):
    def joint(curve):
        p, place = curve.points, at(curve, [4.0])[0]
        assert same(place, (5 * p[2] + p[3]) / 6)
        first, second = curve.derivatives([4.0], 2)[0, 1:]
        assert same(np.cross(first, p[3] - p[2]), 0.0)
        assert np.linalg.norm(first) > NEAR and same(np.cross(first, second), 0.0), "without curvature"
    require_meeting(obs, 2, joint)


@of("001.78")
def tripled(obs):
    def joint(curve):
        place, first, _ = curve.derivatives([4.0], 2)[0]
        assert same(place, curve.points[2]) and same(first, 0.0)
        assert not parallel(curve.points[1] - curve.points[0], curve.points[4] - curve.points[3])
    require_meeting(obs, 3, joint)


@of("004.6")
def twisted(obs):
    x, y, z = at(values(obs[0])[0], inside(values(obs[0])[0])).T
    assert same(y, x**2) and same(z, x**3) and "axis" in names(obs[1])


@of("004.7")
def helix(obs):
    curve, = values(obs[0])
    x, y, z = at(curve, inside(curve, 33)).T
    turn = 2 * np.pi * 3 * z / 2.0
    assert np.allclose(x, np.cos(turn), atol=1e-5) and np.allclose(y, np.sin(turn), atol=1e-5)


@of("004.16")
def derivative(obs):
    curve, = values(obs[0])
    assert 'hodograph' in shown() and len(named(obs[1], "mark")) == 5
    for (foot, vector), u in zip(arrows(obs[1]), (0.0, 1.0)):
        step = 1e-6
        inward = step if u == 0.0 else -step
        assert same(foot, at(curve, [u])[0])
        assert np.allclose(vector, (at(curve, [u + inward])[0] - at(curve, [u])[0]) / inward, atol=1e-4)


@of("004.28")
def direction_or_derivative(obs):
    (geometric,), (parametric,) = map(joints_of, obs)
    assert parallel(geometric[0][1], geometric[1][1]) and not same(geometric[0][1], geometric[1][1])
    assert same(parametric[0][:2], parametric[1][:2])


@of("004.29f")
def point_or_derivative(obs):
    (corner,), (smooth,) = map(joints_of, obs)
    assert same(corner[0][0], corner[1][0]) and not parallel(corner[0][1], corner[1][1])
    assert same(smooth[0][:2], smooth[1][:2])


@of("004.30f")
def patch(obs):
    value = obs[0].data.splinewright.value
    for i, u in enumerate((0.0, 1.0)):
        for j, v in enumerate((0.0, 1.0)):
            assert same(np.asarray(value.evaluate_grid([u], [v])).reshape(3), value.points[-i, -j])
    assert {'polygon', 'isocurves'} <= shown()


@of("004.32")
def teapot(obs):
    value = obs[0].data.splinewright.value
    assert len(value) == 32 and len(value.points) == 306 and 'polygon' in shown()


@of("004.45")
def bells(obs):
    require_functions(obs[0], 3, range(8), height=3.0, width=7.0)
    function, bell = named(obs[0], "N_{1,3}")[0], values(obs[1])[0]
    u = np.linspace(1.05, 4.95, 41)
    away = np.abs(at(function, u)[:, 1] - at(bell, u)[:, 1]) / 3.0
    assert 0.01 < away.max() < 0.026
