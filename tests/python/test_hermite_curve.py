"""HermiteCurve: chains of cubics (row S4)."""

import numpy as np

import splinecore as sc
from shapes import hermite_chain, random_points


def test_one_segment_is_the_lectures_matrix():
    points, tangents = random_points(2, 2, seed=1)
    t = np.linspace(0, 1, 21)
    matrix = np.array([[2, 1, -2, 1], [-3, -2, 3, -1], [0, 1, 0, 0], [1, 0, 0, 0]])
    rows = np.array([points[0], tangents[0], points[1], tangents[1]])
    expected = np.stack([t**3, t**2, t, np.ones(21)], axis=1) @ matrix @ rows
    assert np.abs(sc.HermiteCurve(points, tangents).evaluate(t) - expected).max() <= 2e-15


def test_chain_passes_through_its_points_with_its_tangents():
    chain = hermite_chain()
    values = chain.derivatives(chain.parameters, 1)
    assert np.abs(values[:, 0] - chain.points).max() <= 1e-15
    assert np.abs(values[:, 1] - chain.tangents[:, 1]).max() <= 1e-14


def test_two_tangents_at_a_point_are_a_corner():
    tangents = np.zeros((3, 2, 3))
    tangents[:, 0] = (1, 0, 0)
    tangents[:, 1] = (0, 1, 0)
    chain = sc.HermiteCurve([(0, 0), (1, 0), (2, 0)], tangents)
    assert chain.derivatives(1, 1)[1].tolist() == [0, 1, 0]
    assert chain.derivatives(1, 1, side="left")[1].tolist() == [1, 0, 0]
    assert chain.tangents.tolist() == tangents.tolist()


def test_properties_are_what_was_given():
    chain = hermite_chain()
    assert chain.degree == 3 and chain.domain == (0, 3.5) and not chain.is_rational
    assert chain.parameters.tolist() == [0, 1, 3, 3.5]
    assert chain.points.shape == (4, 3) and chain.tangents.shape == (4, 2, 3)
    assert sc.HermiteCurve(chain.points, chain.tangents).parameters.tolist() == [0, 1, 2, 3]
    assert chain.pieces() == [(0, 3.5)]
    assert len(chain.polylines(4)[0][0]) == 13


def test_other_forms_are_the_same_curve():
    chain = hermite_chain()
    u = np.linspace(0, 3.5, 50)
    assert np.array_equal(chain.to_nurbs().evaluate(u), chain.evaluate(u))
    assert len(chain.to_bezier()) == 3
    again = chain.to_nurbs().to_hermite()
    assert np.abs(again.evaluate(u) - chain.evaluate(u)).max() <= 2e-14


def test_split_and_reversed_keep_the_curve():
    chain = hermite_chain()
    before, after = chain.split(1.25)
    assert before.domain == (0, 1.25) and after.domain == (1.25, 3.5)
    assert np.abs(before.evaluate([0.1, 1.2]) - chain.evaluate([0.1, 1.2])).max() <= 2e-15
    assert np.abs(after.evaluate([1.3, 3]) - chain.evaluate([1.3, 3])).max() <= 4e-15
    turned = chain.reversed()
    assert np.abs(turned.evaluate([0, 1, 2.5]) - chain.evaluate([3.5, 2.5, 1])).max() <= 4e-15
