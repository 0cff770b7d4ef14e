"""What a damaged file may hold, by the thousand: it is refused in words, or it is a value. It never ends the process."""

import dataclasses

import numpy as np
import pytest

import damage
import splinecore as sc
from addon_core import core
from shapes import circle, closed_cubic, curves, hermite_chain, random_points, torus, wavy_patch

FAILURES = core("base.failures").FAILURES
DEFINITION = core("shape.definition")
TRIES = 400


def hermite_patch():
    return sc.HermitePatch(random_points(3, 2, seed=1), random_points(3, 2, seed=2), random_points(3, 2, seed=3))


VALUES = {type(value).__name__ + str(i): value for i, value in enumerate(
    [*curves(), [circle(), closed_cubic(), hermite_chain()], wavy_patch(), torus(), hermite_patch(),
     sc.BezierPatch(random_points(3, 4, seed=4)),
     sc.PatchSet.from_patches([wavy_patch(), hermite_patch(), sc.BezierPatch(random_points(2, 3, seed=5))])])}


def refused(action, *expected):
    """What an action gives, or None where it refuses with one of these errors and says why."""
    try:
        return action()
    except expected as error:
        assert str(error), f"{type(error).__name__} without a word"
        return None


def is_same(a, b):
    """Equal definitions, bit for bit."""
    return a.form == b.form and a.pool.tobytes() == b.pool.tobytes() and all(
        p.kind == q.kind and np.array_equal(p.indices, q.indices) and p.degree == q.degree and p.periodic == q.periodic
        and [k.tobytes() for k in p.knots] == [k.tobytes() for k in q.knots] for p, q in zip(a.pieces, b.pieces))


def look_at(value):
    """What everything else relies on, of a value that came through."""
    again = DEFINITION.from_value(value)
    again.require_consistent()
    assert DEFINITION.to_value(again) == value
    assert sc.loads(sc.dumps(value)) == value
    if isinstance(value, sc.PatchSet):
        refused(lambda: sc.Tessellation(value, 2).evaluate(value), ValueError, ArithmeticError)
    elif isinstance(value, sc.NurbsCurve):
        refused(lambda: value.evaluate(value.domain[0]), ArithmeticError)


def damaged_definitions(value):
    random = np.random.default_rng(11)
    for _ in range(TRIES):
        definition = DEFINITION.from_value(value)
        for _ in range(random.integers(1, 4)):
            definition = damage.damaged_definition(random, definition)
        yield definition


@pytest.mark.parametrize("name", VALUES)
def test_a_damaged_definition_is_refused_or_a_value(name):
    came_through = 0
    for definition in damaged_definitions(VALUES[name]):
        def read(definition=definition):
            definition.require_consistent()
            return DEFINITION.to_value(definition)
        value = refused(read, ValueError, TypeError, AttributeError, IndexError, OverflowError)
        if value is not None:
            came_through += 1
            look_at(value)
    assert 0 < came_through < TRIES


@pytest.mark.parametrize("name", VALUES)
def test_what_nobody_looked_through_does_not_end_the_process(name):
    for definition in damaged_definitions(VALUES[name]):
        refused(lambda definition=definition: DEFINITION.to_value(definition), ValueError, TypeError, AttributeError,
                IndexError, OverflowError)


def test_damaged_mappings_of_patches_are_refused_or_a_set():
    random, start = np.random.default_rng(12), VALUES["PatchSet11"]
    for _ in range(6 * TRIES):
        patches = [dict(patch) for patch in start.patches]
        points, weights = start.points, start.weights
        for _ in range(random.integers(1, 4)):
            at = random.integers(len(patches) + 2)
            if at < len(patches):
                patches[at] = damage.damaged_fields(random, patches[at])
            elif at == len(patches):
                points = damage.damaged_array(random, points)
            else:
                weights = damage.damaged_array(random, weights)
        made = refused(lambda: sc.PatchSet(points, patches, weights), ValueError, TypeError)
        if made is not None:
            look_at(made)


@pytest.mark.parametrize("name", VALUES)
def test_damaged_texts_are_refused_or_a_value(name):
    random, text = np.random.default_rng(13), sc.dumps(VALUES[name])
    for _ in range(2 * TRIES):
        changed = damage.damaged_text(random, text)
        value = refused(lambda: sc.loads(changed), sc.InvalidShape)
        if value is not None:
            assert sc.loads(sc.dumps(value)) == value
        data = refused(lambda: sc.loads(changed.encode('utf-8', 'surrogatepass')), sc.InvalidShape)
        assert data == value


def test_damaged_bpt_is_refused_or_a_set():
    random = np.random.default_rng(14)
    text = sc.bpt.dumps(sc.PatchSet.from_patches([sc.BezierPatch(random_points(3, 2, seed=1)), wavy_bezier()]))
    for _ in range(4 * TRIES):
        made = refused(lambda: sc.bpt.loads(damage.damaged_text(random, text)), sc.InvalidShape)
        if made is not None:
            assert sc.loads(sc.dumps(made)) == made


def wavy_bezier():
    return sc.BezierPatch(random_points(4, 4, seed=2))


@pytest.mark.parametrize("name", VALUES)
def test_an_undamaged_definition_is_the_same_again(name):
    definition = DEFINITION.from_value(VALUES[name])
    definition.require_consistent()
    assert is_same(DEFINITION.from_value(DEFINITION.to_value(definition)), definition)


@pytest.mark.parametrize("name", ["NurbsCurve0", "BezierPatch10", "PatchSet11"])
def test_each_number_of_a_pool_may_be_anything(name):
    definition = DEFINITION.from_value(VALUES[name])
    for at in range(min(definition.pool.size, 24)):
        for number in damage.HARD:
            pool = definition.pool.copy()
            pool.flat[at] = number
            changed = dataclasses.replace(definition, pool=pool)
            value = refused(lambda changed=changed: DEFINITION.to_value(changed), *FAILURES)
            if value is not None:
                look_at(value)
