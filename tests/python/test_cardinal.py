"""Catmull-Rom, cardinal and Kochanek-Bartels splines (row S5)."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import splinecore as sc
from shapes import point_lists, random_points

NAN = float("nan")
catmull_rom, kochanek_bartels = sc.build.catmull_rom, sc.build.kochanek_bartels
unit = st.floats(-1, 1)


@given(point_lists(3, 9), unit, unit, unit)
def test_inner_tangents_are_the_lectures(points, t, c, b):
    p = np.array(points)
    tangents = kochanek_bartels(p, t, c, b).tangents[1:-1]
    before, after = p[1:-1] - p[:-2], p[2:] - p[1:-1]
    incoming = (1 - t) * (1 - c) * (1 + b) / 2 * before + (1 - t) * (1 + c) * (1 - b) / 2 * after
    outgoing = (1 - t) * (1 + c) * (1 + b) / 2 * before + (1 - t) * (1 - c) * (1 - b) / 2 * after
    size = np.abs(p).max() + 1e-300
    assert np.abs(tangents[:, 0] - incoming).max() <= 1e-14 * size
    assert np.abs(tangents[:, 1] - outgoing).max() <= 1e-14 * size


@given(point_lists(2, 9), st.sampled_from(["parabola", "chord", "natural"]), st.booleans())
def test_without_shaping_it_is_catmulls_and_roms(points, ends, closed):
    if closed and len(points) < 3:
        points = points + [(0.5, 0.25, 0.125)]
    plain = catmull_rom(points, closed=closed, ends=ends)
    assert plain == kochanek_bartels(points, 0, 0, 0, "uniform", closed, ends)
    count = len(points) + closed
    assert np.array_equal(plain.points[:len(points)], np.array(points, float)) and len(plain.points) == count
    assert plain.parameters.tolist() == list(range(count))
    assert np.array_equal(plain.tangents[:, 0], plain.tangents[:, 1])


def test_tension_scales_the_tangents():
    points = random_points(6, seed=21)
    loose, tense = catmull_rom(points), catmull_rom(points, tension=0.75)
    assert np.abs(tense.tangents - 0.25 * loose.tangents).max() <= 1e-15
    assert (catmull_rom(points, tension=1).tangents == 0).all()


@pytest.mark.parametrize("kind, power", [("centripetal", 0.5), ("chordal", 1.0)])
def test_parameters_are_powers_of_distances(kind, power):
    points = random_points(6, seed=22)
    steps = np.linalg.norm(np.diff(points, axis=0), axis=1) ** power
    chain = catmull_rom(points, kind)
    assert np.abs(chain.parameters - np.r_[0, np.cumsum(steps)]).max() <= 1e-14
    h, slopes = steps[:, None], np.diff(points, axis=0) / steps[:, None]
    expected = (h[1:] * slopes[:-1] + h[:-1] * slopes[1:]) / (h[1:] + h[:-1])
    assert np.abs(chain.tangents[1:-1, 0] - expected).max() <= 1e-14


def test_a_parabola_is_kept_on_any_parameters():
    u = np.array([0, 0.5, 2, 2.25, 4])
    chain = catmull_rom(np.stack([u, u * u], 1), u)
    t = np.linspace(0, 4, 33)
    assert np.abs(chain.evaluate(t) - np.stack([t, t * t, 0 * t], 1)).max() <= 1e-14


def test_natural_ends_have_no_second_derivative():
    chain = catmull_rom(random_points(5, seed=23), "centripetal", ends="natural")
    assert np.abs(chain.derivatives(chain.domain, 2, side="right")[0, 2]).max() <= 1e-13
    assert np.abs(chain.derivatives(chain.domain[1], 2)[2]).max() <= 1e-13


@pytest.mark.parametrize("kind", ["uniform", "centripetal", "chordal"])
def test_a_closed_chain_is_smooth_where_it_began(kind):
    points = random_points(5, seed=24)
    chain = catmull_rom(points, kind, closed=True)
    assert np.array_equal(chain.points[0], chain.points[-1]) and len(chain.points) == 6
    assert np.array_equal(chain.tangents[0], chain.tangents[-1])
    assert chain.polylines(8)[0][1]
    turned = catmull_rom(np.roll(points, -1, axis=0), kind, closed=True)
    assert np.abs(turned.tangents[:-1] - chain.tangents[1:]).max() <= 1e-13
    explicit = catmull_rom(points, chain.parameters, closed=True)
    assert explicit == chain


@given(point_lists(2, 8), unit, unit, unit, st.sampled_from(["parabola", "chord", "natural"]))
def test_reversed_points_make_the_reversed_chain(points, t, c, b, ends):
    one = kochanek_bartels(points, t, c, b, ends=ends).reversed()
    other = kochanek_bartels(points[::-1], t, c, -b, ends=ends)
    assert np.abs(one.tangents - other.tangents).max() <= 1e-13 * (np.abs(points).max() + 1e-300)


def test_it_is_affinely_invariant_on_uniform_parameters():
    points, matrix, shift = random_points(6, seed=25), random_points(3, seed=26), np.array([3, 1, -2])
    u = np.linspace(0, 5, 41)
    there = kochanek_bartels(points, 0.2, -0.3, 0.4).evaluate(u) @ matrix + shift
    assert np.abs(kochanek_bartels(points @ matrix + shift, 0.2, -0.3, 0.4).evaluate(u) - there).max() <= 1e-13


def test_shaping_may_be_given_for_each_point():
    points = random_points(4, seed=27)
    chain = kochanek_bartels(points, [0, 1, 0, 0], bias=np.zeros(4), continuity=[0, 0, 0.5, 0])
    assert (chain.tangents[1] == 0).all()
    assert np.abs(chain.tangents[2, 0] - chain.tangents[2, 1]).max() > 0.01


def test_coincident_points_are_allowed_where_parameters_do_not_come_from_distances():
    points = [(0, 0), (1, 0), (1, 0), (2, 1)]
    assert np.isfinite(catmull_rom(points).evaluate(np.linspace(0, 3, 31))).all()
    assert catmull_rom(points, [0, 1, 3, 4]).parameters.tolist() == [0, 1, 3, 4]
    for kind in ("centripetal", "chordal"):
        with pytest.raises(sc.InvalidShape, match=r"points\[2\] is too close to points\[1\]"):
            catmull_rom(points, kind)
    with pytest.raises(sc.InvalidShape, match=r"points\[0\] is too close to points\[3\]"):
        catmull_rom([(0, 0), (1, 0), (1, 1), (0, 0)], "chordal", closed=True)


LINE = [(0, 0), (1, 1), (2, 0)]


@pytest.mark.parametrize("call, words", [
    (lambda: catmull_rom([(0, 0)]), "points has 1 rows"), (lambda: catmull_rom(np.zeros((0, 2))), "points has 0 rows"),
    (lambda: catmull_rom(LINE[:2], closed=True), "points has 2 rows, 3 or more"),
    (lambda: catmull_rom([(0, 0), (NAN, 1)]), r"points\[1\].x = nan"),
    (lambda: catmull_rom([(0, 0), (1e200, 0)], "chordal", tension=1e200), "inf is not finite"),
    (lambda: catmull_rom(LINE, "middle"), "parameterization = 'middle' is none of 'centripetal', 'chordal', 'uniform'"),
    (lambda: catmull_rom(LINE, [0, 1]), "parameterization has 2 values for 3 points"),
    (lambda: catmull_rom(LINE, []), "parameterization has 0 values"),
    (lambda: catmull_rom(LINE, [0, 1, 2], closed=True), "parameterization has 3 values for 4 points"),
    (lambda: catmull_rom(LINE, [0, 2, 1]), r"parameterization\[2\] = 1 does not increase"),
    (lambda: catmull_rom(LINE, [0, 1, NAN]), r"parameterization\[2\] = nan"),
    (lambda: catmull_rom(LINE, ends="loose"), "ends = 'loose'"),
    (lambda: catmull_rom(LINE, tension=NAN), r"tension(\[0\])? = nan"),
    (lambda: kochanek_bartels(LINE, bias=[0, 0, NAN]), r"bias\[2\] = nan"),
    (lambda: kochanek_bartels(LINE, continuity=[0, 0]), r"continuity has shape \(2,\) for 3 points"),
])
def test_bad_numbers_are_named(call, words):
    with pytest.raises(sc.InvalidShape, match=words):
        call()


@pytest.mark.parametrize("call, words", [
    (lambda: catmull_rom(None), "points"), (lambda: catmull_rom(LINE, None), "parameterization"),
    (lambda: catmull_rom(LINE, tension="1"), "tension"), (lambda: catmull_rom(LINE, closed=1), "closed"),
    (lambda: catmull_rom(LINE, ends=None), "ends must be a str"), (lambda: kochanek_bartels(LINE, bias=None), "bias"),
])
def test_what_is_of_another_type_raises_type_error(call, words):
    with pytest.raises(TypeError, match=words):
        call()
