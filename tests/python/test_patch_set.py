"""PatchSet: a pool of points that patches share, and how their sides meet."""

import numpy as np
import pytest

import splinecore as sc
from shapes import cylinder, hermite_net, patches, random_points, sphere_octant, torus, wavy_patch

# Two unit squares beside each other: rows 2 and 3 of the pool are the common edge.
POOL = [(0, 0, 0), (0, 1, 0), (1, 0, 0), (1, 1, 0), (2, 0, 0), (2, 1, 0)]
SQUARES = [[[0, 1], [2, 3]], [[2, 3], [4, 5]]]


def test_patches_are_read_from_the_pool():
    pair = sc.PatchSet(POOL, SQUARES)
    assert len(pair) == 2 and pair.points.tolist() == [list(map(float, row)) for row in POOL]
    assert pair[1] == sc.BezierPatch(np.array(POOL, float)[[[2, 3], [4, 5]]])
    assert pair[-1] == pair[1] and list(pair) == [pair[0], pair[1]]
    assert (pair.weights == 1).all()
    for i in (2, -3, 10**9):
        with pytest.raises(IndexError, match=f"i = {i}"):
            pair[i]


def test_every_kind_of_patch_comes_back():
    every = patches()
    for merge in (True, False):
        assert list(sc.PatchSet.from_patches(every, merge=merge)) == every


def test_patches_come_back_as_the_constructor_takes_them():
    pool = sc.PatchSet.from_patches(patches())
    assert {fields["kind"] for fields in pool.patches} == {"nurbs", "bezier", "hermite"}
    assert sc.PatchSet(pool.points, pool.patches, pool.weights) == pool
    fields = pool.patches[3]
    assert fields["degree"] == (3, 2) and fields["periodic"] == (False, True) and fields["indices"].shape == (5, 4)
    assert pool.patches[4]["indices"].shape == (4, 3, 2) and len(pool.patches[4]["parameters"]) == 2


def test_merging_joins_points_that_are_equal_in_every_bit():
    left, right = sc.PatchSet(POOL, SQUARES)
    assert sc.PatchSet.from_patches([left, right]).points.shape == (6, 3)
    assert sc.PatchSet.from_patches([left, right], merge=False).points.shape == (8, 3)
    moved = right.with_points(np.nextafter(right.points, 9))
    assert sc.PatchSet.from_patches([left, moved]).points.shape == (8, 3)


@pytest.mark.parametrize("dtype", [np.int8, np.int32, np.int64, np.uint64, ">i4"])
def test_indices_of_every_integer_dtype_are_taken(dtype):
    assert sc.PatchSet(POOL, np.array(SQUARES, dtype)) == sc.PatchSet(POOL, SQUARES)
    assert sc.PatchSet(POOL, tuple(np.array(SQUARES, dtype))) == sc.PatchSet(POOL, SQUARES)


def test_another_pool_moves_every_patch():
    pair = sc.PatchSet(POOL, SQUARES, weights=[1, 2, 1, 2, 1, 2])
    moved = pair.with_points(pair.points + (0, 0, 5))
    assert (moved.weights == pair.weights).all() and (moved[0].points[..., 2] == 5).all()
    assert moved.patches[0]["indices"].tolist() == SQUARES[0]
    assert (pair.with_points(pair.points, weights=np.ones(6)).weights == 1).all()
    longer = np.vstack([pair.points, [[9, 9, 9]]])
    assert len(pair.with_points(longer, weights=np.ones(7)).points) == 7
    with pytest.raises(sc.InvalidShape, match=r"points has shape \(7, 3\)"):
        pair.with_points(longer)


def test_edges_are_counted_by_how_they_meet():
    assert sc.PatchSet(POOL, SQUARES).edge_counts() == {"shared": 1, "free": 6, "pole": 0}
    octant = sc.PatchSet.from_patches([sphere_octant()])
    assert octant.edge_counts() == {"shared": 0, "free": 3, "pole": 1}
    tube = sc.PatchSet.from_patches([wavy_patch()]).edge_counts()
    assert tube == {"shared": 1, "free": 2, "pole": 0}


def test_seams_name_the_sides_that_are_one():
    assert sc.PatchSet(POOL, SQUARES).seams() == [((0, "u_end"), (1, "u_start"))]
    assert sc.PatchSet.from_patches([torus()]).seams() == [((0, "u_start"), (0, "u_end")), ((0, "v_start"), (0, "v_end"))]
    assert sc.PatchSet.from_patches([sphere_octant()]).seams() == []
    gap = sc.NurbsPatch((1, 1), ([0, 0, 1, 1, 2, 2], [0, 0, 1, 1]), [[(i, j, 0) for j in (0, 1)] for i in (0, 1, 1, 2)])
    assert gap.degree == (1, 1) and sc.PatchSet.from_patches([gap]).seams() == [], "halves of one patch are no seam"
    third = sc.PatchSet(POOL, [*SQUARES, [[2, 3], [0, 5]]])
    assert {((0, "u_end"), (1, "u_start")), ((1, "u_start"), (2, "u_start"))} <= set(third.seams())


def test_an_edge_may_run_both_ways():
    turned = sc.PatchSet(POOL, [SQUARES[0], [[3, 2], [5, 4]]])
    assert turned.edge_counts()["shared"] == 1
    mirrored = sc.PatchSet(POOL, [SQUARES[0], [[4, 2], [5, 3]]])
    assert mirrored.edge_counts()["shared"] == 1


def test_the_first_and_last_row_of_a_cylinder_are_one_edge():
    counts = sc.PatchSet.from_patches([cylinder()]).edge_counts()
    assert counts == {"shared": 1, "free": 2, "pole": 0}
    assert sc.PatchSet.from_patches([torus()]).edge_counts() == {"shared": 2, "free": 0, "pole": 0}


def test_flipped_turns_every_normal():
    pool = sc.PatchSet.from_patches(patches())
    flipped = pool.flipped()
    assert np.array_equal(flipped.points, pool.points) and flipped.flipped() == pool
    for patch, turned in zip(pool, flipped):
        u, v = (0.3 * start + 0.7 * end for start, end in patch.domain)
        one, normal = patch.evaluate_grid_with_normals([u], [v])
        other, opposite = turned.evaluate_grid_with_normals([v], [u])
        assert np.abs(one - other).max() <= 4e-15 and np.abs(normal + opposite).max() <= 1e-12


BAD = [
    (lambda: sc.PatchSet(POOL, []), sc.InvalidShape, "patch"),
    (lambda: sc.PatchSet(POOL, [[[0, 1], [2, 6]]]), sc.InvalidShape, r"patches\[0\]: indices\[1, 1\] = 6 is outside"),
    (lambda: sc.PatchSet(POOL, [SQUARES[0], [[0, 1], [2, -1]]]), sc.InvalidShape, r"patches\[1\]: indices\[1, 1\] = -1"),
    (lambda: sc.PatchSet(POOL, [[[0, 2**40], [1, 2]]]), sc.InvalidShape, r"indices\[0, 1\] = 1099511627776"),
    (lambda: sc.PatchSet(POOL, [np.full((2, 2), 2**64 - 1, "u8")]), sc.InvalidShape,
     r"indices\[0, 0\] = 18446744073709551615"),
    (lambda: sc.PatchSet(POOL, [[[0, 1], [2]]]), sc.InvalidShape, r"patches\[0\]: indices\[1\] = \[2\] has 1"),
    (lambda: sc.PatchSet(POOL, [[0, 1, 2, 3]]), sc.InvalidShape, r"patches\[0\]: indices has shape \(4,\)"),
    (lambda: sc.PatchSet(POOL, [[[0, 1]]]), sc.InvalidShape, r"patches\[0\]: indices is 1 x 2"),
    (lambda: sc.PatchSet(POOL, [[[0.0, 1], [2, 3]]]), TypeError, r"patches\[0\]: indices has dtype float64"),
    (lambda: sc.PatchSet(POOL, [None]), TypeError, r"patches\[0\]: indices"),
    (lambda: sc.PatchSet(POOL, None), TypeError, "patches must be a list"),
    (lambda: sc.PatchSet(POOL, "ab"), TypeError, "patches must be a list"),
    (lambda: sc.PatchSet(None, SQUARES), TypeError, "points is missing"),
    (lambda: sc.PatchSet(POOL, SQUARES, weights=[1]), sc.InvalidShape, r"weights has shape \(1,\)"),
    (lambda: sc.PatchSet([*POOL[:5], (0, 0, np.nan)], SQUARES), sc.InvalidShape, r"points\[5\].z = nan"),
    (lambda: sc.PatchSet(POOL, [{}]), sc.InvalidShape, r"patches\[0\]: kind is missing"),
    (lambda: sc.PatchSet(POOL, [{"kind": "cone"}]), sc.InvalidShape, r"patches\[0\]: kind = 'cone'"),
    (lambda: sc.PatchSet(POOL, [{"kind": "nurbs", "indices": SQUARES[0]}]), sc.InvalidShape, "knots is missing"),
    (lambda: sc.PatchSet(POOL, [{"kind": "nurbs", "indices": SQUARES[0], "knots": 3}]), TypeError,
     r"patches\[0\]: knots = 3 must be a pair"),
    (lambda: sc.PatchSet(POOL, [{"kind": "nurbs", "indices": SQUARES[0], "degree": (1, 1),
                                 "knots": ([0, 0, 1, 1], [0, 1])}]), sc.InvalidShape, r"patches\[0\]: .*knots"),
    (lambda: sc.PatchSet(POOL, [{"kind": "hermite", "indices": SQUARES[0], "parameters": ([0, 1], [0, 1])}]),
     sc.InvalidShape, r"indices has shape \(2, 2\)"),
    (lambda: sc.PatchSet(POOL, [{"kind": "hermite", "indices": [SQUARES[0]] * 4, "parameters": ([0, 1], [0, 1])}]),
     sc.InvalidShape, r"patches\[0\]: points\[0\] has w = 1"),
    (lambda: sc.PatchSet.from_patches([]), sc.InvalidShape, "patch"),
    (lambda: sc.PatchSet.from_patches([torus(), 3]), TypeError, r"patches\[1\] is no"),
    (lambda: sc.PatchSet.from_patches(torus()), TypeError, "patches must be a list"),
    (lambda: sc.PatchSet.from_patches([torus()], merge=1), TypeError, "merge = 1"),
    (lambda: sc.PatchSet(POOL, SQUARES)["0"], TypeError, "i = '0'"),
]


@pytest.mark.parametrize("call, error, words", BAD)
def test_bad_arguments_are_named(call, error, words):
    with pytest.raises(error, match=words):
        call()


def test_hermite_rows_of_the_pool_are_directions():
    pool = sc.PatchSet.from_patches([hermite_net()])
    points, tangents_u, _, _ = pool.patches[0]["indices"]
    assert (pool.weights[points] == 1).all() and (pool.weights[tangents_u] == 0).all()
    assert np.array_equal(pool.points[tangents_u], hermite_net().tangents_u)
    assert random_points(4, 3, 2, seed=13)[1].tolist() == pool.points[tangents_u].tolist()
