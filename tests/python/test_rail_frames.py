"""Frames of rails are those in which sweeps put sections."""

import numpy as np
import pytest

import splinecore as sc
from addon_core import core
from shapes import circle, closed_cubic, cubic, hermite_chain
from splinecore import build

BENT = sc.BezierCurve([(0, 0, 0), (1, 0, 1), (2, 2, 0), (4, 1, 1)])
AROUND = closed_cubic()
RAILS = {"bezier": BENT, "cubic": cubic(), "periodic": AROUND, "closed": AROUND.clamped(), "hermite": hermite_chain(), "circle": circle(),
         "corners": sc.NurbsCurve(1, [0, 0, 1, 2, 3, 4, 4], [(0, 0, 0), (2, 0, 0), (2, 2, 1), (0, 2, 0), (0, 0, 0)])}


def size_of(rail):
    return np.ptp(rail.evaluate(np.linspace(*rail.domain, 50)), axis=0).max()


@pytest.mark.parametrize("frame", ("minimal", "upright", "parallel"))
@pytest.mark.parametrize("name", RAILS)
def test_a_sweep_has_its_sections_there(name, frame):
    rail = RAILS[name]
    size = size_of(rail)
    section = sc.BezierCurve([(0, 0, 0), (0.01 * size, 0, 0), (0.01 * size, 0.02 * size, 0)])
    swept = build.sweep(rail, section, frame=frame, tolerance=1e-7 * size).value
    start, length = swept.domain[1][0], np.ptp(rail.domain)
    u = np.linspace(0, 1, 5)
    for at in rail.domain[0] + np.array([0.13, 0.41, 0.77]) * length:
        matrix = build.rail_frames(rail, at, frame=frame)
        off = section.transformed(matrix).evaluate(u) - swept.isocurve("v", at if at >= start else at + length).evaluate(u)
        if name == "corners" and frame != "parallel":  # miters move it along the rail
            off -= np.outer(off @ matrix[:3, 2], matrix[:3, 2])
        assert np.abs(off).max() <= 1e-6 * size


@pytest.mark.parametrize("rail", RAILS.values(), ids=RAILS.keys())
def test_frames_are_right_handed_and_on_the_rail(rail):
    at = np.linspace(*rail.domain, 12).reshape(3, 4)
    for frame in ("minimal", "upright", "parallel"):
        found = build.rail_frames(rail, at, frame=frame)
        axes = found[..., :3, :3]
        assert found.shape == (3, 4, 4, 4) and (found[..., 3, :] == (0, 0, 0, 1)).all()
        assert np.abs(np.swapaxes(axes, -1, -2) @ axes - np.eye(3)).max() < 1e-12 and (np.linalg.det(axes) > 0).all()
        assert np.abs(found[..., :3, 3] - rail.evaluate(at)).max() <= 1e-13 * size_of(rail)
        if frame == "parallel":
            assert (axes == axes[0, 0]).all()


def test_upright_frames_stand_and_minimal_ones_begin_as_told():
    at = np.linspace(0, 1, 9)
    assert (build.rail_frames(BENT, at, frame="upright", up=(0, 1, 0))[:, 1, 1] > 0.3).all()
    first = build.rail_frames(BENT, 0.0, start=(0, 1, 0))
    assert np.allclose(first[:3, 0], (0, 1, 0))


def rail_beside(rail, rng):
    points = rail.points + np.array([0, 0.3, 2]) + rng.uniform(-0.2, 0.2, rail.points.shape)
    return sc.BezierCurve(points)


@pytest.mark.parametrize("up", (None, (0, 1, 0)))
@pytest.mark.parametrize("seed", range(4))
def test_a_sweep_between_rails_has_its_sections_there(seed, up):
    second = rail_beside(BENT, np.random.default_rng(seed))
    at = np.array([0.0, 0.3, 0.6, 1.0])
    frames = build.two_rail_frames(BENT, second, at, up=up)
    widths = np.linalg.norm(second.evaluate(at) - BENT.evaluate(at), axis=1)
    sections = [sc.BezierCurve([(0, 0, 0), (0.4 * width, 0.2, 0), (width, 0, 0)]) for width in widths]
    swept = build.sweep_two_rails(BENT, second, sections, at=at, up=up, tolerance=1e-6).value
    for place, frame, section in zip(at, frames, sections):
        u = np.linspace(0, 1, 5)
        assert np.abs(swept.isocurve("v", place).evaluate(u) - section.transformed(frame).evaluate(u)).max() <= 1e-5
    assert np.allclose(frames[:, :3, 3], BENT.evaluate(at), atol=1e-13)


def test_the_second_rail_may_have_another_domain():
    second = rail_beside(BENT, np.random.default_rng(9)).to_nurbs()
    found = [build.two_rail_frames(BENT, one, [0.2, 0.9]) for one in (second, second.with_domain((-3.0, 40.0)))]
    assert np.allclose(*found, atol=1e-13)


@pytest.mark.parametrize("size", (1e-100, 1e-9, 1e9, 1e100))
def test_size_does_not_matter(size):
    scaled = sc.BezierCurve(BENT.points * size)
    plain, other = (build.rail_frames(rail, [0.1, 0.8]) for rail in (BENT, scaled))
    assert np.allclose(plain[:, :3, :3], other[:, :3, :3], atol=1e-9) and np.allclose(plain[:, :3, 3], other[:, :3, 3] / size)
    beside = BENT.points + (0, 0.3, 2)
    plain, other = (build.two_rail_frames(sc.BezierCurve(BENT.points * by), sc.BezierCurve(beside * by), [0.1, 0.8]) for by in (1.0, size))
    assert np.allclose(plain[:, :3, :3], other[:, :3, :3], atol=1e-9) and np.allclose(plain[:, :3, 3], other[:, :3, 3] / size)


@pytest.mark.parametrize("call, words", [
    (lambda: build.rail_frames(BENT, 1.5), "at"),
    (lambda: build.rail_frames(BENT, float("nan")), "at"),
    (lambda: build.rail_frames(sc.BezierCurve([(0, 0, 0), (0, 0, 1)]), 0.5, frame="upright"), "upright"),
    (lambda: build.rail_frames(BENT, 0.5, frame="upright", up=(0, 0, 0)), "upright direction is zero"),
    (lambda: build.rail_frames(BENT, 0.5, frame="none"), "frame"),
    (lambda: build.two_rail_frames(BENT, BENT, 0.5), "rails meet"),
    (lambda: build.two_rail_frames(BENT, sc.BezierCurve(BENT.points + (0, 0, 1)), -0.5), "at"),
    (lambda: build.two_rail_frames(sc.BezierCurve([(0, 0, 0), (1, 0, 0)]), sc.BezierCurve([(1, 1, 0), (0, 1, 0)]), 0.5), "against"),
])
def test_what_is_wrong_is_said(call, words):
    with pytest.raises(sc.InvalidShape, match=words):
        call()


@pytest.mark.parametrize("rail", [AROUND, AROUND.clamped(), BENT], ids=["periodic", "closed", "open"])
def test_sections_of_the_addon_stay_where_they_are_drawn(rail):
    at = rail.domain[0] + np.array([0.2, 0.55]) * np.ptp(rail.domain)
    drawn = [sc.BezierCurve(rail.evaluate(place) + 0.05 * rail.frames(place)[[1, 2, 1]] * [[-1], [1], [1]]) for place in at]
    moved, places, order = core("surfaces.rails").along(rail, drawn, "minimal")
    swept = build.sweep(rail, moved, at=places, tolerance=1e-7).value
    u = np.linspace(0, 1, 7)
    for place, number in zip(places, order):
        found, wanted = swept.isocurve("v", place).evaluate(u), drawn[number].evaluate(u)
        assert min(np.abs(one - wanted).max() for one in (found, found[::-1])) < 1e-5  # a sweep may run sections the other way
