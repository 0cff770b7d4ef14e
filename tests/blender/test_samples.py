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
            lines = [points for curve in curves for points, _ in curve.polylines(settings.resolution_u, settings.reach)]
            assert len(lines) == len(ob.data.splines)
            for spline, points in zip(ob.data.splines, lines):
                assert np.allclose(curve_points(spline), points, atol=1e-6), ob.name
        else:
            patch_set = value if isinstance(value, sc.PatchSet) else sc.PatchSet.from_patches([value], merge=False)
            plan = sc.Tessellation(patch_set, (settings.resolution_u, settings.resolution_v))
            assert np.allclose(vertices(ob.data), plan.evaluate(patch_set)[0], atol=1e-6), ob.name
