"""The scenes in blend_samples: saved by the oldest supported Blender, alive in all of them."""

from pathlib import Path

import bpy
import numpy as np
import pytest

from support import curve_points, part, splinecore as sc, vertices

recipes = part('bridge.recipes.recipes')
SAMPLES = Path(__file__).resolve().parents[2] / "blend_samples"
NAMES = sorted(path.stem.removeprefix("make_") for path in SAMPLES.glob("make_*.py"))


def test_there_are_samples():
    assert {'gallery', 'teapot', 'vase', 'solids', 'cups', 'conics', 'moebius', 'knots', 'points', 'runge',
            'joins', 'railing', 'scan', 'bottle', 'contour', 'offsets', 'kettle', 'boat', 'flask', 'mirror',
            'suzanne', 'shampoo', 'mouse', 'hull'} <= set(NAMES)


@pytest.mark.parametrize('name', NAMES)
def test_a_sample_has_its_scene_and_its_picture(name):
    assert (SAMPLES / f"{name}.png").read_bytes().startswith(b'\x89PNG')
    bpy.ops.wm.open_mainfile(filepath=str(SAMPLES / f"{name}.blend"))
    assert tuple(bpy.data.version)[:2] == (3, 4)
    assert bpy.context.scene.camera is not None


@pytest.mark.parametrize('name', NAMES)
def test_every_shape_of_a_sample_shows_its_definition(name):
    bpy.ops.wm.open_mainfile(filepath=str(SAMPLES / f"{name}.blend"))
    shapes = [ob for ob in bpy.data.objects if part('bridge.shape.shape').has_shape(ob)]
    assert shapes
    for ob in shapes:
        assert not part('bridge.shape.shape').is_touched(ob.data), ob.name
        settings, value = ob.data.splinewright, ob.data.splinewright.value
        if ob.type == 'CURVE':
            curves = value if isinstance(value, list) else [value]
            reach = settings.resolution_u, settings.reach, part('bridge.recipes.recipes').around(ob.data)
            lines = [points for curve in curves for points, _ in curve.polylines(*reach)]
            assert len(lines) == len(ob.data.splines)
            for spline, points in zip(ob.data.splines, lines):
                assert np.allclose(curve_points(spline), points, atol=1e-6), ob.name
        else:
            patch_set = value if isinstance(value, sc.PatchSet) else sc.PatchSet.from_patches([value], merge=False)
            plan = sc.Tessellation(patch_set, (settings.resolution_u, settings.resolution_v))
            assert np.allclose(vertices(ob.data), plan.evaluate(patch_set)[0], atol=1e-6), ob.name


def opened(name):
    bpy.ops.wm.open_mainfile(filepath=str(SAMPLES / f"{name}.blend"))
    return {ob.name: ob.data.splinewright.value for ob in bpy.data.objects if part('bridge.shape.shape').has_shape(ob)}


def settings_of_functions(number):
    return recipes.parameters(bpy.data.objects[f"Functions {number}"].data)


def test_of_six_inner_knots_of_degree_5_four_are_moved_onto_the_last():
    opened('knots')
    for moved in range(5):
        settings = settings_of_functions(moved + 1)
        knots = [float(word) for word in settings['knot_values'].split()]
        assert settings['degree'] == 5 and len(knots) == 18
        assert sorted(knots[6:12]) == [*range(1, 6 - moved), *[6] * (moved + 1)]


def test_the_keys_of_the_first_picture_make_it_the_others():
    opened('knots')
    scene, shape = bpy.context.scene, part('bridge.shape.shape')
    for moved in range(5):
        scene.frame_set(1 + 24 * moved)
        bpy.context.view_layer.update()
        shown, wanted = (shape.value_of(bpy.data.objects[f"Functions {number}"].data) for number in (1, moved + 1))
        places = [np.vstack([curve.evaluate(np.linspace(*curve.domain, 9)) for curve in curves]) for curves in (shown, wanted)]
        assert np.abs(places[0] - places[1]).max() < 1e-6, moved
    assert scene.frame_end == 1 + 24 * 4


def test_runges_polynomial_oscillates_and_the_spline_beside_it_does_not():
    shapes = opened('runge')
    heights = {name: value.evaluate(np.linspace(*value.domain, 401)[:-1])[:, 1] for name, value in shapes.items()}
    assert heights["Polynomial of degree 10"].max() > 1.5 * heights["The function itself"].max()
    assert heights["Catmull-Rom spline"].max() <= heights["The function itself"].max() * 1.001


def test_a_doubled_and_a_tripled_point_have_the_joints_of_the_lectures():
    shapes = opened('points')
    curvature = {}
    for copies, name in ((1, "simple"), (2, "doubled"), (3, "tripled")):
        curve = shapes[f"Middle point {name}"]
        assert (curve.points == (0, 1.5, 0)).all(axis=1).sum() == copies
        joint = curve.knots[3 + (len(curve.points) - 3) // 2]
        _, first, second = curve.derivatives(joint, 2)
        curvature[name] = np.linalg.norm(np.cross(first, second))
    assert curvature["simple"] > 0.1 and curvature["doubled"] < 1e-12 and curvature["tripled"] < 1e-12


def test_moebius_maps_and_joins_are_what_they_are_called():
    values = opened('moebius').values()
    at = np.linspace(0, 1, 9)
    images = [value.evaluate(at / (at + float(value.weights[1] / value.weights[0]) * (1 - at))) for value in values]
    assert all(np.allclose(image, images[0], atol=1e-12) for image in images)
    classes = {name.split()[-1]: value.joints()[0][1] for name, value in opened('joins').items()}
    assert {name: (found.c, min(found.g, 2)) for name, found in classes.items()} == {
        'C0': (0, 0), 'G1': (0, 1), 'C1': (1, 1), 'C2': (2, 2)}


def patches_of(value):
    return [value[i] for i in range(len(value))] if isinstance(value, sc.PatchSet) else [value]


def test_solids_are_recipes_whose_radius_is_within_what_the_picture_says():
    shapes = opened('solids')
    assert {name: recipes.kind(bpy.data.objects[name].data) for name in shapes} == {
        'Sphere': 'sphere', 'Torus': 'torus', 'Cylinder': 'cylinder', 'Cone': 'cone'}
    round_ones = {name: patches_of(value)[0] for name, value in shapes.items()}
    assert {name: patch.degree for name, patch in round_ones.items()} == {
        'Sphere': (2, 2), 'Torus': (2, 2), 'Cylinder': (2, 1), 'Cone': (2, 1)}
    points = {name: patch.evaluate_grid(*(np.linspace(*domain, 57) for domain in patch.domain))
              for name, patch in round_ones.items()}
    across = {name: np.linalg.norm(rows[..., :2], axis=-1) for name, rows in points.items()}
    errors = (np.linalg.norm(points['Sphere'], axis=-1) - 1, across['Cylinder'] / 0.85 - 1,
              np.hypot(points['Torus'][..., 2], across['Torus'] - 0.85) / 0.36 - 1,
              across['Cone'] + (points['Cone'][..., 2] + 0.95) / 1.9 - 1)
    assert max(np.abs(error).max() for error in errors) <= 2e-15
    for name, end in (('Sphere', "3e-16"), ('Torus', "2e-15"), ('Cylinder', "4e-16"), ('Cone', "3e-16")):
        captions = [ob.data.body for ob in bpy.data.objects if ob.type == 'FONT' and ob.location.x == pytest.approx(
            bpy.data.objects[name].location.x)]
        assert f"radius to {end}" in captions and name.lower() in captions


def change_and_follow(source, followers):
    """Moves the points of a curve; asserts that all that was made of it, and nothing else, follows."""
    before = {ob.name: ob.data.splinewright.value for ob in bpy.data.objects
              if ob.type == 'MESH' and part('bridge.shape.shape').has_shape(ob)}
    curve = source.data.splinewright.value
    bend = lambda piece: piece.with_points(piece.points * (1.25, 1.25, 1))
    source.data.splinewright.value = [bend(piece) for piece in curve] if isinstance(curve, list) else bend(curve)
    bpy.context.view_layer.update()
    changed = {name for name, value in before.items() if bpy.data.objects[name].data.splinewright.value != value}
    assert changed == set(followers)


def test_vases_are_exact_surfaces_that_follow_the_three_kinds_of_profiles():
    shapes = opened('vase')
    profiles = {name.removeprefix("Profile: "): value for name, value in shapes.items() if name.startswith("Profile")}
    assert len(profiles) == 6 and len(shapes) == 12
    for suffix in ("", ", moved"):
        assert profiles[f"Bezier of degree 11{suffix}"].degree == 11
        assert [curve.degree for curve in profiles[f"Two joined Beziers{suffix}"]] == [6, 6]
        spline = profiles[f"Cubic B-spline{suffix}"]
        assert spline.degree == 3 and len(spline.points) == 12
        for name in ("Bezier of degree 11", "Two joined Beziers", "Cubic B-spline"):
            vase = bpy.data.objects[f"Vase: {name}{suffix}"]
            assert recipes.kind(vase.data) == 'revolve' and not vase.modifiers
    for name in list(profiles):
        change_and_follow(bpy.data.objects[f"Profile: {name}"], [f"Vase: {name}"])


def test_the_same_point_changes_the_whole_vase_one_half_or_its_neighborhood():
    shapes = opened('vase')
    heights = {}
    for name in ("Bezier of degree 11", "Two joined Beziers", "Cubic B-spline"):
        still, moved = (patches_of(shapes[f"Vase: {name}{suffix}"]) for suffix in ("", ", moved"))
        v = [np.linspace(*patch.domain[1], 400) for patch in still]
        pairs = [(a.evaluate(0.0, at), b.evaluate(0.0, at)) for a, b, at in zip(still, moved, v)]
        differs = np.concatenate([np.linalg.norm(a - b, axis=1) > 1e-12 for a, b in pairs])
        heights[name] = differs.mean()
    assert heights["Bezier of degree 11"] > 0.95
    assert 0.45 < heights["Two joined Beziers"] <= 0.5
    assert 0.3 < heights["Cubic B-spline"] < 0.45


def test_cups_are_made_of_curves_that_they_follow_and_of_tubes():
    shapes = opened('cups')
    kinds = {name: recipes.kind(bpy.data.objects[name].data) for name in shapes}
    assert {name for name, kind in kinds.items() if kind == 'revolve'} == {"Cup", "Saucer", "Sugar bowl", "Lid"}
    assert list(kinds.values()).count('extrude') == 4 and list(kinds.values()).count('ruled') == 2
    for name in ("Handle", "Ear 1", "Ear 2", "Spoon"):
        assert shapes[name].degree == (3, 3) and shapes[name].periodic == (False, True)
    change_and_follow(bpy.data.objects["Profile of Cup"], ["Cup"])
    change_and_follow(bpy.data.objects["Outline of Biscuit 1"], ["Biscuit 1, outside", "Biscuit 1, top"])


def test_bodies_of_the_cups_are_closed_and_tubes_have_their_normals_outside():
    shapes = opened('cups')
    for name in ("Cup", "Saucer", "Sugar bowl", "Lid", "Spoon"):
        assert sc.PatchSet.from_patches([shapes[name]]).volume() > 0, name
    for name in ("Handle", "Ear 1", "Ear 2"):
        points, normals = shapes[name].evaluate_grid_with_normals(*(np.linspace(*d, 9)[:-1] for d in shapes[name].domain))
        outward = points - points.mean(axis=1, keepdims=True)
        assert ((outward * normals).sum(axis=-1) > 0).all(), name


def test_splines_through_the_same_points_differ_by_the_spacing_of_their_parameters():
    missed, returns = {}, {}
    for name, curve in opened('interpolation').items():
        x, y, _ = curve.evaluate(np.linspace(*curve.domain, 8001)[:-1]).T
        kind = name.removeprefix("Spline, ")
        missed[kind], returns[kind] = np.abs(y - 1.2 * np.abs(x)).max(), (np.diff(x) < 0).any()
    assert missed["centripetal"] < 0.1 < missed["uniform"] < missed["chordal"]
    assert returns == {"uniform": True, "chordal": False, "centripetal": False}


def test_the_path_lies_on_the_hill_and_its_posts_stand_at_equal_parts():
    shapes = opened('railing')
    hill, foot = shapes["Hill"], shapes["Path on the hill"]
    assert hill.nearest(foot.evaluate(np.linspace(*foot.domain, 2001))).distances.max() < 0.0011
    assert recipes.kind(bpy.data.objects["Path on the hill"].data) == 'projected'
    posts = np.array([ob.location for ob in bpy.data.objects if ob.name.startswith("Post.")])
    places = foot.evaluate(foot.divide(len(posts) - 1))
    assert len(posts) == 25
    assert np.allclose(posts[np.argsort(posts[:, 0])], places[np.argsort(places[:, 0])], atol=1e-5)


def test_the_fitted_patch_is_near_the_scan_and_farthest_at_the_fold():
    patch = opened('scan')["Fitted patch"]
    points = vertices(bpy.data.objects["Scan"].data)
    distances = patch.nearest(points).distances
    at_fold = np.abs(points[:, 1] - 0.3 * points[:, 0] + 0.55) < 0.16
    assert patch.points.shape[:2] == (16, 12) and distances[points[:, 0] < -1].mean() < 0.02
    assert distances[at_fold & (points[:, 0] > 0.5)].mean() > 2 * distances[~at_fold].mean()
    sights = bpy.context.scene.splinewright_sights
    assert sights.deviation and sights.deviation_object == bpy.data.objects["Scan"]


def test_the_scan_is_colored_by_the_mean_distance_of_the_points_near_by():
    """From dark blue where there is none to dark red from 0.06 on, by the sixteen points that are nearest."""
    patch = opened('scan')["Fitted patch"]
    points, mesh = vertices(bpy.data.objects["Scan"].data), bpy.data.objects["Fitted patch"].data
    distances, places = patch.nearest(points).distances, vertices(mesh)
    near = np.argsort(((places[:, None] - points[None]) ** 2).sum(-1), axis=1)[:, :16]
    means = distances[near].mean(1)
    shown = np.array([each.color[:3] for each in mesh.attributes["Distance"].data])
    assert len(shown) == len(places) and means.max() > 0.06 > 0.02 > means.min()
    parts = np.clip(means / 0.06, 0, 1) * 4
    key = np.array([(0.06, 0.16, 0.42), (0.05, 0.40, 0.45), (0.60, 0.62, 0.20), (0.85, 0.35, 0.08), (0.62, 0.03, 0.03)])
    expected = np.stack([np.interp(parts, range(5), channel) for channel in key.T], -1)
    assert np.abs(shown - expected).max() < 1e-3


def test_the_sections_of_the_bottle_lie_on_it_and_follow_its_profile():
    opened('bottle')
    bottle, profile = bpy.data.objects["Bottle"], bpy.data.objects["Profile"]

    def require_on_bottle():
        bpy.context.view_layer.update()
        for name in ("Rings", "Upright section", "Oblique section", "Where a pipe meets it"):
            ob = bpy.data.objects[name]
            assert part('bridge.follow.follow').problem(ob.data) == ""
            into = np.array(bottle.matrix_world.inverted() @ ob.matrix_world)
            value = ob.data.splinewright.value
            for curve in value if isinstance(value, list) else [value]:
                there = curve.evaluate(np.linspace(*curve.domain, 60)) @ into[:3, :3].T + into[:3, 3]
                assert bottle.data.splinewright.value.nearest(there).distances.max() < 5e-4, name

    require_on_bottle()
    curve = profile.data.splinewright.value
    profile.data.splinewright.value = curve.with_points(curve.points * (1.1, 1, 1))
    require_on_bottle()


def test_trimmed_offsets_are_nowhere_nearer_and_the_others_are():
    shapes = opened('offsets')
    for words in ("as they are", "trimmed"):
        curve = shapes[f"Curve, offsets {words}"]
        for name, value in shapes.items():
            if not name.startswith("Offset") or words not in name:
                continue
            distance = abs(float(name.split()[1].rstrip(",")))
            least = min(curve.nearest(one.evaluate(np.linspace(*one.domain, 400))).distances.min()
                        for one in (value if isinstance(value, list) else [value]))
            assert (least > distance - 1e-3) == (words == "trimmed") or distance < 0.75, name


def test_corners_of_the_contours_are_sharp_round_and_cut_off():
    shapes = opened('contour')
    corners = {name.rpartition(" ")[2]: sum(joint.g == 0 for _, joint in value.joints()) for name, value in shapes.items()
               if name.startswith("Contour")}
    assert corners == {"sharp": 7, "round": 0, "off": 14}


def test_the_kettle_and_the_boat_follow_their_curves():
    for name, moved, followers in (('kettle', "Section 3", {"Body"}), ('boat', "Frame 3", {"Hull"})):
        before = opened(name)
        bpy.data.objects[moved].location.z += 0.1
        bpy.context.view_layer.update()
        after = {ob.name: ob.data.splinewright.value for ob in bpy.data.objects if part('bridge.shape.shape').has_shape(ob)}
        assert {changed for changed in after if after[changed] != before[changed]} == followers


def kinds_in(shapes):
    return {name: recipes.kind(bpy.data.objects[name].data) for name in shapes}


def changed_by(change, before):
    """The names of the shapes that are others once something was changed."""
    change()
    bpy.context.view_layer.update()
    shapes = {name: bpy.data.objects[name] for name in before}
    assert not any(part('bridge.follow.follow').problem(ob.data) for ob in shapes.values())
    return {name for name, ob in shapes.items() if ob.data.splinewright.value != before[name]}


def continuity_between(names, sides=('u_start', 'u_end', 'v_start', 'v_end')):
    """Across the two sides that come nearest to each other, of the patches of two objects in the scene."""
    first, second = (bpy.data.objects[name] for name in names)
    first, second = (ob.data.splinewright.value.transformed(np.array(ob.matrix_world)) for ob in (first, second))
    return min((sc.seam_continuity(first, a, second, b) for a in sides for b in sides), key=lambda seam: seam.gap)


def test_the_sides_of_the_flask_are_lofts_and_its_front_and_back_go_on_from_them():
    shapes = opened('flask')
    kinds = kinds_in(shapes)
    assert {name for name, kind in kinds.items() if kind == 'loft'} == {"Right side", "Left side"}
    assert {name for name, kind in kinds.items() if kind == 'filling'} == {"Front", "Back"}
    for name in ("Front", "Back"):
        assert recipes.read(bpy.data.objects[name].data).said.startswith("4 sides, angle 0")
        for side in ("Right side", "Left side"):
            seam = continuity_between((side, name))
            assert seam.gap < 1e-9 and np.degrees(seam.angle) < 1e-6 and seam.curvature_difference < 1e-5
    middle = shapes["Front"].evaluate(*(np.mean(domain) for domain in shapes["Front"].domain))
    assert middle[1] > shapes["Front"].points[..., 1].min() + 0.1           # a dent


def test_a_section_of_the_flask_changes_both_sides_and_what_fills_between():
    before = opened('flask')
    curve = bpy.data.objects["Section 4, right"].data.splinewright
    def widen():
        curve.value = curve.value.with_points(curve.value.points * (1.1, 1, 1))
    assert changed_by(widen, before) == {"Section 4, right", "Section 4, left", "Right side", "Left side", "Front", "Back"}


def test_the_parts_of_the_mirror_go_on_from_each_other_with_their_curvatures():
    shapes = opened('mirror')
    kinds = kinds_in(shapes)
    assert kinds["Housing"] == 'network' and kinds["Glass"] == 'filling' and list(kinds.values()).count('surface_blend') == 3
    for name, neighbors in (("Blend of housing and arm", ("Housing", "Arm")), ("Blend of arm and foot", ("Arm", "Foot")),
                             ("Rim", ("Housing", "Bezel"))):
        assert recipes.read(bpy.data.objects[name].data).said.count("angle 0°, curvatures differ by 0") == 2
        for neighbor in neighbors:
            seam = continuity_between((neighbor, name), ('v_start', 'v_end'))
            assert seam.gap < 1e-9 and np.degrees(seam.angle) < 1e-6 and seam.curvature_difference < 1e-6, name
    assert np.ptp(shapes["Glass"].points[..., 1]) < 1e-9


def test_the_mirror_follows_its_curves():
    before = opened('mirror')
    def lower():
        bpy.data.objects["Section of the foot, 2"].location.z -= 0.02
    assert changed_by(lower, before) == {"Foot", "Blend of arm and foot"}


def test_suzanne_follows_her_mesh_and_is_smooth():
    opened('suzanne')
    ob, mesh = bpy.data.objects["Suzanne as patches"], bpy.data.objects["Suzanne"]
    before, said = ob.data.splinewright.value, recipes.read(ob.data).said
    assert len(before) == 7868 and "404 of them" in said
    mesh.data.vertices[0].co.z += 0.05
    mesh.data.update()
    bpy.context.view_layer.update()
    assert ob.data.splinewright.value != before


def body_of(name):
    value = bpy.data.objects[name].data.splinewright.value
    return value if isinstance(value, sc.PatchSet) else sc.PatchSet.from_patches([value])


def open_sides(patch_set):
    """How many sides of patches that are no points no other side has."""
    return sum(map(len, sc.build.open_ends(patches_of(patch_set))))


def test_the_shampoo_bottle_is_closed_and_follows_a_section():
    before = opened('shampoo')
    assert kinds_in(before)["Bottle"] == 'loft' and len(before["Bottle"]) == 3
    assert open_sides(before["Bottle"]) == 0 and before["Bottle"].volume() > 0
    def widen():
        bpy.data.objects["Section 4"].scale.x *= 1.1
    assert changed_by(widen, before) == {"Bottle"}
    assert open_sides(body_of("Bottle")) == 0


def test_the_halves_of_the_mouse_go_on_as_each_other_across_the_plane():
    before = opened('mouse')
    assert kinds_in(before)["Mouse"] == 'mirror' and open_sides(before["Base"]) == 0
    def lift():
        bpy.data.objects["Rib 2"].location.z += 0.03
    assert changed_by(lift, before) == {"Half", "Mouse", "Line behind the buttons"}
    for value in (before["Mouse"], body_of("Mouse")):
        (first, side), (second, other) = value.seams()[0]
        seam = sc.seam_continuity(value[first], side, value[second], other)
        assert len(value.seams()) == 1 and seam.gap < 1e-12 and seam.g >= 2
        assert np.abs(value[first].boundary(side).points[:, 1]).max() == 0.0


def test_the_chine_of_the_hull_is_one_edge():
    before = opened('hull')
    frames = [np.asarray(before[f"Frame {i + 1}"].points) for i in range(6)]
    half = before["Half"]
    knots, degree = np.asarray(half.knots[0]), half.degree[0]
    inner = knots[(knots > half.domain[0][0]) & (knots < half.domain[0][1])]
    assert len(inner) == degree and np.ptp(inner) == 0.0        # the only line of knots along the hull, and a sharp one
    chine = half.isocurve('u', inner[0])
    assert chine.nearest([points[1] for points in frames]).distances.max() < 1e-9
    assert bpy.data.objects["Curve of the spray rail"].data.splinewright.value == chine
    def lower():
        bpy.data.objects["Frame 3"].location.z -= 0.05
    assert changed_by(lower, before) == {"Half", "Half, both"}
