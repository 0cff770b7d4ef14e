"""Products of two functions as patches: against exact fractions, and as what a patch is the sum of its points by."""

from fractions import Fraction

import numpy as np
import pytest

import splinecore as sc
from addon_core import core
from test_function_graphs import cox_de_boor

definitions, functions, labels, products, teaching = (core(name) for name in (
    "shape.definition", "formulas.functions", "formulas.labels", "formulas.products", "formulas.teaching"))
recipes = core("recipes.table").RECIPES
Refusal = core("base.failures").Refusal
RANDOM = np.random.default_rng(44)
SQUARE = (1.0, 1.0)


def inside(domain, count=9):
    return np.linspace(*domain, count + 2)[1:-1]


def on_grid(patch, count=9):
    """(u, v, points) of parameters inside a patch."""
    u, v = (inside(domain, count) for domain in patch.domain)
    return u, v, patch.evaluate_grid(u, v)


KNOTS = {
    'simple': ((2, [0, 1, 2, 3, 4]), (1, [0, 1, 3, 4])), 'steps': ((0, [0, 1, 2]), (2, [0, 1, 2, 3])), 'multiple': ((3, [0, 0, 0, 0, 1, 3, 3, 4]), (2, [0, 0, 1, 1, 1, 2])),
    'both steps': ((0, [0, 1, 4]), (0, [0, 2, 3])), 'with a function that is zero': ((1, [0, 1, 1, 1, 2]), (1, [0, 1, 2])),
    'far': ((2, [100, 101, 102, 104]), (3, [-8, -7, -5, -4, -3])),
}


@pytest.mark.parametrize('name', KNOTS)
def test_each_product_of_b_splines_is_that_of_cox_and_de_boor(name):
    along = KNOTS[name]
    families = tuple(functions.of_knots(degree, knots) for degree, knots in along)
    width, depth, height = 3.0, 2.0, 0.5
    parts = products.picture(families, 'all', (0, 0), (width, depth), height)
    exact = [[Fraction(knot) for knot in knots] for _, knots in along]
    wanted = {(i, j) for i in range(len(families[0].names)) for j in range(len(families[1].names))
              if families[0].supports(i) and families[1].supports(j)}
    seen = set()
    for part in parts:
        (_, first), (_, second) = products.factors(part.name)
        i, j = int(first.split(",")[0]), int(second.split(",")[0])
        seen.add((i, j))
        u, v, points = on_grid(part.curve, 5)
        for a, one in enumerate(u):
            for b, other in enumerate(v):
                value = float(cox_de_boor(i, along[0][0], exact[0], Fraction(one)) * cox_de_boor(j, along[1][0], exact[1], Fraction(other)))
                start, scale = zip(*((knots[0], size / (knots[-1] - knots[0])) for (_, knots), size in zip(along, (width, depth))))
                assert np.allclose(points[a, b], ((one - start[0]) * scale[0], (other - start[1]) * scale[1], height * value), rtol=0, atol=1e-12)
        for axis, (number, family) in enumerate(zip((i, j), families)):
            assert part.curve.domain[axis] in family.supports(number), "only where it is not zero"
    assert seen == wanted and len(parts) == len(wanted)


def patches():
    points, weights = RANDOM.uniform(-1, 1, (7, 6, 3)), RANDOM.uniform(0.5, 2, (7, 6))
    yield 'clamped', sc.NurbsPatch((3, 2), ([0, 0, 0, 0, 1, 1, 2, 3, 3, 3, 3], [0, 0, 0, 1, 2, 4, 5, 5, 5]), points, weights)
    yield 'unclamped', sc.NurbsPatch((2, 3), (np.cumsum(RANDOM.uniform(0.2, 1, 10)), np.cumsum(RANDOM.uniform(0.2, 1, 10))), points)
    yield 'a tube', sc.NurbsPatch((2, 1), (np.cumsum(RANDOM.uniform(0.2, 1, 8)), [0, 0, 1, 2, 3, 4, 4]), points[:, :5], periodic=(True, False))
    yield 'a ring', sc.NurbsPatch((3, 2), (range(8), range(7)), points, weights, (True, True))
    yield 'a narrow ring', sc.NurbsPatch((3, 1), ([0, 1, 2.5, 4], [0, 0, 1, 1]), points[:3, :2], periodic=(True, False))
    yield 'Bezier', sc.BezierPatch(points[:4, :3], weights[:4, :3])
    yield 'Hermite', sc.HermitePatch(points[:3, :2], points[3:6, :2], points[:3, 2:4], points[3:6, 2:4], parameters=([0, 1, 3], [0, 2]))


PATCHES = dict(patches())


def homogeneous(patch):
    """{(i, j): (4,)}: what each product is multiplied by, with those of denominators."""
    if not isinstance(patch, sc.HermitePatch):
        rows = patch.homogeneous_points
        return {place: rows[place] for place in np.ndindex(rows.shape[:2])}
    rows = [np.dstack([each, np.full(each.shape[:2], is_point)]) for each, is_point in (
        (patch.points, 1.0), (patch.tangents_u, 0.0), (patch.tangents_v, 0.0), (patch.twists, 0.0))]
    return {(2 * i + along_u, 2 * j + along_v): rows[along_u + 2 * along_v][i, j]
            for i, j in np.ndindex(patch.points.shape[:2]) for along_u in (0, 1) for along_v in (0, 1)}


@pytest.mark.parametrize('name', PATCHES)
def test_a_patch_is_the_sum_of_its_points_by_the_products(name):
    patch = PATCHES[name]
    families = products.of_patch(patch)
    rows, (u, v) = homogeneous(patch), (inside(domain) for domain in patch.domain)
    assert len(rows) == len(families[0].names) * len(families[1].names)
    scales = [1.0 / np.ptp(family.places) for family in families]
    found = np.zeros((len(u), len(v), 4))
    for (i, j), row in rows.items():
        for part in products.picture(families, 'chosen', (i, j), SQUARE, 1.0):
            (a, b), (c, d) = part.curve.domain
            at, over = (u >= a) & (u <= b), (v >= c) & (v <= d)
            if at.any() and over.any():
                graph = part.curve.evaluate_grid(u[at], v[over])
                assert np.allclose(graph[:, 0, 0], (u[at] - families[0].places[0]) * scales[0], rtol=0, atol=1e-12)
                found[np.ix_(at, over)] += graph[..., 2, None] * row
    assert np.allclose(found[..., :3] / found[..., 3:], patch.evaluate_grid(u, v), rtol=0, atol=1e-11)


@pytest.mark.parametrize('name', PATCHES)
def test_the_sum_is_1_over_the_domain(name):
    patch = PATCHES[name]
    families = products.of_patch(patch)
    for part in products.picture(families, 'sum', (0, 0), SQUARE, 2.0):
        assert part.name == functions.SUM
        domain = [(max(a, c), min(b, d)) for (a, b), (c, d) in zip(part.curve.domain, patch.domain)]
        assert np.allclose(part.curve.evaluate_grid(*map(inside, domain))[..., 2], 2.0, rtol=0, atol=1e-12)


def test_all_products_lie_over_the_square_and_have_two_names():
    families = products.of_patch(sc.BezierPatch(np.zeros((3, 2, 3)) + np.eye(3)[0]))
    parts = products.picture(families, 'all', (0, 0), SQUARE, 1.0)
    assert [part.name for part in parts] == [f"B_{{{i},2}} B_{{{j},1}}" for i in range(3) for j in range(2)]
    low, high = (np.array([bound(part.curve.points.reshape(-1, 3), axis=0) for part in parts]) for bound in (np.min, np.max))
    assert (low >= 0).all() and (high <= 1).all() and (low[:, :2] == 0).all() and (high[:, :2] == 1).all()
    middle = next(part for part in parts if part.name == "B_{1,2} B_{1,1}")
    assert middle.curve.evaluate(0.5, 1.0).tolist() == [0.5, 1.0, 0.5]


def test_labels_stand_on_the_tops_and_of_patches_at_knots():
    made = recipes['products'].make(None, **{**recipes['products'].defaults, 'degree': 1, 'degree_v': 2, 'knot_values': "0 1 2", 'knot_values_v': "0 1 2 3"})
    (label,) = labels.of(made.definition)
    assert label.runs == [("N", False), ("0,1", True), (" N", False), ("0,2", True)]
    assert label.point == pytest.approx((0.5, 0.5, 0.75), abs=1e-12)
    patch = sc.NurbsPatch((1, 2), ([0, 0, 1, 3, 3], [0, 0, 0, 2, 2, 4, 4, 4]), np.dstack(np.meshgrid([0, 1, 2.0], [0, 1, 2, 3, 4.0], [0.0], indexing='ij')).reshape(3, 5, 3))
    found = {f"{label.base}_{label.below}{label.after}": label.point for label in labels.of(definitions.from_value(patch)) if label.base in ("u", "v")}
    assert found == {"u_2 = 1": (1.0, 0.0, 0.0), "v_3…4 = 2": (0.0, 2.0, 0.0)}


def test_functions_that_are_zero_are_told_and_what_cannot_be_is_refused():
    values = {**recipes['products'].defaults, 'degree': 1, 'knot_values': "0 1 1 1 2"}
    assert recipes['products'].make(None, **values).said == "zero everywhere: N_{1,1}"
    for changed, said in (({'show': 'chosen', 'index': 1}, "all functions are zero"), ({'show': 'chosen', 'index_v': 9}, "no function 9 along v: the last one is 2"),
                          ({'knot_values_v': "0 1"}, "at least 4"), ({'knot_values': " ".join(map(str, range(200)))}, "256 are the most")):
        with pytest.raises(Refusal, match=said):
            recipes['products'].make(None, **{**values, **changed})
    with pytest.raises(Refusal, match="a surface is needed"):
        teaching.patch_of(definitions.from_value(sc.BezierCurve(np.eye(3))), 1)
