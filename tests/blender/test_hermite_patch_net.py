"""Tangents and twists of a Hermite patch are handles of its net, at a third and a ninth of what they are."""

import bpy
import numpy as np
import pytest

from shapes import add, enter, leave, move, numbers_of, require_exact, select
from support import splinecore as sc

NETS = ('points', 'tangents_u', 'tangents_v', 'twists')
MOVE = np.array([0.5, -0.25, 2.0])


def patch(parameters=(None, None)):
    """2 x 3 points, with numbers that float32 does not hold."""
    random = np.random.default_rng(5)
    return sc.HermitePatch(*random.uniform(-1, 1, (4, 2, 3, 3)), parameters=parameters)


def vertex_of(held, net, i, j):
    """The vertex that sets a point, tangent or twist."""
    numbers, row = numbers_of(held), (net * 2 + i) * 3 + j
    found = np.flatnonzero(numbers.rows == row)
    assert len(found) == 1
    return int(found[0])


def after_moving(value, *handles):
    """The patch after these handles, of nets at places i and j, were dragged together."""
    ob = add(value)
    held = enter()
    select(held, *(vertex_of(held, *handle) for handle in handles))
    move(*MOVE)
    leave()
    ob = bpy.data.objects["shape"]
    require_exact(ob)
    return ob.data.splinewright.value


def require_changed(before, after, expected):
    """expected: by net and place, how many times the move is added. All else is as it was, in every bit."""
    for number, name in enumerate(NETS):
        was, now = getattr(before, name), getattr(after, name)
        others = np.ones((2, 3), bool)
        for (net, i, j), times in expected.items():
            if net == number:
                others[i, j] = False
                assert np.allclose(now[i, j] - was[i, j], times * MOVE, rtol=0, atol=abs(times) * 1e-6)
        assert now[others].tobytes() == was[others].tobytes(), name


def signs(i, j):
    """Of tangents along u and v: in the last row and column handles point back."""
    return (-1 if i == 1 else 1), (-1 if j == 2 else 1)


PLACES = pytest.mark.parametrize('i, j', [(i, j) for i in range(2) for j in range(3)])


@PLACES
def test_a_twist_handle_that_is_dragged_changes_its_twist_nine_times_as_much(i, j):
    before, (u, v) = patch(), signs(i, j)
    require_changed(before, after_moving(before, (3, i, j)), {(3, i, j): 9 * u * v})


@PLACES
@pytest.mark.parametrize('net', (1, 2))
def test_a_tangent_handle_dragged_with_its_twist_handle_changes_its_tangent_three_times_as_much(net, i, j):
    before = patch()
    require_changed(before, after_moving(before, (net, i, j), (3, i, j)), {(net, i, j): 3 * signs(i, j)[net - 1]})


@PLACES
@pytest.mark.parametrize('net', (1, 2))
def test_a_tangent_handle_dragged_alone_leaves_the_twist_handle_where_it_is(net, i, j):
    before, (u, v) = patch(), signs(i, j)
    expected = {(net, i, j): 3 * (u, v)[net - 1], (3, i, j): -9 * u * v}
    require_changed(before, after_moving(before, (net, i, j)), expected)


def test_handles_lie_at_a_third_of_the_steps_between_parameters():
    before = patch(([0, 0.6], [0, 1, 4]))
    after = after_moving(before, (1, 0, 1), (3, 0, 1))
    assert np.allclose((after.tangents_u - before.tangents_u)[0, 1], MOVE / 0.2, atol=1e-5)
    bpy.data.objects.remove(bpy.data.objects["shape"])
    after = after_moving(before, (3, 0, 1))
    assert np.allclose((after.twists - before.twists)[0, 1], MOVE / (0.2 * 1.0), atol=1e-5)
