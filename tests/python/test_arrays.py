"""What arrays go in and come out: shapes, dtypes, strides, out, views."""

import numpy as np
import pytest

import splinecore as sc
from shapes import circle, cubic, curves, hermite_chain, hermite_net, patches, random_points, torus, wavy_patch


@pytest.mark.parametrize("shape", [(), (1,), (7,), (0,), (2, 3), (0, 4), (2, 3, 4)])
def test_parameters_of_any_shape_give_points_of_that_shape(shape):
    curve = circle()
    u = np.linspace(0.1, 3.9, int(np.prod(shape))).reshape(shape)
    points = curve.evaluate(u)
    assert points.shape == (*shape, 3) and points.dtype == np.float64 and points.flags.c_contiguous
    assert curve.derivatives(u, 2).shape == (*shape, 3, 3)
    assert np.array_equal(points.reshape(-1, 3), curve.evaluate(u.ravel()))
    patch = torus()
    assert patch.evaluate(u, u).shape == (*shape, 3)
    assert patch.derivatives(u, u, 1).shape == (*shape, 2, 2, 3)


def test_u_and_v_are_broadcast():
    patch = wavy_patch()
    u, v = np.linspace(0, 2, 3)[:, None], np.linspace(0, 5, 4)
    assert patch.evaluate(u, v).shape == (3, 4, 3)
    assert patch.evaluate(u, 1.0).shape == (3, 1, 3)
    assert patch.derivatives(0.5, v, 1).shape == (4, 2, 2, 3)
    with pytest.raises(sc.InvalidShape, match=r"u of shape \(3,\) and v of shape \(4,\)"):
        patch.evaluate([0, 1, 2], [0, 1, 2, 3])


def test_grids_may_be_empty():
    patch = torus()
    assert patch.evaluate_grid([], [1, 2]).shape == (0, 2, 3)
    assert patch.evaluate_grid([1], []).shape == (1, 0, 3)
    points, normals = patch.evaluate_grid_with_normals([], [])
    assert points.shape == normals.shape == (0, 0, 3)
    with pytest.raises(sc.InvalidShape, match=r"u has shape \(\)"):
        patch.evaluate_grid(1.0, [1.0])
    with pytest.raises(sc.InvalidShape, match=r"v has shape \(1, 1\)"):
        patch.evaluate_grid([1.0], [[1.0]])


@pytest.mark.parametrize("dtype", ["f2", "f4", "f8", "g", ">f8", ">f4", "i1", "i4", "i8", "u1", "u8"])
def test_every_real_dtype_is_taken(dtype):
    values = np.array([0, 1, 2, 3, 4], dtype)
    assert np.array_equal(circle().evaluate(values), circle().evaluate([0.0, 1.0, 2.0, 3.0, 4.0]))
    points = np.array([(0, 1), (2, 3), (4, 5)], dtype)
    curve = sc.NurbsCurve(2, np.array([0, 0, 0, 1, 1, 1], dtype), points, np.array([1, 2, 1], dtype))
    assert curve.points.tolist() == [[0, 1, 0], [2, 3, 0], [4, 5, 0]]
    assert curve == sc.NurbsCurve(2, [0, 0, 0, 1, 1, 1], [(0, 1), (2, 3), (4, 5)], [1, 2, 1])


def test_every_stride_is_taken():
    u = np.linspace(0, 4, 24)
    expected = circle().evaluate(u)
    assert np.array_equal(circle().evaluate(u[::-1]), expected[::-1])
    assert np.array_equal(circle().evaluate(u[::3]), expected[::3])
    assert np.array_equal(circle().evaluate(np.asfortranarray(u.reshape(4, 6))), expected.reshape(4, 6, 3))
    assert np.array_equal(circle().evaluate(np.broadcast_to(u[5], (2, 2))), np.broadcast_to(expected[5], (2, 2, 3)))
    net = random_points(5, 4, seed=1)
    assert sc.BezierPatch(np.asfortranarray(net)) == sc.BezierPatch(net)
    assert sc.BezierPatch(net[::-1].copy()[::-1]) == sc.BezierPatch(net)
    assert sc.BezierPatch(net.swapaxes(0, 1)) == sc.BezierPatch(net).swapped()


def test_unaligned_numbers_are_taken():
    raw = bytearray(8 * 5 + 1)
    u = np.frombuffer(raw, "f8", offset=1)
    u[:] = [0, 1, 2, 3, 4]
    assert np.array_equal(circle().evaluate(u), circle().evaluate([0, 1, 2, 3, 4]))


def test_read_only_input_is_taken_and_input_is_never_changed():
    u, points, weights = np.linspace(0, 1, 5), random_points(4, seed=2), np.linspace(1, 2, 4)
    kept = [array.copy() for array in (u, points, weights)]
    for array in (u, points, weights):
        array.flags.writeable = False
    curve = sc.BezierCurve(points, weights)
    curve.evaluate(u), curve.derivatives(u, 2), curve.with_points(points), curve.with_weights(weights)
    assert all(np.array_equal(a, b) for a, b in zip((u, points, weights), kept))


def test_a_value_does_not_follow_its_input():
    points = random_points(4, seed=2)
    curve = sc.BezierCurve(points)
    before = curve.evaluate(0.5)
    points[:] = 0
    assert np.array_equal(curve.evaluate(0.5), before)


def test_two_columns_mean_z_is_zero():
    net = random_points(3, 3, seed=3)[..., :2]
    assert (sc.BezierPatch(net).points[..., 2] == 0).all()
    assert (sc.HermiteCurve([(0, 1), (2, 3)], [(1, 0), (0, 1)]).tangents[..., 2] == 0).all()
    assert (sc.PatchSet(net.reshape(-1, 2), [[[0, 1], [3, 4]]]).points[:, 2] == 0).all()


@pytest.mark.parametrize("dtype", [np.float32, "f4", np.dtype("float32")])
def test_float32_is_the_rounded_float64(dtype):
    u, v = np.linspace(0, 4, 9), np.linspace(0, 4, 7)
    for exact, single in [(circle().evaluate(u), circle().evaluate(u, dtype=dtype)),
                          (torus().evaluate(u, u), torus().evaluate(u, u, dtype=dtype)),
                          (torus().evaluate_grid(u, v), torus().evaluate_grid(u, v, dtype=dtype))]:
        assert single.dtype == np.float32 and np.array_equal(single, exact.astype("f4"))
    exact, single = (torus().evaluate_grid_with_normals(u, v, dtype=kind) for kind in ("f8", dtype))
    assert all(np.array_equal(s, e.astype("f4")) for s, e in zip(single, exact))


@pytest.mark.parametrize("rational", [False, True])
def test_what_is_too_large_for_float32_is_infinite_and_normals_are_those_of_float64(rational):
    u = np.linspace(0, 1, 9)
    net = 1e39 * random_points(4, 4, seed=5)
    weights = np.linspace(0.5, 2, 16).reshape(4, 4) if rational else None
    curve, patch = sc.BezierCurve(net[0], None if weights is None else weights[0]), sc.BezierPatch(net, weights)
    points, normals = patch.evaluate_grid_with_normals(u, u)
    single, single_normals = patch.evaluate_grid_with_normals(u, u, dtype="f4")
    with np.errstate(over="ignore"):
        for exact, found in [(curve.evaluate(u), curve.evaluate(u, dtype="f4")),
                             (patch.evaluate(u, u), patch.evaluate(u, u, dtype="f4")), (points, single)]:
            assert np.isinf(found).any() and np.array_equal(found, exact.astype("f4"))
    assert np.isfinite(normals).all() and np.array_equal(single_normals, normals.astype("f4"))


@pytest.mark.parametrize("dtype", ["f8", "f4"])
def test_out_is_filled_and_returned(dtype):
    u, v = np.linspace(0, 4, 6), np.linspace(0, 4, 5)
    for verb, where in [(circle().evaluate, (u,)), (torus().evaluate, (u[:5], v)), (torus().evaluate_grid, (u, v))]:
        expected = verb(*where)
        out = np.full(expected.shape, 7, dtype)
        assert verb(*where, out=out) is out
        assert np.array_equal(out, expected.astype(dtype))
    part = np.zeros((10, 3))
    circle().evaluate(u, out=part[2:8])
    assert np.array_equal(part[2:8], circle().evaluate(u)) and not part[:2].any() and not part[8:].any()


def test_out_takes_derivatives_too():
    u, v = np.linspace(0, 4, 6), np.linspace(0, 4, 6)
    for verb, where in [(circle().derivatives, (u, 0)), (circle().derivatives, (u, 2)), (circle().derivatives, (u, 5)),
                        (torus().derivatives, (u, v, 1)), (torus().derivatives, (u, v, 3)),
                        (torus().first_derivatives, (u, v))]:
        expected = verb(*where)
        out = np.full(expected.shape, 7.0)
        assert verb(*where, out=out) is out
        assert np.array_equal(out, expected)


def test_out_may_lie_over_the_parameters():
    memory = np.linspace(0, 4, 90)
    u = memory[60:]
    expected = circle().evaluate(u.copy())
    assert np.array_equal(circle().evaluate(u, out=memory.reshape(30, 3)), expected)


def test_out_of_another_kind_is_refused():
    u = [0.0, 1.0]
    unaligned = np.frombuffer(bytearray(49), "f8", count=6, offset=1).reshape(2, 3)
    frozen = np.zeros((2, 3))
    frozen.flags.writeable = False
    for out, error, words in [
            (np.zeros((3, 3)), sc.InvalidShape, r"out has shape \(3, 3\), the result has \(2, 3\)"),
            (np.zeros((2, 6))[:, ::2], sc.InvalidShape, "out is not C-contiguous"),
            (np.zeros((2, 3), order="F"), sc.InvalidShape, "out is not C-contiguous"),
            (unaligned, sc.InvalidShape, "out is not aligned"),
            (frozen, sc.InvalidShape, "out is read-only"),
            (np.zeros((2, 3), int), TypeError, "out has dtype int64"),
            (np.zeros((2, 3), ">f8"), TypeError, "out has dtype >f8"),
            ([[0, 0, 0], [0, 0, 0]], TypeError, "out must be a numpy array, not list")]:
        with pytest.raises(error, match=words):
            circle().evaluate(u, out=out)
    with pytest.raises(TypeError, match="out has dtype float64, but dtype is float32"):
        circle().evaluate(u, out=np.zeros((2, 3)), dtype="f4")
    for dtype in ("i4", "f2", "nonsense", 3.5):
        with pytest.raises(TypeError, match="dtype"):
            circle().evaluate(u, dtype=dtype)
    with pytest.raises(TypeError, match="^out has dtype float32, float64 is expected$"):
        circle().derivatives(u, 1, out=np.zeros((2, 2, 3), np.float32))
    with pytest.raises(TypeError, match="^out has dtype float32, float64 is expected$"):
        torus().first_derivatives(u, u, out=np.zeros((2, 3, 3), np.float32))
    with pytest.raises(TypeError, match="must be a pair: an array for points, one for normals"):
        torus().evaluate_grid_with_normals([0.0, 1.0, 2.0], u, out=np.zeros((3, 2, 3)))


def test_masked_numbers_are_refused_and_a_mask_of_none_is_not():
    points = np.ma.array([(0.0, 0.0), (1.0, 1.0), (2.0, 0.0)], mask=[(0, 0), (0, 1), (0, 0)])
    with pytest.raises(TypeError, match=r"^points\[1, 1\] = masked is not a real number"):
        sc.BezierCurve(points)
    with pytest.raises(TypeError, match=r"^points\[1, 1\] = masked is not a real number"):
        sc.fit.interpolate(points, 2)
    curve = sc.BezierCurve(points.data)
    with pytest.raises(TypeError, match=r"^u\[2\] = masked"):
        curve.evaluate(np.ma.masked_greater([0.0, 0.5, 2.0], 1.0))
    with pytest.raises(TypeError, match=r"^u = masked"):
        curve.evaluate(np.ma.masked)
    assert sc.BezierCurve(np.ma.array(points.data)) == curve
    assert np.array_equal(curve.evaluate(np.ma.array([0.0, 0.5])), curve.evaluate([0.0, 0.5]))


def test_numbers_in_an_array_of_objects_are_refused_as_what_they_are():
    with pytest.raises(TypeError, match="u is an array of objects: give it a dtype of numbers"):
        circle().evaluate(np.array([0.5, 0.7], object))
    with pytest.raises(TypeError, match=r"u\[1\] = None is not a real number"):
        circle().evaluate(np.array([0.5, None], object))


def arrays_of(value):
    for name in dir(type(value)):
        if isinstance(getattr(type(value), name), property) and name != "domain":
            got = getattr(value, name)
            for array in got if isinstance(got, (tuple, list)) else [got]:
                if isinstance(array, dict):
                    yield from ((name, part) for part in array.values() if isinstance(part, np.ndarray))
                elif isinstance(array, np.ndarray):
                    yield name, array


def everything():
    pool = sc.PatchSet.from_patches(patches())
    return [*curves(), *patches(), pool, sc.Tessellation(pool, 2), circle().knot_vector]


@pytest.mark.parametrize("value", everything(), ids=lambda value: type(value).__name__)
def test_arrays_handed_out_are_read_only(value):
    names = set()
    for name, array in arrays_of(value):
        names.add(name)
        assert not array.flags.writeable, name
        if name != "homogeneous_points":  # not a view, but numbers made for the caller
            with pytest.raises(ValueError):
                array.flags.writeable = True
    assert names


def test_views_outlive_their_value():
    import gc

    views = [array.copy() for _, array in arrays_of(cubic())], [array for _, array in arrays_of(cubic())]
    gc.collect()
    assert all(np.array_equal(a, b) for a, b in zip(*views))


def test_points_come_back_bit_for_bit():
    points = np.array([(-0.0, 5e-324, 1e-310), (0.1, 1 / 3, -1e300), (1e-17, 2.0**-1074, 1.0)])
    weights = np.array([3.3, -0.0, 1e-5])
    curve = sc.BezierCurve(points, weights)
    assert curve.points.tobytes() == points.tobytes() and curve.weights.tobytes() == weights.tobytes()
    chain = sc.HermiteCurve(points[:2], points[1:])
    assert chain.points.tobytes() == points[:2].tobytes()
    net = random_points(4, 2, 2, seed=1)
    assert sc.HermitePatch(*net).twists.tobytes() == net[3].tobytes()
    assert hermite_chain().parameters.dtype == hermite_net().parameters[0].dtype == np.float64


def test_scalars_of_numpy_are_numbers():
    curve = sc.NurbsCurve(np.int8(2), [0, 0, 0, 1, 1, 1], random_points(3, seed=1), periodic=np.bool_(False))
    assert curve.insert_knot(np.float32(0.5), np.int64(2)) == curve.insert_knot(0.5, 2)
    assert curve.insert_knot(np.array(0.5)) == curve.insert_knot(0.5)
    assert curve.derivatives(0.5, np.uint8(1)).shape == (2, 3)
