"""What notebooks show: SVG that parses, small, of every kind of shape, however wild."""

import re
import xml.etree.ElementTree as ElementTree

import numpy as np
import pytest

import splinecore as sc
from splinecore import build
from wild_shapes import CURVES, SURFACES, random

SPACE = "{http://www.w3.org/2000/svg}"
MARGIN = 120


def steps_of(path):
    """(command, numbers) of the data of a path."""
    return [(found[1], [int(number) for number in re.findall(r"-?\d+", found[2])]) for found in re.finditer(r"([a-zA-Z])([^a-zA-Z]*)", path)]


def ends_of(path):
    """Points at which the parts of a path end, all corners of its lines among them."""
    at, found = np.zeros(2, int), []
    for command, numbers in steps_of(path):
        rows = np.array(numbers + [0] * (command == "h")).reshape(-1, 2)
        if command == "M":
            at, found = rows[0], [*found, rows[0]]
        elif command == "c":
            at = at + rows[2]
            found.append(at)
        else:
            found += list(at + np.cumsum(rows, axis=0))
            at = found[-1]
    return np.array(found)


def drawn(shape):
    """The parsed picture, its paths by color and width, what is written below it; small, and all of it within its frame."""
    text = shape._repr_svg_()
    top = ElementTree.fromstring(text)
    assert top.tag == f"{SPACE}svg" and len(text.encode()) < 10_000 and "nan" not in text and "inf" not in top.get("viewBox")
    assert top.find(f"{SPACE}title").text == repr(shape)
    x, y, width, height = map(int, top.get("viewBox").split())
    paths = {}
    for path in top.iter(f"{SPACE}path"):
        points = ends_of(path.get("d"))
        assert (points >= (x + MARGIN, y + MARGIN)).all() and (points <= (x + width - MARGIN, y + height - MARGIN)).all()
        paths[path.get("stroke"), path.get("stroke-width")] = path.get("d")
    return paths, " ".join(row.text for row in top.iter(f"{SPACE}text"))


@pytest.mark.parametrize("name", CURVES)
def test_every_curve_has_a_picture(name):
    paths, note = drawn(CURVES[name])
    assert paths and not note.startswith("not drawn")
    assert (note != "") == (name in ("degree 255", "many points", "many of Hermite"))
    assert ("#2b83d6", "20") in paths


@pytest.mark.parametrize("name", SURFACES)
def test_every_surface_has_a_picture(name):
    paths, note = drawn(SURFACES[name])
    assert ("#2b83d6", "14") in paths
    assert note == ("150 of 1000 patches drawn" if name == "1000 of a set" else "")


def test_a_cubic_is_one_command_with_its_control_points():
    paths, _ = drawn(sc.BezierCurve([(0, 0), (0, 1), (2, 1), (2, 0)]))
    assert paths["#2b83d6", "20"] == "M0 1500c0-1500 3000-1500 3000 0"
    assert paths["#8a8a8a", "8"] == "M0 1500l0-1500 3000 0 0 1500"
    assert paths["#8a8a8a", "50"] == "M0 0h0M0 1500h0M3000 0h0M3000 1500h0"


@pytest.mark.parametrize("degree", [1, 2, 3])
def test_a_span_of_low_degree_is_one_command(degree):
    knots = [0] * (degree + 1) + [1, 2, 3] + [4] * (degree + 1)
    curve = sc.NurbsCurve(degree, knots, random(degree + 4, 2))
    assert [command for command, _ in steps_of(drawn(curve)[0]["#2b83d6", "20"])] == ["M"] + ["l" if degree == 1 else "c"] * 4


def test_curves_of_high_degree_and_with_weights_are_near():
    for curve in (CURVES["arc"], sc.BezierCurve(random(12, 2)), sc.BezierCurve(random(5, 2), weights=[1, 40, 0.1, 7, 1])):
        paths, _ = drawn(curve)
        points = curve.evaluate(np.linspace(0, 1, 20001))[:, :2]
        low = np.minimum(points.min(axis=0), curve.points[:, :2].min(axis=0))
        high = np.maximum(points.max(axis=0), curve.points[:, :2].max(axis=0))
        seen = (points - (low[0], high[1])) * (1, -1) / (high - low).max() * 3000
        at = np.zeros(2)
        for command, numbers in steps_of(paths["#2b83d6", "20"]):
            rows = np.array(numbers).reshape(-1, 2)
            if command == "c":
                a, b, c, d = at, *(at + rows)
                for t in (0.2, 0.5, 0.9):
                    point = (1 - t)**3 * a + 3 * t * (1 - t)**2 * b + 3 * t * t * (1 - t) * c + t**3 * d
                    assert np.hypot(*(seen - point).T).min() < 6            # of 3000
            at = rows[-1] if command == "M" else at + rows[-1]


def test_jumps_are_gaps():
    for name in ("gap", "steps"):
        commands = [command for command, _ in steps_of(drawn(CURVES[name])[0]["#2b83d6", "20"])]
        assert commands.count("M") == 2
    branches = drawn(CURVES["hyperbola"])[0]["#2b83d6", "20"]
    assert branches.count("M") == 3


def test_a_polygon_has_no_line_to_infinity_and_that_of_a_ring_is_closed():
    assert ("#8a8a8a", "8") not in drawn(CURVES["half circle"])[0]
    ring = ends_of(drawn(CURVES["ring"])[0]["#8a8a8a", "8"])
    assert len(ring) == 13 and (ring[0] == ring[-1]).all()


def test_random_shapes_have_pictures(inputs):
    draw = np.random.default_rng(5)
    for _ in range(inputs(150)):
        degree, count = draw.integers(1, 9), draw.integers(1, 12)
        size = 10.0 ** draw.uniform(-300, 300)
        weights = draw.choice([1, 1, 1, 0, -1, 1e-6, 1e6, -1e6], degree + count)
        knots = np.sort(np.concatenate([[0] * degree, draw.integers(0, 4, count - 1), [0, 4], [4] * degree]))
        try:
            curve = sc.NurbsCurve(degree, knots, size * draw.uniform(-1, 1, (degree + count, draw.integers(2, 4))), weights)
            patch = build.extrude(curve, size * draw.uniform(-1, 1, 3))
        except sc.Error:
            continue
        drawn(curve)
        drawn(patch)


def test_what_cannot_be_drawn_says_so(monkeypatch):
    def refuse(*_):
        raise sc.InvalidShape("a < b & so on")

    monkeypatch.setattr(sc._svg._cubics, "cubics", refuse)
    paths, note = drawn(CURVES["cubic"])
    assert not paths and note == "not drawn: a < b & so on"
