"""Bad input raises InvalidShape or TypeError that names the argument, the place and the value."""

import numpy as np
import pytest

import splinecore as sc
from shapes import circle, closed_cubic, cubic, sphere_octant, torus

LINE = [(0, 0), (1, 1)]
NET = [[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 0)]]
LINEAR = [0, 0, 1, 1]
NAN, INF = float("nan"), float("inf")


def nurbs(degree=1, knots=LINEAR, points=LINE, **more):
    return sc.NurbsCurve(degree, knots, points, **more)


def net(degree=(1, 1), knots=(LINEAR, LINEAR), points=NET, **more):
    return sc.NurbsPatch(degree, knots, points, **more)


def chain(points=LINE, tangents=LINE, parameters=None):
    return sc.HermiteCurve(points, tangents, parameters)


def grid(points=NET, tangents_u=NET, tangents_v=NET, twists=None, parameters=None):
    return sc.HermitePatch(points, tangents_u, tangents_v, twists, parameters)


REFUSED = [
    # counts and degrees
    (lambda: nurbs(knots=[0, 0, 1]), r"points has 2 rows, but 3 knots"),
    (lambda: nurbs(knots=[0, 0, 0.5, 1, 1]), r"points|knots"),
    (lambda: nurbs(points=[(0, 0)]), r"points|knots"),
    (lambda: nurbs(knots=[]), r"knots has 0 values"),
    (lambda: nurbs(points=np.zeros((0, 3))), r"points|knots"),
    (lambda: nurbs(0, [0, 1, 2], LINE), r"degree = 0"),
    (lambda: nurbs(-3), r"degree = -3"),
    (lambda: nurbs(256), r"degree = 256"),
    (lambda: nurbs(10**30), r"degree = 10{30}"),
    (lambda: nurbs(-10**30), r"degree = -10{30}"),
    (lambda: nurbs(2**31), r"degree = 2147483648"),
    (lambda: sc.BezierCurve([(0, 0)]), r"points|degree = 0"),
    (lambda: sc.BezierPatch(np.zeros((1, 4, 3))), r"degree = 0|points"),
    (lambda: sc.BezierPatch(np.zeros((2, 300, 3))), r"degree = 299|points"),
    (lambda: net(points=np.zeros((2, 3, 3))), r"points has shape \(2, 3, 3\).* 2 x 2"),
    (lambda: net((0, 1), ([0, 1, 2], LINEAR)), r"degree in u = 0"),
    (lambda: net((1, 1), (LINEAR, [0, 1, 0, 1])), r"in v: knots\[2\] = 0 is below knots\[1\] = 1"),
    (lambda: chain(points=[(0, 0)], tangents=[(0, 0)]), r"points"),
    (lambda: chain(tangents=[(0, 0)]), r"tangents"),
    (lambda: chain(parameters=[0, 1, 2]), r"parameters"),
    (lambda: grid(tangents_u=np.zeros((2, 3, 3))), r"tangents_u has shape \(2, 3, 3\)"),
    (lambda: grid(tangents_v=np.zeros((4, 1, 3))), r"tangents_v has shape \(4, 1, 3\)"),
    (lambda: grid(twists=np.zeros((1, 4, 3))), r"twists has shape \(1, 4, 3\)"),
    (lambda: grid(parameters=([0, 1, 2], None)), r"parameters_u"),
    # knots
    (lambda: nurbs(knots=[0, 1, 0.5, 1]), r"knots\[2\] = 0.5 is below knots\[1\] = 1"),
    (lambda: nurbs(knots=[0, 0, 0, 1]), r"knots\[2\] = 0 has multiplicity above degree \+ 1 = 2"),
    (lambda: nurbs(knots=[0, 0, NAN, 1]), r"knots\[2\] = nan"),
    (lambda: nurbs(knots=[0, 0, 1, INF]), r"knots\[3\] = inf"),
    (lambda: nurbs(knots=[-1e308, -1e308, 1e308, 1e308]), r"knots .*overflow"),
    (lambda: nurbs(knots=[0, 1, 1, 2]), r"knots leave no domain"),
    (lambda: nurbs(1, [0, 0, 0], LINE, periodic=True), r"knots"),
    (lambda: nurbs(1, [3, 3], [(0, 0)], periodic=True), r"knots\[1\] = 3"),
    (lambda: nurbs(knots=[[0, 0], [1, 1]]), r"knots has shape \(2, 2\)"),
    (lambda: chain(parameters=[1, 1]), r"parameters\[1\] = 1"),
    (lambda: chain(parameters=[0, NAN]), r"parameters\[1\] = nan"),
    # points, weights
    (lambda: nurbs(points=[(0, 0), (1, NAN)]), r"points\[1\].y = nan"),
    (lambda: nurbs(points=[(0, 0), (-INF, 1)]), r"points\[1\].x = -inf"),
    (lambda: net(points=np.where(np.arange(12).reshape(2, 2, 3) == 11, INF, 0)), r"points\[1, 1\].z = inf"),
    (lambda: nurbs(weights=[1, NAN]), r"weights\[1\] = nan"),
    (lambda: nurbs(weights=[0, 0]), r"weights are all zero"),
    (lambda: nurbs(weights=[1]), r"weights has shape \(1,\)"),
    (lambda: nurbs(weights=1), r"weights has shape \(\)"),
    (lambda: net(weights=np.zeros((2, 2))), r"weights are all zero"),
    (lambda: net(weights=[1, 1, 1, 1]), r"weights has shape \(4,\)"),
    (lambda: nurbs(points=[0, 1]), r"points has shape \(2,\)"),
    (lambda: nurbs(points=[(0, 0, 0, 1), (1, 1, 1, 1)]), r"points has shape \(2, 4\)"),
    (lambda: nurbs(points=[(0,), (1,)]), r"points has shape \(2, 1\)"),
    (lambda: nurbs(points=[(0, 0), (1, 1, 1)]), r"points\[1\] = \(1, 1, 1\) has 3 values"),
    (lambda: chain(tangents=[(0, INF), (1, 1)]), r"tangents\[0(, \d)?\]\S* = inf|tangents.*inf"),
    (lambda: chain(tangents=np.zeros((2, 3, 3))), r"tangents has shape \(2, 3, 3\)"),
    (lambda: grid(twists=np.full((2, 2, 3), NAN)), r"twists\[0, 0\].x = nan"),
    (lambda: sc.NurbsCurve.from_homogeneous(1, LINEAR, [(0, 0, 0), (1, 1, 1)]), r"points has shape \(2, 3\)"),
    (lambda: sc.NurbsCurve.from_homogeneous(1, LINEAR, np.zeros((2, 4))), r"weights are all zero"),
    (lambda: sc.BezierCurve.from_homogeneous([(0, 0, 0, NAN), (1, 1, 1, 1)]), r"weights\[0\] = nan"),
    (lambda: sc.NurbsPatch.from_homogeneous((1, 1), (LINEAR, [0, 0, 1, 2, 2]), np.ones((3, 2, 4))), r"2 x 3"),
    (lambda: circle().with_points(LINE), r"points has shape \(2, 2\)"),
    (lambda: sc.BezierCurve(LINE).with_points(np.zeros((3, 3))), r"points has shape \(3, 3\)"),
    (lambda: sphere_octant().with_points(np.zeros((4, 3, 3))), r"points has shape \(4, 3, 3\)"),
    (lambda: torus().with_weights(np.ones((9, 8))), r"weights has shape \(9, 8\)"),
    (lambda: circle().with_weights([1, 1]), r"weights has 2 values for 9"),
    # parameters
    (lambda: circle().evaluate(4.1), r"u = 4.1 is outside the domain \[0, 4\]"),
    (lambda: circle().evaluate([0, 1, NAN]), r"u\[2\] = nan"),
    (lambda: circle().evaluate([[0, 1], [INF, 1]]), r"u\[1, 0\] = inf"),
    (lambda: circle().evaluate(np.r_[np.zeros(200_000), -1]), r"u\[200000\] = -1"),
    (lambda: closed_cubic().evaluate(INF), r"u = inf"),
    (lambda: circle().derivatives([0, -2], 1), r"u\[1\] = -2"),
    (lambda: torus().evaluate([[0], [5]], [0, 1, 2]), r"u\[1, 0\] = 5"),
    (lambda: torus().evaluate_grid([0], [1, NAN]), r"v\[1\] = nan"),
    (lambda: torus().evaluate_grid_with_normals([0, 9], [1]), r"u\[1\] = 9"),
    (lambda: torus().derivatives(0, -0.1, 1), r"v = -0.1"),
    (lambda: circle().derivatives(0, -1), r"order = -1"),
    (lambda: circle().derivatives(0, 65), r"order = 65"),
    (lambda: torus().derivatives(0, 0, 10**30), r"order = 10{30}"),
    (lambda: circle().evaluate(0, side="middle"), r"side = 'middle'"),
    (lambda: circle().evaluate(0, side=None), r"side = None"),
    (lambda: circle().evaluate(0, at_infinity="zero"), r"at_infinity = 'zero'"),
    (lambda: torus().evaluate(0, 0, side=("left", 3)), r"side = 3"),
    (lambda: torus().split("w", 1), r"axis = 'w'"),
    (lambda: torus().refine(0, [1]), r"axis = 0"),
    (lambda: circle().insert_knot(5), r"u = 5 is outside"),
    (lambda: circle().insert_knot(NAN), r"u = nan"),
    (lambda: circle().insert_knot(1, 2), r"multiplicity"),
    (lambda: circle().insert_knot(1.5, 0), r"times = 0"),
    (lambda: circle().insert_knot(1.5, 10**30), r"times = 10{30}"),
    (lambda: circle().refine([0.5, 9]), r"knots\[1\] = 9"),
    (lambda: circle().refine([[0.5]]), r"knots has shape \(1, 1\)"),
    (lambda: circle().split(0), r"u = 0 is not inside"),
    (lambda: cubic().split(INF), r"u = inf"),
    (lambda: sphere_octant().split("v", 1), r"[uv] = 1 is not inside"),
    (lambda: circle().polylines(0), r"resolution = 0"),
    (lambda: circle().polylines(10**9), r"resolution = 1000000000"),
    (lambda: circle().polylines(10**30), r"resolution = 10{30}"),
]


@pytest.mark.parametrize("call, words", REFUSED)
def test_bad_numbers_raise_invalid_shape_that_names_them(call, words):
    with pytest.raises(sc.InvalidShape, match=words):
        call()


NOT_NUMBERS = [None, "ab", b"ab", [None, None], ["a", "b"], [1j, 2j], [True, False], [object(), object()], {}, {1, 2},
               lambda: 0, [10**30, 1], np.array(["2020", "2021"], "M8[Y]"), np.zeros(2, "c16"), np.zeros(2, object),
               np.zeros(2, [("x", float)])]
TAKES_NUMBERS = {
    "knots": lambda bad: nurbs(knots=bad),
    "points": lambda bad: nurbs(points=bad),
    "weights": lambda bad: nurbs(weights="ab" if bad is None else bad),
    "tangents": lambda bad: chain(tangents=bad),
    "parameters": lambda bad: chain(parameters="ab" if bad is None else bad),
    "tangents_u": lambda bad: grid(tangents_u=bad),
    "tangents_v": lambda bad: grid(tangents_v=bad),
    "twists": lambda bad: grid(twists="ab" if bad is None else bad),
    "u": lambda bad: circle().evaluate(bad),
    "v": lambda bad: torus().evaluate(0, bad),
    "values": lambda bad: sc.basis.Samples(circle().knot_vector, [0]).apply(bad),
}


@pytest.mark.parametrize("argument", TAKES_NUMBERS)
@pytest.mark.parametrize("bad", NOT_NUMBERS, ids=lambda bad: repr(bad)[:20])
def test_what_is_no_real_number_raises_type_error_that_names_the_argument(argument, bad):
    with pytest.raises((TypeError, sc.InvalidShape), match=f"^{argument}") as caught:
        TAKES_NUMBERS[argument](bad)
    assert isinstance(caught.value, TypeError) or np.zeros(2, object) is bad


@pytest.mark.parametrize("bad, words", [
    ([(0, 0), (1, None)], r"points\[1, 1\] = None"), ([(0, "x"), (1, 1)], r"points\[0, 1\] = 'x' is"),
    ([(0, 0), (1, 2j)], r"points\[1, 1\] = 2j"), ([(0, 0), (b"1", 0)], r"points\[1, 0\] = b'1'"),
    ([(np.float32(0), np.int8(1)), (np.longdouble(2), "y")], r"points\[1, 1\] = 'y'"),
    (np.array([["0", "1"]]), r"points\[0, 0\] = '0'"),
    ([(0, 10**30), (1, 1)], r"points\[0, 1\] = 10{30}")])
def test_the_first_element_that_is_no_number_is_named(bad, words):
    with pytest.raises(TypeError, match=words):
        nurbs(points=bad)


@pytest.mark.parametrize("argument", [name for name in TAKES_NUMBERS if name not in ("points", "tangents", "tangents_u",
                                                                                   "tangents_v", "twists")])
def test_a_word_among_numbers_is_named_and_not_its_neighbors(argument):
    for bad in ([0.0, "abc", 1.0], (0.0, "abc", 1.0)):
        with pytest.raises(TypeError, match=rf"^{argument}\[1\] = 'abc' is not a real number"):
            TAKES_NUMBERS[argument](bad)


TAKES_ONE = {
    "degree": lambda bad: nurbs(bad), "periodic": lambda bad: nurbs(periodic=0.5 if bad is True else bad),
    "order": lambda bad: circle().derivatives(0, bad), "times": lambda bad: circle().insert_knot(0.5, bad),
    "resolution": lambda bad: circle().polylines(bad), "i": lambda bad: circle().knot_vector.function(bad, 0),
}


@pytest.mark.parametrize("argument", TAKES_ONE)
@pytest.mark.parametrize("bad", [None, "1", 1.0, 1j, [1], True, np.float64(1), np.array(1.5), Ellipsis, slice(3)])
def test_what_is_no_integer_raises_type_error_that_names_the_argument(argument, bad):
    with pytest.raises(TypeError, match=f"^{argument} "):
        TAKES_ONE[argument](bad)


@pytest.mark.parametrize("bad", [None, 3, (3,), (1, 2, 3), "11", b"11", {0: 1, 1: 1}, np.array(1), np.zeros((3, 2))])
def test_what_is_no_pair_raises_type_error_that_names_the_argument(bad):
    for name in ("degree", "knots", "periodic"):
        with pytest.raises(TypeError, match=f"^{name} = .* must be a pair"):
            net(**{name: bad})
    with pytest.raises(TypeError, match="^parameters = .* must be a pair"):
        grid(parameters=3 if bad is None else bad)


def test_unknown_missing_and_extra_arguments_raise_type_error():
    for call in (lambda: nurbs(color=1), lambda: sc.NurbsCurve(1, LINEAR), lambda: circle().evaluate(),
                 lambda: circle().evaluate(0, "left"), lambda: torus().evaluate(0), lambda: sc.NurbsCurve()):
        with pytest.raises(TypeError):
            call()


def test_an_error_of_the_input_itself_is_not_hidden():
    class Stubborn:
        def __array__(self, *_):
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        circle().evaluate(Stubborn())


def test_a_parameter_4_ulp_outside_is_moved_to_the_end():
    curve = cubic()
    start, end = curve.domain
    over = end
    for _ in range(3):
        over = np.nextafter(over, np.inf)
    assert np.array_equal(curve.evaluate(over), curve.evaluate(end))
    with pytest.raises(sc.InvalidShape):
        curve.evaluate(end * (1 + 1e-14))
