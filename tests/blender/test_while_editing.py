"""What others do while a net is out."""

import bpy
import numpy as np
import pytest

from shapes import VALUES, activate, add, enter, first_point, leave, move, require_exact, select
from support import part, vertices

editing, shape = part('ui.editing'), part('bridge.shape.shape')


def test_a_follower_of_a_shape_follows_its_net_at_every_move():
    ob = add(VALUES['nurbs patch'](), "a")
    bpy.ops.splinewright.follow_object('EXEC_DEFAULT', True)
    follower = bpy.context.object
    activate(ob)
    held = enter()
    select(held, first_point(held))
    for _ in range(2):
        move(0, 0, 1)
        assert follower.data.splinewright.value == ob.data.splinewright.value
        require_exact(follower)
    leave()


def test_a_mesh_changed_by_hand_while_its_net_is_out_is_not_overwritten():
    ob = add(VALUES['nurbs patch']())
    held = enter()
    select(held, first_point(held))
    ob.data.vertices[7].co.z += 5
    changed = vertices(ob.data).copy()
    move(0, 0, 0.5)
    assert "changed by hand" in part('bridge.net.live').problem(held) and np.array_equal(vertices(ob.data), changed)
    leave()
    assert shape.is_touched(ob.data) and np.array_equal(vertices(ob.data), changed)


@pytest.mark.parametrize('kind', sorted(VALUES))
def test_the_result_itself_in_edit_mode_is_not_changed_by_hand(kind):
    ob = add(VALUES[kind]())
    bpy.ops.object.mode_set(mode='EDIT')
    assert bpy.context.mode in ('EDIT_MESH', 'EDIT_CURVE') and not shape.is_touched(ob.data)
    bpy.ops.object.mode_set(mode='OBJECT')
    assert not shape.is_touched(ob.data)
    require_exact(ob)


def test_a_value_given_while_the_net_is_out_is_not_lost():
    ob = add(VALUES['nurbs patch']())
    held = enter()
    select(held, first_point(held))
    move(0, 0, 0.5)
    value = VALUES['bezier patch']()
    ob.data.splinewright.value = value
    move(0, 0, 0.5)
    assert "another definition" in part('bridge.net.live').problem(held)
    leave()
    assert ob.data.splinewright.value == value
    require_exact(ob)


@pytest.mark.parametrize('everything', (False, True))
def test_parts_separated_from_a_net_are_no_nets_and_revert_nothing(everything):
    ob = add(VALUES['nurbs patch']())
    held = enter()
    select(held, *(range(24) if everything else (0, 1)))
    bpy.ops.mesh.separate('EXEC_DEFAULT', True, type='SELECTED')
    leave()
    assert [ob.name for ob in bpy.data.objects] == ["shape"]
    held = enter()
    select(held, 3)
    move(0, 0, 1)
    leave()
    value = bpy.data.objects["shape"].data.splinewright.value
    editing.sweep()
    assert bpy.data.objects["shape"].data.splinewright.value == value


@pytest.mark.parametrize('mode', ('SCULPT', 'VERTEX_PAINT', 'WEIGHT_PAINT'))
def test_a_net_taken_into_another_mode_is_swept_and_undo_survives(mode):
    add(VALUES['bezier patch']())
    held = enter()
    select(held, 0)
    move(0, 0, 0.5)
    bpy.ops.object.mode_set('EXEC_DEFAULT', True, mode=mode)
    editing.sweep()
    assert bpy.context.mode == 'OBJECT' and not list(editing.nets())
    for _ in range(3):
        bpy.ops.ed.undo()
        editing.sweep()
        require_exact(bpy.data.objects["shape"])


def test_a_material_stays_on_its_patch_when_the_resolution_changes():
    ob = add(VALUES['mixed set']())
    for name in ("red", "blue"):
        ob.data.materials.append(bpy.data.materials.new(name))
    patches = np.empty(len(ob.data.polygons), np.int32)
    ob.data.attributes["patch"].data.foreach_get('value', patches)
    ob.data.polygons.foreach_set('material_index', (patches == 1).astype(np.int32))
    ob.data.splinewright.resolution_u = 7
    patches = np.empty(len(ob.data.polygons), np.int32)
    ob.data.attributes["patch"].data.foreach_get('value', patches)
    indices = np.empty(len(ob.data.polygons), np.int32)
    ob.data.polygons.foreach_get('material_index', indices)
    assert set(patches) == {0, 1} and np.array_equal(indices, patches == 1)
