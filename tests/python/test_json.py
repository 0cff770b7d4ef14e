"""dumps and loads: exact both ways, and strict about what is read."""

import json

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import splinecore as sc
from shapes import circle, closed_cubic, cubic, curves, hermite_chain, hermite_net, parabola, patches, point_lists, semicircle

finite = st.floats(allow_nan=False, allow_infinity=False, width=64)


def values():
    return [*curves(), *patches(), sc.PatchSet.from_patches(patches()), ring(), ring() - ring()]


def ring():
    return sc.Region.of([sc.conics.circle((1, 0, 0), 2.0), circle()])


@pytest.mark.parametrize("value", values(), ids=lambda value: type(value).__name__)
def test_every_kind_is_read_back_equal(value):
    text = value.dumps()
    again = sc.loads(text)
    assert again == value and type(again) is type(value) and again.dumps() == text
    assert sc.dumps(value) == text and sc.loads(text.encode()) == value
    assert json.loads(text)["format"] == "splinecore"


@given(st.lists(st.tuples(finite, finite, finite), min_size=2, max_size=6), st.data())
def test_every_bit_of_every_number_is_read_back(points, data):
    weights = data.draw(st.lists(finite, min_size=len(points), max_size=len(points)).filter(any))
    curve = sc.BezierCurve(points, weights)
    again = sc.loads(curve.dumps())
    assert again.points.tobytes() == curve.points.tobytes()
    assert again.weights.tobytes() == curve.weights.tobytes()


@given(st.lists(point_lists(), max_size=4))
def test_lists_are_read_back_as_lists(lists):
    shapes = [sc.BezierCurve(points) for points in lists]
    assert sc.loads(sc.dumps(shapes)) == shapes
    assert sc.loads(sc.dumps(tuple(shapes))) == shapes


def test_lists_mix_kinds_and_keep_their_order():
    assert sc.loads(sc.dumps(values())) == values()
    assert sc.loads(sc.dumps([])) == []


@pytest.mark.parametrize("value", [None, 1, "text", [None], [circle(), 3], [[circle()]], {"a": circle()},
                                   circle().knot_vector])
def test_what_is_no_shape_is_refused(value):
    with pytest.raises(TypeError, match="value must be"):
        sc.dumps(value)


DAMAGED = [
    ("", "damaged at byte"), ("{", "damaged at byte"), ("[1, 2]", "splinecore"), ("3", "splinecore"), ("null", "splinecore"),
    ("{}", "splinecore"), ('{"format": "other"}', "splinecore"), ('{"format": "splinecore"}', "version"),
    ('{"format": "splinecore", "version": 1}', "kind"),
    ('{"format": "splinecore", "version": 4, "kind": "bezier_curve"}', "newer"),
    ('{"format": "splinecore", "version": 0}', "version 0"), ('{"format": "splinecore", "version": "1"}', "version"),
    ('{"format": "splinecore", "version": 1, "kind": "cone"}', "cone"),
    ('{"format": "splinecore", "version": 1, "items": 3}', "items"),
    ('{"format": "splinecore", "version": 1, "items": [3]}', "kind"),
    ('{"format": "splinecore", "version": 1e400}', "too large"),
    ("\ufeff{}", "splinecore|damaged"), ("\ud800", "Unicode"), (b"\xff\xfe", "Unicode"), (b'{"\xc3', "Unicode"),
]


@pytest.mark.parametrize("text, words", DAMAGED, ids=lambda text: repr(text)[:30])
def test_damaged_text_is_refused_with_the_place(text, words):
    with pytest.raises(sc.InvalidShape, match=words):
        sc.loads(text)


@pytest.mark.parametrize("text", [None, 3, bytearray(b"{}"), ["{}"], {}])
def test_what_is_no_text_is_refused(text):
    with pytest.raises(TypeError, match="text must be a str"):
        sc.loads(text)


@pytest.mark.parametrize("value", values(), ids=lambda value: type(value).__name__)
def test_every_cut_text_is_refused(value):
    text = value.dumps()
    for length in range(0, len(text), max(1, len(text) // 200)):
        with pytest.raises(sc.InvalidShape):
            sc.loads(text[:length])


def places(node, path=()):
    yield path
    children = node.items() if isinstance(node, dict) else enumerate(node) if isinstance(node, list) else ()
    for key, child in children:
        yield from places(child, (*path, key))


def changed(tree, path, junk):
    """The tree with one place replaced, or without it."""
    if not path:
        return None if junk is KeyError else junk
    node = tree = json.loads(json.dumps(tree))
    for key in path[:-1]:
        node = node[key]
    if junk is KeyError:
        del node[path[-1]]
    else:
        node[path[-1]] = junk
    return tree


SMALL = [semicircle(), hermite_chain(), cubic(), closed_cubic(), sc.BezierPatch(np.arange(18).reshape(2, 3, 3)),
         parabola(), hermite_net(), sc.PatchSet.from_patches([hermite_net(), patches()[1]]), ring()]


@pytest.mark.parametrize("value", SMALL, ids=lambda value: type(value).__name__)
def test_no_change_of_one_place_is_worse_than_invalid_shape(value):
    tree = json.loads(value.dumps())
    for path in list(places(tree))[::3]:
        for junk in (None, "x", -1, 1e300, 2**40, True, [], {}, [[]], KeyError):
            try:
                sc.loads(json.dumps(changed(tree, path, junk)))
            except sc.InvalidShape as error:
                assert str(error)


def test_a_text_is_of_the_first_version_that_knows_its_kinds():
    assert json.loads(circle().dumps())["version"] == 1 and json.loads(parabola().dumps())["version"] == 2
    assert json.loads(sc.dumps([circle(), parabola()]))["version"] == 2
    assert json.loads(sc.dumps([circle(), ring(), parabola()]))["version"] == 3
    assert sc.loads(circle().dumps().replace('"version":1', '"version":2')) == circle()


def test_a_text_nested_too_deeply_is_refused():
    for text in ('{"format":' + '[' * 200_000 + ']' * 200_000 + '}', '[' * 200_000, '{"kind":' * 100_000):
        with pytest.raises(sc.InvalidShape, match="nested more deeply|damaged"):
            sc.loads(text)


def test_a_net_that_is_turned_against_its_knots_is_refused():
    patch = sc.NurbsPatch((1, 2), ([0, 0, 1, 1], [0, 0, 0, 1, 1, 1]), np.zeros((2, 3, 3)))
    fields = json.loads(patch.dumps())
    fields["points"] = np.array(fields["points"]).swapaxes(0, 1).tolist()
    with pytest.raises(sc.InvalidShape, match="points is 3 x 2, but the knots belong to 2 x 3"):
        sc.loads(json.dumps(fields))


@pytest.mark.parametrize("text", ["é", '{"format": é}', "{'日': 1}", '"' + "x" * 400 + "é"])
def test_a_message_that_quotes_half_a_character_is_not_lost(text):
    with pytest.raises(sc.InvalidShape, match="JSON: the text is damaged at byte"):
        sc.loads(text)
