"""Sample scenes that lie in the zip: each is added beside what there is, alive and fine."""

from pathlib import Path

import bpy
import pytest

from layouts import drawn_by
from shapes import op, require_exact
from support import part

add_sample, follow, recipes, shape = (part(name) for name in ('ui.operators.add_sample', 'bridge.follow.follow', 'bridge.recipes.recipes', 'bridge.shape.shape'))
NAMES = [name for name, _, _ in add_sample.SAMPLES]


def test_all_files_are_listed_and_small():
    found = {path.stem: path.stat().st_size for path in add_sample.FOLDER.glob("*.blend")}
    assert set(found) == set(NAMES) and sum(found.values()) < 700_000


@pytest.mark.parametrize('name', NAMES)
def test_a_sample_is_added_in_a_scene_of_its_own(name):
    bpy.ops.mesh.primitive_cube_add()
    mine = set(bpy.context.scene.objects)
    before = bpy.context.scene
    assert op(bpy.ops.splinewright.add_sample, sample=name) == {'FINISHED'}
    assert set(before.objects) == mine
    scene = bpy.data.scenes[-1] if bpy.context.window is None else bpy.context.window.scene
    shapes = [ob for ob in scene.objects if shape.has_shape(ob)]
    assert scene != before and shapes and not any(follow.problem(ob.data) for ob in shapes if recipes.follows(ob.data))
    for ob in shapes:
        require_exact(ob)
        assert not shape.is_touched(ob.data)
        assert ob.type == 'CURVE' or ob.data.splinewright.mode == 'AUTOMATIC'


def test_the_surface_of_a_sample_follows_its_curve():
    op(bpy.ops.splinewright.add_sample, sample='vase')
    scene = next(one for one in bpy.data.scenes if one.name.startswith("Vase"))
    curve = next(ob for ob in scene.objects if ob.type == 'CURVE')
    vase = next(ob for ob in scene.objects if ob.type == 'MESH')
    area = vase.data.splinewright.value.area()
    value = curve.data.splinewright.value
    moved = value.points.copy()
    moved[:, 0] *= 2
    bpy.context.window.scene = scene
    curve.data.splinewright.value = type(value)(value.degree, value.knots, moved)
    bpy.context.view_layer.update()
    assert vase.data.splinewright.value.area() != pytest.approx(area, rel=0.1)


def test_a_missing_file_is_said(monkeypatch):
    monkeypatch.setattr(add_sample, 'FOLDER', Path("/nowhere"))
    with pytest.raises(RuntimeError, match="Hull"):
        op(bpy.ops.splinewright.add_sample, sample='hull')


def test_samples_are_an_asset_library_once():
    libraries = bpy.context.preferences.filepaths.asset_libraries
    assert op(bpy.ops.splinewright.add_asset_library) == {'FINISHED'}
    assert Path(libraries[-1].path) == add_sample.FOLDER and libraries[-1].name == "Splinewright"
    assert not bpy.ops.splinewright.add_asset_library.poll()
    bpy.ops.preferences.asset_library_remove(index=len(libraries) - 1)
    with bpy.data.libraries.load(str(add_sample.FOLDER / "mouse.blend"), assets_only=True) as (known, _):
        assert known.objects == ["Mouse"]


def test_the_sidebar_shows_how_to_begin_while_nothing_is_selected():
    start = drawn_by(part('ui.start_panel').SPLINEWRIGHT_PT_start, bpy.context)
    assert {"splinewright.add_sample", "splinewright.manual"} <= set(start.operators)
