"""The active piece: operators begin with it, verbs carry it along; where pieces lie in the view."""

from types import SimpleNamespace

import bpy
import numpy as np
import pytest

import patches
from curves import value_of
from shapes import activate, add, op
from support import part, splinecore as sc

hand, landmarks, picking, surveys, verbs = (part(name) for name in (
    'ui.active_shape', 'core.surfaces.outlines', 'ui.picking', 'bridge.analysis.surveys', 'core.verbs.verbs'))


class Called:
    """An operator as hand.begin() sees it; Blender invokes none in background: tests/gui/test_pieces.py does."""

    def __init__(self, **given):
        self.given = given
        self.properties = self
        self.piece = self.first = self.second = 0
        self.__dict__.update(given)

    def is_property_set(self, name):
        return name in self.given


def test_an_operator_begins_with_the_piece_in_hand_unless_one_is_given():
    ob = add(value_of('many curves'))
    ob.data.splinewright.piece = 2
    for called, expected in ((Called(), 2), (Called(piece=1), 1), (Called(piece=0), 0)):
        hand.begin(called, [ob])
        assert called.piece == expected


def test_of_several_shapes_all_pieces_are_meant_and_of_others_none():
    obs = [add(value_of('many curves'), name) for name in "ab"]
    obs[0].data.splinewright.piece = 2
    bpy.ops.mesh.primitive_cube_add()
    for chosen, expected in ((obs, 0), ([bpy.context.object], 0), ([], 0), ([bpy.context.object, obs[0]], 2)):
        called = Called()
        hand.begin(called, chosen)
        assert called.piece == expected


def test_scripts_go_their_own_way():
    ob = add(value_of('many curves'))
    before = [curve.degree for curve in ob.data.splinewright.value]
    ob.data.splinewright.piece = 2
    op(bpy.ops.splinewright.raise_degree)
    assert [curve.degree for curve in ob.data.splinewright.value] == [degree + 1 for degree in before]


def test_a_piece_that_is_not_there_is_not_in_hand():
    ob = add(value_of('many curves'))
    ob.data.splinewright.piece, ob.data.splinewright.other_piece = 5, 4
    assert hand.of(ob.data) == (0, 4)


def test_one_piece_is_not_in_hand_twice():
    data = add(value_of('many curves')).data
    hand.take(data, 2)
    hand.take(data, 3, is_other=True)
    assert hand.of(data) == (2, 3)
    hand.take(data, 3)
    assert hand.of(data) == (3, 0)
    hand.take(data, 3, is_other=True)
    assert hand.of(data) == (0, 3)


@pytest.mark.parametrize('piece, expected', ((1, 1), (2, 2), (3, 4), (4, 5)))
def test_in_hand_stays_what_came_of_the_piece(piece, expected):
    ob = add(value_of('many curves'))
    ob.data.splinewright.piece = piece
    bpy.ops.ed.undo_push(message="pick")
    op(bpy.ops.splinewright.split, piece=2, parameter_u=3.0)
    assert hand.of(ob.data)[0] == expected
    bpy.ops.ed.undo()
    assert hand.of(bpy.data.objects["shape"].data)[0] == piece


def test_a_piece_that_another_took_in_is_in_hand_no_more():
    line = [sc.BezierCurve([(i, 0, 0), (i + 1, 1, 0)]) for i in range(3)]
    ob = add([line[0], sc.BezierCurve([(1, 1, 0), (2, 0, 0)]), line[2].with_points(line[2].points + (0, 9, 0))])
    ob.data.splinewright.piece, ob.data.splinewright.other_piece = 2, 3
    op(bpy.ops.splinewright.join_ends, first=1, second=2)
    assert hand.of(ob.data) == (0, 2)


def test_pairs_begin_with_two_pieces_of_one_shape_or_one_of_each_of_two():
    first, second = (add(patches.value_of('four around a corner'), name) for name in "ab")
    first.data.splinewright.piece, first.data.splinewright.other_piece = 3, 4
    second.data.splinewright.piece = 2
    for chosen, given, expected in (([first], {}, (3, 4)), ([first, second], {}, (3, 2)), ([second, first], {}, (2, 3)),
                                    ([first], {'first': 1}, (1, 0)), ([first], {'second': 1}, (0, 1))):
        activate(*chosen)
        called = Called(**given)
        hand.begin_pair(called, bpy.context)
        assert (called.first, called.second) == expected


def test_the_numbers_that_are_asked_for_are_those_of_before():
    ob = add(value_of('many curves'))
    op(bpy.ops.splinewright.split, piece=2, parameter_u=3.0)
    operator = SimpleNamespace(bl_idname='SPLINEWRIGHT_OT_split')
    assert hand.asked(operator) == {'piece': {"shape": (1, 2, 2, 3, 4)}}
    assert hand.asked(SimpleNamespace(bl_idname='SPLINEWRIGHT_OT_reverse')) == {}
    op(bpy.ops.splinewright.reverse, piece=1)
    assert hand.asked(operator) == {}


def test_after_two_shapes_became_one_each_number_is_of_its_own():
    first, second = (add([sc.BezierCurve([(i + start, 0, 0), (i + start + 0.9, 1, 0)]) for i in range(2)], name)
                     for start, name in ((0, "a"), (5, "b")))
    activate(first, second)
    op(bpy.ops.splinewright.join_ends, first=2, second=1)
    asked = hand.asked(SimpleNamespace(bl_idname='SPLINEWRIGHT_OT_join_ends'))
    assert asked == {'first': {"a": (1, 2, 0)}, 'second': {"a": (0, 0, 2)}}


# Where they lie -----------------------------------------------------------------------------------


KINDS = ('many curves', 'semicircle', 'periodic', 'closed hermite', 'nurbs patch', 'mixed set', 'teapot',
         'patch with a point at infinity')


@pytest.mark.parametrize('kind', KINDS)
def test_a_number_lies_on_its_piece_and_the_outline_around_it(kind):
    definition = part('bridge.data.store').read(add(value_of(kind)).data)
    pieces = verbs.pieces_of(definition)
    middles = landmarks.middles(pieces)
    assert middles.shape == (len(pieces), 3) and np.isfinite(middles).all()
    for piece, middle in zip(pieces, middles):
        lines = landmarks.outline(piece)
        assert lines and all(line.shape[1] == 3 and len(line) > 1 for line in lines)
        size = np.ptp(np.concatenate([piece.points.reshape(-1, 3), *lines]), axis=0).max()
        grid = np.linspace(0, 1, 201)
        at = [start + grid * (end - start) for start, end in np.atleast_2d(piece.domain)]
        dense = piece.evaluate(*at, at_infinity='nan') if len(at) == 1 else piece.evaluate_grid(*at, at_infinity='nan')
        assert np.nanmin(np.linalg.norm(dense.reshape(-1, 3) - middle, axis=1)) < 0.02 * size


def test_a_piece_whose_middle_is_at_infinity_has_its_number_elsewhere():
    hyperbola = sc.BezierCurve([(1, 0), (1, 1), (0, 1)], [1, -1, 1])        # it runs off at u = 0.5
    middle, = landmarks.middles([hyperbola])
    assert np.array_equal(middle, hyperbola.evaluate(0.25))


def test_they_are_worked_out_once_for_a_definition(monkeypatch):
    ob, calls = add(value_of('teapot')), []
    work = landmarks.middles
    monkeypatch.setattr(landmarks, 'middles', lambda pieces: calls.append(pieces) or work(pieces))
    for _ in range(3):
        surveys.middles_of(ob.data)
    assert len(calls) == 1


REGION = SimpleNamespace(width=200, height=100)
VIEW = SimpleNamespace(perspective_matrix=np.diag([1.0, 2.0, 1.0, 1.0]))


def test_points_are_put_on_the_screen_and_those_behind_the_eye_are_not():
    places = picking.on_screen(REGION, VIEW, np.eye(4), np.array([(0, 0, 0), (0.5, 0.25, 7), (-1, -0.5, 0)]))
    assert np.array_equal(places, [(100, 50), (150, 75), (0, 0)])
    view = SimpleNamespace(perspective_matrix=np.array([(1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, -1.0, 0)]))
    places = picking.on_screen(REGION, view, np.eye(4), np.array([(0, 0, -2.0), (0, 0, 2), (1, 1, 0)]))
    assert places[0].tolist() == [100, 50] and np.isnan(places[1:]).all()


def test_the_nearest_curve_is_picked_and_none_that_is_far():
    ob = add([sc.BezierCurve([(-1, y, 0), (1, y, 0)]) for y in (-0.25, 0.0, 0.25)])
    for place, number in (((30, 26), 1), ((120, 52), 2), ((199, 74), 3)):
        assert picking.piece_at(REGION, VIEW, place, [ob], None) == (ob, number)
    far = SimpleNamespace(width=2000, height=1000)
    assert picking.piece_at(far, VIEW, (1000, 900), [ob], None) is None
