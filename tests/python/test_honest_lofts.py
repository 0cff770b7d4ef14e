"""What a loft says of itself: how far it is from its sections, however far it runs between them; and lofts that would be too large."""

import time

import numpy as np
import pytest

import splinecore as sc
from splinecore import build


def open_section(rng, place, out, spans, weights=None):
    points = place + rng.uniform(-1, 1, (spans + 3, 1)) * out + rng.uniform(-1, 1, (spans + 3, 1)) * np.array([0, 0, 1.0])
    return sc.NurbsCurve(3, np.r_[[0] * 4, np.arange(1, spans) / spans, [1] * 4], points, weights)


def random_loft(seed):
    rng = np.random.default_rng([seed, 13])
    count, closed, scale = int(rng.integers(3, 20)), bool(rng.random() < 0.5), 10**rng.uniform(-12, 9)
    sections = []
    for i in range(count):
        angle = 2 * np.pi * i / count
        out = np.array([np.cos(angle), np.sin(angle), 0])
        spans = int(rng.integers(1, 4))
        weights = 10**rng.uniform(-0.2, 0.2, spans + 3) if seed % 5 == 0 else None
        sections.append(open_section(rng, 10 * out, out, spans, weights).transformed(np.diag([scale] * 3 + [1.0])))
    steps = 10**rng.uniform(-rng.choice([0, 1, 3, 6]), 0, count if closed else count - 1)
    options = {'align': False, 'closed': closed, 'degree': int(rng.integers(1, 16)), 'parameters': np.r_[0, np.cumsum(steps)]}
    for end in ('start', 'end'):
        if not closed and options['degree'] > 2 and rng.random() < 0.5:
            options[f"{end}_tangent"] = rng.normal(size=3) * 10**rng.uniform(-3, 3)
    return sections, options, scale


def test_how_far_a_surface_misses_its_sections_is_said(inputs):
    """Splines of high degrees through uneven places run so far away that rounding is no longer small."""
    made_count = said_count = 0
    for seed in range(inputs(1000)):
        sections, options, scale = random_loft(seed)
        try:
            made = build.loft(sections, **options)
        except sc.InvalidShape as error:
            assert "run off" in str(error) or "weights" in str(error), seed
            continue
        made_count += 1
        said_count += made.error > 0
        along = np.linspace(0, 1, 33)
        (start, end), _ = made.value.domain
        for section, v in zip(sections, options['parameters']):
            found = made.value.evaluate_grid(start + along * (end - start), [v]).reshape(-1, 3)
            missed = np.linalg.norm(found - section.evaluate(along), axis=1).max()
            assert missed <= made.error + 1e-10 * scale, seed
            assert made.error <= 2e-5 * scale, seed
    assert said_count > 0 and made_count > said_count


def test_a_surface_that_would_miss_its_sections_is_refused():
    sections, options, _ = random_loft(4)
    rng = np.random.default_rng(0)
    sections = [sc.BezierCurve(np.c_[[0, 1, 2], rng.uniform(0, 1, 3), [z] * 3]) for z in range(12)]
    with pytest.raises(sc.InvalidShape, match="run off.*lower degree"):
        build.loft(sections, degree=11, parameters=np.r_[np.arange(6) * 1e-5, 1 + np.arange(6)])


def test_knots_of_their_own_are_refused_before_they_fill_the_memory():
    rng = np.random.default_rng(1)

    def sections(count, shared):
        inner = np.sort(rng.uniform(0, 1, count))
        for i in range(count):
            own = inner if shared else np.sort(rng.uniform(0, 1, count))
            points = np.c_[np.linspace(0, 1, count + 4), 0.01 * rng.normal(size=count + 4), np.full(count + 4, 0.1 * i)]
            yield sc.NurbsCurve(3, np.r_[[0] * 4, own, [1] * 4], points)

    start = time.process_time()
    with pytest.raises(sc.InvalidShape, match="do not share their knots.*tolerance"):
        build.loft(list(sections(300, False)))
    assert time.process_time() - start < 30
    assert build.loft(list(sections(300, True))).value.points.shape == (304, 300, 3)
    few = build.loft(list(sections(30, False))).value
    assert few.points.shape == (904, 30, 3)


def test_many_sections_with_knots_of_their_own_take_their_share_of_time():
    """One knot vector is looked for along the hardest of them, not along all of them at each count of spans."""
    rng = np.random.default_rng(1)
    sections = []
    for i in range(180):
        own = (np.arange(1, 61) + rng.uniform(-0.3, 0.3, 60)) / 61
        x = np.linspace(0, 1, 64)
        points = np.c_[x, 0.2 * np.sin(9 * x + i / 10) + 1e-3 * rng.normal(size=64), np.full(64, 0.1 * i)]
        sections.append(sc.NurbsCurve(3, np.r_[[0] * 4, own, [1] * 4], points))
    start = time.process_time()
    made = build.loft(sections, tolerance=1e-3)
    assert time.process_time() - start < 5
    assert made.error <= 1e-3 and made.value.points.shape[0] < 100
    u = np.linspace(0, 1, 201)
    for section, v in ((sections[0], 0.0), (sections[-1], 1.0)):
        assert np.linalg.norm(made.value.isocurve('v', v).evaluate(u) - section.evaluate(u), axis=1).max() <= made.error


@pytest.mark.parametrize("spans", [100, 200, 400])
def test_parameters_see_every_span(spans):
    """Sections that are apart in every second span alone."""
    rise = np.zeros(spans + 3)
    rise[::2] = 1.0
    flat = np.c_[np.linspace(0, 1, spans + 3), np.zeros(spans + 3), np.zeros(spans + 3)]
    knots = np.r_[[0] * 4, np.arange(1, spans) / spans, [1] * 4]
    sections = [sc.NurbsCurve(3, knots, flat + np.c_[0 * rise, 0 * rise, height + share * rise])
                for height, share in ((0, 0.0), (1, 0.5), (2, -1.0), (3, 1.0))]
    def distance(a, b):
        u = np.linspace(0, 1, 40001)
        return np.linalg.norm(a.evaluate(u) - b.evaluate(u), axis=1).mean()
    steps = np.array([distance(*pair) for pair in zip(sections, sections[1:])])
    made = build.loft(sections, degree=1).value
    inner = np.array(made.knots[1])[2:-2]
    assert inner == pytest.approx(np.cumsum(steps)[:-1] / steps.sum(), abs=1e-4)
