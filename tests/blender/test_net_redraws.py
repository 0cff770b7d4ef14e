"""What panel and overlay show of a net is worked out when it changes, at once, and not at every redraw."""

import bpy
import numpy as np
import pytest

from layouts import drawn
from shapes import VALUES, add, enter, move, op, select
from support import part

net_props, selection = part('ui.net_props'), part('bridge.net.selection')


@pytest.fixture
def scans(monkeypatch):
    """Grows by one whenever the vertices of a net are asked for what is selected."""
    seen, scan = [], selection._selected

    def counted(ob, net):
        seen.append(ob.name)
        return scan(ob, net)

    monkeypatch.setattr(selection, '_selected', counted)
    return seen


def in_hand():
    return net_props.chosen(bpy.context.object.data)[1]


@pytest.mark.parametrize('name', ('nurbs patch', 'hermite patch', 'nurbs', 'hermite'))
def test_a_panel_asks_once_what_is_selected_until_that_changes(name, scans):
    add(VALUES[name]())
    held = enter()
    select(held, *range(6))
    bpy.context.view_layer.update()
    scans.clear()
    assert f"{len(in_hand())} of" in drawn()
    drawn()
    assert len(scans) == 1
    bpy.context.view_layer.update()
    drawn()
    assert len(scans) == 1
    kind = bpy.ops.mesh if held.type == 'MESH' else bpy.ops.curve
    for action, text in (('DESELECT', "Select points to edit them"), ('SELECT', " of "), ('INVERT', "Select points")):
        scans.clear()
        op(kind.select_all, action=action)
        bpy.context.view_layer.update()
        assert text in drawn() and len(scans) == 1
        drawn()
        assert len(scans) == 1


@pytest.mark.parametrize('name', ('nurbs patch', 'nurbs'))
def test_numbers_and_selection_are_those_of_this_moment(name):
    add(VALUES[name]())
    held = enter()
    select(held, 3)
    assert in_hand() == [3]
    before = np.array(held.data.splinewright_points.numbers[:3])
    move(0, 0, 1)
    assert np.allclose(held.data.splinewright_points.numbers[:3], before + (0, 0, 1), atol=1e-6)
    bpy.ops.ed.undo()
    held = bpy.context.object
    assert np.allclose(held.data.splinewright_points.numbers[:3], before, atol=1e-6) and in_hand() == [3]
    select(held, 1, 2)
    assert in_hand() == [1, 2]
    numbers = list(held.data.splinewright_points.numbers)
    numbers[0], numbers[4] = 0.5, 0.25
    held.data.splinewright_points.numbers = numbers
    bpy.context.view_layer.update()
    assert held.data.splinewright_points.numbers[0] == 0.5 and held.data.splinewright_points.numbers[4] == 0.25


def test_of_two_nets_each_has_its_own_selection():
    for name in "ab":
        add(VALUES['nurbs patch'](), name)
    for ob in bpy.data.objects:
        ob.select_set(True)
    enter()
    first, second = bpy.context.objects_in_mode
    select(first, 1)
    select(second, 2, 3)
    assert net_props.chosen(first.data)[1] == [1] and net_props.chosen(second.data)[1] == [2, 3]
    op(bpy.ops.mesh.select_all, action='SELECT')
    bpy.context.view_layer.update()
    assert len(net_props.chosen(first.data)[1]) == len(net_props.chosen(second.data)[1]) == 24
