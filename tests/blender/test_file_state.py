"""What is remembered of the open file: by what keys, until when, and that it holds no truth."""

import bpy
import numpy as np
import pytest

from shapes import activate, add, enter, leave, move, points, require_exact, select
from support import part, splinecore as sc

file_state, fineness, follow, live, problems, settings, shape, store = (part(name) for name in (
    'bridge.data.file_state', 'bridge.data.tessellate', 'bridge.follow.follow', 'bridge.net.live', 'bridge.data.problems', 'bridge.data.settings',
    'bridge.shape.shape', 'bridge.data.store'))


def patch():
    return sc.BezierPatch(points(3, 3))


def test_a_linked_block_and_a_local_one_of_the_same_name_are_two(tmp_path):
    add(patch(), "twin")
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "library.blend"))
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
    local = add(patch(), "twin")
    with bpy.data.libraries.load(str(tmp_path / "library.blend"), link=True) as (_, wanted):
        wanted.objects = ["twin"]
    linked = wanted.objects[0]
    assert linked.data.name == local.data.name and linked.data != local.data
    problems.set_problem(linked.data, problems.FOLLOWING, "of the linked one")
    assert problems.of(local.data, problems.FOLLOWING) == ""
    for block in (linked, local, linked.data, local.data):
        assert file_state.block_of(file_state.key(block)) == block


def test_problems_about_several_things_do_not_hide_one_another():
    data = add(patch()).data
    problems.set_problem(data, problems.NET, "net")
    problems.set_problem(data, problems.SETTING, "setting")
    problems.set_problem(data, problems.NET, "")
    assert (problems.of(data, problems.NET), problems.of(data, problems.SETTING)) == ("", "setting")


def test_another_file_is_another_state():
    data = add(patch()).data
    problems.set_problem(data, problems.SETTING, "old")
    enter()
    leave()
    file_state.state.quiet.add(file_state.key(data))
    part('ui.ui_state').ui_state.hovered = ("gone", 1)
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
    assert file_state.state == file_state.FileState()
    assert part('ui.ui_state').ui_state == part('ui.ui_state').UiState(is_scanned=True)


@pytest.mark.parametrize('resolution', ((2.5, 3), (3, 2.5), ("a", 3), (3, None)))
def test_a_resolution_that_is_none_changes_nothing_for_ever(resolution):
    ob = add(patch())
    count = len(ob.data.vertices)
    with pytest.raises(TypeError):
        ob.data.splinewright.set_resolution(*resolution)
    assert (ob.data.splinewright.resolution_u, ob.data.splinewright.resolution_v) == (4, 4)
    assert len(ob.data.vertices) == count and not file_state.state.quiet
    ob.data.splinewright.resolution_u = 9
    assert len(ob.data.vertices) == 10 * 5


def test_an_old_file_with_the_flag_set_for_ever_shows_settings_again(tmp_path):
    ob = add(patch())
    if bpy.app.version < (5, 0, 0):     # later ones keep elsewhere what is registered
        ob.data.splinewright.resolution_v = 5
        ob.data['splinewright']['quiet'] = 1
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "old.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "old.blend"))
    data = bpy.data.objects["shape"].data
    data.splinewright.resolution_u = 9
    assert len(data.vertices) == 10 * (data.splinewright.resolution_v + 1)


def test_a_mistake_of_ours_is_no_advice_and_stops_no_other_follower(monkeypatch, capfd):
    sources = [add(sc.BezierCurve(points(4)), name) for name in ("a", "b")]
    followers = []
    for source in sources:
        activate(source)
        bpy.ops.splinewright.follow_object()
        followers.append(bpy.context.object)
    derived = part('bridge.follow.recipe_results')

    def broken(recipe, values, inputs, *others, work=derived.work):
        if inputs[0] == sources[0]:
            raise KeyError("forgotten")
        return work(recipe, values, inputs, *others)
    monkeypatch.setattr(derived, 'work', broken)
    for source in sources:
        source.data.splinewright.value = sc.BezierCurve(points(5))
    bpy.context.view_layer.update()
    assert "an error in Splinewright" in follow.problem(followers[0].data)
    assert follow.problem(followers[1].data) == ""
    assert followers[1].data.splinewright.value == sources[1].data.splinewright.value
    assert "KeyError" in capfd.readouterr().err


def test_a_mistake_of_ours_in_an_operator_is_no_report(monkeypatch):
    ob = add(sc.BezierCurve(points(4)))
    activate(ob)

    def broken(*_):
        raise KeyError("forgotten")
    monkeypatch.setattr(part('bridge.edit.replace_pieces'), 'do', broken)
    with pytest.raises(RuntimeError, match="KeyError"):
        bpy.ops.splinewright.reverse()


def test_the_end_of_a_gesture_builds_no_new_faces(monkeypatch):
    ob = add(patch())
    held = enter()
    select(held, 4)
    move(0.1, 0.2, 0.3)
    move(0.1, 0.2, 0.3)                 # the first made the faces known
    assert store.is_draft(ob.data)

    def built(*_):
        raise AssertionError("the faces were built anew")
    monkeypatch.setattr(fineness, 'tessellated', built)
    live.finalize(ob.data)
    assert not store.is_draft(ob.data)
    monkeypatch.undo()
    require_exact(ob)
    leave()


def test_whether_a_mesh_was_touched_is_looked_at_when_it_changes():
    ob = add(patch())
    assert not shape.seems_touched(ob.data)
    ob.data.vertices[0].co.z += 1.0
    ob.data.update()
    bpy.context.view_layer.update()
    assert shape.seems_touched(ob.data) and shape.is_touched(ob.data)
    bpy.ops.splinewright.restore()
    assert not shape.seems_touched(ob.data)


def test_what_is_read_twice_is_decoded_once(monkeypatch):
    ob = add(patch())
    first = store.read(ob.data)
    monkeypatch.setattr(store, 'decoded', None)
    assert store.read(ob.data) is first and not first.pool.flags.writeable
    assert np.array_equal(first.pool[:, :3].reshape(3, 3, 3), ob.data.splinewright.value.points)
