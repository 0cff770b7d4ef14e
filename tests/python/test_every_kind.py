"""What shapes of every kind can: to be moved, turned and scaled, to be joined, to say whether they are closed."""

import numpy as np
import pytest

import splinecore as sc
import shapes
from splinecore import build

CURVES = {
    "nurbs": shapes.cubic(),
    "circle": shapes.circle(),
    "bezier": sc.BezierCurve([(0, 0, 0), (1, 2, 0), (3, 1, 1)], [1, 2, 0.5]),
    "hermite": shapes.hermite_chain(),
    "power": sc.PowerCurve([(0, 0, 1), (1, 2, 0), (0, 1, 1)], origin=0.5),
}
PATCHES = {
    "nurbs": shapes.torus(),
    "bezier": sc.BezierPatch(np.arange(36.0).reshape(3, 4, 3) % 7),
    "hermite": shapes.hermite_net(),
}
EVERY = {**{f"{name} curve": one for name, one in CURVES.items()},
         **{f"{name} patch": one for name, one in PATCHES.items()},
         "set": sc.PatchSet.from_patches(list(PATCHES.values()))}


def places(shape):
    if isinstance(shape, sc.PatchSet):
        return np.concatenate([places(patch) for patch in shape])
    if np.ndim(shape.domain) == 1:
        return shape.evaluate(np.linspace(*shape.domain, 9))
    (a, b), (c, d) = shape.domain
    return shape.evaluate_grid(np.linspace(a, b, 5), np.linspace(c, d, 6)).reshape(-1, 3)


def near(a, b):
    return np.abs(a - b).max() <= 1e-12 * (1 + np.abs(b).max())


@pytest.mark.parametrize("name", EVERY)
def test_every_kind_is_moved_turned_and_scaled(name):
    one, before = EVERY[name], places(EVERY[name])
    moved = one.translated((1, -2, 3))
    assert type(moved) is type(one) and near(places(moved), before + (1, -2, 3))
    turned = one.rotated(np.pi / 2, about=(1, 0))
    assert type(turned) is type(one)
    assert near(places(turned), (before - (1, 0, 0)) @ np.array([(0, 1, 0), (-1, 0, 0), (0, 0, 1)]) + (1, 0, 0))
    axis, angle = np.array([1, 2, -2]) / 3, 0.7
    cross = np.cross(axis, before)
    want = before * np.cos(angle) + cross * np.sin(angle) + np.outer(before @ axis, axis) * (1 - np.cos(angle))
    assert near(places(one.rotated(angle, 5 * axis)), want)
    assert near(places(one.scaled(2.5, (1, 1, 1))), 2.5 * (before - 1) + 1)
    assert near(places(one.scaled((-1, 2, 1))), before * (-1, 2, 1))
    matrix = np.random.default_rng(3).normal(size=(3, 4))
    assert near(places(one.transformed(matrix)), before @ matrix[:, :3].T + matrix[:, 3])
    back = one.translated((1, -2, 4)).translated((-1, 2, -4))
    assert near(places(back), before)


@pytest.mark.parametrize("name", EVERY)
def test_bad_motions_are_refused(name):
    one = EVERY[name]
    for call in (lambda: one.translated((np.nan, 0, 0)), lambda: one.rotated(np.inf), lambda: one.rotated(1, (0, 0, 0)),
                 lambda: one.scaled(0), lambda: one.scaled((1, 0, 1)), lambda: one.scaled(np.nan),
                 lambda: one.transformed(np.eye(2)), lambda: one.translated((1,))):
        with pytest.raises(sc.InvalidShape):
            call()
    for call in (lambda: one.translated("up"), lambda: one.rotated("left"), lambda: one.scaled(None)):
        with pytest.raises(TypeError):
            call()


PERSPECTIVE = np.array([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0.01, 0.02, 0, 1]])


@pytest.mark.parametrize("name", EVERY)
def test_under_a_perspective_hermite_shapes_say_that_they_have_no_image(name):
    one = EVERY[name]
    if "hermite" in name or name == "set":
        with pytest.raises(sc.InvalidShape, match="not affine"):
            one.transformed(PERSPECTIVE)
        return
    before = np.c_[places(one), np.ones(len(places(one)))] @ PERSPECTIVE.T
    assert near(places(one.transformed(PERSPECTIVE)), before[:, :3] / before[:, 3:])


@pytest.mark.parametrize("first", [name for name in CURVES if name != "circle"])
@pytest.mark.parametrize("second", [name for name in CURVES if name != "circle"])
def test_curves_of_any_kinds_are_joined(first, second):
    a, b = CURVES[first], CURVES[second]
    b = b.translated(a.evaluate(a.domain[1]) - b.evaluate(b.domain[0]))
    whole, error = a.join(b)
    assert error <= 1e-13 and isinstance(whole, sc.NurbsCurve)
    assert near(whole.evaluate(whole.domain[0]), a.evaluate(a.domain[0]))
    assert near(whole.evaluate(whole.domain[1]), b.evaluate(b.domain[1]))
    assert whole.length(tolerance=1e-9) == pytest.approx(a.length(tolerance=1e-9) + b.length(tolerance=1e-9), rel=1e-7)
    assert a.continuity_to(b).c >= 0
    with pytest.raises(sc.InvalidShape):
        a.join(3)


def ring():
    return sc.Region.of([sc.conics.circle((1, 0, 3), 2.0), sc.conics.circle((1.5, 0, 3), 1.0)])


def test_regions_are_moved_with_what_is_in_them():
    one, rng = ring(), np.random.default_rng(7)
    points = np.c_[rng.uniform(-2, 4, (200, 2)), np.full(200, 3.0)]
    inside = one.contains(points)
    for matrix in (*rng.normal(size=(40, 3, 4)) * 10.0 ** rng.integers(-3, 4, (40, 1, 1)), np.diag([-1.0, 1, 1, 1])[:3], np.diag([1.0, 1, -1, 1])[:3]):
        moved = one.transformed(matrix)
        assert (moved.contains(points @ matrix[:, :3].T + matrix[:, 3]) == inside).all()
        cofactors = np.linalg.det(matrix[:, :3]) * np.linalg.inv(matrix[:, :3]).T
        assert moved.area() == pytest.approx(one.area() * np.linalg.norm(cofactors @ one.normal), rel=1e-6)
        assert near(moved.normal, cofactors @ one.normal / np.linalg.norm(cofactors @ one.normal))
        assert all((outline.points[0] == outline.points[-1]).all() or outline.periodic for outline in moved.outlines)
    assert one.translated((1, -2, 4)).translated((-1, 2, -4)).area() == pytest.approx(one.area())
    assert near(one.rotated(np.pi, (1, 0, 0)).normal, -one.normal) and one.scaled(3).area() == pytest.approx(9 * one.area())
    for call in (lambda: one.transformed(PERSPECTIVE), lambda: one.transformed(np.diag([0, 1, 1])), lambda: one.scaled(0)):
        with pytest.raises(sc.InvalidShape, match="not affine|flattens|zero|0"):
            call()
    assert not (one - one).translated((1, 2, 3))


def test_regions_are_drawn_and_written(tmp_path):
    one = ring()
    assert "evenodd" in one._repr_svg_() and "empty" in (one - one)._repr_svg_()
    sc.meshes.save(tmp_path / "a.obj", [one])
    assert (tmp_path / "a.obj").read_text().count("\nl ") >= 2
    with pytest.raises(sc.InvalidShape, match="STL"):
        sc.meshes.save(tmp_path / "a.stl", one)
    with pytest.raises(FileNotFoundError, match=r"b\.obj'$"):
        sc.meshes.save(tmp_path / "none" / "b.obj", one)


def test_patches_say_whether_they_are_closed():
    assert build.sphere((0, 0, 0), 1).is_closed and shapes.torus().is_closed
    assert not build.extrude(shapes.circle(), (0, 0, 1)).is_closed and not PATCHES["bezier"].is_closed
    for name, patch in PATCHES.items():
        assert patch.is_closed == sc.PatchSet.from_patches([patch]).is_closed, name


@pytest.mark.parametrize("name", PATCHES)
def test_patches_of_every_kind_join_a_side_as_the_function_does(name):
    a = PATCHES[name] if name != "nurbs" else build.plane((0, 0, 0), (1, 0, 0), (0, 1, 0))
    b = a.translated((0.5, 9, 0.25))
    joined, want = a.join("u_end", b, "u_start", "C0"), build.join_patches(a, "u_end", b, "u_start", "C0")
    assert joined.first == want.first and joined.second == want.second and joined.second_error == want.second_error
    with pytest.raises(TypeError, match="second|other"):
        a.join("u_end", 3, "u_start")


def test_sets_join_patches_and_sets():
    a = build.plane((0, 0, 0), (1, 0, 0), (0, 1, 0))
    one = sc.PatchSet.from_patches([a])
    two = one.join(a.translated((1, 0, 0)))
    assert len(two) == 2 and two.edge_counts()["shared"] == 1 and len(two.points) == 6
    assert two == sc.PatchSet.from_patches([a, a.translated((1, 0, 0))])
    four = two.join(two.translated((0, 1, 0)), merge=False)
    assert len(four) == 4 and len(four.points) == 16 and two.join(two.translated((0, 1, 0))).edge_counts()["shared"] == 4
    with pytest.raises(TypeError, match="other must be a patch or a PatchSet, not int"):
        one.join(3)


def test_curves_say_whether_they_are_closed():
    assert shapes.circle().is_closed and shapes.closed_cubic().is_closed
    assert not shapes.cubic().is_closed and not shapes.hyperbola().is_closed
    assert sc.BezierCurve([(0, 0), (1, 1), (2, 0), (0, 0)]).is_closed
    assert not sc.BezierCurve([(0, 0), (1, 1), (2, 0), (1e-16, 0)]).is_closed
    assert sc.HermiteCurve([(0, 0), (1, 1), (0, 0)], [(1, 0), (0, 1), (1, 0)]).is_closed


def box():
    corners = np.array([[[(x, y, z) for z in (0, 1)] for y in (0, 1)] for x in (0, 1)], float)
    faces = [corners[0], corners[1], corners[:, 0], corners[:, 1], corners[:, :, 0], corners[:, :, 1]]
    return [sc.BezierPatch(face) for face in faces]


def test_of_whichever_sides_are_seen_the_oriented_box_has_its_volume():
    faces = box()
    for choice in range(64):
        mixed = sc.PatchSet.from_patches([f.swapped() if choice >> i & 1 else f for i, f in enumerate(faces)])
        assert mixed.is_closed
        made = mixed.oriented()
        assert made.volume() == pytest.approx(1) and np.array_equal(made.points, mixed.points)
        assert made.oriented() == made


def test_two_bodies_are_each_turned_outwards():
    faces = box() + [face.translated((5, 0, 0)).scaled(2) for face in box()]
    rng = np.random.default_rng(1)
    for _ in range(10):
        mixed = sc.PatchSet.from_patches([f.swapped() if rng.random() < 0.5 else f for f in faces])
        assert mixed.oriented().volume() == pytest.approx(9)
    ball = sc.PatchSet.from_patches([build.sphere((0, 0, 0), 1).swapped()])
    assert ball.oriented().volume() == pytest.approx(abs(ball.volume()))


def test_what_is_open_agrees_with_its_first_patch():
    faces = box()[:5]
    mixed = sc.PatchSet.from_patches([faces[0], *(f.swapped() for f in faces[1:])])
    assert not mixed.is_closed
    made = mixed.oriented()
    assert made[0] == mixed[0]
    whole = sc.PatchSet.from_patches([*made, box()[5]]).oriented()
    flips = [whole[i] == made[i] for i in range(5)]
    assert all(flips) or not any(flips)


def test_a_band_with_half_a_turn_is_refused():
    u = np.linspace(0, np.pi, 9)
    out = np.c_[np.cos(2 * u), np.sin(2 * u), 0 * u]
    across = np.c_[np.cos(u)[:, None] * out[:, :2], np.sin(u)]
    rows = np.stack([2 * out - 0.3 * across, 2 * out + 0.3 * across], axis=1)
    rows[-1] = rows[0][::-1]
    strip = [sc.BezierPatch(rows[i:i + 2]) for i in range(8)]
    with pytest.raises(sc.InvalidShape, match="come back the other way"):
        sc.PatchSet.from_patches(strip).oriented()


def test_where_three_patches_meet_in_an_edge_none_is_chosen():
    edge = np.array([(0, 0, 0), (0, 1, 0)], float)
    leaves = [sc.BezierPatch([edge, edge + way]) for way in ((1, 0, 0), (-1, 0, 0), (0, 0, 1))]
    with pytest.raises(sc.InvalidShape, match="lies on 2 others"):
        sc.PatchSet.from_patches(leaves).oriented()
