"""The verbs of patch shapes as operators: what they keep, and what they say that they do not."""

import types

import bpy
import numpy as np
import pytest

from curves import run, said_distance
from patches import DIRECTIONS, LETTERS, farthest, patches_of, size_of, value_of
from shapes import activate, add, op, require_exact
from support import part, splinecore as sc

knot_verbs, on_shapes, pieces = (part(f'ui.operators.{name}') for name in ('knot_verbs', 'on_shapes', 'pieces'))

ALL = ('bezier patch', 'hermite patch', 'nurbs patch', 'rational nurbs', 'uniform', 'both periodic', 'bicubic')
WITH_KNOTS = ('rational nurbs', 'both periodic', 'uniform', 'plain nurbs')
AT = {'parameter_u': 0.3, 'parameter_v': 0.2}
#: Operator, settings, kinds of patches that it keeps, in every direction.
ALONG = (
    ('insert_knot', AT, ALL), ('insert_knot', {'where': 'SPANS', 'times': 2}, ALL),
    ('raise_degree', {'times': 2}, ALL), ('reverse', {}, ALL), ('split', AT, ALL),
    ('split', {'where': 'KNOTS'}, WITH_KNOTS), ('reparameterize', {'start': -1.5, 'end': 3.1}, ALL),
    ('reparameterize', {'how': 'MOEBIUS', 'rho': 2.5}, ALL), ('clamp', {}, ('both periodic', 'uniform')),
    ('unclamp', {}, ('bezier patch', 'hermite patch', 'rational nurbs', 'both periodic')),
    ('make_periodic', {}, ('torus',)))
WHOLE = (
    ('swap_uv', ALL), ('to_bezier', ('hermite patch', 'nurbs patch', *WITH_KNOTS)),
    ('to_hermite', ('bicubic', 'plain nurbs', 'nurbs patch', 'bilinear')),
    ('to_nurbs', ('bezier patch', 'hermite patch', 'bicubic')))
KEEPING = [(name, {**settings, 'direction': direction}, kind)
           for name, settings, kinds in ALONG for kind in kinds for direction in DIRECTIONS]
KEEPING += [(name, {}, kind) for name, kinds in WHOLE for kind in kinds]


@pytest.fixture
def said(monkeypatch):
    """What the operators say behind the name of what they did."""
    texts = []

    def told(outcomes, told=pieces.told):
        texts.append(told(outcomes))
        return texts[-1]
    monkeypatch.setattr(pieces, 'told', told)
    return texts


@pytest.mark.parametrize('name, settings, kind', [
    pytest.param(*row, id=f"{row[0]}-{'-'.join(map(str, row[1].values()))}-{row[2]}") for row in KEEPING])
def test_the_shape_is_kept_in_double_precision_and_taken_back_by_undo(name, settings, kind, said):
    before = value_of(kind)
    ob = add(before)
    assert run(name, **settings) == {'FINISHED'}
    after, value = patches_of(ob), ob.data.splinewright.value
    assert value != before and said_distance(said[0]) < 1e-12
    assert farthest(before, after, name, settings) < 1e-12 * max(size_of([before]), 1)
    require_exact(ob)
    bpy.ops.ed.undo()
    assert bpy.data.objects["shape"].data.splinewright.value == before
    bpy.ops.ed.redo()
    assert bpy.data.objects["shape"].data.splinewright.value == value


def test_the_measure_of_these_tests_sees_a_move_of_a_millionth():
    before = value_of('rational nurbs')
    moved = before.points.copy()
    moved[2, 2] += 1e-9
    assert farthest(before, [before.with_points(moved)], 'raise_degree', {}) > 1e-11


@pytest.mark.parametrize('direction', DIRECTIONS)
def test_what_was_asked_for_is_done_along_the_chosen_axes_and_no_other(direction):
    def changes(name, what, kind='rational nurbs', **settings):
        value = value_of(kind)
        ob = add(value)
        assert run(name, direction=direction, **settings) == {'FINISHED'}
        before, after = what(value), what(patches_of(ob)[0])
        chosen = [letter in DIRECTIONS[direction] for letter in LETTERS]
        assert [bool(np.any(np.not_equal(a, b))) for a, b in zip(before, after)] == chosen
        return [pair for pair, is_chosen in zip(after, chosen) if is_chosen]

    def knots_of(patch):
        return [knots.tolist() for knots in patch.to_nurbs().knots]

    def count_of(patch):
        return patch.points.shape[:2]

    assert changes('raise_degree', lambda p: p.degree, times=2) == [
        degree for degree, letter in zip((5, 4), LETTERS) if letter in DIRECTIONS[direction]]
    assert all(domain == (0.1, 0.7) for domain in changes(
        'reparameterize', lambda p: p.domain, start=0.1, end=0.7)), "a typed 0.1 is 0.1"
    changes('insert_knot', count_of, times=2, **AT)
    changes('remove_knot', count_of, 'plain nurbs', parameter_u=0.3, parameter_v=0.3)
    changes('remove_knots', count_of, 'plain nurbs', tolerance=10.0)
    changes('lower_degree', lambda p: p.degree, 'biquintic', times=3)
    changes('make_periodic', lambda p: p.periodic, 'torus')
    changes('unclamp', lambda p: [len(set(knots)) for knots in knots_of(p)])
    changes('clamp', lambda p: [len(set(knots)) for knots in knots_of(p)], 'uniform')


KINDS_AFTERWARDS = (
    ('to_bezier', 'rational nurbs', sc.BezierPatch), ('to_hermite', 'bicubic', sc.HermitePatch),
    ('to_nurbs', 'hermite patch', sc.NurbsPatch), ('raise_degree', 'bicubic', sc.BezierPatch),
    ('reverse', 'hermite patch', sc.HermitePatch), ('swap_uv', 'hermite patch', sc.HermitePatch),
    ('split', 'hermite patch', sc.HermitePatch), ('insert_knot', 'bicubic', sc.NurbsPatch))


@pytest.mark.parametrize('name, kind, expected', KINDS_AFTERWARDS)
def test_the_kind_is_what_the_name_says_or_the_one_before(name, kind, expected):
    ob = add(value_of(kind))
    run(name)
    assert {type(patch) for patch in patches_of(ob)} == {expected}


def test_numbers_in_single_precision_meet_the_knots_that_are_meant():
    ob = add(value_of('rational nurbs'))
    third = {'parameter_u': 1 / 3, 'parameter_v': 1 / 3, 'direction': 'BOTH'}
    run('insert_knot', **third)
    for knots in ob.data.splinewright.value.knots:
        assert (knots == 1 / 3).sum() == 2 and np.float32(1 / 3) not in knots
    run('remove_knot', nearest=False, **third)
    assert [(knots == 1 / 3).sum() for knots in ob.data.splinewright.value.knots] == [1, 1]
    run('split', **third)
    assert [patch.domain for patch in patches_of(ob)] == [
        (u, v) for u in ((0, 1 / 3), (1 / 3, 1)) for v in ((0, 1 / 3), (1 / 3, 3))]


def first_parameters(cls, piece=0, given=()):
    """What an operator begins with. Its invoke() is called in a window only, so a stand-in calls it."""
    settings = types.SimpleNamespace(is_property_set=lambda name: name in given)
    own = {name: vars(base)[name] for base in cls.__mro__[::-1] for name in ('first_parameter', 'first_values', 'asked')
           if name in vars(base)}
    menu = type("Menu", (on_shapes.AtParameters, on_shapes.OnShapes), {
        **own, 'properties': settings, 'piece': piece, 'only': "", 'parameter_u': 0.25, 'parameter_v': 0.75,
        'execute': lambda self, context: (self.parameter_u, self.parameter_v)})
    return menu().invoke(bpy.context, None)


def test_from_a_menu_the_parameters_are_those_of_the_active_patch_unless_they_are_given():
    insert, split = knot_verbs.SPLINEWRIGHT_OT_insert_knot, knot_verbs.SPLINEWRIGHT_OT_split
    first = add(value_of('rational nurbs'))
    assert np.allclose(first_parameters(insert), (2 / 3, 7 / 6)) and first_parameters(split) == (0.5, 1.5)
    assert first_parameters(split, given=['parameter_u']) == (0.25, 1.5)
    other = add(value_of('mixed set'), "other")
    activate(other, first)
    assert np.allclose(first_parameters(insert, piece=1), (0.15, 2.5))
    assert first_parameters(split, piece=2) == (0.5, 0.5)
    assert first_parameters(insert, piece=3) == (0.25, 0.75), "execute() refuses piece 3"


def test_from_a_menu_one_piece_is_meant_where_pieces_have_other_domains():
    for kind, piece in (('teapot', 0), ('mixed set', 1)):
        add(value_of(kind))
        chosen = []
        menu = type("Menu", (on_shapes.AtParameters, on_shapes.OnShapes), {
            'properties': types.SimpleNamespace(is_property_set=lambda name: False), 'piece': 0, 'only': "",
            'parameter_u': 0.0, 'parameter_v': 0.0, 'execute': lambda self, context: chosen.append(self.piece)})
        menu().invoke(bpy.context, None)
        assert chosen == [piece]


# What is said -----------------------------------------------------------------------------------------------------


def measured(before, after):
    """At equal parameters, on so many that little is missed."""
    at = [np.linspace(*domain, 301) for domain in before.domain]
    return np.linalg.norm(before.evaluate_grid(*at) - after.evaluate_grid(*at), axis=-1).max()


APPROXIMATING = (
    ('remove_knot', {'parameter_u': 0.3, 'parameter_v': 0.3}, 'plain nurbs'),
    ('remove_knots', {'tolerance': 9.0}, 'plain nurbs'), ('lower_degree', {}, 'plain nurbs'),
    ('lower_degree', {'times': 2}, 'biquintic'), ('lower_degree', {}, 'hermite patch'),
    ('lower_degree', {}, 'both periodic'))


@pytest.mark.parametrize('direction', DIRECTIONS)
@pytest.mark.parametrize('name, settings, kind', APPROXIMATING)
def test_the_error_said_is_the_error_made(name, settings, kind, direction, said):
    before = value_of(kind)
    ob = add(before)
    assert run(name, **{**settings, 'direction': direction}) == {'FINISHED'}
    error = measured(before, ob.data.splinewright.value)
    assert error > 1e-6 and 0.94 * error < said_distance(said[0]) < 1.2 * error
    assert error <= settings.get('tolerance', np.inf)
    require_exact(ob)


@pytest.mark.parametrize('kind, settings', (
    ('plain nurbs', {}), ('rational nurbs', {'count_u': 6, 'degree_u': 2}), ('both periodic', {'count_u': 5, 'count_v': 5}),
    ('hermite patch', {'count_u': 4, 'count_v': 4})))
def test_a_rebuilt_patch_is_the_librarys_and_its_error_is_said(kind, settings, said):
    before = value_of(kind)
    ob = add(before)
    assert run('rebuild', **settings) == {'FINISHED'}
    after = ob.data.splinewright.value
    counts = settings.get('count_u', 10), settings.get('count_v', 10)
    assert after == before.rebuild(counts, (settings.get('degree_u', 3), 3)).value and after.points.shape[:2] == counts
    error = measured(before, after)
    assert error < 1e-12 or 0.9 * error < said_distance(said[0]) < 1.2 * error
    require_exact(ob)


def test_rebuilt_patches_that_shared_an_edge_share_it_still():
    op(bpy.ops.splinewright.add_teapot)
    ob = bpy.context.object
    assert len(ob.data.splinewright.value.points) < 32 * 16
    run('rebuild', count_u=5, count_v=5)
    assert len(ob.data.splinewright.value.points) < 32 * 25 - 150
    require_exact(ob)


@pytest.mark.parametrize('kind, settings', (
    ('plain nurbs', {}), ('rational nurbs', {'tolerance': 0.0625}), ('both periodic', {'tolerance': 0.125}),
    ('biquintic', {'keep_tangents': True}), ('hermite patch', {})))
def test_a_fair_patch_is_the_librarys_and_its_error_is_said(kind, settings, said):
    before = value_of(kind)
    ob = add(before)
    settings = {'tolerance': 0.03125, **settings}
    assert run('fair', **settings) == {'FINISHED'}
    after = ob.data.splinewright.value
    ends = 'tangents' if settings.get('keep_tangents') else 'points'
    assert after == before.to_nurbs().fair(settings['tolerance'], ends=ends).value
    error = measured(before, after)
    assert 0.9 * error < said_distance(said[0]) < 1.2 * error <= 1.2 * settings['tolerance']
    require_exact(ob)


@pytest.mark.parametrize('name, settings', (('rebuild', {'count_u': 5, 'count_v': 6}), ('fair', {'tolerance': 0.125})))
@pytest.mark.parametrize('kind', ('plain nurbs', 'rational nurbs', 'hermite patch'))
def test_what_is_rebuilt_and_faired_is_taken_back_and_done_again(name, settings, kind):
    before = value_of(kind)
    ob = add(before)
    assert run(name, **settings) == {'FINISHED'}
    value = ob.data.splinewright.value
    bpy.ops.ed.undo()
    assert bpy.data.objects["shape"].data.splinewright.value == before != value
    bpy.ops.ed.redo()
    assert bpy.data.objects["shape"].data.splinewright.value == value


def test_fair_patches_that_shared_an_edge_share_it_still():
    op(bpy.ops.splinewright.add_teapot)
    ob = bpy.context.object
    before = ob.data.splinewright.value
    run('fair', tolerance=0.03125)
    after = ob.data.splinewright.value
    assert len(after.points) <= len(before.points), "points that are equal may have become one"
    moved = 0
    for old, new in zip((before[i].points for i in range(32)), (after[i].points for i in range(32))):
        border = np.ones((4, 4), bool)
        border[1:-1, 1:-1] = False
        np.testing.assert_array_equal(new[border], old[border])
        moved += np.any(new != old)
    assert moved > 24
    require_exact(ob)


def test_both_axes_share_one_tolerance():
    raised = value_of('plain nurbs').elevate('u').elevate('v')
    noise = 1e-3 * np.cos(np.arange(raised.points.size)).reshape(raised.points.shape)
    moved = raised.with_points(raised.points + noise)
    errors = {}
    for direction in DIRECTIONS:
        ob = add(moved)
        run('lower_degree', direction=direction)
        errors[direction] = measured(moved, ob.data.splinewright.value)
        ob.data.splinewright.value = moved
        if direction == 'BOTH':
            limit = 1.05 * max(errors['U'], errors['V'])
            with pytest.raises(RuntimeError, match="along v: the degree cannot be lowered within"):
                run('lower_degree', direction=direction, limited=True, tolerance=limit)
            assert ob.data.splinewright.value == moved
            limit = 1.3 * (errors['U'] + errors['V'])
            run('lower_degree', direction=direction, limited=True, tolerance=limit)
            assert measured(moved, ob.data.splinewright.value) <= limit


@pytest.mark.parametrize('direction', DIRECTIONS)
@pytest.mark.parametrize('name, settings, kind, undoes', (
    ('remove_knot', {'parameter_u': 0.6, 'parameter_v': 0.6}, 'plain nurbs', ('insert_knot', {
        'parameter_u': 0.6, 'parameter_v': 0.6})),
    ('remove_knots', {}, 'bicubic', ('insert_knot', {'where': 'SPANS'})),
    ('lower_degree', {'times': 2}, 'rational nurbs', ('raise_degree', {'times': 2})),
    ('lower_degree', {}, 'bicubic', ('raise_degree', {}))))
def test_what_was_added_goes_without_an_error(name, settings, kind, undoes, direction, said):
    before = value_of(kind)
    ob = add(before)
    run(undoes[0], direction=direction, **undoes[1])
    limit = {} if name == 'remove_knots' else {'limited': True}
    run(name, direction=direction, tolerance=1e-9, **limit, **settings)
    after = ob.data.splinewright.value
    assert said_distance(said[1]) < 1e-12 and measured(before, after) < 1e-12
    assert after.points.shape == before.points.shape


def test_counts_of_pieces_and_points_are_said_and_shared_points_count_once(said):
    add(value_of('plain nurbs'))
    run('to_bezier')
    run('split', piece=2, parameter_v=0.5, direction='V', neighbors=False)
    assert said == [": 1 piece became 9, 36 points became 100", ": 9 pieces became 10, 100 points became 114"]
