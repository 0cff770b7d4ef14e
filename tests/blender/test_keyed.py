"""Keys and drivers on the parameters of recipes and on the settings of how a shape is shown."""

import bpy
import numpy as np
import pytest

from animated import animate, follow_object, in_scene, rendered
from layouts import drawn
from shapes import activate, add, enter, op, require_exact
from support import part

parameters, problems, recipes, settings, shape, starters = (part(name) for name in (
    'bridge.recipes.parameters', 'bridge.data.problems', 'bridge.recipes.recipes', 'bridge.data.settings', 'bridge.shape.shape', 'core.shape.starters'))
FRAMES = (1, 4, 7)


def add_recipe(kind, **numbers):
    assert op(getattr(bpy.ops.splinewright, f"add_{kind}"), **numbers) == {'FINISHED'}
    return bpy.context.object


def add_revolve():
    """Of a curve that is shown, which is moved aside."""
    profile = add(starters.nurbs_curve(3, 6, 'CLAMPED'))
    profile.location.x = 2
    bpy.context.view_layer.update()
    activate(profile)
    return add_recipe('revolve')


def extent(ob, depsgraph):
    """The size along x, y and z of what a depsgraph shows."""
    data = ob.evaluated_get(depsgraph).data
    vertices = data.vertices if ob.type == 'MESH' else [point for spline in data.splines for point in spline.points]
    return np.ptp([vertex.co[:3] for vertex in vertices], axis=0)


def count(ob, depsgraph):
    """How many vertices or points a depsgraph shows."""
    data = ob.evaluated_get(depsgraph).data
    return len(data.vertices) if ob.type == 'MESH' else sum(len(spline.points) for spline in data.splines)


def graph():
    return bpy.context.evaluated_depsgraph_get()


def in_views_and_renders(look, ob, frames=FRAMES):
    """{frame: look(ob, depsgraph)} of views, and the same of a render; the shape is exact in each."""
    views = {}
    for frame in (*frames, frames[1]):
        bpy.context.scene.frame_set(frame)
        require_exact(ob)
        views[frame] = look(ob, graph())
    renders = {frame: looks[0] for frame, looks in rendered(lambda depsgraph: look(ob, depsgraph), frames).items()}
    require_exact(ob)
    return views, renders


def test_a_keyed_radius_is_right_in_every_frame_of_views_and_renders():
    ob = add_recipe('circle', form='square')
    animate(ob.data, 'splinewright_parameters.circle_radius', {1: 1.0, 11: 11.0})
    for seen in in_views_and_renders(extent, ob):
        assert {frame: size[0] for frame, size in seen.items()} == {frame: pytest.approx(2 * frame) for frame in FRAMES}
    assert recipes.parameters(ob.data)['radius'] == 4.0, "the render put the frame back, and the number with it"


def test_a_keyed_angle_of_a_surface_that_follows_a_curve_is_right_in_every_frame():
    """Its setter asked for the depsgraph in the midst of evaluation."""
    ob = add_revolve()
    animate(ob.data, 'splinewright_parameters.revolve_sweep', {1: 0.1, 7: 3.1})
    views, renders = in_views_and_renders(lambda ob, depsgraph: tuple(extent(ob, depsgraph).round(4)), ob)
    assert views == renders and len(set(views.values())) == 3
    assert recipes.parameters(ob.data)['sweep'] == pytest.approx(1.6)


def test_a_follower_of_what_is_keyed_moves_in_the_same_frame():
    circle = add_recipe('circle')
    ob = follow_object(circle)
    animate(circle.data, 'splinewright_parameters.circle_radius', {1: 1.0, 11: 11.0})
    for seen in in_views_and_renders(extent, ob):
        assert {frame: size[0] for frame, size in seen.items()} == {frame: pytest.approx(2 * frame) for frame in FRAMES}


def test_choices_and_switches_are_keyed_too():
    ob = add_recipe('catmull_rom')
    animate(ob.data, 'splinewright_parameters.catmull_rom_closed', {1: False, 4: True})
    animate(ob.data, 'splinewright_parameters.catmull_rom_parametrisation', {1: 'uniform', 7: 'chordal'})
    seen = {}
    for frame in FRAMES:
        bpy.context.scene.frame_set(frame)
        require_exact(ob)
        values = recipes.parameters(ob.data)
        seen[frame] = values['closed'], values['parametrisation']
    assert seen == {1: (False, 'uniform'), 4: (True, 'uniform'), 7: (True, 'chordal')}


@pytest.mark.parametrize('make', (lambda: add(starters.nurbs_curve(3, 6, 'CLAMPED')), add_revolve, lambda: add_recipe('torus'),
                                  lambda: add(starters.teapot())), ids=('curve', 'revolve', 'torus', 'teapot'))
def test_a_keyed_resolution_is_right_in_every_frame_of_views_and_renders(make):
    ob = make()
    ob.data.splinewright.set_resolution(3, 3)
    animate(ob.data, 'splinewright.resolution_u', {1: 2, 7: 8})
    views, renders = in_views_and_renders(count, ob)
    assert views == renders and len(set(views.values())) == 3
    bpy.context.scene.frame_set(4)
    data = ob.data.copy()
    data.animation_data_clear()
    data.splinewright.resolution_u = 1
    data.splinewright.resolution_u = 5
    assert views[4] == (len(data.vertices) if ob.type == 'MESH' else sum(len(spline.points) for spline in data.splines))


def test_tolerance_angle_and_reach_are_keyed_too():
    ob = add(starters.teapot())
    ob.data.splinewright.mode = 'TOLERANCE'
    animate(ob.data, 'splinewright.tolerance', {1: 0.3, 7: 0.001})
    views, renders = in_views_and_renders(count, ob)
    assert views == renders and views[1] < views[4] < views[7]
    hyperbola = add_recipe('conic', weight=-2.0)
    animate(hyperbola.data, 'splinewright.reach', {1: 5.0, 7: 50.0})
    views, renders = in_views_and_renders(lambda ob, depsgraph: float(extent(ob, depsgraph).max()), hyperbola)
    assert views == renders and views[1] < views[4] < views[7]


@pytest.mark.parametrize('path, values', (('splinewright.resolution_u', {1: 2, 7: 8}),
                                          ('splinewright_parameters.helix_turns', {1: 1.0, 7: 4.0})))
def test_a_key_that_goes_on_the_same_writes_nothing(path, values, monkeypatch):
    ob = add_recipe('helix')
    animate(ob.data, path, values)
    bpy.context.scene.frame_set(7)
    writes = []
    finish = shape._finish
    monkeypatch.setattr(shape, '_finish', lambda *arguments: writes.append(1) or finish(*arguments))
    for frame in (8, 20, 9):
        bpy.context.scene.frame_set(frame)
    assert not writes
    bpy.context.scene.frame_set(4)
    assert len(writes) == 1


def drive(data, path, lever):
    driver = data.driver_add(path).driver
    variable = driver.variables.new()
    variable.targets[0].id, variable.targets[0].data_path = lever, 'location.x'
    driver.expression = variable.name


@pytest.mark.parametrize('make, path', (
    (lambda: add_recipe('circle'), 'splinewright_parameters.circle_radius'),
    (add_revolve, 'splinewright_parameters.revolve_sweep'), (lambda: add_recipe('helix'), 'splinewright.resolution_u')))
def test_a_driver_is_followed_when_what_drives_it_moves_in_views_and_renders(make, path):
    ob, lever = make(), in_scene("lever", None)
    drive(ob.data, path, lever)
    seen = []
    for x in (1.0, 2.0, 3.0):
        lever.location.x = x
        bpy.context.view_layer.update()
        require_exact(ob)
        assert ob.data.path_resolve(path) == pytest.approx(x)
        seen.append((count(ob, graph()), *extent(ob, graph()).round(4)))
    assert len(set(seen)) == 3
    animate(lever, 'location', {1: 1.0, 4: 2.0, 7: 3.0}, index=0)
    _, renders = in_views_and_renders(lambda ob, depsgraph: (count(ob, depsgraph), *extent(ob, depsgraph).round(4)), ob)
    assert list(renders.values()) == seen


def test_what_a_user_types_over_a_key_holds_until_the_frame_changes():
    ob = add_recipe('circle')
    animate(ob.data, 'splinewright_parameters.circle_radius', {1: 1.0, 11: 11.0})
    animate(ob.data, 'splinewright.resolution_u', {1: 2, 11: 12})
    bpy.context.scene.frame_set(3)
    for _ in range(2):
        ob.data.splinewright_parameters.circle_radius = 0.3
        assert recipes.parameters(ob.data)['radius'] == 0.3 and extent(ob, graph())[0] == pytest.approx(0.6)
        ob.data.splinewright.resolution_u = 30
        bpy.context.view_layer.update()
        require_exact(ob)
        assert recipes.parameters(ob.data)['radius'] == 0.3 and ob.data.splinewright.resolution_u == 30
        bpy.context.scene.frame_set(3)
        assert recipes.parameters(ob.data)['radius'] == 3.0 and ob.data.splinewright.resolution_u == 4
        require_exact(ob)


def test_a_key_of_which_nothing_comes_is_said_and_the_next_frame_is_right():
    ob = add_recipe('foci')             # neither an ellipse nor a hyperbola where the distance is that of the foci: 2
    animate(ob.data, 'splinewright_parameters.foci_distance', {1: 3.0, 5: 1.0})
    for frame in (1, 2, 3, 4, 3, 1):
        before = ob.data.splinewright.value
        bpy.context.scene.frame_set(frame)
        problem = problems.of(ob.data, problems.KEYED)
        if frame == 3:
            assert problem and all(word in drawn() for word in problem.split()) and ob.data.splinewright.value == before
        else:
            assert problem == "" and recipes.parameters(ob.data)['distance'] == pytest.approx(3.5 - frame / 2)
        require_exact(ob)


def test_keys_drivers_and_strips_of_a_mesh_stay_when_its_faces_change():
    ob = add_recipe('torus')
    animate(ob.data, 'splinewright_parameters.torus_radius', {1: 1.0, 11: 11.0})
    ob.data["own"] = 1.0
    ob.data.driver_add('["own"]')
    action = ob.data.animation_data.action
    ob.data.animation_data.nla_tracks.new().strips.new("strip", 1, action)
    ob.data.splinewright.resolution_u = 5
    animation = ob.data.animation_data
    assert animation.action == action and len(animation.drivers) == 1 and len(animation.nla_tracks[0].strips) == 1


def test_a_shape_that_cannot_be_written_says_so_and_the_others_are_right():
    first, second = add_recipe('torus'), add_recipe('torus')
    for ob in (first, second):
        animate(ob.data, 'splinewright_parameters.torus_radius', {1: 1.0, 11: 11.0})
        animate(ob.data, 'splinewright.resolution_u', {1: 2, 11: 12})
    bpy.context.scene.frame_set(1)
    first.data.vertices[0].co.z += 1
    bpy.context.scene.frame_set(5)
    assert "changed by hand" in problems.of(first.data, problems.KEYED) and problems.of(second.data, problems.KEYED) == ""
    assert recipes.parameters(first.data)['radius'] == 1.0 and recipes.parameters(second.data)['radius'] == 5.0
    require_exact(second)


def test_undo_and_redo_over_keys_are_right():
    ob = add_recipe('circle')
    animate(ob.data, 'splinewright_parameters.circle_radius', {1: 1.0, 11: 11.0})
    animate(ob.data, 'splinewright.resolution_u', {1: 2, 11: 12})
    name, scene = ob.name, bpy.context.scene
    for frame in (2, 5, 9):
        scene.frame_set(frame)
        bpy.ops.ed.undo_push(message=f"frame {frame}")

    def require(frame):
        ob = bpy.data.objects[name]
        assert bpy.context.scene.frame_current == frame
        assert recipes.parameters(ob.data)['radius'] == frame and ob.data.splinewright.resolution_u == frame + 1
        require_exact(ob)
        assert extent(ob, graph())[0] == pytest.approx(2 * frame)

    require(9)
    for step, frame in ((bpy.ops.ed.undo, 5), (bpy.ops.ed.undo, 2), (bpy.ops.ed.redo, 5), (bpy.ops.ed.redo, 9)):
        step()
        require(frame)


def test_keys_go_on_in_a_file_that_is_opened(tmp_path):
    ob = add_recipe('circle')
    name = ob.name
    animate(ob.data, 'splinewright_parameters.circle_radius', {1: 1.0, 11: 11.0})
    animate(ob.data, 'splinewright.resolution_u', {1: 2, 11: 12})
    bpy.context.scene.frame_set(4)
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "keyed.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "keyed.blend"))
    ob = bpy.data.objects[name]
    assert {frame: looks[0][0] for frame, looks in rendered(lambda depsgraph: extent(ob, depsgraph), FRAMES).items()} == {
        frame: pytest.approx(2 * frame) for frame in FRAMES}
    bpy.context.scene.frame_set(6)
    assert ob.data.splinewright.resolution_u == 7
    require_exact(ob)


def test_200_frames_and_many_keyed_shapes_crash_nothing():
    circles = [add_recipe('circle') for _ in range(12)]
    solids = [add_revolve(), add_recipe('torus')]
    for i, ob in enumerate(circles):
        animate(ob.data, 'splinewright_parameters.circle_radius', {1: 1.0 + i, 201: 201.0 + i})
    animate(solids[0].data, 'splinewright_parameters.revolve_sweep', {1: 0.1, 200: 6.0})
    animate(solids[1].data, 'splinewright_parameters.torus_tube_radius', {1: 0.1, 200: 0.9})
    animate(solids[1].data, 'splinewright.resolution_u', {1: 1, 200: 12})
    follower = follow_object(circles[3])
    for frame in range(1, 201):
        bpy.context.scene.frame_set(frame, subframe=0.25 * (frame % 4))
        if frame % 20 == 0:
            for ob in (*circles, *solids, follower):
                require_exact(ob)
            assert recipes.parameters(circles[11].data)['radius'] == 11 + frame + 0.25 * (frame % 4)
    assert follower.data.splinewright.value == circles[3].data.splinewright.value


def test_what_is_keyed_while_its_net_is_out_goes_on():
    ob = add_recipe('conic')
    animate(ob.data, 'splinewright_parameters.conic_weight', {1: 0.5, 11: 5.5})
    activate(ob)
    enter()
    bpy.context.scene.frame_set(3)
    assert recipes.parameters(ob.data)['weight'] == 1.5
    require_exact(ob)


@pytest.mark.parametrize('path', ('splinewright_points.numbers', 'splinewright_points.weight'))
def test_points_of_a_net_take_no_keys_and_no_drivers(path):
    add(starters.nurbs_curve(3, 6, 'CLAMPED'))
    held = enter()
    with pytest.raises(TypeError, match="not animatable"):
        held.data.keyframe_insert(path)
    with pytest.raises(TypeError):
        held.data.driver_add(path)
    assert not held.data.animation_data or not held.data.animation_data.drivers


def test_the_colors_of_seams_take_no_keys():
    with pytest.raises(TypeError, match="not animatable"):
        add(starters.teapot()).data.keyframe_insert('splinewright.show_seams')


def of_an_older_file(ob):
    """As recipes were when no property kept a number."""
    recipe = recipes.of(ob.data)
    with settings.quiet(ob.data):
        for parameter in recipe.parameters:
            parameters.of(ob.data).property_unset(parameters.name_of(recipe, parameter))
    assert not parameters.are_shown(ob.data, recipe)


@pytest.mark.parametrize('is_linked', (None, False, True), ids=('opened', 'appended', 'linked'))
def test_properties_show_the_recipes_of_older_files(is_linked, tmp_path):
    ob, path = add_recipe('helix', turns=5.5, radius=0.3), str(tmp_path / "older.blend")
    name, value = ob.name, ob.data.splinewright.value
    of_an_older_file(ob)
    bpy.ops.wm.save_as_mainfile(filepath=path)
    if is_linked is None:
        bpy.ops.wm.open_mainfile(filepath=path)
        ob = bpy.data.objects[name]
    else:
        bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
        with bpy.data.libraries.load(path, link=is_linked) as (_, wanted):
            wanted.objects = [name]
        ob = wanted.objects[0]
        bpy.context.scene.collection.objects.link(ob)
        bpy.context.view_layer.update()
    assert ob.data.splinewright_parameters.helix_turns == 5.5
    assert ob.data.splinewright_parameters.helix_radius == np.float32(0.3) and recipes.parameters(ob.data)['radius'] == 0.3
    assert ob.data.splinewright.value == value


def test_keys_of_older_files_go_on(tmp_path):
    ob, path = add_recipe('circle'), str(tmp_path / "older.blend")
    name = ob.name
    animate(ob.data, 'splinewright_parameters.circle_radius', {1: 1.0, 11: 11.0})
    of_an_older_file(ob)
    bpy.ops.wm.save_as_mainfile(filepath=path)
    bpy.ops.wm.open_mainfile(filepath=path)
    bpy.context.scene.frame_set(4)
    assert recipes.parameters(bpy.data.objects[name].data) == {'radius': 4.0, 'form': 'square', 'tolerance': 0.001}
    require_exact(bpy.data.objects[name])


def test_a_refused_number_is_shown_as_it_was():
    ob = add_recipe('helix')
    ob.data.splinewright_parameters.helix_turns = 0.0
    assert "turns" in ob.data.splinewright.problem and ob.data.splinewright_parameters.helix_turns == 3.0


def merging(ob, frames=10):
    """Keys by which u5, then u4, u3, u2 and u1, go onto u6, each in so many frames."""
    for step, number in enumerate((5, 4, 3, 2, 1)):
        animate(ob.data, 'splinewright_parameters.functions_knot_values_list',
                {1 + step * frames: float(number), 1 + (step + 1) * frames: 6.0}, index=5 + number)


def test_the_five_pictures_of_merging_knots_are_one_film():
    """Lecture rows 000.102 to 000.107."""
    ob = add_recipe('functions', degree=5, knot_values="0 " * 6 + "1 2 3 4 5 6" + " 7" * 6, axes=False)
    materials = list(ob.data.materials)
    merging(ob)
    names = [f"N_{{{i},5}}" for i in range(12)]
    functions = part('core.formulas.functions')

    def ends(ob, depsgraph):
        points = [[point.co[:3] for point in spline.points] for spline in ob.evaluated_get(depsgraph).data.splines]
        return [(round(min(x for x, *_ in each), 4), round(max(y for _, y, _ in each), 4)) for each in points]
    for frame in (1, 4, 11, 17, 21, 31, 36, 41, 51, 8):
        bpy.context.scene.frame_set(frame)
        inner = [6.0 if frame >= 1 + 10 * (6 - u) else u + (6 - u) * max(frame - 1 - 10 * (5 - u), 0) / 10 for u in (1, 2, 3, 4, 5)]
        knots = [0.0] * 6 + inner + [6.0] + [7.0] * 6
        assert np.allclose([float(word) for word in recipes.parameters(ob.data)['knot_values'].split()], knots, rtol=0, atol=1e-6)
        assert problems.of(ob.data, problems.KEYED) == ""
        definition = part('bridge.data.store').read(ob.data)
        assert [piece.name for piece in definition.pieces] == names
        assert [spline.material_index for spline in ob.data.splines] == [3 + i % (len(materials) - 3) for i in range(12)]
        require_exact(ob)
        exact = part('core.shape.definition').to_value(definition)
        whole = functions.of_knots(5, [float(word) for word in recipes.parameters(ob.data)['knot_values'].split()])
        assert all(np.isclose(curve.points[0, 0] * 3.5, whole.supports(i)[0][0], atol=1e-9) for i, curve in enumerate(exact))
    assert list(ob.data.materials) == materials
    views, renders = in_views_and_renders(ends, ob, (4, 20, 36))
    assert views == renders and len({tuple(each) for each in views.values()}) == 3


def test_numbers_of_a_text_are_fields_that_keep_what_was_typed():
    ob = add_recipe('functions', degree=1, knot_values="0 0.3333333333333333, 2 3 1e2", axes=False)
    group = ob.data.splinewright_parameters
    assert np.allclose(group.functions_knot_values_list[:6], (0, 1 / 3, 2, 3, 100, 0))
    group.functions_knot_values_list[3] = 2.1
    bpy.context.view_layer.update()
    assert recipes.parameters(ob.data)['knot_values'] == group.functions_knot_values == "0 0.3333333333333333 2 2.1 1e2"
    require_exact(ob)
    group.functions_knot_values_list[3] = 1.5
    assert "must not decrease" in problems.of(ob.data, problems.SETTING)
    assert group.functions_knot_values_list[3] == pytest.approx(2.1) and group.functions_knot_values.split()[3] == "2.1"
    group.functions_knot_values_list[20] = 5.0
    assert group.functions_knot_values.split() == ["0", "0.3333333333333333", "2", "2.1", "1e2"]
    group.functions_knot_values = "0 1 2"
    assert tuple(group.functions_knot_values_list[:3]) == (0.0, 1.0, 2.0)


def test_a_knot_has_a_driver():
    ob, lever = add_recipe('functions', degree=1, knot_values="0 1 2 3", axes=False), in_scene("lever", None)
    driver = ob.data.driver_add('splinewright_parameters.functions_knot_values_list', 2).driver
    variable = driver.variables.new()
    variable.targets[0].id, variable.targets[0].data_path = lever, 'location.x'
    driver.expression = variable.name
    for x in (1.25, 2.5, 3.0):
        lever.location.x = x
        bpy.context.view_layer.update()
        assert recipes.parameters(ob.data)['knot_values'].split()[2] == f"{x:g}"
        require_exact(ob)
    lever.location.x = 4.0
    bpy.context.view_layer.update()
    assert "must not decrease" in problems.of(ob.data, problems.KEYED)
