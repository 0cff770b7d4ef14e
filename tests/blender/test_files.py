"""Shapes in files: saved while edited, opened without the add-on, linked, appended, older and newer."""

import shutil
import subprocess
from pathlib import Path

import bpy
import numpy as np
import pytest

from layouts import sidebar
from shapes import VALUES, activate, add, enter, first_point, leave, move, require_exact, select, shown
from support import part, vertices

editing, live, net_object, shape, store = (part(name) for name in (
    'ui.editing', 'bridge.net.live', 'bridge.cage.net_object', 'bridge.shape.shape', 'bridge.data.store'))

DATA = Path(__file__).resolve().parent.parent / "data"
KINDS = ('nurbs patch', 'teapot', 'nurbs', 'hermite')


def save(path):
    bpy.ops.wm.save_as_mainfile(filepath=str(path))


def reopen(path):
    bpy.ops.wm.open_mainfile(filepath=str(path))


def nets():
    return [ob for ob in bpy.data.objects if net_object.is_net(ob)]


@pytest.mark.parametrize('name', KINDS)
def test_saving_in_the_middle_of_editing_keeps_editing_and_the_file_has_no_net(name, tmp_path):
    value = VALUES[name]()
    add(value)
    held = enter()
    vertex = first_point(held)
    select(held, vertex)
    move(0, 0, 1)
    moved = bpy.data.objects["shape"].data.splinewright.value
    path = tmp_path / "middle.blend"
    save(path)
    held = bpy.context.object
    assert net_object.is_net(held) and held.mode == 'EDIT' and len(nets()) == 1
    move(0, 0, 1)
    further = bpy.data.objects["shape"].data.splinewright.value
    assert further != moved
    bpy.ops.ed.undo()
    assert bpy.data.objects["shape"].data.splinewright.value == moved
    bpy.ops.ed.undo()
    assert bpy.data.objects["shape"].data.splinewright.value == value, "every digit, across a save"
    leave()
    reopen(path)
    assert not nets() and [ob.name for ob in bpy.data.objects] == ["shape"] and bpy.context.mode == 'OBJECT'
    ob = bpy.data.objects["shape"]
    assert ob.data.splinewright.value == moved and not shape.is_touched(ob.data)
    require_exact(ob)


def test_saving_takes_nets_of_other_scenes_out_and_leaves_other_objects_in_edit_mode(tmp_path):
    other, here = bpy.data.scenes.new("other"), bpy.context.scene
    bpy.context.window.scene = other
    add(VALUES['nurbs']())
    enter()
    bpy.context.window.scene = here
    ob = add(VALUES['nurbs patch'](), "patch")
    held = enter()
    cube = bpy.data.objects.new("cube", bpy.data.meshes.new("cube"))
    cube.data.from_pydata([(0, 0, 0)], [], [])
    here.collection.objects.link(cube)
    cube.select_set(True)
    bpy.ops.object.mode_set(mode='OBJECT')
    bpy.ops.object.mode_set(mode='EDIT')
    assert {one.name for one in bpy.context.objects_in_mode} == {held.name, "cube"} and len(nets()) == 2
    save(tmp_path / "scenes.blend")
    assert {one.name for one in bpy.context.objects_in_mode} == {held.name, "cube"}
    assert bpy.context.object == held and len(nets()) == 2 and all(one.mode == 'EDIT' for one in nets())
    copy = shutil.copy(tmp_path / "scenes.blend", tmp_path / "copy.blend")      # Blender reads no file that is open
    with bpy.data.libraries.load(str(copy)) as (found, _):
        assert sorted(found.objects) == ["cube", "patch", "shape"]
    cube.select_set(False)
    assert leave() == ob


@pytest.mark.parametrize('name', KINDS)
def test_a_recovered_file_with_a_net_in_it_goes_on(name, tmp_path):
    """As autosave and crash recovery write it: no handler was asked."""
    value = VALUES[name]()
    add(value)
    held = enter()
    select(held, first_point(held))
    move(0, 0, 1)
    moved = bpy.data.objects["shape"].data.splinewright.value
    path = tmp_path / "recovered.blend"
    saving = part('ui.saving')
    handlers = [bpy.app.handlers.save_pre, bpy.app.handlers.save_post]
    for handler, function in zip(handlers, (saving.before, saving.after)):
        handler.remove(function)
    save(path)
    for handler, function in zip(handlers, (saving.before, saving.after)):
        handler.append(function)
    reopen(path)
    part('ui.handlers').loaded()
    assert len(nets()) == 1 and bpy.data.objects["shape"].data.splinewright.value == moved
    held = nets()[0]
    assert held.mode == 'EDIT'
    activate(held)
    bpy.ops.mesh.select_all(action='DESELECT') if held.type == 'MESH' else bpy.ops.curve.select_all(action='DESELECT')
    select(held, first_point(held))
    move(0, 0, -1)
    ob = leave()
    after, before = store.read(ob.data), part('core.shape.definition').from_value(value)
    same = (after.pool == before.pool).all(1) if after.pool.shape == before.pool.shape else np.array([True])
    assert same.sum() >= len(same) - 3, "what was not moved has the digits of before the file was written"
    require_exact(ob)


WITHOUT = """
import bpy, sys, addon_utils
print([a for a in bpy.context.preferences.addons.keys() if 'splinewright' in a])
print("OBJECTS", sorted(ob.name for ob in bpy.data.objects), bpy.context.mode)
mesh = bpy.data.objects["shape"].data
print("VERTICES", len(mesh.vertices), sum(v.co.z for v in mesh.vertices))
bpy.ops.wm.save_as_mainfile(filepath=sys.argv[-1])
"""


def test_without_the_add_on_the_mesh_is_there_and_with_it_the_shape_lives_on(tmp_path):
    value = VALUES['nurbs patch']()
    add(value)
    held = enter()
    select(held, first_point(held))
    move(0, 0, 1)
    path, other = tmp_path / "shape.blend", tmp_path / "resaved.blend"
    save(path)
    ob = bpy.data.objects["shape"]
    moved, count, height = ob.data.splinewright.value, len(ob.data.vertices), vertices(ob.data)[:, 2].sum()
    script = tmp_path / "without.py"
    script.write_text(WITHOUT)
    done = subprocess.run([bpy.app.binary_path, '--background', '--factory-startup', str(path), '--python-exit-code', '1',
                           '--python', str(script), '--', str(other)], capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stderr
    assert "OBJECTS ['shape'] OBJECT" in done.stdout
    line = next(line for line in done.stdout.splitlines() if line.startswith("VERTICES")).split()
    assert int(line[1]) == count and np.isclose(float(line[2]), height, rtol=1e-4)
    reopen(other)
    ob = bpy.data.objects["shape"]
    assert ob.data.splinewright.value == moved
    require_exact(ob)
    activate(ob)
    held = enter()
    select(held, first_point(held))
    move(0, 0, 1)
    require_exact(leave())


def library(tmp_path, name='nurbs patch'):
    """A file with one shape; its path and value. The present file is empty afterwards."""
    value = VALUES[name]()
    add(value)
    path = tmp_path / "library.blend"
    save(path)
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
    return path, value


def bring(path, link):
    with bpy.data.libraries.load(str(path), link=link) as (source, target):
        target.objects = ["shape"]
    ob = target.objects[0]
    bpy.context.scene.collection.objects.link(ob)
    bpy.context.view_layer.update()
    activate(ob)
    return ob


@pytest.mark.parametrize('name', KINDS)
def test_an_appended_shape_is_alive(name, tmp_path):
    path, value = library(tmp_path, name)
    ob = bring(path, link=False)
    assert ob.data.splinewright.value == value and not shape.is_touched(ob.data)
    bpy.ops.ed.undo_push(message="append")
    held = enter()
    select(held, first_point(held))
    move(0, 0, 1)
    require_exact(leave())


def test_a_linked_shape_is_shown_and_refuses_changes_with_a_word(tmp_path):
    path, value = library(tmp_path)
    ob = bring(path, link=True)
    assert ob.data.splinewright.value == value
    assert not bpy.ops.splinewright.edit_net.poll()
    for operator, word in ((bpy.ops.splinewright.restore, "linked"), (bpy.ops.splinewright.detach, "linked"),
                           (bpy.ops.splinewright.apply_transform, "linked")):
        with pytest.raises(RuntimeError, match=word):
            operator()
    with pytest.raises(ValueError, match="linked"):
        ob.data.splinewright.value = value
    bpy.ops.object.make_local(type='SELECT_OBDATA')
    ob = bpy.context.object
    bpy.ops.ed.undo_push(message="local")
    held = enter()
    select(held, first_point(held))
    move(0, 0, 1)
    require_exact(leave())


def test_an_overridden_shape_refuses_changes_with_a_word(tmp_path):
    path, value = library(tmp_path)
    linked = bring(path, link=True)
    ob = linked.override_create(remap_local_usages=True)
    activate(ob)
    assert ob.data.splinewright.value == value and not bpy.ops.splinewright.edit_net.poll()
    with pytest.raises(RuntimeError, match="linked"):
        bpy.ops.splinewright.restore()
    ob.data.splinewright.resolution_u = 3
    with pytest.raises(ValueError, match="linked"):
        ob.data.splinewright.value = value
    assert ob.data.splinewright.value == value


def test_copy_and_paste_between_files(tmp_path):
    value = VALUES['teapot']()
    add(value)
    bpy.ops.view3d.copybuffer()
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
    bpy.ops.view3d.pastebuffer()
    ob = next(ob for ob in bpy.data.objects if shape.has_shape(ob))
    assert ob.data.splinewright.value == value
    require_exact(ob)


def test_a_follower_brings_along_what_it_follows(tmp_path):
    data = bpy.data.curves.new("source", 'CURVE')
    data.splines.new('NURBS').points.add(4)
    for i, point in enumerate(data.splines[0].points):
        point.co = (i, i % 2, 0, 1)
    source = bpy.data.objects.new("source", data)
    bpy.context.scene.collection.objects.link(source)
    bpy.context.view_layer.update()
    activate(source)
    bpy.ops.splinewright.follow_object()
    bpy.context.object.name = "shape"
    path = tmp_path / "library.blend"
    save(path)
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
    ob = bring(path, link=False)
    follow = part('bridge.follow.follow')
    assert "deleted" in follow.problem(ob.data), "the source is in no scene yet"
    bpy.context.scene.collection.objects.link(bpy.data.objects["source"])
    bpy.data.objects["source"].location.z = 1
    bpy.context.view_layer.update()
    assert np.allclose(store.read(ob.data).pool[:, 2], 1) and follow.problem(ob.data) == ""


# Versions ------------------------------------------------------------------------------------------


def test_a_file_of_version_1_opens_is_edited_and_becomes_one_of_this_version(tmp_path):
    reopen(DATA / "definition_version_1.blend")
    shapes = [ob for ob in bpy.data.objects if shape.has_shape(ob)]
    assert len(shapes) >= 4 and all(ob.data[store.KEY]['version'] == 1 for ob in shapes)
    for name in [ob.name for ob in shapes]:
        ob = bpy.data.objects[name]
        value = ob.data.splinewright.value
        assert value is not None and not shape.is_touched(ob.data)
        activate(ob)
        bpy.ops.ed.undo_push(message="choose")
        held = enter()
        select(held, first_point(held))
        move(0, 0, 0.25)
        ob = leave()
        assert ob.data[store.KEY]['version'] == store.VERSION and ob.data.splinewright.value != value
        require_exact(ob)
    save(tmp_path / "newer.blend")


@pytest.mark.parametrize('name', ('nurbs patch', 'nurbs'))
def test_a_shape_of_a_newer_version_is_shown_and_read_only_with_a_word(name):
    ob = add(VALUES[name]())
    before = shown(ob).copy()
    ob.data[store.KEY]['version'] = store.VERSION + 1
    bpy.ops.ed.undo_push(message="newer")
    for operator in (bpy.ops.splinewright.edit_net, bpy.ops.splinewright.restore, bpy.ops.splinewright.apply_transform):
        with pytest.raises(RuntimeError, match="newer Splinewright"):
            operator()
    ob.data.splinewright.resolution_u = 9
    assert "newer Splinewright" in ob.data.splinewright.problem
    assert np.array_equal(shown(ob), before) and ob.data[store.KEY]['version'] == store.VERSION + 1
    assert not nets()


# The add-on goes and comes -------------------------------------------------------------------------


@pytest.mark.parametrize('name', KINDS)
def test_disabling_the_add_on_in_the_middle_of_editing_puts_the_net_away(name):
    add(VALUES[name]())
    held = enter()
    select(held, first_point(held))
    move(0, 0, 1)
    value = bpy.data.objects["shape"].data.splinewright.value
    part('ui').unregister()
    try:
        assert [ob.name for ob in bpy.data.objects] == ["shape"] and bpy.context.mode == 'OBJECT'
    finally:
        part('ui').register()
    part('ui.handlers').loaded()
    ob = bpy.data.objects["shape"]
    assert ob.data.splinewright.value == value
    require_exact(ob)
    activate(ob)
    held = enter()
    select(held, first_point(held))
    move(0, 0, 1)
    require_exact(leave())


@pytest.mark.parametrize('is_overridden', (False, True))
def test_the_panel_and_tab_say_from_which_file_a_shape_is_linked_and_make_it_local(is_overridden, tmp_path):
    path, _ = library(tmp_path)
    ob = bring(path, link=True)
    if is_overridden:
        ob = ob.override_create(remap_local_usages=True)
        activate(ob)
    layout = sidebar(bpy.context)
    assert "linked from library.blend" in " ".join(layout.texts) and "object.make_local" in layout.operators
    assert "splinewright.edit_net" not in layout.operators
    assert bpy.ops.splinewright.edit_linked.poll(), "Tab"
    with pytest.raises(RuntimeError, match="shape is linked from library.blend: make it local"):
        bpy.ops.splinewright.edit_linked()
    bpy.ops.object.make_local(type='SELECT_OBDATA')
    activate(bpy.context.object)
    assert bpy.ops.splinewright.edit_net.poll() and not bpy.ops.splinewright.edit_linked.poll()
    bpy.ops.ed.undo_push(message="local")
    enter()
    require_exact(leave())
