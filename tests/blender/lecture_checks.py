"""What is true of each picture of the lectures: {number: a function of the objects, in the order in which they were made}."""

import numpy as np

from support import part

labels, store = part('core.formulas.labels'), part('bridge.data.store')
CHECKS = {}
#: Blender moves points in single precision.
NEAR = 1e-6


def of(*numbers):
    def known(check):
        CHECKS.update(dict.fromkeys(numbers, check))
        return check
    return known


def values(ob):
    value = ob.data.splinewright.value
    return value if isinstance(value, list) else [value]


def names(ob):
    return [piece.name for piece in store.read(ob.data).pieces]


def named(ob, name):
    """The curves of a picture that have a name, or begin with a word."""
    return [value for known, value in zip(names(ob), values(ob)) if known == name or known.partition(" ")[0] == name]


def labels_of(ob):
    return [f"{label.base}{label.below and '_' + label.below}{label.after}" for label in labels.of(store.read(ob.data))]


def same(one, other):
    return np.allclose(one, other, rtol=0.0, atol=NEAR)


def at(curve, u):
    return np.asarray(curve.evaluate(np.atleast_1d(np.asarray(u, float))))


def inside(curve, count=9):
    start, end = curve.domain
    return start + (end - start) * (np.arange(count) + 0.5) / count


def cox_de_boor(i, degree, knots, u):
    """N_{i,p} by its definition, 0/0 taken as 0."""
    if degree == 0:
        return ((knots[i] <= u) & (u < knots[i + 1])).astype(float)
    total = np.zeros_like(u)
    for j, first, last, is_ahead in ((i, knots[i], knots[i + degree], True), (i + 1, knots[i + 1], knots[i + degree + 1], False)):
        if last > first:
            total += ((u - first) if is_ahead else (last - u)) / (last - first) * cox_de_boor(j, degree - 1, knots, u)
    return total


def require_functions(ob, degree, knots, height=1.0, width=5.0):
    """All functions that are not zero are drawn, in colors of their own, with the values of their definition."""
    knots = np.array(knots, float)
    wanted = [i for i in range(len(knots) - degree - 1) if knots[i] < knots[i + degree + 1]]
    for i in wanted:
        graph, = named(ob, f"N_{{{i},{degree}}}")
        u = inside(graph)
        places = at(graph, u)
        assert same(places[:, 1], height * cox_de_boor(i, degree, knots, u)), i
        assert same(places[:, 0], (u - knots[0]) * width / np.ptp(knots)), i
    shown = {name for name in names(ob) if name.startswith("N_")}
    assert len(shown) == len(wanted)
    slots = {spline.material_index for name, spline in zip(names(ob), ob.data.splines) if name in shown}
    assert len(slots) == len(shown), "a color each"


def functions(*rows, **more):
    """A check of graphs one below the other: of (degree, knots) each."""
    def check(obs):
        assert len(obs) == len(rows)
        for ob, (degree, knots) in zip(obs, rows):
            require_functions(ob, degree, knots, **more)
    return check


def require_sum(ob, height, domain):
    """The sum is drawn, and is 1 on the domain."""
    total, = named(ob, "sum")
    start, end = domain
    assert same(at(total, np.linspace(start, end, 7)[1:-1])[:, 1], height)


def rational_against_lift(curve, lifted):
    """The homogeneous curve, seen from 0, is the rational one."""
    u = inside(curve)
    x, y, z = at(lifted, u).T
    assert same(np.stack([x, y], -1) / (z + 1.0)[:, None], at(curve, u)[:, :2])
    assert np.ptp(curve.weights) > 0.4 and np.ptp(lifted.points[:, 2]) > 0.4 and same(lifted.weights, 1.0)


@of("000.9", "000.24", "000.27")
def homogeneous(obs):
    curve, lift = values(obs[0])[0], obs[1]
    rational_against_lift(curve, named(lift, "homogeneous curve")[0])
    assert named(lift, "homogeneous polygon") and named(lift, "polygon") and len(named(lift, "ray")) == 4
    if len(obs) == 2:
        assert "p_1" in labels_of(lift)
        return
    space, plane = (named(ob, "level") for ob in obs[2:])
    assert len(space) == len(plane) > 2
    for above, below in zip(space, plane):
        x, y, z = above.points.T
        assert same(np.stack([x, y], -1) / (z + 1.0)[:, None], below.points[:, :2])


@of("000.49")
def arcs(obs):
    short, long = (values(ob)[0] for ob in obs)
    for curve in (short, long):
        assert same(np.linalg.norm(at(curve, inside(curve)), axis=1), 1.0)
    assert same([short.length(), long.length()], [np.pi / 2, 3 * np.pi / 2])


@of("000.52")
def half_ellipse(obs):
    curve, = values(obs[0])
    assert curve.weights[1] == 0.0 and curve.degree == 2
    x, y, _ = at(curve, inside(curve)).T
    height = curve.homogeneous_points[1, 1]
    assert same(x * x + (y / height) ** 2, 1.0)


def require_chain_points(ob, spline):
    """e, f and g divide as the intervals do."""
    breaks = np.unique(spline.knots)
    pieces = spline.to_bezier()
    for i, (before, after) in enumerate(zip(pieces, pieces[1:])):
        h = breaks[i + 1] - breaks[i], breaks[i + 2] - breaks[i + 1]
        joint = before.points[-1]
        assert same(joint * (h[0] + h[1]), h[1] * before.points[2] + h[0] * after.points[1])
        for order, factor in ((1, 3.0), (2, 6.0)):
            ends = [factor * np.diff(piece.points, order, axis=0)[side] / width ** order for piece, side, width in zip((before, after), (-1, 0), h)]
            assert same(*ends), order
    assert named(ob, "spline polygon") or any("spline" in name for name in names(ob))
    marked = {name.split(" ")[1].partition("_")[0] for name in names(ob) if name.startswith("mark ")}
    assert {"d", "e"} <= marked


@of("000.59", "000.64", "001.81")
def c2_chain(obs):
    spline, = values(obs[0])
    require_chain_points(obs[1], spline)
    wanted = {5: "e_1  1 : 2", 7: "f_2", 6: "e_1"}[len(spline.points)]
    assert any(label.startswith(wanted) for label in labels_of(obs[1]))


@of("000.72")
def vases(obs):
    profiles = [values(ob)[0] for ob in obs[::2]]
    assert [curve.degree for curve in profiles] == [6, 3, 3] and len(obs) == 6
    assert same(profiles[0].points, profiles[1].points) and same(profiles[1].points, profiles[2].points)
    assert list(profiles[1].knots).count(1.0) == 3 and list(profiles[2].knots).count(1.0) == 1
    for ob, curve in zip(obs[1::2], profiles):
        value = ob.data.splinewright.value
        patch = value if hasattr(value, 'domain') else value[0]
        u, v = (patch.domain[axis] for axis in (0, 1))
        places = patch.evaluate_grid(np.linspace(*u, 5), np.linspace(*v, 7)).reshape(-1, 3)
        radii = np.hypot(places[:, 1] + 1.0, places[:, 2])
        known = at(curve, np.linspace(*curve.domain, 4001))
        for place, radius in zip(places, radii):
            near = known[np.abs(known[:, 0] - place[0]).argmin()]
            assert abs(radius - (near[1] + 1.0)) < 5e-3


_SIMPLE, _MULTIPLE = range(6), (0, 0, 1, 2, 2, 3, 4, 4, 4)
CHECKS |= {
    "000.81": functions((0, _SIMPLE), (1, _SIMPLE)), "000.82": functions((2, _SIMPLE), (3, _SIMPLE)),
    "000.83": functions((0, _MULTIPLE), (1, _MULTIPLE)), "000.84": functions((2, _MULTIPLE), (3, _MULTIPLE)),
    "000.87": functions((1, range(4))), "002.5f": functions((0, range(4))), "002.8f": functions((1, range(4))),
    "004.47": functions((0, range(6))), "004.48": functions((1, range(6))), "004.49": functions((2, range(6))),
    "001.71": functions((3, range(10)), width=6.0, height=2.0), "001.79": functions((3, range(5)), width=4.0, height=3.0)}


@of("000.107")
def merged(obs):
    for moved, ob in enumerate(obs):
        knots = [0] * 6 + [6 if u > 5 - moved else u for u in range(1, 7)] + [7] * 6
        require_functions(ob, 5, knots)
        assert same(sorted({*knots}), [*range(6 - moved), 6, 7])
        last, shortened = named(ob, "N_{10,5}")[0], named(ob, f"N_{{{11 - moved},5}}")
        assert shortened and last.domain == ((5 if moved == 0 else 6), 7)
        whole, order = named(ob, f"N_{{{10 - moved},5}}")[0], 5 - moved
        before, after = (whole.derivatives([6.0], order, side=side)[0, :, 1] for side in ("left", "right"))
        assert np.allclose(before[:order], after[:order], atol=1e-5) and abs(before[order] - after[order]) > 0.1, moved
    assert len(obs) == 5


def links(ob, word):
    return [name for name in names(ob) if name.partition(" ")[0] == word]


@of("000.85", "002.6")
def triangle(obs):
    found = labels_of(obs[0])
    degree = max(int(label.rpartition(",")[2]) for label in found if label.startswith("N_"))
    count = sum(label.startswith("N_") and label.endswith(",0") for label in found)
    for p in range(degree + 1):
        assert sum(label.startswith("N_") and label.endswith(f",{p}") for label in found) == count - p
    assert len(links(obs[0], "link")) == sum(2 * (count - p) for p in range(1, degree + 1)) and "[0, 1)" in found


@of("000.89", "002.11f")
def support(obs):
    """N_{1,3} depends on two of degree 2, three of degree 1, four of degree 0."""
    assert len(links(obs[0], "support")) == 2 + 4 + 6
    ends = [np.array([curve.points[0], curve.points[1]]) for curve in named(obs[0], "support")]
    first_column = {round(-start[1] / 0.6) for start, _ in ends if start[0] < 1.0 and start[0] < 0.5}
    assert len(first_column) >= 4


@of("000.92", "002.14f")
def wedges(obs):
    spans = sorted({name for name in names(obs[0]) if name.startswith("wedge")})
    chosen = [int(name.split(" ")[1]) for name in spans]
    knots = np.arange(9.0)
    for span in chosen:
        active = [i for i in range(5) if cox_de_boor(i, 3, knots, np.array([span + 0.5]))[0] > 0.0]
        assert 0 < len(active) <= 4 and active == [i for i in range(max(span - 3, 0), min(span, 4) + 1)]
        border = [curve for name, curve in zip(names(obs[0]), values(obs[0])) if name == f"wedge {span}"][-1]
        low, high = border.points[:, 1].min(), border.points[:, 1].max()
        assert low <= -0.6 * (active[-1] + 1.5) and high >= -0.6 * (active[0] + 1.5)
    assert chosen in ([4], [0, 2, 4])


@of("002.16f")
def ratios(obs):
    assert {"N_0,2", "u/2", "(3-u)/2"} <= set(labels_of(obs[0])) and len(links(obs[0], "parents")) == 2
    u = np.linspace(0.1, 2.9, 9)
    knots = np.arange(4.0)
    assert same(cox_de_boor(0, 2, knots, u), u / 2 * cox_de_boor(0, 1, knots, u) + (3 - u) / 2 * cox_de_boor(1, 1, knots, u))


@of("002.10")
def pieces_join(obs):
    require_functions(obs[0], 2, range(4))
    require_functions(obs[1], 2, (0, 1, 1, 3))
    jumps = []
    for ob, knot in zip(obs, (1.0, 1.0)):
        graph, = named(ob, "N_{0,2}")
        step = 1e-7
        slopes = [(at(graph, b)[0, 1] - at(graph, a)[0, 1]) / step for a, b in ((knot - step, knot), (knot, knot + step))]
        jumps.append(abs(slopes[1] - slopes[0]))
    assert jumps[0] < 1e-4 < 0.5 < jumps[1]
