"""Points of a net that are put onto others take their digits, so that what is made of them is what it looks like."""

import numpy as np
import pytest

import splinecore as sc
from addon_core import core

net_of, exact_net, definitions, snapped = core("net.curve_net"), core("net.exact_net"), core("shape.definition"), core("net.snapped")

POINTS = np.array([(0, 0, 0), (1 / 3, 0.7, 0.1), (1.1, 0.1, 1 / 7), (1.9, 0.9, 0.3), (2.3, 0.2, 0), (3.1, 0.6, 0.2), (4 / 3, 2.2, 0.7)])


def net_of_curve(points=POINTS):
    return net_of.make(definitions.from_value(sc.NurbsCurve(3, np.arange(len(points) + 4.0), points)))


def as_blender_puts(places, point, onto, turn=np.eye(3)):
    """A point is moved onto another by the way there, in single precision and through the axes of its object."""
    turn = turn.astype(np.float32)
    way = turn @ places[onto] - turn @ places[point]
    places[point] += np.linalg.inv(turn).astype(np.float32) @ way


def moved(net, *pairs, turn=np.eye(3)):
    places = net.single.copy()
    for point, onto in pairs:
        as_blender_puts(places, point, onto, turn)
    return exact_net.exact(net, places, net.single_weights)


def turned(rng):
    axes, _ = np.linalg.qr(rng.normal(size=(3, 3)))
    return axes


@pytest.mark.parametrize('seed', range(60))
@pytest.mark.parametrize('size', (1e-3, 1.0, 250.0))
def test_a_point_takes_the_digits_of_the_one_on_which_it_was_put(seed, size):
    rng = np.random.default_rng(seed)
    net = net_of_curve(size * (POINTS + rng.uniform(-0.1, 0.1, POINTS.shape)))
    point, onto = rng.choice(len(POINTS), 2, replace=False)
    state = moved(net, (point, onto), turn=turned(rng))
    assert (state.positions[point] == net.positions[onto]).all() and not state.kept[point]
    others = np.delete(np.arange(len(POINTS)), point)
    assert (state.positions[others] == net.positions[others]).all() and state.kept[others].all()


@pytest.mark.parametrize('pairs', ([(1, 2), (3, 2)], [(2, 3), (1, 2)], [(3, 2), (1, 3)]))
def test_a_tripled_point_is_a_corner(pairs):
    net = net_of_curve()
    curve = definitions.to_value(exact_net.read(net, moved(net, *pairs)))
    assert (curve.points[1:4] == curve.points[2]).all()
    found = curve.continuity(curve.knots[4])
    assert found.g == 0 and found.angle > 0.2


def test_points_put_onto_one_that_moved_itself_are_one_with_it():
    net, places = net_of_curve(), net_of_curve().single.copy()
    places[2] += np.float32(0.123)
    for point in (1, 3):
        as_blender_puts(places, point, 2, turned(np.random.default_rng(1)))
    state = exact_net.exact(net, places, net.single_weights)
    assert (state.positions[1:4] == state.positions[1]).all()
    assert np.abs(state.positions[2] - places[2]).max() <= 1e-6


@pytest.mark.parametrize('far', (0.0, 1.0, 1e3))
def test_small_shapes_far_from_the_origin_and_small_moves_stay_as_they_are(far):
    """Neighbors are apart by little more than the steps of single precision."""
    rng = np.random.default_rng(3)
    points = (far + max(far, 1.0) * 2e-6 * rng.integers(-4, 5, (40, 3))).astype(np.float32)
    net = net_of_curve(points.astype(float))
    for way in (0.0, 0.25, 1e-6):
        places = net.single + np.float32(way * max(far, 1.0))
        state = exact_net.exact(net, places, net.single_weights)
        assert (state.positions.astype(np.float32) == places).all()


def test_typed_numbers_come_before_the_digits_of_others():
    net = net_of_curve()
    places = net.single.copy()
    places[1] = net.single[2]
    typed = net.positions[2] + 1e-9
    state = exact_net.exact(net, places, net.single_weights, [(1, *typed, 1.0)])
    assert (state.positions[1] == typed).all()


@pytest.mark.parametrize('seed', range(40))
def test_targets_are_those_that_all_pairs_give(seed):
    rng = np.random.default_rng(seed)
    before = rng.uniform(-3, 3, (60, 3)).astype(np.float32).astype(float)
    now, moved_points = before.copy(), np.sort(rng.choice(60, rng.integers(1, 30), replace=False))
    for point in moved_points:
        now[point] = now[rng.integers(60)] * (1 + rng.choice([0, 1e-7, 1e-6, 1e-2]) * rng.uniform(-1, 1, 3))
    now = now.astype(np.float32).astype(float)
    found = dict(snapped.targets(before, now, moved_points, snapped.Order(before)))
    for point in moved_points:
        radius = 4 * np.finfo(np.float32).eps * max(np.abs(now[point]).max(), np.abs(before[point]).max())
        near = [other for other in range(60) if (ways := np.abs(now[point] - now[other]).max()) == 0 or ways <= radius
                and np.abs(before[point] - before[other]).max() > 1000 * radius]
        stay = [other for other in near if other not in moved_points]
        earlier = [other for other in near if other in moved_points and other < point and (now[point] != now[other]).any()]
        assert found.get(point) == next(iter(stay or earlier), None)


def test_so_many_points_that_come_together_are_not_compared_with_all_others():
    places = np.random.default_rng(5).uniform(-1, 1, (20_000, 3)).astype(np.float32).astype(float)
    order, every = snapped.Order(places), np.arange(len(places))
    for now in (np.float32(places + 0.5).astype(float), np.zeros_like(places), np.full_like(places, np.nan)):
        assert not snapped.targets(places, now, every, order)
    assert snapped.targets(places, np.where(every[:, None] == 7, places[9], places), np.array([7]), order) == [(7, 9)]
