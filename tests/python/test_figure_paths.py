"""Curves as paths on a page: exact where the page allows it, within the tolerance elsewhere, and cut where nothing can be seen."""

import numpy as np
import pytest

import splinecore as sc
from addon_core import core

bernstein, hiding, lines, page, paths = (core(f"figures.{name}") for name in ('bernstein', 'hiding', 'lines', 'page', 'paths'))
RANDOM = np.random.default_rng(44)
FLAT = page.around(np.array([(-1.0, -1, 0), (1, 1, 0)]), np.eye(3), 160.0, 120.0, 10.0)


def perspective(eye=(0.0, -6, 3), at=(0.0, 0, 0), near=0.1, width=160.0):
    """A Page seen from a place, as a lens of 90 degrees sees it."""
    back = (np.array(eye) - at) / np.linalg.norm(np.subtract(eye, at))
    right = np.cross((0, 0, 1), back)
    right /= np.linalg.norm(right)
    turn = np.array([right, np.cross(back, right), back])
    view = np.eye(4)
    view[:3, :3], view[:3, 3] = turn, -turn @ eye
    lens = np.array([[1.0, 0, 0, 0], [0, 1, 0, 0], [0, 0, -1.002, -0.2], [0, 0, -1, 0]])
    return page.page(lens @ view, width, 1.0, near)


def of(curve, seen=FLAT):
    return paths.of_pieces(paths.pieces_of([curve]), seen)


def steps_of(found):
    """The points of every step with the one before it, (k + 1, 2)."""
    for path in found:
        before = path.start
        for step in path.steps:
            yield np.vstack([before, step])
            before = step[-1]


def samples(found, count=50):
    at = np.linspace(0, 1, count)
    return np.concatenate([bernstein.value(step, at) for step in steps_of(found)])


def distances(points, others):
    """From each point to the nearest place on the segments between others."""
    starts, along = others[:-1], np.diff(others, axis=0)
    part = np.clip(((points[:, None] - starts) * along).sum(-1) / np.maximum((along ** 2).sum(-1), 1e-300), 0, 1)
    return np.linalg.norm(points[:, None] - starts - part[..., None] * along, axis=-1).min(axis=1)


def curves():
    knots = [0, 0, 0, 0, 1, 2, 2, 2, 2]
    return {
        'cubic': sc.BezierCurve(RANDOM.uniform(-1, 1, (4, 3))), 'quintic': sc.BezierCurve(RANDOM.uniform(-1, 1, (6, 3))),
        'spline': sc.NurbsCurve(3, knots, RANDOM.uniform(-1, 1, (5, 3))),
        'rational': sc.NurbsCurve(3, knots, RANDOM.uniform(-1, 1, (5, 3)), RANDOM.uniform(0.2, 3, 5)),
        'circle': sc.conics.circle((0, 0, 0), 0.9), 'line': sc.BezierCurve(RANDOM.uniform(-1, 1, (2, 3))),
        'Hermite': sc.HermiteCurve(RANDOM.uniform(-1, 1, (3, 3)), RANDOM.uniform(-1, 1, (3, 3))),
        'semicircle by a point at infinity': sc.BezierCurve([(0.9, 0), (0, 0.9), (-0.9, 0)], [1, 0, 1]),
    }


@pytest.mark.parametrize('degree', (1, 2, 3))
def test_a_polynomial_piece_has_exactly_its_projected_control_points(degree):
    points = RANDOM.uniform(-1, 1, (degree + 1, 3))
    (found,) = of(sc.BezierCurve(points))
    (step,) = steps_of([found])
    assert np.array_equal(step, page.places(points, FLAT))
    assert len(found.steps) == 1 and not found.closed


def test_on_this_page_a_unit_has_the_size_that_fits_the_margin():
    corners = page.places(np.array([(-1.0, -1, 5), (1, 1, -5), (0, 0, 0)]), FLAT)
    assert np.allclose(corners, [(30, 110), (130, 10), (80, 60)], atol=1e-12), "y grows downward"
    assert page.unit(FLAT, np.zeros(3)) == pytest.approx(50.0)


def test_a_spline_is_one_path_of_its_bezier_pieces():
    spline = curves()['spline']
    (found,) = of(spline)
    assert [step.shape for step in found.steps] == [(3, 2), (3, 2)]
    wanted = [page.places(piece.points, FLAT)[1:] for piece in spline.to_bezier()]
    assert all(map(np.array_equal, found.steps, wanted))


def test_a_circle_is_closed_and_within_a_hundredth_of_a_millimeter():
    (found,) = of(curves()['circle'])
    assert found.closed and len(found.steps) >= 4
    radii = np.linalg.norm(samples([found], 400) - (80, 60), axis=1)
    assert np.abs(radii - 45.0).max() <= paths.TOLERANCE


def test_a_larger_page_takes_more_pieces():
    wide = page.around(np.array([(-1.0, -1, 0), (1, 1, 0)]), np.eye(3), 1600.0, 1200.0, 100.0)
    assert len(of(curves()['circle'], wide)[0].steps) > len(of(curves()['circle'])[0].steps)


@pytest.mark.parametrize('name', curves())
@pytest.mark.parametrize('seen', (FLAT, perspective(), perspective((2, -2, 1))), ids=('parallel', 'perspective', 'near'))
def test_paths_lie_on_the_projected_curve_and_reach_all_of_it(name, seen):
    curve = curves()[name]
    found = of(curve, seen)
    at = np.linspace(*curve.domain, 200)
    wanted = page.places(curve.evaluate(at), seen)
    inside = ((wanted >= 0) & (wanted <= (seen.width, seen.height))).all(axis=1)
    assert inside.sum() > 50
    drawn = samples(found, 200)
    assert distances(wanted[inside], drawn).max() <= paths.TOLERANCE + 2e-3, "all of it is drawn"
    fine = page.places(curve.evaluate(np.linspace(*curve.domain, 2000)), seen)
    assert distances(drawn[::23], fine[np.isfinite(fine).all(1)]).max() <= paths.TOLERANCE + 2e-3, "nothing else is drawn"


def test_in_perspective_a_line_stays_a_line_and_a_cubic_across_the_view_stays_itself():
    seen = perspective((0, -6, 0))
    (straight,) = of(sc.BezierCurve([(-1, -1, 0), (1, 2, 1)]), seen)
    assert [step.shape for step in straight.steps] == [(1, 2)]
    points = RANDOM.uniform(-1, 1, (4, 3)) * (1, 0, 1)
    (flat,) = of(sc.BezierCurve(points), seen)
    assert len(flat.steps) == 1 and np.allclose(np.vstack([flat.start, *flat.steps]), page.places(points, seen), atol=paths.TOLERANCE)


def test_a_cubic_that_comes_near_in_perspective_is_split_and_smooth():
    curve = sc.BezierCurve([(-1, -4, 0), (1, 2, 1), (-1, 1, 0), (0, 4, 1)])
    found = of(curve, perspective())
    assert sum(len(path.steps) for path in found) > 2
    steps = list(steps_of(found))
    for before, after in zip(steps, steps[1:]):
        if np.array_equal(before[-1], after[0]):
            out, into = before[3] - before[2], after[1] - after[0]
            assert out @ into == pytest.approx(np.linalg.norm(out) * np.linalg.norm(into), rel=1e-6)


def test_the_bound_of_a_distance_is_one_and_not_far_above_it():
    rows = np.column_stack([RANDOM.uniform(0, 100, (4, 2)), RANDOM.uniform(0.5, 2, 4)])
    rows[:, :2] *= rows[:, 2:]
    cubic = RANDOM.uniform(0, 100, (4, 2))
    at = np.linspace(0, 1, 1000)
    values = bernstein.value(rows, at)
    largest = np.linalg.norm(values[:, :2] / values[:, 2:] - bernstein.value(cubic, at), axis=1).max()
    assert largest <= paths.distance_bound(rows, cubic) <= 20 * largest


def test_a_curve_that_is_a_point_on_the_page_is_a_dot():
    (found,) = of(sc.BezierCurve([(0, 0, -1), (0, 0, 0), (0, 0, 1)]))
    assert np.array_equal(found.start, found.end) and len(found.steps) == 1


def test_what_lies_behind_the_eye_is_left_out_and_a_line_through_it_is_cut():
    seen = perspective((0, -6, 0))
    assert of(sc.BezierCurve([(0, -8, 0), (1, -9, 0), (2, -8, 1)]), seen) == []
    assert np.isnan(page.places(np.array([(0, -8.0, 0)]), seen)).all()
    (cut,) = of(sc.BezierCurve([(0, -12, -1), (0, 0, 0.5)]), seen)
    assert np.isfinite(cut.start).all() and np.allclose(cut.end, page.places(np.array([(0, 0, 0.5)]), seen)[0])
    bent = of(sc.BezierCurve([(-1, 0, 0), (0, -14, 0.2), (1, 0, 0)]), seen)
    assert len(bent) == 2, "before the eye on both ends"


def test_what_lies_beside_the_page_is_left_out():
    assert of(sc.BezierCurve([(5, 0, 0), (6, 1, 0), (7, 0, 0), (8, 1, 0)])) == []
    assert len(of(sc.BezierCurve([(-9, 0, 0), (-1, 1, 0), (1, 1, 0), (9, 0, 0)]))) == 1


def test_a_hyperbola_is_drawn_on_both_sides_of_infinity():
    found = of(sc.BezierCurve([(-0.5, 0.5), (0, 0.2), (0.5, 0.5)], [1, -2, 1]))
    assert len(found) == 3 and all(np.isfinite(np.vstack(path.steps)).all() for path in found)


def test_a_page_without_a_size_is_refused():
    with pytest.raises(core("base.failures").Refusal, match="no size"):
        page.page(np.eye(4), 160.0, 0.0, 0.1)
    with pytest.raises(core("base.failures").Refusal, match="no size"):
        page.page(np.zeros((4, 4)), 160.0, 1.0, 0.1)


def test_the_eye_is_where_lines_of_sight_meet():
    assert np.allclose(page.eye(perspective((2, -3, 4))), (2, -3, 4, 1))
    assert np.allclose(page.eye(FLAT), (0, 0, 1, 0))


def test_positive_stretches_end_where_a_polynomial_changes_its_sign():
    assert bernstein.positive([1.0, 2, 3]) == [(0.0, 1.0)] and bernstein.positive([-1.0, -2]) == []
    ((start, end), (again, last)) = bernstein.positive([1.0, -2, 1])
    root = (3 - np.sqrt(3)) / 6
    assert (start, last) == (0.0, 1.0) and end == pytest.approx(root) and again == pytest.approx(1 - root)


def test_a_part_of_a_polynomial_is_the_same_polynomial():
    rows = RANDOM.uniform(-1, 1, (5, 3))
    at = np.linspace(0, 1, 9)
    assert np.allclose(bernstein.value(bernstein.part(rows, 0.2, 0.7), at), bernstein.value(rows, 0.2 + 0.5 * at))
    other = RANDOM.uniform(-1, 1, (3, 3))
    assert np.allclose(bernstein.value(bernstein.product(rows, other), at), bernstein.value(rows, at) * bernstein.value(other, at))


def test_a_piece_is_parted_where_it_is_hidden():
    piece = paths.homogeneous(np.array([(0.0, 0, 0), (1, 0, 0)]))
    found = hiding.stretches(piece, lambda place: not 0.3 < place[0] < 0.6)
    assert [seen for _, seen in found] == [True, False, True]
    assert [part[-1][0] for part, _ in found] == pytest.approx([0.3, 0.6, 1.0], abs=0.005)
    assert np.array_equal(found[0][0][0], piece[0]) and np.array_equal(found[-1][0][-1], piece[-1])
    ((whole, seen),) = hiding.stretches(piece, lambda place: True)
    assert seen and np.array_equal(whole, piece)


def test_patches_show_each_side_and_isocurve_once():
    left, right = (sc.BezierPatch([[(x, y, 0) for y in (0, 1)] for x in ends]) for ends in ((0, 1), (2, 1)))
    assert len(lines.sides([left, right])) == 7, "one of eight is shared"
    assert len(lines.isocurves([left], 3)) == 6 and len(lines.isocurves([left], 0)) == 0
    knots = sc.NurbsPatch((1, 1), ([0, 0, 1, 2, 2], [0, 0, 1, 1]), RANDOM.uniform(-1, 1, (3, 2, 3)))
    assert len(lines.isocurves([knots], 0)) == 1, "the one at its knot"


def test_a_periodic_patch_has_a_line_where_it_begins():
    tube = sc.build.extrude(sc.NurbsCurve(3, range(8), RANDOM.uniform(-1, 1, (7, 3)), periodic=True), (0, 0, 1))
    around = 'uv'[list(tube.periodic).index(True)]
    start = tube.isocurve(around, tube.domain['uv'.index(around)][0])
    (wanted,) = paths.pieces_of([start])
    assert any(np.allclose(piece, wanted) or np.allclose(piece, wanted[::-1]) for piece in lines.isocurves([tube], 0))
    assert len(lines.sides([tube])) == 2 * 7
