"""How far points lie from exact shapes, against closed forms: near and far, large and small, across seams and at ends."""

import numpy as np
import pytest
import splinecore as sc
from addon_core import core

deviations, faces, lengths, measuring = (core(name) for name in (
    'analysis.deviations', 'analysis.faces', 'base.length_units', 'analysis.measuring'))
all_at_once = measuring.all_at_once
distances = deviations.distances_to


def points(count=400, seed=5):
    return 2 * np.random.default_rng(seed).normal(size=(count, 3))


@pytest.mark.parametrize('size', (1e-150, 1e-20, 1.0, 1e20, 1e150))
def test_a_sphere_is_as_far_as_its_radius_says_at_every_size(size):
    found = distances([sc.build.sphere((0, 0, 0), 2 * size)], points() * size)
    assert np.abs(found / size - np.abs(np.linalg.norm(points(), axis=1) - 2)).max() < 1e-14


@pytest.mark.parametrize('middle', ((0, 0, 0), (1e6, -2e6, 3e6)))
def test_a_torus_is_too_across_both_its_seams_and_far_from_the_origin(middle):
    at = points(3000)
    found = distances([sc.build.torus(middle, (0, 0, 1), 3.0, 1.0)], at + middle)
    wanted = np.abs(np.hypot(np.hypot(at[:, 0], at[:, 1]) - 3, at[:, 2]) - 1)
    assert np.abs(found - wanted).max() < 1e-14 + 1e-14 * np.abs(middle).max()


def test_points_on_a_surface_are_no_distance_from_it():
    patch = sc.NurbsPatch((3, 2), ([0, 0, 0, 0, 1, 2, 2, 2, 2], [0, 0, 0, 1, 1, 1]),
                          np.random.default_rng(2).uniform(size=(5, 3, 3)) + np.stack(
                              np.meshgrid(range(5), range(3), [0], indexing='ij'), -1)[:, :, 0])
    at = patch.evaluate_grid(np.linspace(0, 2, 23), np.linspace(0, 1, 17)).reshape(-1, 3)
    assert distances([patch], at).max() < 1e-13


def test_where_a_patch_ends_the_border_is_nearest_and_beside_it_the_next_patch():
    def plane(x):
        return sc.BezierPatch([[(x, 0, 0), (x, 1, 0)], [(x + 1, 0, 0), (x + 1, 1, 0)]])
    at = np.array([(-1, 0.3, 0.5), (3, 2, 0), (0.999999, 0.5, 2), (1.000001, 0.5, 2), (1.2, 0.2, 0)])
    found = distances([plane(0), plane(1)], at)
    assert np.allclose(found, [np.hypot(1, 0.5), np.hypot(1, 1), 2, 2, 0], atol=1e-15)


def test_pieces_of_a_circle_are_as_far_beside_their_seam():
    halves = [sc.BezierCurve([(2, 0), (2, 2), (0, 2)], [1, np.sqrt(0.5), 1]),
              sc.BezierCurve([(0, 2), (-2, 2), (-2, 0)], [1, np.sqrt(0.5), 1])]
    at = np.array([(-0.05, 3.0, 0.0), (0.05, 3.0, 0.0)])
    assert np.allclose(distances(halves, at), np.linalg.norm(at, axis=1) - 2, atol=1e-14)


def test_curves_are_as_far_as_their_circle():
    quarter = sc.BezierCurve([(2, 0), (2, 2), (0, 2)], [1, np.sqrt(0.5), 1])
    at = np.abs(points())
    found = distances([quarter], at)
    assert np.abs(found - np.hypot(np.hypot(at[:, 0], at[:, 1]) - 2, at[:, 2])).max() < 1e-14


def test_degenerate_pieces_give_numbers():
    point = sc.BezierPatch(np.ones((3, 3, 3)))
    assert np.allclose(distances([point], np.array([(1, 1, 3.0)])), 2)
    halt = sc.BezierCurve([(0, 0), (0, 0), (1, 0)])
    assert np.allclose(distances([halt], np.array([(-1, 0, 0), (0.5, 1, 0)])), 1)


def test_where_a_distance_is_no_number_the_others_are_known():
    line = sc.BezierCurve([(-1, 0), (1, 0)])
    at = np.array([(0, 1, 0), (1.5e308, 1.5e308, 0), (0, 2, 0), (3, 0, 0)])
    assert np.array_equal(distances([line], at), [1, np.nan, 2, 2], equal_nan=True)


def over_faces(values, positions, triangles):
    return deviations.over_faces(values, triangles, *deviations.areas(positions, triangles))


def sheet():
    return sc.NurbsPatch((2, 1), ([0, 0, 0, 1, 2, 2, 2], [0, 0, 1, 1]),
                         [[(x, y, 0) for y in (0, 1)] for x in (0, 0.5, 1.5, 2)])


def height(points):
    """From a plane that leans."""
    return np.abs(points[:, 2] + 0.5 * points[:, 0])


@pytest.mark.parametrize('most, error', ((10**6, 1e-7), (100, 1e-2)))
def test_a_sheet_has_its_heights_by_all_places_or_few(most, error):
    patch_set = sc.PatchSet.from_patches([sheet()])
    shown, places = faces.placed(sc.Tessellation(patch_set, 12), patch_set)
    calls = []

    def counted(at):
        calls.append(len(at))
        return height(at)
    values = all_at_once(deviations.at_places(patch_set, places, most), counted)
    assert np.abs(values - 0.5 * shown.positions[:, 0]).max() < error
    assert most == 10**6 or sum(calls) <= 121
    summed = over_faces(values, shown.positions, shown.triangles)
    assert summed.largest == pytest.approx(1, abs=error) and summed.mean == pytest.approx(0.5, abs=error)
    assert summed.extent == pytest.approx(2)


@pytest.mark.parametrize('size', (1e-150, 1.0, 1e150))
def test_means_are_of_areas_and_never_run_out_of_range(size):
    positions = np.array([(0, 0, 0), (3, 0, 0), (0, 1, 0), (100, 0, 0), (101, 0, 0), (100, 1, 0)]) * size
    found = over_faces(np.array([1, 1, 1, 4, 4, 4]) * size, positions, np.array([[0, 1, 2], [3, 4, 5]]))
    assert found.largest == 4 * size and found.mean / size == pytest.approx(7 / 4)


def test_what_has_no_distance_does_not_count_and_nothing_has_no_mean():
    positions = np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0.0)])
    triangles = np.array([[0, 1, 2], [1, 3, 2]])
    found = over_faces(np.array([1, 1, 1, np.nan]), positions, triangles)
    assert (found.largest, found.mean) == (1, 1)
    none = over_faces(np.full(4, np.nan), positions, triangles)
    assert np.isnan(none.largest) and np.isnan(none.mean)
    flat = over_faces(np.ones(4), np.zeros((4, 3)), triangles)
    assert (flat.largest, flat.mean) == (1, 1)
    zero = over_faces(np.zeros(4), positions, triangles)
    assert (zero.largest, zero.mean) == (0, 0)
    empty = np.empty((0, 2, 3))
    assert np.isnan(deviations.over_lines(all_at_once(deviations.along_lines(empty, 10), height), empty).largest)


@pytest.mark.parametrize('most', (4, 10, 1000))
def test_lines_have_the_heights_of_their_ends_and_gaps_stay_gaps(most):
    x = np.linspace(0, 1, 101)
    line = np.stack([x, 0 * x, 0 * x], -1)
    one = np.stack([line[:-1], line[1:]], 1)
    pairs = np.concatenate([one, one + (5, 0, 0)])
    found = all_at_once(deviations.along_lines(pairs, most), height)
    assert np.allclose(found, 0.5 * pairs[:, :, 0], atol=1e-12)
    summed = deviations.over_lines(found, pairs)
    assert summed.largest == pytest.approx(3) and summed.mean == pytest.approx(1.5) and summed.extent == pytest.approx(2)


def test_several_have_the_mean_of_all_their_area():
    some = [deviations.Deviation(None, 2.0, 1.0, 3.0), deviations.Deviation(None, 8.0, 5.0, 1.0)]
    assert deviations.over_all(some) == (8.0, 2.0)
    assert deviations.over_all([deviations.Deviation(None, 0.0, 0.0, 0.0)]) == (0.0, 0.0)


@pytest.mark.parametrize('length, system, wanted, scale, text', (
    (2.0, 'METRIC', 'ADAPTIVE', 1.0, "2 m"), (0.0123, 'METRIC', 'ADAPTIVE', 1.0, "1.23 cm"),
    (2.0, 'METRIC', 'ADAPTIVE', 0.001, "2 mm"), (2.0, 'METRIC', 'MILLIMETERS', 1.0, "2e+03 mm"),
    (1e-150, 'METRIC', 'ADAPTIVE', 1.0, "1e-144 µm"), (1e150, 'METRIC', 'ADAPTIVE', 1.0, "1e+147 km"),
    (0.3048, 'IMPERIAL', 'ADAPTIVE', 1.0, "1 ft"), (0.0254, 'IMPERIAL', 'THOU', 1.0, "1e+03 thou"),
    (0.125, 'NONE', 'ADAPTIVE', 7.0, "0.125"), (0.0, 'METRIC', 'ADAPTIVE', 1.0, "0 µm"),
    (1.0, 'METRIC', 'FEET', 1.0, "1 m")))
def test_lengths_are_said_in_the_units_of_the_scene(length, system, wanted, scale, text):
    assert lengths.text(length, lengths.unit_for(length, system, wanted, scale)) == text


def test_what_is_measured_a_part_at_a_time_is_what_is_measured_at_once():
    patch_set = sc.PatchSet.from_patches([sheet()])
    _, places = faces.placed(sc.Tessellation(patch_set, 40), patch_set)
    plan = deviations.at_places(patch_set, places, 5000)
    some = measuring.Measuring(plan, height)
    shares = [some.share]
    while not some.go_on(1e-5):
        shares.append(some.share)
    assert shares[0] == 0.0 and some.share == 1.0 and len(shares) > 2 and (np.diff(shares) > 0).all()
    assert np.array_equal(some.values(), all_at_once(plan, height))
    assert measuring.Measuring(deviations.along_lines(np.empty((0, 2, 3)), 10), height).share == 1.0
