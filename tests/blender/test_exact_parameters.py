"""What a click or the knot strip gives another command has every digit, where Blender's properties hold float32."""

import math
from types import SimpleNamespace

import bpy
import numpy as np
import pytest

from shapes import activate, add, enter, op, require_exact
from support import part, splinecore as sc

parameters, strip_keys, on_shapes, insert_here = (part(name) for name in (
    'core.shape.parameters', 'ui.operators.strip_keys', 'ui.operators.on_shapes', 'ui.operators.insert_here'))
THIRD = math.pi / 10
KNOTS = np.array([0, 0, 0, 0, 0.25, 1 / 3, 0.5, 1, 1, 1, 1])


def curve(knots=KNOTS):
    ob = add(sc.NurbsCurve(3, knots, [(i, i * i % 3, 0) for i in range(len(knots) - 4)]))
    ob.name = "shape"
    return ob


def patch():
    ob = add(sc.NurbsPatch((3, 2), (KNOTS, [0, 0, 0, 0.4, 1, 1, 1]), np.random.default_rng(3).uniform(-1, 1, (7, 4, 3))))
    ob.name = "shape"
    return ob


def value():
    return bpy.data.objects["shape"].data.splinewright.value


def click(cls, *at, direction='U'):
    """What clicking does of which the mouse says this."""
    aimed = SimpleNamespace(name="shape", number=1, parameters=at, direction=direction)
    said = []
    operator = SimpleNamespace(report=lambda kind, text: said.append((kind, text)), bl_label="", at_once=False)
    operator.done_at = lambda *args, **settings: cls.done_at(operator, *args, **settings)
    return cls.clicked(operator, aimed), said


@pytest.mark.parametrize('in_net', (False, True))
def test_a_knot_that_is_clicked_in_lies_where_the_click_was(in_net):
    curve()
    if in_net:
        enter()
    assert click(insert_here.SPLINEWRIGHT_OT_insert_here, THIRD)[0] == {'FINISHED'}
    assert THIRD in value().knots.tolist() and float(np.float32(THIRD)) != THIRD


@pytest.mark.parametrize('direction', ('U', 'V', 'BOTH'))
def test_patches_are_cut_and_isocurves_taken_at_the_very_parameters(direction):
    patch()
    before, (u, v) = value(), (THIRD, 0.1 + math.e / 10)
    assert click(insert_here.SPLINEWRIGHT_OT_extract_here, u, v, direction=direction)[0] == {'FINISHED'}
    found = bpy.context.object.data.splinewright.value
    expected = [before.isocurve(axis, at) for axis, at in (('u', u), ('v', v)) if direction in ('BOTH', axis.upper())]
    assert (found if isinstance(found, list) else [found]) == expected
    activate(bpy.data.objects["shape"])
    assert click(insert_here.SPLINEWRIGHT_OT_insert_here, u, v, direction=direction)[0] == {'FINISHED'}
    assert [at in knots.tolist() for at, knots in zip((u, v), value().knots)] == [direction in ('U', 'BOTH'), direction in ('V', 'BOTH')]
    assert click(insert_here.SPLINEWRIGHT_OT_split_here, u, v, direction=direction)[0] == {'FINISHED'}
    assert len(value()) == (4 if direction == 'BOTH' else 2)
    assert value()[0].domain == ((0.0, u if direction in ('U', 'BOTH') else 1.0), (0.0, v if direction in ('V', 'BOTH') else 1.0))


def test_at_a_knot_it_is_that_knot():
    curve()
    for at in (np.nextafter(1 / 3, 1), 1 / 3 + 1e-12):
        assert click(insert_here.SPLINEWRIGHT_OT_insert_here, at)[0] == {'FINISHED'}
    assert (value().knots == 1 / 3).sum() == 3


def test_knots_that_float32_takes_for_one_are_told_apart():
    """Such as those of a domain far from 0."""
    curve(KNOTS + 1e7)
    at = 1e7 + 0.7
    assert np.float32(at) == np.float32(1e7 + 1.0)
    assert click(insert_here.SPLINEWRIGHT_OT_insert_here, at)[0] == {'FINISHED'} and at in value().knots.tolist()
    hit = SimpleNamespace(shown=SimpleNamespace(ob=bpy.data.objects["shape"], number=1), bar=SimpleNamespace(name=""), value=at, mark=1)
    assert strip_keys.SPLINEWRIGHT_OT_remove_on_strip.call(SimpleNamespace(), bpy.context, hit) == {'FINISHED'}
    assert np.allclose(value().knots, KNOTS + 1e7, atol=0)
    hit.value = 1e7 + 0.6
    assert strip_keys.SPLINEWRIGHT_OT_insert_on_strip.call(SimpleNamespace(), bpy.context, hit) == {'FINISHED'}
    assert hit.value in value().knots.tolist()


def test_the_strip_reaches_both_directions_of_patches():
    ob = patch()
    for axis, at in (('u', THIRD), ('v', THIRD / 2)):
        hit = SimpleNamespace(shown=SimpleNamespace(ob=ob, number=1), bar=SimpleNamespace(name=axis), value=at, mark=None)
        assert strip_keys.SPLINEWRIGHT_OT_insert_on_strip.call(SimpleNamespace(), bpy.context, hit) == {'FINISHED'}
    assert THIRD in value().knots[0].tolist() and THIRD / 2 in value().knots[1].tolist()
    require_exact(ob)


def test_another_number_in_the_redo_panel_counts():
    curve()
    assert op(bpy.ops.splinewright.insert_knot, parameter_u=0.75, exact=repr(THIRD)) == {'FINISHED'}
    assert 0.75 in value().knots.tolist() and THIRD not in value().knots.tolist()


@pytest.mark.parametrize('text', ("", "nonsense", "nan", "inf", "1e999", "0.3 0.4 0.5", "0x3"))
def test_texts_that_are_no_such_number_do_nothing(text):
    curve()
    assert op(bpy.ops.splinewright.insert_knot, parameter_u=0.125, exact=text) == {'FINISHED'}
    assert 0.125 in value().knots.tolist() and len(value().knots) == len(KNOTS) + 1


def test_trims_by_click_name_the_part_that_is_clicked():
    ob = add([sc.NurbsCurve(1, [1e7, 1e7, 1e7 + 1, 1e7 + 1], [(0, 0, 0), (4, 0, 0)]), *[
        sc.NurbsCurve(1, [0, 0, 1, 1], [(x, -1, 0), (x, 1, 0)]) for x in (1.0, 2.0, 3.0)]])
    ob.name = "shape"
    trim = part('ui.operators.curve_here').SPLINEWRIGHT_OT_trim_here
    operator = SimpleNamespace(report=lambda *_: None, meet='VISIBLE')
    operator.operator = lambda *args: trim.operator(operator, *args)
    assert trim.clicked(operator, SimpleNamespace(name="shape", number=1, parameters=(1e7 + 0.6,))) == {'FINISHED'}
    ends = sorted(float(end) for piece in value() for end in piece.evaluate(np.array(piece.domain))[:, 0] if np.ptp(piece.points[:, 1]) == 0)
    assert np.allclose(ends, [0, 2, 3, 4], atol=1e-6)


@pytest.mark.parametrize('name, at', (('split_here', 0.0), ('split_here', 1.0), ('insert_here', 2.0), ('split_here', math.nan)))
def test_what_is_refused_in_a_command_that_another_calls_is_a_report(name, at):
    curve()
    before = value()
    result, said = click(getattr(insert_here, f"SPLINEWRIGHT_OT_{name}"), at)
    assert result == {'CANCELLED'} and said and said[-1][0] == {'ERROR'} and "Traceback" not in said[-1][1]
    assert value() == before
