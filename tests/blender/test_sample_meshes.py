"""Every patch shape of every sample, meshed by count and adaptively: without cracks, slivers and flipped faces."""

import functools
import sys
from pathlib import Path

import bpy
import numpy as np
import pytest

from support import part, splinecore as sc

sys.path.append(str(Path(__file__).resolve().parents[1] / "python"))
import mesh_checks  # noqa: E402

SAMPLES = Path(__file__).resolve().parents[2] / "blend_samples"
NAMES = sorted(path.stem for path in SAMPLES.glob("*.blend"))
#: 1 is left out: it makes two half tubes one flat strip.
COUNTS = (2, 3, 6, (4, 9), (11, 3))
#: Tolerances in parts of the size.
ADAPTIVE = ({'tolerance': 0.01}, {'tolerance': 0.002}, {'angle': 0.3})
#: Of a larger set so many patches are looked at: the time of the check grows faster than they.
MOST = 100


@functools.cache
def patch_sets(name):
    """{object: its patches} of a sample, each definition once."""
    bpy.ops.wm.open_mainfile(filepath=str(SAMPLES / f"{name}.blend"))
    found = {}
    for ob in bpy.data.objects:
        if ob.type == 'MESH' and part('bridge.shape.shape').has_shape(ob):
            value = ob.data.splinewright.value
            patches = value if isinstance(value, sc.PatchSet) else sc.PatchSet.from_patches([value])
            found[ob.name] = patches if len(patches) <= MOST else sc.PatchSet.from_patches(list(patches)[:MOST])
    return found


def check_all(name, meshed):
    for ob, patches in patch_sets(name).items():
        try:
            mesh_checks.check(patches, meshed(patches))
        except AssertionError as error:
            raise AssertionError(f"{ob}: {error}") from error


def test_there_are_patch_shapes_among_the_samples():
    assert len(patch_sets('teapot')) == 1 and len(patch_sets('gallery')) == 4


@pytest.mark.parametrize('resolution', COUNTS, ids=str)
@pytest.mark.parametrize('name', NAMES)
def test_shapes_of_a_sample_hold_together_by_count(name, resolution):
    check_all(name, lambda patches: sc.Tessellation(patches, resolution))


@pytest.mark.parametrize('name', NAMES)
def test_shapes_of_a_sample_hold_together_as_they_were_saved(name):
    bpy.ops.wm.open_mainfile(filepath=str(SAMPLES / f"{name}.blend"))
    saved = {ob.name: (ob.data.splinewright.resolution_u, ob.data.splinewright.resolution_v)
             for ob in bpy.data.objects if ob.type == 'MESH' and part('bridge.shape.shape').has_shape(ob)}
    for ob, patches in patch_sets(name).items():
        mesh_checks.check(patches, sc.Tessellation(patches, saved[ob]))


@pytest.mark.parametrize('settings', ADAPTIVE, ids=str)
@pytest.mark.parametrize('name', NAMES)
def test_shapes_of_a_sample_hold_together_adaptively(name, settings):
    def meshed(patches):
        size = np.ptp(patches.points, axis=0).max()
        return sc.Tessellation.adaptive(
            patches, **{word: number * (size if word == 'tolerance' else 1) for word, number in settings.items()})
    check_all(name, meshed)
