"""What another setting may do leaves the panel of the last operator there; what no setting can is refused."""

from types import SimpleNamespace

import bpy
import pytest

from curves import value_of
from layouts import Layout
from patches import value_of as patch_of
from shapes import add, enter, leave, select
from support import part, splinecore as sc

pieces = part('ui.operators.pieces')
decreasing = "0 0 0 0 3 2 3 3 3 3"


def asked(name, **settings):
    """As from a menu: in background nothing is invoked."""
    return getattr(bpy.ops.splinewright, name)('EXEC_DEFAULT', True, by_hand=True, **settings)


@pytest.mark.parametrize('name, value', (('make_periodic', lambda: value_of('cubic')), ('remove_knots', lambda: value_of('nurbs')),
                                         ('make_periodic', lambda: patch_of('bicubic')),
                                         ('reparameterize', lambda: value_of('cubic'))))
def test_the_panel_stays_where_a_setting_may_do_it(name, value, capfd):
    ob = add(value())
    before = ob.data.splinewright.value
    assert asked(name) == {'FINISHED'}
    assert ob.data.splinewright.value == before and "Warning: Nothing changed; shape: " in capfd.readouterr().out
    with pytest.raises(RuntimeError):
        getattr(bpy.ops.splinewright, name)('EXEC_DEFAULT', True)


def test_what_no_setting_can_do_is_refused_by_hand_too():
    add(value_of('cubic'))
    with pytest.raises(RuntimeError, match="are Bezier already"):
        asked('to_bezier')
    bpy.ops.splinewright.add_circle()
    with pytest.raises(RuntimeError, match="made by a recipe"):
        asked('make_periodic')


@pytest.mark.parametrize('is_refused', (False, True))
@pytest.mark.parametrize('said, word', (("Lowered the degree of shape: largest distance 0.22", "largest distance 0.22"),
                                        ("Nothing changed; shape: the ends do not meet", "do not meet")))
def test_the_panel_of_the_last_operator_says_what_came_of_it(said, word, is_refused):
    layout = Layout()
    operator = SimpleNamespace(result=said, layout=layout, is_refused=is_refused)
    part('ui.operators.selected').OnSelected.draw_result(operator)
    assert word in " ".join(layout.texts)


@pytest.mark.parametrize('text, words', (
    (decreasing, "knot 6, 2, is smaller than the one before it, 3"), ("0 0 0 0 1 2 3 3 3", "9 knots were given, 10 are needed"),
    ("0 0 0 0 one 2 3 3 3 3", "'one', word 5 of the knots, is not a number")))
def test_knots_are_refused_in_words_and_the_text_is_there_again(text, words):
    bpy.ops.splinewright.add_nurbs_curve()
    ob, operator = bpy.context.object, part('ui.operators.set_knots').SPLINEWRIGHT_OT_set_knots
    with pytest.raises(RuntimeError, match=words):
        bpy.ops.splinewright.set_knots(knots=text)
    again = SimpleNamespace(piece=1, axis='U', _refused=operator._refused, _axis=lambda: 0, _place=lambda: "1 U")
    operator._show_knots(again, ob.data)
    operator._show_refused(again, ob.data)
    assert again.knots == text
    assert bpy.ops.splinewright.set_knots(knots="0 0 0 0 1 2.5 3 3 3 3") == {'FINISHED'}
    again._refused = operator._refused
    operator._show_knots(again, ob.data)
    operator._show_refused(again, ob.data)
    assert again.knots == "0 0 0 0 1 2.5 3 3 3 3"


def test_parameters_of_a_chain_must_grow():
    bpy.ops.splinewright.add_bezier_chain()
    with pytest.raises(RuntimeError, match="parameter 3, 1, is not larger than the one before it, 1"):
        bpy.ops.splinewright.set_knots(knots="0 1 1 2")


@pytest.mark.parametrize('name', ('add_bezier_curve', 'add_bezier_chain', 'add_hermite_curve', 'add_nurbs_curve', 'add_line',
                                  'add_nurbs_patch', 'add_bezier_patch'))
def test_new_shapes_have_no_roundings(name):
    closed = {'add_hermite_curve': {'closed': True}, 'add_nurbs_curve': {'knots': 'PERIODIC'},
              'add_nurbs_patch': {'knots_u': 'PERIODIC', 'knots_v': 'PERIODIC'}}
    for settings in ({}, closed.get(name, {})):
        getattr(bpy.ops.splinewright, name)(**settings)
        for number in part('bridge.data.store').read(bpy.context.object.data).pool.ravel():
            assert number == 0 and str(number) == "0.0" or abs(number) > 1e-12, number


def test_the_median_and_the_space_of_selected_points():
    ob = add(sc.NurbsCurve(1, [0, 0, 1, 2, 2], [(0, 0, 0), (1, 0, 0), (2, 0, 3)]))
    ob.location, ob.scale = (10, 0, 0), (2, 2, 2)
    bpy.context.view_layer.update()
    held = enter()
    points = held.data.splinewright_points
    select(held, 1, 2)
    assert tuple(points.median) == (1.5, 0, 1.5)
    points.space = 'GLOBAL'
    assert tuple(points.median) == (13, 0, 3) and tuple(points.numbers[:3]) == (12, 0, 0)
    points.median = (13.2, 0, 3)
    bpy.context.view_layer.update()
    points.space = 'LOCAL'
    points.median = (points.median[0], 0.1, 1.5)
    bpy.context.view_layer.update()
    leave()
    found = part('bridge.data.store').read(bpy.data.objects["shape"].data).pool
    assert found[:, :3].tolist() == [[0, 0, 0], [pytest.approx(1.1), 0.1, 0], [pytest.approx(2.1), 0.1, 3]]
