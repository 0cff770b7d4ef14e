"""Labels as strokes, and axes around shapes: where they stand, how large they are, and that every sign that labels have is there."""

import string

import numpy as np
import pytest

import splinecore as sc
from addon_core import core

axes, definitions, glyphs, labels, lettering, scales = (core(name) for name in (
    "formulas.axes", "shape.definition", "formulas.glyphs", "formulas.labels", "formulas.lettering", "analysis.scales"))
recipes = core("recipes.table").RECIPES
Refusal = core("base.failures").Refusal


def drawn(kind, *inputs, **settings):
    recipe = recipes[kind]
    given = [definitions.from_value(one) for one in inputs] or recipe.start
    return recipe.make(given, **{**recipe.defaults, **settings}).definition


@pytest.mark.parametrize('sign', glyphs.STROKES)
def test_every_sign_lies_within_its_width_and_the_grid(sign):
    corners = np.array([corner for stroke in glyphs.strokes(sign) for corner in stroke]).reshape(-1, 2)
    assert sign == " " or len(corners) > 1
    assert all(len(stroke) > 1 for stroke in glyphs.strokes(sign))
    assert (corners >= (0, -glyphs.LINE)).all() and (corners <= (glyphs.width(sign) - glyphs.GAP, glyphs.CAPITAL)).all()
    if sign in string.ascii_uppercase + string.digits:
        assert (corners[:, 1].min(), corners[:, 1].max()) == (0.0, glyphs.CAPITAL)


def test_no_two_signs_look_alike():
    known = {}
    for sign in glyphs.STROKES:
        look = frozenset(frozenset(map(tuple, pair)) for stroke in glyphs.strokes(sign) for pair in zip(stroke, stroke[1:]))
        assert known.setdefault(look, sign) == sign


def test_every_sign_of_labels_is_there():
    curve = sc.NurbsCurve(3, [0, 0, 0, 0, 1, 1, 3, 3, 3, 3], np.random.default_rng(1).uniform(-1, 1, (6, 3)) * (1, 1, 0), [1, 2, 0.5, 1, 1, 1])
    pictures = [drawn(kind, curve) for kind in ('basis', 'construction', 'basis_triangle', 'chain_points', 'marks', 'discs', 'orders', 'influence', 'lift')]
    pictures += [drawn(kind) for kind in ('functions', 'axes', 'triangle', 'products')] + [definitions.from_value(curve)]
    used = {sign for picture in pictures for label in labels.of(picture) for text, _ in label.runs for sign in text}
    assert len(used) > 25 and used | set(string.ascii_letters + string.digits) <= set(glyphs.STROKES)


@pytest.mark.parametrize('plane, right, up', (('xy', 0, 1), ('xz', 0, 2), ('yz', 1, 2)))
def test_letters_stand_beside_their_place_in_their_plane(plane, right, up):
    place = (3.0, -2.0, 5.0)
    parts = lettering.picture([labels.Label("P", "1", "", place)], 0.6, plane)
    assert {part.name for part in parts} == {"text P"}
    points = np.concatenate([part.curve.points for part in parts]) - place
    capital = parts[0].curve.points - place
    assert np.ptp(capital[:, up]) == pytest.approx(0.6) and capital[:, right].min() == pytest.approx(0.35 * 0.6)
    index = parts[1].curve.points - place
    assert np.ptp(index[:, up]) == pytest.approx(0.72 * 0.6) and index[:, up].min() < capital[:, up].min() and index[:, right].min() > capital[:, right].max()
    across = ({0, 1, 2} - {right, up}).pop()
    assert not points[:, across].any()


def test_letters_are_called_after_what_they_stand_beside_and_are_not_labeled_again():
    graphs = drawn('functions', degree=1, knot_values="0 1 2.5")
    made = recipes['labels'].make([graphs], **recipes['labels'].defaults).definition
    assert {piece.name for piece in made.pieces} == {"text N_{0,1}", "text tick 0", "text tick 1", "text tick 2.5"}
    assert labels.of(made) == []
    with pytest.raises(Refusal, match="nothing of it has a name"):
        recipes['labels'].make([made], **recipes['labels'].defaults)


def scale_of(value):
    return scales.of(definitions.from_value(value))


@pytest.mark.parametrize('size', (1e-6, 0.3, 1.0, 7.0, 1e8))
def test_axes_reach_around_the_shape_with_ticks_at_round_steps(size):
    points = size * np.array([(0.5, -1, 0), (2, 1, 0), (4, 0.2, 0)])
    found = scale_of(sc.BezierCurve(points))
    low, high = found.lines.reshape(-1, 3).min(axis=0), found.lines.reshape(-1, 3).max(axis=0)
    assert (low[:2] <= points.min(axis=0)[:2]).all() and (high[:2] >= points.max(axis=0)[:2] * (1 - 1e-9)).all() and low[0] <= 0.0
    along_x = sorted(float(label.after) for label in found.labels if abs(label.point[1]) < 1 * size and label.point[1] <= 0 and label.point[0] >= 0)
    steps = np.diff(sorted({float(label.after) for label in found.labels}))
    assert 5 <= len(along_x) <= 30 and np.allclose(steps, steps[0], rtol=1e-4)
    mantissa = steps[0] / 10.0 ** np.floor(np.log10(steps[0]) + 1e-9)
    assert min(abs(mantissa - one) for one in (1, 2, 5)) < 1e-3
    assert len(found.grid) and not found.grid[..., 2].any()


def test_a_shape_in_space_has_three_axes_one_far_away_no_origin_and_a_point_none():
    assert len({int(np.abs(line[1] - line[0]).argmax()) for line in scale_of(sc.BezierCurve([(0, 0, 0), (1, 1, 1)])).lines if np.ptp(line, axis=0).max() > 0.9}) == 3
    far = scale_of(sc.BezierCurve([(1000, 1000, 0), (1001, 1002, 0)])).lines.reshape(-1, 3)
    assert far[:, :2].min() > 999
    assert len(scale_of(sc.BezierCurve([(1, 1, 1), (1, 1, 1)])).lines) == 0


@pytest.mark.parametrize('middle, step', [(0.0, 0.2), (3.0, 1e-6), (1e6, 0.2), (-1e9, 0.05), (1e12, 0.5), (1e-150, 1e-152), (1e150, 1e147)])
def test_numbers_of_axes_differ_and_are_those_of_their_places(middle, step):
    first = round(middle / step) * step
    parts = axes.picture([(first, first + 10 * step), (0.0, 10.0)], [step, 1.0], 0.1, False)
    ticks = [part for part in parts if part.name.startswith(axes.TICK)][:11]
    written = [float(part.name.partition(" ")[2]) for part in ticks]
    assert len(set(written)) == 11
    assert np.abs(np.array(written) - [part.curve.points[1, 0] for part in ticks]).max() < 0.06 * step
