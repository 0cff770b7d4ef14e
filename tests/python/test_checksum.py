"""The add-on's checksum of positions: no edit that a user makes of a mesh leaves it as it was."""

import numpy as np
import pytest

from addon_core import core

checksum = core('base.checksum')


def grid(count):
    side = int(np.ceil(np.sqrt(count)))
    x, y = np.meshgrid(np.arange(side), np.arange(side), indexing='ij')
    return np.stack([x.ravel(), y.ravel(), np.ones(side * side)], -1)[:count]


SHAPES = {
    'all equal': lambda count: np.ones((count, 3)),
    'grid': grid,
    'grid about the origin': lambda count: grid(count) - grid(count).mean(0).round(),
    'cylinder': lambda count: np.stack([np.cos(grid(count)[:, 0]), np.sin(grid(count)[:, 0]), grid(count)[:, 1]], -1),
    'random': lambda count: np.random.default_rng(count).normal(size=(count, 3)),
}


def of_many(points):
    """Edits of all vertices, of half of them, of some."""
    count = len(points)
    for axis in range(3):
        for some in (slice(None), slice(count // 2), slice(2), slice(-2, None), slice(0, None, 2)):
            for factor in (-1, 2, 0.5, -2, 0, 1024):
                edited = points.copy()
                edited[some, axis] *= factor
                yield edited
            for step in (1, -1, 0.25, 1e-3):
                edited = points.copy()
                edited[some, axis] += step
                yield edited
        for step in (1, 0.25, 1e-3):
            for one, other in ((0, -1), (slice(0, None, 2), slice(1, None, 2))):
                edited = points.copy()
                edited[one, axis] += step
                edited[other, axis] -= step
                yield edited
    yield from (points[:, order].copy() for order in ([1, 0, 2], [0, 2, 1], [2, 1, 0], [1, 2, 0]))
    yield from (points[::-1].copy(), -points, np.roll(points, 1, 0), np.roll(points.ravel(), 1).reshape(-1, 3))


def of_two(points, random):
    """Edits of two vertices that could cancel."""
    one, other = random.choice(len(points), 2, replace=False)
    for axis in (0, 1, 2, slice(None)):
        for factors in ((-1, -1), (2, 0.5), (2, 2), (-2, -2)):
            edited = points.copy()
            edited[one, axis] *= factors[0]
            edited[other, axis] *= factors[1]
            yield edited
    swapped, turned = points.copy(), points.copy()
    swapped[[one, other]] = points[[other, one]]
    yield swapped
    turned[[one, other]] = points[[one, other]][:, [1, 0, 2]]
    yield turned


@pytest.mark.parametrize('name', SHAPES)
@pytest.mark.parametrize('count', (2, 3, 9, 32, 100, 3001))
def test_an_edit_of_a_mesh_gives_another_checksum(name, count):
    points, random = SHAPES[name](count).astype(np.float32), np.random.default_rng(count)
    known, tried = checksum.of(points.ravel()), 0
    assert known < 2 ** 52
    edits = [*of_many(points), *(edited for _ in range(25) for edited in of_two(points, random))]
    for edited in edits:
        is_other = edited.tobytes() != points.tobytes()
        assert (checksum.of(edited.ravel()) != known) == is_other
        tried += is_other
    assert tried > 100


@pytest.mark.parametrize('bits', [(bit,) for bit in range(64)] + [(31, 63), (0, 32), (23, 55), (30, 31, 62, 63)])
def test_no_two_places_cancel_where_the_same_bits_flip(bits):
    """All pairs of 500 places: of each the amount by which the sum changes."""
    flipped = np.bitwise_or.reduce(np.uint64(1) << np.array(bits, np.uint64))
    for value in (0, 0x3F8000003F800000):
        pair = np.array([value], np.uint64)
        factors = checksum._factors(500)
        changes = [checksum._sum(pair ^ flipped, factors[i:i + 1]) - checksum._sum(pair, factors[i:i + 1]) for i in range(500)]
        shown = {change % 2 ** 64 >> 12 for change in changes}
        assert len(shown) == len(changes) and shown.isdisjoint(-change % 2 ** 64 >> 12 for change in changes)


@pytest.mark.parametrize('block', (1, 4, 4096))
@pytest.mark.parametrize('count', (0, 1, 2, 7, 8, 9, 8191, 8192, 8193, 30_001))
def test_a_checksum_that_is_kept_is_that_of_all_numbers(count, block, monkeypatch):
    random = np.random.default_rng(count)
    room = checksum.room(count)
    numbers = room[:count]
    numbers[:] = random.normal(size=count)
    known = checksum.of(numbers)            # in blocks of the usual size
    monkeypatch.setattr(checksum, '_BLOCK', block)
    kept = checksum.Kept(room)
    assert kept.value() == checksum.of(numbers) == known
    for step in range(20):
        if step % 3 == 0:
            chosen = np.arange(*sorted(random.integers(0, count + 1, 2).tolist()))
            chosen = chosen if step % 2 else chosen[random.random(len(chosen)) < 0.3]
            places = kept.places(chosen)
        kept.writes(places)
        numbers[chosen] = random.normal(size=len(chosen))
        kept.wrote()
        assert kept.value() == checksum.of(numbers)


def test_places_that_have_some_in_common_are_read_again():
    numbers = np.random.default_rng(2).normal(size=40).astype(np.float32)
    kept, step = checksum.Kept(numbers), 0
    every = [(chosen, kept.places(chosen)) for chosen in ([0, 1, 7], [6, 7, 8, 9], [39], [])]
    for chosen, places in (*every, *every[::-1], *every[:2]):
        step += 1
        kept.writes(places)
        numbers[np.array(chosen, int)] += step
        kept.wrote()
        assert kept.value() == checksum.of(numbers)


@pytest.mark.parametrize('count', (1, 2, 9, 8193))
def test_each_bit_of_each_number_counts(count):
    numbers = np.random.default_rng(count).normal(size=count).astype(np.float32)
    known = checksum.of(numbers)
    for place in {0, count // 2, count - 1}:
        for bit in range(32):
            edited = numbers.copy()
            edited.view(np.uint32)[place] ^= np.uint32(1 << bit)
            assert checksum.of(edited) != known
    assert checksum.of(numbers[:-1]) != known
