"""The add-on's positions of a dragged patch set and their checksum: the same as of all of them made anew."""

import numpy as np
import pytest

import splinecore as sc
from addon_core import core
from test_local_updates import CASES, MESHES, set_of

checksum, moved_positions = core('checksum'), core('moved_positions')


def require_as_anew(moved, faces, patch_set):
    anew = faces.evaluate_positions(patch_set)
    assert moved.positions.tobytes() == anew.tobytes()
    assert moved.checksum() == checksum.of(anew.reshape(-1))


@pytest.mark.parametrize('name,how', CASES)
def test_what_a_drag_leaves_has_the_positions_and_the_checksum_of_the_whole(name, how):
    before, random = set_of(name), np.random.default_rng(5)
    faces = MESHES[how](before)
    moved = moved_positions.MovedPositions(faces, before)
    require_as_anew(moved, faces, before)
    points, weights = before.points.copy(), before.weights.copy()
    for step in range(18):
        if step % 3 == 0:
            rows = random.choice(len(points), (1, 2)[step % 2], replace=False)
        points[rows] += random.normal(0, 1e-3 if step % 2 else 0.2, (len(rows), 3))
        if step == 11 and (weights > 0).all():
            weights[rows] *= 1.5
        after = before.with_points(points, weights)
        if not moved.fits(after):
            return                      # sides have come apart: there are other faces then
        moved.move(after)
        if step != 7:                   # not asked at every step
            require_as_anew(moved, faces, after)


def test_numbers_that_come_to_be_the_same_again_are_found_in_what_was_written():
    """Rows that move a little first and far next, or back to where they were."""
    made = set_of('sheet')
    faces, points = sc.Tessellation(made, (2, 5)), made.points.copy()
    moved = moved_positions.MovedPositions(faces, made)
    moved.checksum()
    for size in (5e-324, 1e-17, 1e-9, 1e3, -1e3, 0.0):
        points[[100, 120], 2] = size
        moved.move(made.with_points(points))
        require_as_anew(moved, faces, made.with_points(points))


def test_a_drag_sums_what_moved_alone(monkeypatch):
    made = set_of('sheet')
    faces, points = sc.Tessellation(made, 60), made.points.copy()
    moved = moved_positions.MovedPositions(faces, made)
    moved.checksum()
    summed = []

    def add(self, numbers, first, end, work=checksum.Kept._add):
        summed.append(end - first)
        work(self, numbers, first, end)
    monkeypatch.setattr(checksum.Kept, '_add', add)
    for step in range(3):
        points[0] += (0, 0, 0.1)
        moved.move(made.with_points(points))
        require_as_anew(moved, faces, made.with_points(points))
    blocks = -(-3 * faces.vertex_count // 8192)
    assert len(summed) == 3 and 0 < max(summed) < blocks / 4


@pytest.mark.parametrize('count', (0, 1, 2, 8191, 8192, 8193, 30_001))
def test_a_checksum_that_is_kept_is_that_of_all_numbers(count):
    random = np.random.default_rng(count)
    numbers = random.normal(size=count).astype(np.float32)
    kept = checksum.Kept(numbers)
    assert kept.value() == checksum.of(numbers) < 2 ** 52
    for _ in range(20):
        first, end = sorted(random.integers(0, count + 1, 2).tolist())
        numbers[first:end] = random.normal(size=end - first)
        kept.wrote(numbers, first, end)
        assert kept.value() == checksum.of(numbers)
    if count:
        before = checksum.of(numbers)
        numbers[count // 2] = np.nextafter(numbers[count // 2], np.float32(9))
        assert checksum.of(numbers) != before
