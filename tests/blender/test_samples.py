"""The scenes in blend_samples: saved by the oldest supported Blender, alive in all of them."""

from pathlib import Path

import bpy
import numpy as np
import pytest

from support import curve_points, part, splinecore as sc, vertices

SAMPLES = Path(__file__).resolve().parents[2] / "blend_samples"
NAMES = sorted(path.stem.removeprefix("make_") for path in SAMPLES.glob("make_*.py"))


def test_there_are_samples():
    assert {'gallery', 'teapot', 'vase', 'conics', 'moebius', 'knots', 'points', 'runge', 'joins'} <= set(NAMES)


@pytest.mark.parametrize('name', NAMES)
def test_a_sample_has_its_scene_and_its_picture(name):
    assert (SAMPLES / f"{name}.png").read_bytes().startswith(b'\x89PNG')
    bpy.ops.wm.open_mainfile(filepath=str(SAMPLES / f"{name}.blend"))
    assert tuple(bpy.data.version)[:2] == (3, 4)
    assert bpy.context.scene.camera is not None


@pytest.mark.parametrize('name', NAMES)
def test_every_shape_of_a_sample_shows_its_definition(name):
    bpy.ops.wm.open_mainfile(filepath=str(SAMPLES / f"{name}.blend"))
    shapes = [ob for ob in bpy.data.objects if part('bridge.shape').has_shape(ob)]
    assert shapes
    for ob in shapes:
        assert not part('bridge.shape').is_touched(ob.data), ob.name
        settings, value = ob.data.splinewright, ob.data.splinewright.value
        if ob.type == 'CURVE':
            curves = value if isinstance(value, list) else [value]
            reach = settings.resolution_u, settings.reach, part('bridge.recipes').around(ob.data)
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
    return {ob.name: ob.data.splinewright.value for ob in bpy.data.objects if part('bridge.shape').has_shape(ob)}


def test_five_inner_knots_of_degree_5_are_merged_one_after_the_other():
    shapes = opened('knots')
    curves = [value for name, value in shapes.items() if name.startswith("Inner knots")]
    assert all(curve.degree == 5 and len(curve.points) == 11 for curve in curves)
    assert sorted(curve.knot_vector.multiplicity(3.0) for curve in curves) == [1, 2, 3, 4, 5]
    assert sorted(curve.continuity(3.0).c for curve in curves) == [0, 1, 2, 3, 4]
    assert sum(name.startswith("Basis functions") for name in shapes) == 5


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
