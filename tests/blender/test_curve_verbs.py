"""The verbs of curve shapes as operators: what they keep, and what they say that they do not."""

import types

import bpy
import numpy as np
import pytest

import shapes
from curves import curves_of, run, said_distance, value_of
from shapes import activate, add, require_exact
from support import part, splinecore as sc

knot_verbs, on_shapes, pieces = (part(f'ui.operators.{name}') for name in ('knot_verbs', 'on_shapes', 'pieces'))

ALL = ('cubic', 'rational cubic', 'quintic', 'semicircle', 'hermite', 'hermite with corners', 'closed hermite', 'nurbs',
       'periodic')
WITH_KNOTS = ('hermite', 'hermite with corners', 'closed hermite', 'nurbs', 'periodic')
#: Operator, settings, kinds of curves that it keeps.
KEEPING = (
    ('insert_knot', {'parameter_u': 0.3}, ALL), ('insert_knot', {'where': 'SPANS', 'times': 2}, ALL),
    ('raise_degree', {'times': 2}, ALL), ('reverse', {}, ALL),
    ('split', {'parameter_u': 0.3}, ALL), ('split', {'where': 'KNOTS'}, WITH_KNOTS),
    ('reparameterize', {'start': -1.5, 'end': 3.1}, ALL), ('reparameterize', {'how': 'MOEBIUS', 'rho': 2.5}, ALL),
    ('standard_form', {}, ('rational cubic', 'nurbs')), ('clamp', {}, ('periodic', 'uniform')), ('unclamp', {}, ALL),
    ('make_periodic', {}, ('closed hermite', 'circle')), ('to_bezier', {}, WITH_KNOTS),
    ('to_hermite', {}, ('cubic', 'parabola', 'periodic', 'three knots')),
    ('to_nurbs', {}, ('cubic', 'rational cubic', 'quintic', 'semicircle', 'hermite', 'closed hermite')))


@pytest.fixture
def said(monkeypatch):
    """What the operators say behind the name of what they did."""
    texts = []

    def told(outcomes, told=pieces.told):
        texts.append(told(outcomes))
        return texts[-1]
    for module in (pieces, part('ui.operators.curve_join')):
        monkeypatch.setattr(module, 'told', told)
    return texts


def distinct_knots(curve):
    start, end = curve.domain
    knots = curve.to_nurbs().knots
    return np.unique(knots[(knots >= start) & (knots <= end)])


def breaks_of(curve, name, settings):
    """The parameters between which the curves lie that come out, on the curve that went in."""
    start, end = curve.domain
    if name == 'to_bezier' or settings.get('where') == 'KNOTS' and name == 'split':
        return distinct_knots(curve)
    if name == 'split':
        at = settings['parameter_u']
        return [at, at + end - start] if getattr(curve, 'periodic', False) else [start, at, end]
    return [start, end]


def fraction_before(fractions, curve, name, settings):
    """Where on the curve that went in, as a part of its domain, a point lay that now lies at a part of the domain."""
    if name == 'reverse':
        return 1 - fractions
    if name == 'standard_form':
        weights = curve.weights
        rho = (weights[0] / weights[-1]) ** (1 / curve.degree)
    elif settings.get('how') == 'MOEBIUS':
        rho = settings['rho']
    else:
        return fractions
    return rho * fractions / (1 - fractions + rho * fractions)


def farthest(before, after, name, settings):
    """The largest distance of points of the curves that came out from where they were."""
    fractions, worst = np.linspace(0, 1, 101)[1:-1], 0.0
    breaks = breaks_of(before, name, settings)
    assert len(after) == len(breaks) - 1
    for curve, begin, end in zip(after, breaks, breaks[1:]):
        start = curve.domain[0]
        points = curve.evaluate(start + fractions * (curve.domain[1] - start))
        at = begin + fraction_before(fractions, before, name, settings) * (end - begin)
        first, last = before.domain
        if getattr(before, 'periodic', False):
            at = first + (at - first) % (last - first)
        worst = np.maximum(worst, np.abs(points - before.evaluate(at)).max())
    return worst


@pytest.mark.parametrize('name, settings, kind', [
    pytest.param(name, settings, kind, id=f"{name}-{'-'.join(map(str, settings.values()))}-{kind}")
    for name, settings, kinds in KEEPING for kind in kinds])
def test_the_shape_is_kept_in_double_precision_and_taken_back_by_undo(name, settings, kind, said):
    before = value_of(kind)
    ob = add(before)
    assert run(name, **settings) == {'FINISHED'}
    after, value = curves_of(ob), ob.data.splinewright.value
    assert value != before and said_distance(said[0]) < 1e-12
    assert farthest(before, after, name, settings) < 1e-12 * np.abs(before.points).max()
    require_exact(ob)
    bpy.ops.ed.undo()
    assert bpy.data.objects["shape"].data.splinewright.value == before
    bpy.ops.ed.redo()
    assert bpy.data.objects["shape"].data.splinewright.value == value


def test_the_measure_of_these_tests_sees_a_move_of_a_millionth():
    before = value_of('nurbs')
    points = before.points.copy()
    points[2] += 1e-9
    assert farthest(before, [before.with_points(points)], 'raise_degree', {}) > 1e-10


KINDS_AFTERWARDS = (('to_bezier', 'nurbs', sc.BezierCurve), ('to_hermite', 'cubic', sc.HermiteCurve),
                    ('to_nurbs', 'hermite', sc.NurbsCurve), ('raise_degree', 'cubic', sc.BezierCurve),
                    ('reverse', 'hermite', sc.HermiteCurve), ('insert_knot', 'cubic', sc.NurbsCurve))


@pytest.mark.parametrize('name, kind, expected', KINDS_AFTERWARDS)
def test_the_kind_is_what_the_name_says_or_the_one_before(name, kind, expected):
    ob = add(value_of(kind))
    run(name)
    assert {type(curve) for curve in curves_of(ob)} == {expected}


def test_degrees_knots_domains_and_weights_are_what_was_asked_for():
    ob = add(value_of('nurbs'))
    run('raise_degree', times=3)
    assert ob.data.splinewright.value.degree == 6
    run('lower_degree', times=3)
    assert ob.data.splinewright.value.degree == 3
    run('reparameterize', start=0.1, end=0.7)
    assert ob.data.splinewright.value.domain == (0.1, 0.7), "a typed 0.1 is 0.1"
    run('standard_form')
    weights = ob.data.splinewright.value.weights
    assert weights[0] == 1 and abs(weights[-1] - 1) < 1e-14
    run('unclamp')
    knots = ob.data.splinewright.value.knots
    assert knots[0] < knots[3] and len(np.unique(knots[:4])) == 4
    run('clamp')
    knots = ob.data.splinewright.value.knots
    assert (knots[:4] == knots[0]).all() and (knots[-4:] == knots[-1]).all()


def test_a_number_in_single_precision_meets_the_knot_that_is_meant():
    ob = add(value_of('nurbs'))
    run('insert_knot', parameter_u=1 / 3, times=2)
    knots = ob.data.splinewright.value.knots
    assert (knots == 1 / 3).sum() == 3 and np.float32(1 / 3) not in knots
    run('remove_knot', parameter_u=1 / 3, nearest=False, times=2)
    assert (ob.data.splinewright.value.knots == 1 / 3).sum() == 1
    run('split', parameter_u=1 / 3)
    assert [curve.domain for curve in curves_of(ob)] == [(0, 1 / 3), (1 / 3, 1)]


def first_parameter(cls, piece=0, given=()):
    """What an operator begins with. Its invoke() is called in a window only, so a stand-in calls it."""
    settings = types.SimpleNamespace(is_property_set=lambda name: name in given)
    menu = type("Menu", (on_shapes.AtParameters, on_shapes.OnShapes), {
        'first_parameter': vars(cls).get('first_parameter', vars(on_shapes.AtParameters)['first_parameter']),
        'properties': settings, 'piece': piece, 'only': "", 'parameter_u': 0.25, 'parameter_v': 0.75,
        'execute': lambda self, context: self.parameter_u})
    return menu().invoke(bpy.context, None)


def test_from_a_menu_the_parameter_is_one_of_the_active_curve_unless_it_is_given():
    insert, split = knot_verbs.SPLINEWRIGHT_OT_insert_knot, knot_verbs.SPLINEWRIGHT_OT_split
    first = add(value_of('nurbs'))
    assert np.isclose(first_parameter(insert), 2 / 3) and first_parameter(split) == 0.5
    assert first_parameter(split, given=['parameter_u']) == 0.25
    other = add([value_of('cubic'), sc.NurbsCurve(2, [5, 5, 5, 6, 8, 8, 8], shapes.points(4))], "other")
    activate(other, first)
    assert first_parameter(insert, piece=2) == 7 and first_parameter(split, piece=2) == 6.5
    assert first_parameter(insert) == 0.5 and first_parameter(insert, piece=3) == 0.25, "execute() refuses piece 3"


# What is said -----------------------------------------------------------------------------------------------------


def measured(before, after):
    """At equal parameters, on so many that little is missed."""
    at = np.linspace(*before.domain, 20001)
    return np.linalg.norm(before.evaluate(at) - after.evaluate(at), axis=1).max()


APPROXIMATING = (
    ('remove_knot', {'parameter_u': 0.3}, 'nurbs'), ('remove_knot', {'parameter_u': 0.3, 'times': 2}, 'three knots'),
    ('remove_knots', {'tolerance': 1.0}, 'three knots'), ('remove_knots', {'tolerance': 2.0}, 'hermite'),
    ('remove_knots', {'tolerance': 0.4}, 'periodic'), ('lower_degree', {}, 'nurbs'), ('lower_degree', {}, 'quintic'),
    ('lower_degree', {'times': 2}, 'quintic'), ('lower_degree', {}, 'hermite'), ('lower_degree', {}, 'periodic'),
    ('make_periodic', {'tolerance': 0.001}, 'nearly closed'),
    ('rebuild', {'count_u': 6}, 'nurbs'), ('rebuild', {'count_u': 7, 'degree_u': 4, 'keep_tangents': True}, 'quintic'),
    ('rebuild', {'by': 'TOLERANCE', 'tolerance': 0.03125}, 'hermite'), ('rebuild', {'count_u': 9}, 'periodic'),
    ('rebuild', {'count_u': 5, 'degree_u': 4}, 'nurbs'), ('rebuild', {'count_u': 12}, 'semicircle'),
    ('fair', {'tolerance': 0.0625}, 'nurbs'), ('fair', {'tolerance': 0.03125, 'keep_tangents': True}, 'three knots'),
    ('fair', {'tolerance': 0.03125}, 'periodic'), ('fair', {'tolerance': 0.0625}, 'hermite'))


@pytest.mark.parametrize('name, settings, kind', APPROXIMATING)
def test_the_error_said_is_the_error_made(name, settings, kind, said):
    before = value_of(kind)
    ob = add(before)
    assert run(name, **settings) == {'FINISHED'}
    after = ob.data.splinewright.value
    error = measured(before, after)
    assert error > 1e-6 and 0.94 * error < said_distance(said[0]) < 1.07 * error
    assert error <= settings.get('tolerance', np.inf)
    require_exact(ob)


@pytest.mark.parametrize('name, settings, kind, undoes', (
    ('remove_knot', {'parameter_u': 0.6}, 'nurbs', ('insert_knot', {'parameter_u': 0.6})),
    ('remove_knots', {}, 'cubic', ('insert_knot', {'where': 'SPANS'})),
    ('lower_degree', {'times': 2}, 'nurbs', ('raise_degree', {'times': 2})),
    ('lower_degree', {}, 'cubic', ('raise_degree', {}))))
def test_what_was_added_goes_without_an_error(name, settings, kind, undoes, said):
    before = value_of(kind)
    ob = add(before)
    run(undoes[0], **undoes[1])
    run(name, limited=True, tolerance=1e-9, **settings) if name != 'remove_knots' else run(name, tolerance=1e-9)
    after = ob.data.splinewright.value
    assert said_distance(said[1]) < 1e-12 and measured(before, after) < 1e-12
    assert len(after.points) == len(before.points)


@pytest.mark.parametrize('name, settings, kind', [row for row in APPROXIMATING if row[0] in ('rebuild', 'fair')])
def test_what_is_rebuilt_and_faired_is_taken_back_and_done_again(name, settings, kind):
    before = value_of(kind)
    ob = add(before)
    assert run(name, **settings) == {'FINISHED'}
    value = ob.data.splinewright.value
    bpy.ops.ed.undo()
    assert bpy.data.objects["shape"].data.splinewright.value == before != value
    bpy.ops.ed.redo()
    assert bpy.data.objects["shape"].data.splinewright.value == value


def test_what_is_rebuilt_and_faired_is_the_librarys():
    before = value_of('nurbs')
    ob = add(before)
    run('rebuild', count_u=7, degree_u=4, keep_tangents=True)
    assert ob.data.splinewright.value == before.rebuild(7, 4, ends='tangents').value
    run('fair', tolerance=0.125)
    assert ob.data.splinewright.value == before.rebuild(7, 4, ends='tangents').value.fair(0.125).value


@pytest.mark.parametrize('kind, tolerance', (('semicircle', 1e-3), ('circle', 1e-6)))
def test_a_conic_becomes_hermite_within_the_tolerance(kind, tolerance, said):
    ob = add(value_of(kind))
    run('to_hermite', tolerance=tolerance)
    chain = ob.data.splinewright.value
    assert isinstance(chain, sc.HermiteCurve)
    center, radius = ((0, 0, 0), 1.0) if kind == 'semicircle' else ((0.5, 0, 0), 2.0)
    points = chain.evaluate(np.linspace(*chain.domain, 20001))
    error = np.abs(np.linalg.norm(points - center, axis=1) - radius).max()
    assert 0 < error <= 1.06 * said_distance(said[0]) and said_distance(said[0]) <= 1.06 * tolerance


def test_counts_of_pieces_and_points_are_said(said):
    add(value_of('nurbs'))
    run('to_bezier')
    run('split', piece=2, parameter_u=0.5)
    assert said == [": 1 piece became 3, 6 points became 12", ": 3 pieces became 4, 12 points became 16"]
