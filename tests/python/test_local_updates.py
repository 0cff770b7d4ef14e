"""A set on other points shares what did not change; a mesh is moved where points moved, with the bits of all anew."""

import numpy as np
import pytest

import splinecore as sc
from shapes import cylinder, hermite_net, random_points, sphere_octant, torus, wavy_patch
from test_patch_set import POOL, SQUARES


def net(count_u, count_v):
    x, y = np.meshgrid(np.linspace(-2, 2, count_u), np.linspace(-2, 2, count_v), indexing='ij')
    return np.stack([x, y, 0.3 * np.cos(2 * x * y)], -1)


def clamped(count, degree):
    return np.concatenate([np.zeros(degree), np.arange(count - degree + 1.0), np.full(degree, count - degree)])


def sheet(count=16):
    return sc.NurbsPatch((3, 3), (clamped(count, 3), clamped(count, 3)), net(count, count))


def rational():
    weights = np.random.default_rng(3).uniform(0.2, 5, (9, 12))
    return sc.NurbsPatch((2, 4), (clamped(9, 2), clamped(12, 4)), net(9, 12), weights)


def periodic():
    turn = np.linspace(0, 2 * np.pi, 9)[:-1]
    u, v = np.meshgrid(turn, turn, indexing='ij')
    points = np.stack([(3 + np.cos(v)) * np.cos(u), (3 + np.cos(v)) * np.sin(u), np.sin(v)], -1)
    return sc.NurbsPatch((3, 2), (np.arange(9.0), np.arange(9.0) ** 1.5), points, periodic=(True, True))


def uneven():
    """Creases, a gap, spans of very different lengths."""
    knots_u = [0, 0, 0, 1, 1, 1.5, 1.5, 1.5, 4, 4, 4]
    knots_v = [0, 0, 0, 0, 1e-6, 1, 1, 1, 9, 9, 9, 9]
    return sc.NurbsPatch((2, 3), (knots_u, knots_v), random_points(8, 8, seed=2))


def at_infinity():
    weights = np.ones((6, 5))
    weights[2, 3] = 0
    return sc.NurbsPatch((3, 2), (clamped(6, 3), clamped(5, 2)), random_points(6, 5, seed=7), weights)


def shared():
    return sc.PatchSet(POOL, SQUARES)


SETS = {make.__name__: make for make in (sheet, rational, periodic, uneven, at_infinity, shared, torus, cylinder,
                                         sphere_octant, wavy_patch, hermite_net)}
MESHES = {'count 1': lambda made: sc.Tessellation(made, 1), 'count 2, 5': lambda made: sc.Tessellation(made, (2, 5)),
          'adaptive': lambda made: sc.Tessellation.adaptive(made, tolerance=0.05)}


#: A patch that runs to infinity has no adaptive mesh.
CASES = [(name, how) for name in SETS for how in MESHES if (name, how) != ('at_infinity', 'adaptive')]


def set_of(name):
    made = SETS[name]()
    if isinstance(made, sc.PatchSet):
        return made
    others = [] if isinstance(made, sc.HermitePatch) else [made.with_points(made.points + (9, 0, 0))]
    return sc.PatchSet.from_patches([made, *others])


def moved(before, rng, count):
    points, weights = before.points.copy(), before.weights.copy()
    rows = rng.choice(len(points), min(count, len(points)), replace=False)
    points[rows] += rng.normal(0, 0.05, (len(rows), 3))
    if rng.random() < 0.4:
        heavy = rows[weights[rows] > 0]
        if not any(patch['kind'] == 'hermite' for patch in before.patches):
            weights[heavy] *= rng.uniform(0.7, 1.4, len(heavy))
    return before.with_points(points, weights)


def fresh(patch_set):
    """The same set made of nothing."""
    return sc.PatchSet(patch_set.points, patch_set.patches, patch_set.weights)


def mesh_of(name, how):
    made = set_of(name)
    return made, MESHES[how](made)


@pytest.mark.parametrize("name, how", CASES)
def test_a_mesh_moved_in_part_has_the_bits_of_one_evaluated_anew(name, how):
    before, mesh = mesh_of(name, how)
    rng, out = np.random.default_rng(1), mesh.evaluate_positions(before)
    for step in range(60):
        after = moved(before, rng, (1, 1, 1, 2, 5, 1000)[step % 6])
        assert mesh.evaluate_positions(after, before=before, out=out) is out
        assert out.tobytes() == mesh.evaluate_positions(after).tobytes(), step
        before = after
    assert out.tobytes() == mesh.evaluate(before)[0].tobytes()


@pytest.mark.parametrize("name", SETS)
def test_a_set_on_other_points_is_the_one_made_of_them(name):
    before, rng = set_of(name), np.random.default_rng(2)
    for step in range(10):
        after = moved(before, rng, 1 + step)
        anew = fresh(after)
        assert after == anew and hash(after) == hash(anew) and sc.dumps(after) == sc.dumps(anew)
        mesh = sc.Tessellation(after, 3)
        assert mesh.evaluate_positions(after).tobytes() == mesh.evaluate_positions(anew).tobytes()
        before = after


def test_weights_that_all_become_one_or_cease_to_be():
    before, mesh = mesh_of('sheet', 'count 2, 5')
    weights = before.weights.copy()
    weights[40] = 3
    heavy = before.with_points(before.points, weights)
    for one, other in ((before, heavy), (heavy, before)):
        out = mesh.evaluate_positions(one)
        mesh.evaluate_positions(other, before=one, out=out)
        assert out.tobytes() == mesh.evaluate_positions(other).tobytes()


def test_zeros_that_change_their_sign_are_moves():
    flat = net(6, 6) * (1, 1, 0)
    before = sc.PatchSet.from_patches([sc.BezierPatch(flat)])
    after = before.with_points(before.points * (1, 1, -1))
    mesh = sc.Tessellation(before, 3)
    out = mesh.evaluate_positions(before)
    mesh.evaluate_positions(after, before=before, out=out)
    assert before == after and out.tobytes() == mesh.evaluate_positions(after).tobytes()


@pytest.mark.parametrize("how, most", [('count 2, 5', 0.08), ('adaptive', 0.2)])
def test_only_what_depends_on_a_point_is_computed(how, most):
    before, mesh = mesh_of('sheet', how)
    points = before.points.copy()
    points[8 * 16 + 8, 2] += 0.1
    out = np.full((mesh.vertex_count, 3), 77, np.float32)
    after = before.with_points(points)
    mesh.evaluate_positions(after, before=before, out=out)
    is_new = (out != 77).any(1)
    assert 0 < is_new.mean() < most
    assert (out[is_new] == mesh.evaluate_positions(after)[is_new]).all()
    assert (mesh.evaluate_positions(after) == mesh.evaluate_positions(before))[~is_new].all()


def test_positions_go_where_the_caller_says():
    made = set_of('shared')
    mesh = sc.Tessellation(made, 3)
    out = np.empty((mesh.vertex_count, 3), np.float32)
    assert mesh.evaluate_positions(made, out=out) is out and out.tobytes() == mesh.evaluate(made)[0].tobytes()
    locked = out.copy()
    locked.flags.writeable = False
    gappy = np.empty((mesh.vertex_count, 6), np.float32)[:, ::2]
    for bad, error in ((out.astype(float), TypeError), (out[:-1], sc.InvalidShape), (out.ravel(), sc.InvalidShape),
                       (gappy, sc.InvalidShape), (locked, sc.InvalidShape), (out.tolist(), TypeError)):
        with pytest.raises(error, match="out"):
            mesh.evaluate_positions(made, out=bad)
    for before, error, words in ((3, TypeError, "before must be a PatchSet"),
                                 (set_of('sheet'), sc.InvalidShape, "before does not fit")):
        with pytest.raises(error, match=words):
            mesh.evaluate_positions(made, before=before, out=out)
    with pytest.raises(sc.InvalidShape, match="no out"):
        mesh.evaluate_positions(made, before=made)


def test_a_pool_of_another_size_is_checked_patch_by_patch():
    made = set_of('shared')
    points = np.vstack([made.points, [(7, 7, 7)]])
    assert np.array_equal(made.with_points(points, np.ones(len(points)))[0].points, made[0].points)
    with pytest.raises(sc.InvalidShape, match=r"patches\[\d\]: indices.* outside the pool"):
        made.with_points(made.points[:-1], made.weights[:-1])
    with pytest.raises(sc.InvalidShape, match="not finite"):
        made.with_points(np.where(np.arange(len(made.points))[:, None] == 3, np.nan, made.points))
    hermite = set_of('hermite_net')
    weights = hermite.weights.copy()
    weights[0] = 2
    with pytest.raises(sc.InvalidShape, match=r"patches\[0\]: .*a Hermite point needs w = 1"):
        hermite.with_points(hermite.points, weights)


def two_squares(merge):
    first, second = sc.PatchSet(POOL, SQUARES)[0], sc.PatchSet(POOL, SQUARES)[1]
    return sc.PatchSet.from_patches([first, second], merge=merge)


def test_sides_come_apart_where_they_have_rows_of_their_own():
    made = two_squares(merge=False)
    mesh = sc.Tessellation(made, 2)
    points = made.points
    common = [i for i, p in enumerate(points) if (np.abs(points - p).max(1) == 0).sum() == 2]
    assert common
    for row in range(len(points)):
        after = made.with_points(points + 0.5 * (np.arange(len(points)) == row)[:, None])
        assert mesh.fits(after, made) == mesh.fits(after) == (row not in common)
    assert mesh.fits(made.with_points(points + 1), made)


def test_sides_on_the_same_rows_stay_one():
    made = two_squares(merge=True)
    mesh = sc.Tessellation(made, 2)
    for row in range(len(made.points)):
        after = made.with_points(made.points + 0.3 * (np.arange(len(made.points)) == row)[:, None])
        assert mesh.fits(after, made) and mesh.fits(after)


def test_a_point_that_is_a_side_opens():
    made = set_of('sphere_octant')
    mesh = sc.Tessellation(made, 3)
    answers = []
    for row in range(len(made.points)):
        after = made.with_points(made.points + 0.3 * (np.arange(len(made.points)) == row)[:, None])
        answers.append((mesh.fits(after, made), mesh.fits(after)))
    assert all(quick == whole for quick, whole in answers)


@pytest.mark.parametrize("name", SETS)
def test_no_move_that_parts_sides_is_missed(name):
    before, rng = set_of(name), np.random.default_rng(4)
    mesh = sc.Tessellation(before, 2)
    for _ in range(20):
        after = moved(before, rng, 1)
        assert mesh.fits(after) == mesh.fits(after, before)
