"""The points d, e, f and g of C2 chains: against the lecture's formulas (S7, S8) in exact fractions."""

from fractions import Fraction

import numpy as np
import pytest

import splinecore as sc
from addon_core import core

chain_points, signs = core("formulas.chain_points"), core("formulas.signs")


def lecture(d, h):
    """{name: (point, ratio)} by S8; h[0] is the length of the first interval; m intervals, m + 3 points."""
    m, h = len(h), {i + 3: Fraction(length) for i, length in enumerate(h)}
    d = [[Fraction(x) for x in point] for point in d]
    f, g, e = {1: d[1]}, {m: d[m + 1]}, {0: d[0], m: d[m + 2]}
    ratios = {}

    def mix(a, p, b, q):
        return [(a * x + b * y) / (a + b) for x, y in zip(p, q)]
    g[1], ratios['g', 1] = mix(h[4], d[1], h[3], d[2]), (h[3], h[4])
    f[m], ratios['f', m] = mix(h[m + 2], d[m], h[m + 1], d[m + 1]), (h[m + 1], h[m + 2])
    for i in range(2, m):
        f[i], ratios['f', i] = mix(h[i + 2] + h[i + 3], d[i], h[i + 1], d[i + 1]), (h[i + 1], h[i + 2] + h[i + 3])
        g[i], ratios['g', i] = mix(h[i + 3], d[i], h[i + 1] + h[i + 2], d[i + 1]), (h[i + 1] + h[i + 2], h[i + 3])
    for i in range(1, m):
        e[i], ratios['e', i] = mix(h[i + 3], g[i], h[i + 2], f[i + 1]), (h[i + 2], h[i + 3])
    points = {(letter, i): point for letter, those in (('d', dict(enumerate(d))), ('e', e), ('f', f), ('g', g)) for i, point in those.items()}
    return {key: (np.array(point, float), ratios.get(key)) for key, point in points.items()}


def marks_of(parts):
    """{(letter, number): (point, what follows)}, those that have one place with another as well."""
    found = {}
    for part in parts:
        if part.name.startswith(signs.MARK):
            letter, below, after = signs.named(part.name)
            place = signs.place_of(part.name, part.curve.points)
            found[letter, int(below)] = place, after
            for other in after.split(" = ")[1:]:
                found[other[0], int(other[1:])] = place, ""
    return found


def spline(d, h):
    joints = np.concatenate([[0.0], np.cumsum(h)])
    return sc.NurbsCurve(3, np.concatenate([[0.0] * 3, joints, [joints[-1]] * 3]), d)


@pytest.mark.parametrize('h', ([1, 1], [1, 3], [1, 1, 1], [2, 1, 3, 1], [1, 2, 1, 5, 1, 1, 3]))
@pytest.mark.parametrize('way', ('spline', 'chain'))
def test_points_and_ratios_are_those_of_the_lecture(h, way):
    d = np.random.default_rng(len(h)).integers(-9, 9, (len(h) + 3, 3)).astype(float)
    curve = spline(d, h)
    if way == 'spline':
        parts = chain_points.of_curve(curve, 'both', 0.1)
    else:
        parts, warning = chain_points.of_chain(curve.to_bezier(), 'both', 0.1)
        assert not warning
    found, wanted = marks_of(parts), lecture(d.astype(int).tolist(), h)
    assert found.keys() == wanted.keys()
    for key, (point, ratio) in wanted.items():
        assert np.allclose(found[key][0], point, rtol=0, atol=1e-11), key
        text = f"  {Fraction(ratio[0], ratio[1]).numerator} : {Fraction(ratio[0], ratio[1]).denominator}" if ratio else ""
        assert not ratio or found[key][1] == text, key
    assert [part.name for part in parts][:2] == [chain_points.SPLINE, chain_points.BEZIER]


def test_two_cubics_joined_with_c2_have_the_point_d_of_s7():
    q, r = sc.build.c2_pair((0, 0, 0), (1, 2, 0), (3, 4, 1), (6, 2, 0), (7, 0, 0), 1.0, 2.0)
    parts, warning = chain_points.of_chain([q, r], 'none', 0.1)
    found = marks_of(parts)
    assert not warning and np.allclose(found['d', 2][0], (3, 4, 1), rtol=0, atol=1e-12)
    assert found['g', 1][1] == found['f', 2][1] == found['e', 1][1] == "  1 : 2"


def test_a_chain_that_is_not_c2_says_so_and_has_its_bezier_points():
    one, other = sc.BezierCurve([(0, 0), (1, 1), (2, 1), (3, 0)]), sc.BezierCurve([(3, 0), (4, 1), (5, 1), (6, 0)])
    parts, warning = chain_points.of_chain([one, other], 'both', 0.1)
    assert "joint 1 is not C1" in warning and {key[0] for key in marks_of(parts)} == {'e', 'f', 'g'}
    apart, warning = chain_points.of_chain([one, one], 'both', 0.0)
    assert "no spline polygon" in warning and [part.name for part in apart] == [chain_points.BEZIER] * 2


@pytest.mark.parametrize('seed', range(30))
def test_marked_points_divide_their_segments_as_they_say_also_with_weights(seed):
    rng = np.random.default_rng(seed)
    count, is_closed = int(rng.integers(5, 9)), seed % 3 == 0
    points, weights = rng.uniform(-1, 1, (count, 3)), rng.uniform(0.3, 3, count) if seed % 2 else None
    steps = rng.choice([1.0, 2.0, 0.1, np.sqrt(2)], count + 3) * (1 if is_closed else rng.choice([0, 1, 1], count + 3))
    knots = np.concatenate([[0.0], np.cumsum(steps)])[:count + 1] if is_closed else np.concatenate([[0.0], np.cumsum(steps + (np.arange(count + 3) % 3 == 1))])
    curve = sc.NurbsCurve(3, knots, points, weights, is_closed)
    found = marks_of(chain_points.of_curve(curve, 'both', 0.05))
    beziers = curve.to_bezier()
    size = np.ptp(points, axis=0).max()
    for i, bezier in enumerate(beziers):
        for letter, number, row in (('e', i, 0), ('f', i + 1, 1), ('g', i + 1, 2)):
            assert np.allclose(found[letter, number][0], bezier.points[row], rtol=0, atol=1e-9)
    for (letter, number), (place, after) in found.items():
        if ":" in after:
            one, other = map(float, after.split("=")[0].split(":"))
            ends = (np.array([found['d', i][0] for i in range(count)]) if letter != 'e'
                    else np.array([beziers[number - 1].points[2], beziers[number].points[1]]))
            legs = [(a, b) for a, b in zip(ends, np.roll(ends, -1, axis=0))][:None if letter != 'e' else 1]
            assert min(np.linalg.norm(place - (other * a + one * b) / (one + other)) for a, b in legs) < 1e-3 * size, (letter, number)


def test_other_degrees_have_their_bezier_points_and_no_ratios():
    quintic = sc.BezierCurve(np.random.default_rng(1).uniform(-1, 1, (6, 3)))
    assert {part.name for part in chain_points.of_curve(quintic, 'none', 0.1)} >= {f"mark d_{{{i}}} = b1,{i}" for i in range(1, 5)}
    conic = sc.NurbsCurve(2, [0, 0, 0, 1, 2, 2, 2], np.random.default_rng(1).uniform(-1, 1, (4, 3)))
    texts = [part.name for part in chain_points.of_curve(conic, 'none', 0.1)]
    assert "mark e_{1}" in texts and not any(":" in text for text in texts)
    infinite = sc.NurbsCurve(3, [0, 0, 0, 0, 1, 2, 2, 2, 2], np.random.default_rng(1).uniform(-1, 1, (5, 3)), [1, 0, 1, 1, 1])
    assert chain_points.of_curve(infinite, 'both', 0.1)


@pytest.mark.parametrize('one, other, text', ((1, 2, "  1 : 2"), (0.1, 0.3, "  1 : 3"), (2.5, 1, "  5 : 2"), (1, 2**0.5, "  1 : 1.414"),
                                              (3.0 * 2**0.5, 1, "  4.243 : 1"), (0, 1, ""), (1, -1, ""), (1e-9, 1, "  1 : 1e+09"), (np.nan, 1, "")))
def test_ratios_are_written_in_whole_numbers_where_those_are_small(one, other, text):
    assert signs.ratio(one, other) == text
