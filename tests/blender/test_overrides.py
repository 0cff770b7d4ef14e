"""What an override of a linked shape has of its own: what is drawn over it. Its geometry is that of its library."""

import bpy
import pytest

from support import part, vertices

OWN = {'show_seams': True, 'show_numbers': True, 'measure_u': 0.25, 'measure_v': 0.75}
SHARED = ('mode', 'tolerance', 'angle', 'resolution_u', 'resolution_v', 'sharp_angle', 'reach', 'piece')
api = part('api')


@pytest.fixture(params=('patch', 'curve'))
def overridden(request, tmp_path):
    """An object whose data overrides that of a file, and the path of a file that holds it."""
    getattr(bpy.ops.splinewright, f"add_nurbs_{request.param}")()
    bpy.context.object.name = "Shape"
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "library.blend"))
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
    with bpy.data.libraries.load(str(tmp_path / "library.blend"), link=True) as (_, wanted):
        wanted.objects = ["Shape"]
    ob = wanted.objects[0].override_create(remap_local_usages=True)
    bpy.context.scene.collection.objects.link(ob)
    ob.data = ob.data.override_create(remap_local_usages=True)
    return ob, str(tmp_path / "shot.blend")


def saved(path):
    bpy.ops.wm.save_as_mainfile(filepath=path)
    bpy.ops.wm.open_mainfile(filepath=path)
    ob = next(ob for ob in bpy.data.objects if not ob.library)
    assert ob.data.override_library
    return ob


def test_what_is_drawn_over_an_override_is_kept_with_the_file(overridden):
    ob, path = overridden
    for name, value in OWN.items():
        assert ob.data.splinewright.is_property_overridable_library(name), name
        setattr(ob.data.splinewright, name, value)
    bpy.ops.ed.undo_push(message="settings")
    ob = saved(path)
    assert {name: getattr(ob.data.splinewright, name) for name in OWN} == OWN
    reference = ob.data.override_library.reference
    assert {name: getattr(reference.splinewright, name) for name in OWN} == {
        'show_seams': False, 'show_numbers': False, 'measure_u': 0.5, 'measure_v': 0.5}
    assert api.is_shape(ob) and api.value(ob) is not None and not api.is_changed_by_hand(ob)


def test_what_the_geometry_depends_on_stays_with_the_library(overridden):
    ob, path = overridden
    before = vertices(ob.data) if ob.type == 'MESH' else None
    resolution = ob.data.splinewright.resolution_u
    for name in SHARED:
        assert not ob.data.splinewright.is_property_overridable_library(name), name
    ob.data.splinewright.resolution_u = 3           # a script may, a panel does not let anyone
    assert "change the original" in ob.data.splinewright.problem
    assert before is None or (vertices(ob.data) == before).all()
    with pytest.raises(api.Refusal, match="change the original"):
        api.set_value(ob, api.value(ob))
    assert saved(path).data.splinewright.resolution_u == resolution
