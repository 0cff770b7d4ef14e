"""Products of functions as surfaces, discs and hulls of patches, and letters that render: colors, labels, live with knots and points."""

import bpy
import numpy as np
import pytest

from shapes import VALUES, activate, add, made, pieces_named, require_exact
from support import part, splinecore as sc

labels, piece_materials, store = (part(name) for name in (
    'core.formulas.labels', 'bridge.shape.piece_materials', 'bridge.data.store'))
SURFACES = ('bezier patch', 'hermite patch', 'nurbs patch', 'patch with a point at infinity', 'teapot', 'mixed set')


def texts_of(ob):
    return ["".join(text for text, _ in label.runs) for label in labels.of(store.read(ob.data))]


def slots_of(ob):
    """The material indices of the faces of each patch, one after the other."""
    mesh = ob.data
    patches, indices = (np.empty(len(mesh.polygons), np.int32) for _ in range(2))
    mesh.attributes["patch"].data.foreach_get('value', patches)
    mesh.polygons.foreach_get('material_index', indices)
    return [sorted(set(indices[patches == number].tolist())) for number in range(patches.max() + 1)]


def bilinear():
    return sc.NurbsPatch((1, 1), ([0, 0, 1, 2, 2], [0, 0, 2, 2]), np.random.default_rng(5).uniform(-1, 1, (3, 2, 3)))


@pytest.mark.parametrize('show', ('all', 'chosen', 'sum'))
@pytest.mark.parametrize('name', SURFACES)
def test_products_are_made_of_every_kind_of_surface(name, show):
    ob = made('basis_products', add(VALUES[name](), "surface"), show=show, index=1, index_v=0)
    assert ob.type == 'MESH' and all(pieces_named(ob)) and set(sum(slots_of(ob), [])) == set(range(len(set(pieces_named(ob)))))
    top = max(vertex.co.z for vertex in ob.data.vertices)
    assert top == pytest.approx(1.0, abs=1e-6) if show == 'sum' else top > 0
    require_exact(ob)


def test_each_product_has_its_color_and_label():
    ob = made('products', degree=1, knot_values="0 1 2 3", degree_v=1, knot_values_v="0 1 2", show='all', width=3.0, depth=2.0)
    assert pieces_named(ob) == ["N_{0,1} N_{0,1}", "N_{1,1} N_{0,1}"] and slots_of(ob) == [[0], [1]]
    assert texts_of(ob) == ["N0,1 N0,1", "N1,1 N0,1"]
    colors = piece_materials.colors_of(ob.data)
    assert colors[pieces_named(ob)[0]] == pytest.approx((0.0, 0.45, 0.70, 1.0), abs=1e-6) and len(set(colors.values())) == 2
    assert all(len(material.node_tree.nodes) == 2 for material in ob.data.materials)
    require_exact(ob)


def test_they_follow_the_knots_of_the_patch():
    source = add(bilinear(), "patch")
    ob = made('basis_products', source, show='all')
    assert len(pieces_named(ob)) == 6
    mine = bpy.data.materials.new("mine")
    ob.data.materials[1] = mine
    source.data.splinewright.value = bilinear().insert_knot('v', 1.0)
    bpy.context.view_layer.update()
    assert len(pieces_named(ob)) == 9 and slots_of(ob) == [[number] for number in range(9)] and ob.data.materials[1] == mine
    moved = bilinear()
    source.data.splinewright.value = sc.NurbsPatch(moved.degree, ([0, 0, 0.25, 2, 2], [0, 0, 2, 2]), moved.points)
    bpy.context.view_layer.update()
    assert len(pieces_named(ob)) == 6
    (top,) = {round(label.point[0], 3) for label in labels.of(store.read(ob.data)) if label.below == "1,1"}
    assert top == 0.125
    require_exact(ob)


def test_they_follow_while_a_knot_is_moved_and_while_it_is_typed():
    source = add(bilinear(), "patch")
    ob = made('basis_products', source, show='chosen', index=1, index_v=1)
    activate(source)
    assert bpy.ops.splinewright.move_knot('EXEC_DEFAULT', True, piece=1, knot=3, parameter=0.5) == {'FINISHED'}
    bpy.context.view_layer.update()
    assert np.unique(ob.data.splinewright.value.to_nurbs().knots[0] if not isinstance(ob.data.splinewright.value, sc.PatchSet)
                     else ob.data.splinewright.value[0].knots[0]).tolist() == [0.0, 0.5, 2.0]
    typed = made('products', degree=1, knot_values="0 1 3", degree_v=1, knot_values_v="0 1 2", width=3.0)
    typed.data.splinewright_parameters.products_knot_values_list[1] = 2.0
    bpy.context.view_layer.update()
    assert [label.point[0] for label in labels.of(store.read(typed.data))] == pytest.approx([2.0], abs=0.05)


def test_what_a_user_gave_faces_stays_while_names_do(tmp_path):
    ob = made('products', degree=1, knot_values="0 1 2 3", degree_v=1, knot_values_v="0 1 2", show='all')
    for polygon in ob.data.polygons:
        polygon.material_index = 1
    ob.data.splinewright_parameters.products_height = 2.0
    bpy.context.view_layer.update()
    assert slots_of(ob) == [[1], [1]]
    ob.data.splinewright.resolution_u = 5
    bpy.context.view_layer.update()
    assert slots_of(ob) == [[1], [1]]
    name = ob.name
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "products.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "products.blend"))
    assert slots_of(bpy.data.objects[name]) == [[1], [1]] and len(pieces_named(bpy.data.objects[name])) == 2


def test_zero_functions_are_told_and_what_cannot_be_is_refused(capfd):
    made('products', degree=1, knot_values="0 1 1 1 2", degree_v=1, knot_values_v="0 1 2", show='all')
    assert "zero everywhere: N_{1,1}" in capfd.readouterr().out
    for settings, said in (({'show': 'chosen', 'index': 8}, "no function 8 along u"), ({'knot_values': "0 x"}, "is not a number")):
        with pytest.raises(RuntimeError, match=said):
            made('products', **{'degree': 1, 'knot_values': "0 1 2", 'degree_v': 1, 'knot_values_v': "0 1 2", 'show': 'all', **settings})


@pytest.mark.parametrize('name', SURFACES)
def test_discs_of_every_kind_of_surface_follow_it(name):
    source = add(VALUES[name](), "surface")
    ob = made('discs', source, position=0.3, position_v=0.6, radius=0.5, piece=1)
    assert pieces_named(ob)[-1].startswith("mark S  u = ") and len(ob.data.materials) > 3
    require_exact(ob)


def test_discs_of_a_patch_have_the_colors_of_the_products_and_take_keys():
    flat = np.dstack(np.meshgrid([0, 1, 2.0], [0, 1.0], [0.0], indexing='ij')).reshape(3, 2, 3)
    source = add(sc.BezierPatch(flat), "patch")
    ob, hills = made('discs', source, position=0.5, position_v=0.25, radius=1.0), made('basis_products', source, show='all')
    assert pieces_named(ob)[:-1] == pieces_named(hills)
    discs, products = piece_materials.colors_of(ob.data), piece_materials.colors_of(hills.data)
    assert all(discs[name] == products[name] for name in pieces_named(hills))
    ob.data.splinewright_parameters.discs_position_v = 0.5
    bpy.context.view_layer.update()
    radii = [np.ptp(value.evaluate(np.linspace(*value.domain, 5))[:, 0]) / 2 for value in ob.data.splinewright.value[:6]]
    assert np.allclose(np.square(radii), [1 / 8, 1 / 8, 1 / 4, 1 / 4, 1 / 8, 1 / 8], atol=1e-6)


@pytest.mark.parametrize('name', SURFACES)
def test_hulls_of_surfaces_have_intersections(name):
    source = add(VALUES[name](), "surface")
    for of in ('spans', 'whole'):
        ob = made('hulls', source, hulls_of=of, show='both')
        assert {each.partition(" ")[0] for each in pieces_named(ob)} <= {"hull", "intersection"}
        require_exact(ob)
    if name == 'teapot':
        assert "intersection" in pieces_named(ob)


@pytest.mark.parametrize('name', VALUES)
def test_labels_are_made_of_every_kind_of_shape(name):
    ob = made('labels', add(VALUES[name](), "shape"), height=0.1)
    assert ob.type == 'CURVE' and ob.data.bevel_depth > 0 and all(each.startswith("text ") for each in pieces_named(ob))
    require_exact(ob)


def test_letters_have_the_colors_of_what_they_name_and_follow():
    graphs = made('functions', family='bspline', degree=1, knot_values="0 1 2 3", show='functions', axes=True)
    ob = made('labels', graphs, height=0.1, plane='xy')
    letters, lines = piece_materials.colors_of(ob.data), piece_materials.colors_of(graphs.data)
    assert {name.removeprefix("text ") for name in letters} == {"N_{0,1}", "N_{1,1}", "tick 0", "tick 1", "tick 2", "tick 3"}
    assert all(color == lines[name.removeprefix("text ")] for name, color in letters.items())
    graphs.data.splinewright_parameters.functions_knot_values = "0 1 2 3 4"
    bpy.context.view_layer.update()
    assert "text N_{2,1}" in pieces_named(ob) and "text tick 4" in pieces_named(ob)
    assert labels.of(store.read(ob.data)) == [], "letters have no labels"
    axes = made('axes', x_from=0.0, x_to=2.0, y_from=0.0, y_to=1.0, step=1.0, spatial=False, grid=True)
    assert {"text tick 1", "text tick 2"} <= set(pieces_named(made('labels', axes)))


def test_letters_are_thick_lines_that_render():
    axes = made('axes', x_from=0.0, x_to=1.0, y_from=0.0, y_to=1.0, step=1.0, spatial=False, grid=False)
    ob = made('labels', axes, height=0.4, plane='xy')
    evaluated = ob.evaluated_get(bpy.context.evaluated_depsgraph_get())
    mesh = evaluated.to_mesh()
    assert len(mesh.polygons) > 50 and not ob.hide_render
    evaluated.to_mesh_clear()
