"""Values: equal, hashed, copied, pickled, printed; never changed."""

import copy
import pickle

import numpy as np
import pytest

import splinecore as sc
from shapes import circle, curves, cubic, hermite_net, patches, torus


def values():
    return [*curves(), *patches(), sc.PatchSet.from_patches(patches()), circle().knot_vector]


ids = [type(value).__name__ for value in values()]
every = pytest.mark.parametrize("index", range(len(ids)), ids=ids)


@every
def test_equal_values_are_equal_and_have_one_hash(index):
    one, other = values()[index], values()[index]
    assert one is not other and one == other and hash(one) == hash(other)
    assert not one != other and len({one, other}) == 1


@every
def test_values_of_other_kinds_differ(index):
    value = values()[index]
    assert all(value != other for i, other in enumerate(values()) if i != index)
    for stranger in (None, 1, "text", object(), [value]):
        assert value != stranger and not value == stranger
    assert value.__eq__(1) is NotImplemented


@every
def test_copies_and_pickles_are_equal(index):
    value = values()[index]
    for protocol in range(2, pickle.HIGHEST_PROTOCOL + 1):
        again = pickle.loads(pickle.dumps(value, protocol))
        assert again == value and type(again) is type(value) and hash(again) == hash(value)
    assert copy.copy(value) == value and copy.deepcopy(value) == value


@every
def test_text_names_the_kind(index):
    value = values()[index]
    assert repr(value).startswith(type(value).__name__ + "(") and repr(value).endswith(")")


def test_text_tells_the_sizes():
    assert repr(circle()) == "NurbsCurve(degree=2, points=9, rational)"
    assert repr(torus()) == "NurbsPatch(degree=(2, 2), points=(9, 9), rational)"
    assert repr(hermite_net()) == "HermitePatch(points=(3, 2))"
    flat = sc.PatchSet.from_patches([torus()], merge=False)
    assert repr(flat) == "PatchSet(patches=1, points=81)"
    mesh = sc.Tessellation(flat, 4)
    assert repr(mesh) == f"Tessellation(patches=1, vertices={mesh.vertex_count}, faces={len(mesh.face_starts)})"
    assert repr(sc.basis.Samples(sc.basis.KnotVector(1, [0, 0, 1, 1]), [0.5, 0.7], 1)) == "Samples(count=2, degree=1, order=1)"


def test_zeros_of_both_signs_are_equal_with_one_hash():
    one, other = sc.BezierCurve([(0.0, 0), (1, -0.05)]), sc.BezierCurve([(-0.0, -0.0), (1, -0.05)])
    assert one == other and hash(one) == hash(other)
    assert sc.basis.KnotVector(1, [-0.0, 0.0, 1, 1]) == sc.basis.KnotVector(1, [0, 0, 1, 1])


def test_the_last_bit_of_one_number_makes_a_difference():
    points = cubic().points.copy()
    points[3, 1] = np.nextafter(points[3, 1], 9)
    assert cubic().with_points(points) != cubic()


@pytest.mark.parametrize("name", ["degree", "points", "knots", "domain", "color"])
def test_attributes_cannot_be_set(name):
    with pytest.raises(AttributeError):
        setattr(circle(), name, 1)


def test_a_second_init_changes_nothing():
    curve = circle()
    points = curve.points
    curve.__init__(1, [0, 0, 1, 1], [(0, 0), (1, 1)])
    assert curve == circle() and np.array_equal(points, circle().points)


@pytest.mark.parametrize("kind", [sc.NurbsCurve, sc.BezierCurve, sc.HermiteCurve, sc.PowerCurve, sc.NurbsPatch, sc.BezierPatch,
                                  sc.HermitePatch, sc.PatchSet, sc.Tessellation, sc.basis.KnotVector,
                                  sc.basis.Samples])
def test_an_object_that_no_constructor_filled_is_refused(kind):
    empty = kind.__new__(kind)
    for name in ("points", "degree", "count", "vertex_count", "first"):
        if hasattr(kind, name):
            with pytest.raises(TypeError, match="constructor"):
                getattr(empty, name)
    with pytest.raises(TypeError):
        kind()


def test_classes_name_the_package():
    assert sc.NurbsCurve.__module__ == "splinecore" and sc.basis.KnotVector.__module__ == "splinecore.basis"


def test_damaged_pickles_are_refused():
    text = pickle.dumps(circle())
    with pytest.raises(Exception):
        pickle.loads(text.replace(b"nurbs_curve", b"nurbs_curvy"))
    made = sc.BezierPatch.__new__(sc.BezierPatch)
    with pytest.raises((ValueError, RuntimeError)):
        made.__setstate__(circle().dumps())


def test_values_that_differ_have_hashes_that_differ():
    points = cubic().points.copy()
    points[3, 1] = np.nextafter(points[3, 1], 9)
    bezier = sc.BezierPatch(np.arange(36.0).reshape(3, 4, 3))
    turned = sc.BezierPatch(bezier.points.reshape(4, 3, 3))
    some = [cubic(), cubic().with_points(points), bezier, turned, bezier.to_nurbs(), sc.PatchSet.from_patches([bezier]),
            sc.PatchSet.from_patches([turned]), sc.PatchSet.from_patches([bezier]).flipped()]
    assert len({hash(one) for one in some}) == len(some)


def test_zeros_of_both_signs_have_one_hash_in_patches_too():
    net = np.zeros((3, 4, 3))
    net[..., 0], net[..., 1] = np.meshgrid(range(3), range(4), indexing='ij')
    one, other = sc.BezierPatch(net), sc.BezierPatch(np.where(net == 0, -0.0, net))
    for a, b in ((one, other), (one.to_nurbs(), other.to_nurbs()),
                 (sc.PatchSet.from_patches([one], merge=False), sc.PatchSet.from_patches([other], merge=False))):
        assert a == b and hash(a) == hash(b)
