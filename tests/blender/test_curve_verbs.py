"""The verbs of curve shapes as operators: what they keep, what they say, what they refuse."""

import re

import bpy
import numpy as np
import pytest

import shapes
from shapes import VALUES, activate, add, by_hand, enter, op, require_exact, shown
from support import part, splinecore as sc

curve_verbs, store = part('ui.operators.curve_verbs'), part('bridge.store')

ALL = ('cubic', 'rational cubic', 'quintic', 'semicircle', 'hermite', 'hermite with corners', 'closed hermite', 'nurbs',
       'periodic')
WITH_KNOTS = ('hermite', 'hermite with corners', 'closed hermite', 'nurbs', 'periodic')
MORE = {
    'parabola': lambda: sc.BezierCurve(shapes.points(3)),
    'uniform': lambda: sc.NurbsCurve(3, np.arange(12.0), shapes.points(8), shapes.RANDOM.uniform(0.5, 2, 8)),
    'hyperbola': lambda: sc.BezierCurve([(1, 0), (1, 1), (0, 1)], [1, -2, 1]),
    'circle': lambda: sc.conics.circle((0.5, 0, 0), 2.0),
    'three knots': lambda: sc.NurbsCurve(3, [0, 0, 0, 0, 0.1, 1 / 3, 1 / 3, 1, 1, 1, 1], shapes.points(7)),
    'nearly closed': lambda: sc.BezierCurve([(0, 0), (1, 0), (1, 1), (0, 1e-4)]),
}

#: Operator, settings, kinds of curves that it keeps.
KEEPING = (
    ('insert_knot', {'parameter': 0.3}, ALL), ('insert_knot', {'where': 'SPANS', 'times': 2}, ALL),
    ('raise_degree', {'times': 2}, ALL), ('reverse', {}, ALL),
    ('split_curve', {'parameter': 0.3}, ALL), ('split_curve', {'where': 'KNOTS'}, WITH_KNOTS),
    ('reparametrise', {'start': -1.5, 'end': 3.1}, ALL), ('reparametrise', {'how': 'MOEBIUS', 'rho': 2.5}, ALL),
    ('standard_form', {}, ('rational cubic', 'nurbs')), ('clamp', {}, ('periodic', 'uniform')), ('unclamp', {}, ALL),
    ('make_periodic', {}, ('closed hermite', 'circle')), ('to_bezier_chain', {}, WITH_KNOTS),
    ('to_hermite', {}, ('cubic', 'parabola', 'periodic', 'three knots')),
    ('to_nurbs', {}, ('cubic', 'rational cubic', 'quintic', 'semicircle', 'hermite', 'closed hermite')))


def value_of(kind):
    """The same one at every call."""
    shapes.RANDOM.bit_generator.state = np.random.default_rng(7).bit_generator.state
    return (VALUES.get(kind) or MORE[kind])()


def run(name, **settings):
    """With the defaults of what is not given: Blender remembers the last ones."""
    operator = getattr(bpy.ops.splinewright, name)
    defaults = {p.identifier: p.default for p in operator.get_rna_type().properties if p.identifier != 'rna_type'}
    return op(operator, **{**defaults, **settings})


def curves_of(ob):
    value = ob.data.splinewright.value
    return value if isinstance(value, list) else [value]


@pytest.fixture
def said(monkeypatch):
    """What the operators say behind the name of what they did."""
    texts = []

    def told(outcomes, told=curve_verbs.told):
        texts.append(told(outcomes))
        return texts[-1]
    for module in (curve_verbs, part('ui.operators.curve_join')):
        monkeypatch.setattr(module, 'told', told)
    return texts


def said_distance(text):
    """The distance at the end of a sentence, 0 where none is said."""
    found = re.search(r"largest distance (\S+)$", text)
    return float(found.group(1)) if found else 0.0


def distinct_knots(curve):
    start, end = curve.domain
    knots = curve.to_nurbs().knots
    return np.unique(knots[(knots >= start) & (knots <= end)])


def breaks_of(curve, name, settings):
    """The parameters between which the curves lie that come out, on the curve that went in."""
    start, end = curve.domain
    if name == 'to_bezier_chain' or settings.get('where') == 'KNOTS' and name == 'split_curve':
        return distinct_knots(curve)
    if name == 'split_curve':
        at = settings['parameter']
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
        worst = max(worst, np.abs(points - before.evaluate(at)).max())
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


KINDS_AFTERWARDS = (('to_bezier_chain', 'nurbs', sc.BezierCurve), ('to_hermite', 'cubic', sc.HermiteCurve),
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
    run('reparametrise', start=0.1, end=0.7)
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
    run('insert_knot', parameter=1 / 3, times=2)
    knots = ob.data.splinewright.value.knots
    assert (knots == 1 / 3).sum() == 3 and np.float32(1 / 3) not in knots
    run('remove_knot', parameter=1 / 3, nearest=False, times=2)
    assert (ob.data.splinewright.value.knots == 1 / 3).sum() == 1
    run('split_curve', parameter=1 / 3)
    assert [curve.domain for curve in curves_of(ob)] == [(0, 1 / 3), (1 / 3, 1)]


def test_from_a_menu_the_parameter_is_the_middle_of_the_widest_span_of_the_active_curve():
    ob = add(value_of('nurbs'))
    assert bpy.ops.splinewright.insert_knot('INVOKE_DEFAULT', where='PARAMETER') == {'FINISHED'}
    assert np.isclose(ob.data.splinewright.value.knots, 2 / 3).sum() == 1
    assert bpy.ops.splinewright.split_curve('INVOKE_DEFAULT', where='PARAMETER') == {'FINISHED'}
    assert curves_of(ob)[0].domain == (0, 0.5)
    ob = add(sc.NurbsCurve(2, [5, 5, 5, 6, 6, 6], np.eye(3)), "other")
    assert bpy.ops.splinewright.insert_knot('INVOKE_DEFAULT', where='PARAMETER') == {'FINISHED'}
    assert 5.5 in ob.data.splinewright.value.knots, "the number of another curve is not kept"


# What is said -----------------------------------------------------------------------------------------------------


def measured(before, after):
    """At equal parameters, on so many that little is missed."""
    at = np.linspace(*before.domain, 20001)
    return np.linalg.norm(before.evaluate(at) - after.evaluate(at), axis=1).max()


APPROXIMATING = (
    ('remove_knot', {'parameter': 0.3}, 'nurbs'), ('remove_knot', {'parameter': 0.0, 'times': 2}, 'three knots'),
    ('remove_knots', {'tolerance': 1.0}, 'three knots'), ('remove_knots', {'tolerance': 2.0}, 'hermite'),
    ('remove_knots', {'tolerance': 0.4}, 'periodic'), ('lower_degree', {}, 'nurbs'), ('lower_degree', {}, 'quintic'),
    ('lower_degree', {'times': 2}, 'quintic'), ('lower_degree', {}, 'hermite'), ('lower_degree', {}, 'periodic'),
    ('make_periodic', {'tolerance': 0.001}, 'nearly closed'))


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
    ('remove_knot', {'parameter': 0.6}, 'nurbs', ('insert_knot', {'parameter': 0.6})),
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


@pytest.mark.parametrize('kind, tolerance', (('semicircle', 1e-3), ('circle', 1e-6)))
def test_a_conic_becomes_hermite_within_the_tolerance(kind, tolerance, said):
    ob = add(value_of(kind))
    run('to_hermite', tolerance=tolerance)
    chain = ob.data.splinewright.value
    assert isinstance(chain, sc.HermiteCurve)
    centre, radius = ((0, 0, 0), 1.0) if kind == 'semicircle' else ((0.5, 0, 0), 2.0)
    points = chain.evaluate(np.linspace(*chain.domain, 20001))
    error = np.abs(np.linalg.norm(points - centre, axis=1) - radius).max()
    assert 0 < error <= 1.06 * said_distance(said[0]) and said_distance(said[0]) <= 1.06 * tolerance


def test_counts_of_pieces_and_points_are_said(said):
    add(value_of('nurbs'))
    run('to_bezier_chain')
    run('split_curve', piece=2, parameter=0.5)
    assert said == [": 1 piece became 3, 6 points became 12", ": 3 pieces became 4, 12 points became 16"]


# What is refused --------------------------------------------------------------------------------------------------


def state(ob):
    """Everything that a refusal must leave."""
    return store.read(ob.data).pool.tobytes(), str(ob.data.splinewright.value), shown(ob).tobytes(), len(ob.data.splines)


REFUSED = (
    ('insert_knot', {'parameter': 1.5}, 'nurbs', "outside the domain"),
    ('insert_knot', {'parameter': 0.0}, 'nurbs', "multiplicity 5"),
    ('insert_knot', {'parameter': 1 / 3, 'times': 8}, 'nurbs', "times|multiplicity"),
    ('remove_knot', {}, 'cubic', "no inner knot"),
    ('remove_knot', {'parameter': 0.4, 'nearest': False}, 'nurbs', "no knot that can be removed"),
    ('remove_knot', {'times': 5}, 'nurbs', "times = 5"),
    ('remove_knot', {'limited': True, 'tolerance': 1e-3}, 'nurbs', "within 0.001: the error would be"),
    ('remove_knots', {'tolerance': 1e-3}, 'nurbs', "no knot can go"),
    ('lower_degree', {'times': 3}, 'cubic', "times = 3"),
    ('lower_degree', {'limited': True, 'tolerance': 0.0}, 'cubic', "the error would be"),
    ('lower_degree', {}, 'semicircle', "weights"),
    ('raise_degree', {'times': 1000}, 'cubic', "times = 1000"),
    ('split_curve', {'parameter': 2.0}, 'cubic', "u = 2"), ('split_curve', {'parameter': 1.0}, 'nurbs', "u = 1"),
    ('split_curve', {'where': 'KNOTS'}, 'cubic', "no inner knot"),
    ('reparametrise', {'start': 1.0, 'end': 1.0}, 'nurbs', "domain"),
    ('reparametrise', {'start': 2.0, 'end': 1.0}, 'hermite', "domain"),
    ('reparametrise', {'start': 0.0, 'end': 1.0}, 'nurbs', "these already"),
    ('reparametrise', {'how': 'MOEBIUS', 'rho': 0.0}, 'nurbs', "rho"),
    ('reparametrise', {'how': 'MOEBIUS', 'rho': -1.0}, 'cubic', "rho"),
    ('standard_form', {}, 'cubic', "1 already"), ('standard_form', {}, 'uniform', "clamped"),
    ('clamp', {}, 'nurbs', "already"), ('unclamp', {}, 'uniform', "already"),
    ('make_periodic', {}, 'cubic', "do not meet"), ('make_periodic', {}, 'periodic', "already"),
    ('to_bezier_chain', {}, 'quintic', "already"), ('to_nurbs', {}, 'periodic', "already"),
    ('to_hermite', {}, 'hermite', "already"), ('to_hermite', {}, 'quintic', "degree = 5"),
    ('to_hermite', {}, 'rational cubic', "not rational"), ('to_hermite', {}, 'hyperbola', "infinity"),
    ('to_hermite', {'tolerance': 1e-12}, 'large circle', "cannot be had"),
    ('reverse', {'piece': 2}, 'cubic', "1 piece, there is none of number 2"),
    ('reverse', {'piece': 5}, 'many curves', "4 pieces, there is none of number 5"),
    ('insert_knot', {'parameter': 0.3}, 'many curves', "piece 2: u = 0.3 is outside"),
    ('lower_degree', {}, 'many curves', "piece 3: weights"))
MORE['large circle'] = lambda: sc.conics.circle((0, 0, 0), 1e6)


@pytest.mark.parametrize('name, settings, kind, word', REFUSED)
def test_what_cannot_be_done_is_said_and_nothing_is_lost(name, settings, kind, word):
    ob = add(value_of(kind))
    before = state(ob)
    with pytest.raises(RuntimeError, match=f"shape: .*({word})"):
        run(name, **settings)
    assert state(ob) == before


NAMES = [cls.bl_idname.split('.')[1] for cls in curve_verbs.CLASSES]


@pytest.mark.parametrize('name', (*NAMES, 'join_ends'))
def test_a_recipe_a_follower_and_what_was_changed_by_hand_are_refused(name):
    op(bpy.ops.splinewright.add_circle)
    circle = bpy.context.object
    original = add([value_of('nurbs'), value_of('cubic')])
    follower = add([value_of('nurbs'), value_of('cubic')], "follower")
    activate(original)
    op(bpy.ops.splinewright.follow_object)
    follower = bpy.context.object
    touched = add([value_of('nurbs'), value_of('cubic')], "touched")
    by_hand(touched)
    for ob, word in ((circle, "Make Editable"), (follower, "Make Editable"), (touched, "changed by hand")):
        activate(ob)
        before = state(ob)
        with pytest.raises(RuntimeError, match=word):
            run(name)
        assert state(ob) == before
    activate(circle)
    op(bpy.ops.splinewright.make_editable)
    if name in ('raise_degree', 'reverse', 'unclamp'):
        assert run(name) == {'FINISHED'}


@pytest.mark.parametrize('name', (*NAMES, 'join_ends'))
def test_linked_and_overridden_shapes_and_newer_ones_are_refused(name, tmp_path):
    add([value_of('nurbs'), value_of('cubic')])
    path = str(tmp_path / "library.blend")
    bpy.ops.wm.save_as_mainfile(filepath=path)
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
    with bpy.data.libraries.load(path, link=True) as (_, target):
        target.objects = ["shape"]
    linked = target.objects[0]
    bpy.context.scene.collection.objects.link(linked)
    bpy.context.view_layer.update()
    overridden = linked.override_create(remap_local_usages=True)
    newer = add([value_of('nurbs'), value_of('cubic')], "newer")
    newer.data[store.KEY]['version'] = 99
    for ob, word in ((overridden, "linked"), (newer, "newer Splinewright")):
        activate(ob)
        before = shown(ob).tobytes()
        with pytest.raises(RuntimeError, match=word):
            run(name)
        assert shown(ob).tobytes() == before


@pytest.mark.parametrize('name', NAMES)
def test_an_operator_wants_a_selected_curve_shape_in_object_mode(name):
    operator = getattr(bpy.ops.splinewright, name)
    assert not operator.poll()
    add(value_of_patch())
    assert not operator.poll()
    with pytest.raises(RuntimeError, match="Select a curve shape"):
        operator()
    bpy.ops.curve.primitive_bezier_curve_add()
    assert not operator.poll()
    add(value_of('nurbs'), "curve")
    assert operator.poll()
    enter()
    assert not operator.poll()
    with pytest.raises(RuntimeError, match="Leave the present mode"):
        operator()


def value_of_patch():
    return sc.BezierPatch(np.random.default_rng(1).uniform(size=(3, 3, 3)))


# Which curves -----------------------------------------------------------------------------------------------------


def test_one_piece_or_all_of_them():
    ob = add([value_of('nurbs'), value_of('cubic')])
    run('raise_degree', piece=2)
    assert [curve.degree for curve in curves_of(ob)] == [3, 4]
    assert curves_of(ob)[0] == value_of('nurbs')
    run('raise_degree')
    assert [curve.degree for curve in curves_of(ob)] == [4, 5]


def test_a_list_of_one_stays_a_list_and_a_curve_becomes_one_where_it_must():
    ob = add([value_of('nurbs')])
    run('reverse')
    assert isinstance(ob.data.splinewright.value, list)
    ob = add(value_of('nurbs'), "single")
    run('reverse')
    assert isinstance(ob.data.splinewright.value, sc.NurbsCurve)
    run('split_curve', parameter=0.5)
    assert isinstance(ob.data.splinewright.value, list)


def test_every_selected_shape_is_done_those_that_share_data_once_and_failures_are_named(capfd):
    first, second, third = (add(value_of(kind), kind) for kind in ('nurbs', 'cubic', 'quintic'))
    twin = bpy.data.objects.new("twin", first.data)
    bpy.context.scene.collection.objects.link(twin)
    patch = add(value_of_patch(), "patch")
    activate(twin, first, second, third, patch)
    assert run('raise_degree') == {'FINISHED'}
    assert [ob.data.splinewright.value.degree for ob in (first, second, third)] == [4, 4, 6]
    assert run('lower_degree', times=4) == {'FINISHED'}, "quintic alone has so many"
    assert [ob.data.splinewright.value.degree for ob in (first, second, third)] == [4, 4, 2]
    with pytest.raises(RuntimeError, match="(?s)nurbs|twin.*cubic.*quintic"):
        run('lower_degree', times=9)


# How it looks -----------------------------------------------------------------------------------------------------


def dressed(value):
    """A shape whose splines differ in material, radius, tilt and shading."""
    ob = add(value)
    for i, spline in enumerate(ob.data.splines):
        ob.data.materials.append(bpy.data.materials.new(str(i)))
        spline.material_index, spline.use_smooth = i, bool(i % 2)
        for point in spline.points:
            point.radius, point.tilt = 1 + i, i / 4
    ob.data.bevel_depth = 0.1
    bpy.ops.ed.undo_push(message="dress")
    return ob


def looks(ob):
    return [(spline.material_index, spline.use_smooth, {p.radius for p in spline.points}, {p.tilt for p in spline.points})
            for spline in ob.data.splines]


def look(i):
    return i, bool(i % 2), {1.0 + i}, {i / 4}


@pytest.mark.parametrize('name, settings, expected', (
    ('reverse', {}, [0, 1, 2]), ('raise_degree', {}, [0, 1, 2]), ('to_bezier_chain', {}, [0, 0, 0, 1, 2, 2]),
    ('split_curve', {'piece': 2, 'parameter': 0.5}, [0, 1, 1, 2]),
    ('insert_knot', {'where': 'SPANS'}, [0, 1, 2])))
def test_material_radius_tilt_and_shading_stay_with_each_piece(name, settings, expected):
    ob = dressed([value_of('nurbs'), value_of('cubic'), sc.HermiteCurve(shapes.points(3), shapes.points(3))])
    run(name, **settings)
    assert looks(ob) == [look(i) for i in expected]
    assert ob.data.bevel_depth == np.float32(0.1) and len(ob.data.materials) == 3
    bpy.ops.ed.undo()
    assert looks(bpy.data.objects["shape"]) == [look(i) for i in range(3)]


def test_the_arms_of_a_hyperbola_keep_their_looks_and_the_reach():
    ob = dressed([value_of('hyperbola'), value_of('cubic')])
    ob.data.splinewright.reach = 3.0
    assert len(ob.data.splines) == 4 and looks(ob) == [look(i) for i in range(4)]
    before = curves_of(ob)[0]
    run('raise_degree')
    require_exact(ob)
    assert looks(ob) == [look(i) for i in range(4)]
    at = np.linspace(0, 1, 41)
    points, was = (curve.evaluate(at, at_infinity='nan') for curve in (curves_of(ob)[0], before))
    assert np.allclose(points, was, rtol=1e-12, atol=1e-12, equal_nan=True)
    run('split_curve', piece=1, parameter=0.5)
    require_exact(ob)
    assert looks(ob) == [look(0)] * 4 + [look(3)], "two parts of two arms each"


# The redo panel ---------------------------------------------------------------------------------------------------


@pytest.mark.parametrize('cls', curve_verbs.CLASSES, ids=lambda cls: cls.bl_idname)
def test_every_setting_is_described_and_shown(cls):
    properties = {p.identifier: p for p in getattr(bpy.ops.splinewright, cls.bl_idname.split('.')[1]).get_rna_type().properties
                  if p.identifier != 'rna_type'}
    assert all(p.name and (p.description or p.type == 'ENUM') for p in properties.values())
    assert {'REGISTER', 'UNDO'} <= cls.bl_options and cls.bl_description and not cls.bl_description.endswith('.')
    shown_names = set()
    for choice in {'where': ('PARAMETER', 'KNOTS'), 'how': ('AFFINE', 'MOEBIUS'), 'limited': (False, True)}.items():
        for value in choice[1]:
            drawn = drawn_by(cls, {**{name: p.default for name, p in properties.items()}, choice[0]: value})
            assert set(drawn) <= set(properties) and drawn[-1] == 'piece'
            shown_names |= set(drawn)
    assert shown_names == set(properties)


def drawn_by(cls, values):
    """The names of the properties that the redo panel shows. Operators cannot be made by hand, what they inherit can."""
    names = []

    class Layout:
        def prop(self, _, name):
            names.append(name)
    own = {key: value for key, value in vars(cls).items() if key in ('settings', 'draw', 'allowed', 'limits')}
    bases = tuple(base for base in cls.__bases__ if not issubclass(base, bpy.types.Operator))
    panel = type("Panel", bases, {**own, '__annotations__': dict(cls.__annotations__), **values, 'layout': Layout()})()
    panel.draw(None)
    return names
