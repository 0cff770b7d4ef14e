"""The add-on's positions of a dragged patch set and their checksum: the same as of all of them made anew."""

import numpy as np
import pytest

import splinecore as sc
from addon_core import core
from test_local_updates import CASES, MESHES, set_of

checksum, moved_positions = core('base.checksum'), core('shape.moved_positions')


def require_as_anew(moved, faces, patch_set):
    anew = faces.evaluate_positions(patch_set)
    assert moved.positions.tobytes() == anew.tobytes()
    assert moved.checksum() == checksum.of(anew.reshape(-1))


@pytest.mark.parametrize('block', (4, 4096))
@pytest.mark.parametrize('name,how', CASES)
def test_what_a_drag_leaves_has_the_positions_and_the_checksum_of_the_whole(name, how, block, monkeypatch):
    monkeypatch.setattr(checksum, '_BLOCK', block)      # small ones, so that there are many
    before, random = set_of(name), np.random.default_rng(5)
    faces = MESHES[how](before)
    moved = moved_positions.MovedPositions(faces, before)
    require_as_anew(moved, faces, before)
    points, weights = before.points.copy(), before.weights.copy()
    for step in range(18):
        if step % 3 == 0:
            rows = random.choice(len(points), (1, 2)[step % 2], replace=False)
        points[rows] += random.normal(0, 1e-3 if step % 2 else 0.2, (len(rows), 3))
        if step in (8, 11) and (weights > 0).all():
            weights[rows if step == 11 else random.integers(len(weights))] *= 1.5     # of others than moved
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

    def summing(pairs, factors, work=checksum._sum):
        summed.append(len(pairs))
        return work(pairs, factors)
    monkeypatch.setattr(checksum, '_sum', summing)
    for step in range(3):
        points[0] += (0, 0, 0.1)
        moved.move(made.with_points(points))
    monkeypatch.undo()
    require_as_anew(moved, faces, made.with_points(points))
    assert len(summed) == 4 and 0 < max(summed) < 3 * faces.vertex_count / 8     # twice the first time


def test_a_weight_of_a_row_that_stays_counts():
    """Its vertices move, where no point does."""
    made = set_of('rational')
    faces, weights = sc.Tessellation(made, 9), made.weights.copy()
    moved = moved_positions.MovedPositions(faces, made)
    known = moved.checksum()
    for row, factor in ((0, 2), (50, 3), (107, 0.25)):
        points = made.points.copy()
        points[20] += (0, 0, 1)
        weights[row] *= factor
        for after in (made.with_points(made.points, weights), made.with_points(points, weights), made):
            moved.move(after)
            require_as_anew(moved, faces, after)
            assert (moved.checksum() == known) == (after is made)


class FailingFaces:
    """Faces that cannot be evaluated once, and write of what they can."""

    def __init__(self, faces):
        self.vertex_count, self._faces, self.fails = faces.vertex_count, faces, False

    def evaluate_positions(self, *arguments, out, **named):
        if self.fails:
            out[:5] = 7
            raise MemoryError
        return self._faces.evaluate_positions(*arguments, out=out, **named)


def test_what_could_not_be_evaluated_leaves_no_checksum_behind():
    made = set_of('sheet')
    faces, points = sc.Tessellation(made, 3), made.points.copy()
    failing = FailingFaces(faces)
    moved = moved_positions.MovedPositions(failing, made)
    moved.checksum()
    for fails in (False, True, False):
        points[7] += (0, 0, 1)
        failing.fails = fails
        if fails:
            with pytest.raises(MemoryError):
                moved.move(made.with_points(points))
        else:
            moved.move(made.with_points(points))
            require_as_anew(moved, faces, made.with_points(points))


@pytest.mark.parametrize('count', (2, 3))
def test_an_odd_number_of_coordinates_is_summed_where_it_lies(count, monkeypatch):
    made = sc.PatchSet.from_patches([sc.BezierPatch(np.random.default_rng(1).normal(size=(3, 3, 3)))])
    faces = sc.Tessellation(made, (2, count))
    assert 3 * faces.vertex_count == {2: 27, 3: 36}[count]
    moved = moved_positions.MovedPositions(faces, made)
    require_as_anew(moved, faces, made)

    def copied(*_):
        raise AssertionError("all positions were copied")
    points = made.points.copy()
    points[0] += 1
    moved.move(made.with_points(points))
    expected = checksum.of(faces.evaluate_positions(made.with_points(points)).reshape(-1))
    monkeypatch.setattr(np, 'append', copied)
    assert moved.checksum() == expected
