"""Rails that run against each other, sections that lie elsewhere, ends of periodic frames, and what messages say."""

import numpy as np
import pytest

import splinecore as sc
from splinecore import build, conics


def arc(radius, start, sweep):
    ends = radius * np.array([(np.cos(angle), np.sin(angle), 0.0) for angle in (start, start + sweep)])
    return conics.arc_about((0, 0, 0), *ends)


def test_curved_rails_that_run_against_each_other_are_refused(inputs):
    section = sc.BezierCurve([(0, 0, 0), (0.5, 0.3, 0), (1, 0, 0)])
    for seed in range(inputs(1000)):
        rng = np.random.default_rng([seed, 15])
        start, sweep = rng.uniform(0, 6), rng.uniform(0.2, 3.0)
        inner = rng.uniform(0.5, 2)
        first, second = arc(inner, start, sweep), arc(inner + 1.0, start + rng.uniform(-0.1, 0.1), sweep * rng.uniform(0.8, 1.1))
        width = np.linalg.norm(second.evaluate(second.domain[0]) - first.evaluate(first.domain[0]))
        fitting = section.with_points(section.points * [width, 1, 1])
        assert build.sweep_two_rails(first, second, fitting).value is not None
        with pytest.raises(sc.InvalidShape, match="against each other"):
            build.sweep_two_rails(first, second.reversed(), fitting)


def test_sections_that_touch_neither_rail_are_refused(inputs):
    for seed in range(inputs(1000)):
        rng = np.random.default_rng([seed, 16])
        scale, width = 10**rng.uniform(-6, 6), rng.uniform(0.5, 3)
        first = sc.BezierCurve(scale * np.array([(0, 0, 0), (0, 0, 5)]))
        second = sc.BezierCurve(scale * np.array([(width, 0, 0), (width, 0, 5)]))
        points = np.array([(0, 0, 0), (0.4 * width, rng.uniform(-1, 1), 0), (width, 0, 0)])
        made = build.sweep_two_rails(first, second, sc.BezierCurve(scale * points)).value
        along = first.evaluate(np.linspace(*first.domain, 5)), second.evaluate(np.linspace(*second.domain, 5))
        sides = made.evaluate_grid(made.domain[0], np.linspace(*made.domain[1], 5))
        assert np.abs(sides - along).max() < 1e-9 * scale
        away = rng.normal(size=3) * [1, 1, 0]
        away *= (2 + 2 * width) / np.linalg.norm(away)
        with pytest.raises(sc.InvalidShape, match="touches neither rail"):
            build.sweep_two_rails(first, second, sc.BezierCurve(scale * (points + away)))


def wild_rail(rng, from_, to):
    """Bent, of degrees 1 to 6, perhaps rational."""
    degree = int(rng.integers(1, 7))
    inner = np.sort(rng.uniform(0.1, 0.9, int(rng.integers(0, 4)))) if degree > 1 else np.array([])
    count = len(inner) + degree + 1
    points = np.linspace(from_, to, count)
    points[1:-1] += rng.normal(0, 0.2, (count - 2, 3))
    weights = 10**rng.uniform(-0.5, 0.5, count) if rng.random() < 0.5 else None
    return sc.NurbsCurve(degree, np.r_[[0] * (degree + 1), inner, [1] * (degree + 1)], points, weights)


def test_surfaces_are_on_both_rails_up_to_what_they_say(inputs):
    """Sections that end on both rails, that all but do, and that are elsewhere at one of them."""
    said = 0
    for seed in range(inputs(1000)):
        rng = np.random.default_rng([seed, 19])
        first = wild_rail(rng, (0, 0, 0), (0, 0, 5))
        second = wild_rail(rng, (2, 0, 0), (2 + rng.normal(0, 0.3), 0, 5))
        width = np.linalg.norm(second.evaluate(0.0) - first.evaluate(0.0))
        points = np.array([(0, 0, 0), (0.25 * width, 0.5, 0), (0.75 * width, -0.3, 0.1), (width, 0, 0)])
        kind = seed % 3
        if kind:
            points[int(rng.choice([0, 3]))] += rng.normal(size=3) * (1e-4 if kind == 1 else 1.0) * width
        scale = 10**rng.uniform(-12, 9)
        rails = [rail.transformed(scale * np.eye(3)) for rail in (first, second)]
        try:
            made, error = build.sweep_two_rails(*rails, sc.BezierCurve(scale * points), tolerance=1e-6 * scale,
                                                height=str(rng.choice(["scaled", "kept"])))
        except sc.ToleranceNotReached:
            continue
        except sc.InvalidShape as why:
            assert "touch" not in str(why), (seed, why)
            continue
        v = np.linspace(*made.domain[1], 60)
        if kind == 2:
            off = max(made.nearest(rail.evaluate(v)).distances.max() for rail in rails)
        else:
            off = max(np.linalg.norm(made.evaluate_grid([u], v)[0] - rail.evaluate(v), axis=-1).max()
                      for u, rail in zip(made.domain[0], rails))
        assert off <= 1.001 * error + 1e-11 * scale, (seed, kind, off / scale, error / scale)
        assert kind or error <= 1e-6 * scale, seed
        said += kind > 0
    assert said > 0.3 * inputs(1000)


def test_the_frame_at_the_end_of_a_periodic_curve_is_that_carried_there(inputs):
    """As that of the same curve opened, whose end is no start."""
    for seed in range(inputs(1000)):
        rng = np.random.default_rng([seed, 17])
        count = int(rng.integers(4, 9))
        turn = np.linspace(0, 2 * np.pi, count, endpoint=False)
        points = np.c_[np.cos(turn), np.sin(turn), np.zeros(count)] + rng.uniform(-0.3, 0.3, (count, 3))
        closed = sc.NurbsCurve(3, np.arange(count + 1.0), points, periodic=True)
        plain = closed.clamped()
        start = rng.normal(size=3)
        end = closed.domain[1]
        wanted = plain.frames([plain.domain[1]], start=start)
        assert np.abs(closed.frames([end], start=start) - wanted).max() < 1e-8
        assert np.abs(closed.frames([end, end], start=start, closed=True)[1] - closed.frames([closed.domain[0]], start=start)[0]).max() < 1e-7


@pytest.mark.parametrize("scale", [1e-12, 1e-6, 1.0, 1e9])
def test_a_touching_circle_is_as_right_at_any_scale(scale):
    sides = [sc.BezierCurve(scale * np.array(ends, float)) for ends in (((0, 0, 0), (4, 0, 0)), ((0, 0, 0), (0, 3, 0)), ((4, 0, 0), (0, 3, 0)))]
    _, center, radius, _ = build.touching_circle(*sides, (0.3, 0.3, 0.5))
    assert radius == pytest.approx(scale, rel=1e-12) and center == pytest.approx((scale, scale, 0), rel=1e-12)
    with pytest.raises(TypeError):
        build.touching_circle(*sides, near=(0.3, 0.3, 0.5))


def test_messages_say_what_is_so():
    rectangle = build.contour([(0, 0), (4, 0), (4, 2), (0, 2)], closed=True)
    with pytest.raises(sc.InvalidShape, match="no place is as far from all of the curve"):
        rectangle.offset(1.5, trimmed=True)
    sharp = np.radians(169)
    bent = build.contour([(0, 0, 0), (4, 0, 0), (4 + 4 * np.cos(sharp), 4 * np.sin(sharp), 0)])
    with pytest.raises(sc.InvalidShape, match="turns by 169 degrees"):
        build.sweep(bent, conics.circle((0, 0, 0), 0.1))
    with pytest.raises(sc.InvalidShape, match="a radius of 1 at"):
        build.offset_patch(build.sphere((0, 0, 0), 1.0), -1.0)
