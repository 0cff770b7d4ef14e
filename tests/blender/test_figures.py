"""Figures: what a view shows is in the file, as paths that are read again."""

from types import SimpleNamespace
from xml.etree import ElementTree

import bpy
import numpy as np
import pytest
from mathutils import Matrix

from natives import native_curve
from shapes import VALUES, add, enter, leave, op
from support import part, scene_state, splinecore as sc

drawn, outlines, page, operator, picking, reports = (part(name) for name in (
    'bridge.figures.drawn', 'bridge.figures.outlines', 'core.figures.page', 'ui.operators.figure', 'ui.picking', 'ui.operators.reports'))
NAMESPACE = "{http://www.w3.org/2000/svg}"
CUBIC = sc.BezierCurve([(-1, -1, 0), (-0.5, 1, 0), (0.5, -1, 0), (1, 1, 0)])
TOP = page.around(np.array([(-2.0, -1.5, 0), (2, 1.5, 0)]), np.eye(3), 160.0, 120.0, 0.0)


def view(nets=(), named=()):
    bpy.context.view_layer.update()
    return drawn.View(bpy.context.scene, bpy.context.view_layer, bpy.context.evaluated_depsgraph_get(), None, tuple(nets), tuple(named))


def drawing(nets=(), named=(), seen=TOP, **wanted):
    return drawn.figure(view(nets, named), seen, drawn.Wanted(**wanted))


def strokes(made, name):
    (group,) = [group for group in made.figure.groups if group.name == name]
    return group.items


def export(path, **settings):
    assert op(bpy.ops.splinewright.export_figure, filepath=str(path), **settings) == {'FINISHED'}
    return ElementTree.parse(path).getroot() if path.suffix == ".svg" else path.read_bytes()


def elements(root, tag):
    return list(root.iter(NAMESPACE + tag))


def real_view():
    """(region, its RegionView3D) of the 3D view of the window, as it comes with Blender, in perspective."""
    return operator._view(bpy.context)[2:]


@pytest.fixture
def from_above(monkeypatch):
    """The same view, eight units wide, from above: without a window Blender does not turn it. (region, what stands for its RegionView3D)."""
    window, area, region, _ = operator._view(bpy.context)
    clip = Matrix.Diagonal((0.25, 0.25 * region.width / region.height, -0.01, 1.0))
    seen = SimpleNamespace(perspective_matrix=clip, view_perspective='ORTHO')
    monkeypatch.setattr(operator, '_view', lambda context: (window, area, region, seen))
    return region, seen


def test_a_curve_in_the_view_is_one_cubic_with_its_projected_points(tmp_path, from_above):
    region, seen = from_above
    add(CUBIC, "wave")
    root = export(tmp_path / "wave.svg", width=200.0)
    (element,) = elements(root, 'path')
    assert root.get('width') == "200mm" and root.find(f".//{NAMESPACE}g/{NAMESPACE}title") is not None
    numbers = [float(number) for number in element.get('d').replace("M", " ").replace("C", " ").replace(",", " ").split()]
    height = 200.0 * region.height / region.width
    wanted = picking.on_screen(region, seen, Matrix(), np.array(CUBIC.points)) * (200 / region.width) * (1, -1) + (0, height)
    assert np.allclose(np.reshape(numbers, (4, 2)), wanted, atol=1e-6)


def test_an_object_lies_where_its_matrix_puts_it():
    ob = add(CUBIC, "wave")
    ob.matrix_world = Matrix.Translation((0.5, 0.25, 0)) @ Matrix.Diagonal((0.5, 0.5, 1, 1))
    (stroke,) = strokes(drawing(), "wave")
    points = np.vstack([stroke.paths[0].start, *stroke.paths[0].steps])
    assert np.allclose(points, page.places(np.array(CUBIC.points) * (0.5, 0.5, 1) + (0.5, 0.25, 0), TOP), atol=1e-9)


def test_blenders_own_curves_are_drawn_as_exactly():
    ob = native_curve('primitive_bezier_circle_add')
    (stroke,) = strokes(drawing(), ob.name)
    (path,) = stroke.paths
    assert path.closed and [step.shape for step in path.steps] == [(3, 2)] * 4
    point = ob.data.splines[0].bezier_points[0]
    assert np.allclose(path.start, page.places(np.array([point.co]), TOP)[0])
    assert np.allclose(path.steps[0][0], page.places(np.array([point.handle_right]), TOP)[0])


def test_a_text_object_is_drawn_by_the_outlines_of_its_letters():
    data = bpy.data.curves.new("text", 'FONT')
    data.body = "oil"
    bpy.context.scene.collection.objects.link(bpy.data.objects.new("text", data))
    (stroke,) = strokes(drawing(), "text")
    assert len(stroke.paths) == 5 and all(path.closed for path in stroke.paths), "o has two, i has two, l has one"


def test_a_patch_has_its_borders_and_isocurves():
    add(sc.BezierPatch([[(x, y, 0) for y in (-1, 1)] for x in (-1, 1)]), "sheet")
    thin, thick = strokes(drawing(count=2, behind='SHOW'), "sheet")
    assert (len(thin.paths), thin.width) == (4, 0.15) and (sum(len(path.steps) for path in thick.paths), thick.width) == (4, 0.5)


def hemisphere():
    add(sc.BezierCurve([(-1.4, 0.1, -1), (1.4, 0.1, -1)]), "behind")
    add(sc.BezierPatch([[(x, y, 0) for y in (-1, 1)] for x in (-1, 1)]), "sheet")


@pytest.mark.parametrize('behind, dashes, whole', (('OMIT', 0, 2), ('DASH', 1, 2), ('SHOW', 0, 1)))
def test_what_lies_behind_a_surface_is_left_out_or_dashed(behind, dashes, whole):
    hemisphere()
    items = strokes(drawing(behind=behind), "behind")
    assert sum(len(item.paths) for item in items if item.dashed) == dashes
    solid = [path for item in items if not item.dashed for path in item.paths]
    assert len(solid) == whole
    if whole == 2:
        assert solid[0].end[0] == pytest.approx(80 - 40, abs=1.0) and solid[1].start[0] == pytest.approx(80 + 40, abs=1.0)


def test_meshes_hide_and_are_not_drawn():
    bpy.ops.mesh.primitive_plane_add(size=2)
    bpy.context.object.name = "plane"
    add(sc.BezierCurve([(-1.4, 0.1, -1), (1.4, 0.1, -1)]), "behind")
    made = drawing()
    assert len(strokes(made, "behind")[0].paths) == 2
    assert {group.name for group in made.figure.groups} == {"behind"} and "mesh" in made.left_out["plane"]


@pytest.mark.parametrize('offset', (0.0, 3e4, -1e6))
def test_a_ray_passes_any_number_of_open_meshes_and_ends_at_one_that_hides(offset):
    """Far from the origin Blender's places are coarse: a ray must not meet one face for ever, nor pass one unseen."""
    size, middle = max(1.0, abs(offset) / 1e4), np.array([offset, offset, 0.0])
    for name, count, shift in (("open", 150, 0.0), ("plane", 1, 160.0 * size)):
        corners = np.array([(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)], float) * size
        places = np.concatenate([corners + (0, 0, shift + i * size) for i in range(count)]) + middle
        mesh = bpy.data.meshes.new(name)
        mesh.from_pydata(places.tolist(), [], [tuple(range(4 * i, 4 * i + 4)) for i in range(count)])
        bpy.context.scene.collection.objects.link(bpy.data.objects.new(name, mesh))
    bpy.data.objects["open"].display_type = 'WIRE'
    add(sc.BezierCurve(np.array([(-1.4, 0.1, -1), (1.4, 0.1, -1)]) * size + middle), "behind")
    seen = page.around(np.array([(-2.0, -1.5, 0), (2, 1.5, 0)]) * size + middle, np.eye(3), 160.0, 120.0, 0.0)
    assert len(strokes(drawing(seen=seen), "behind")[0].paths) == 2
    bpy.data.objects["plane"].display_type = 'WIRE'
    assert len(strokes(drawing(seen=seen), "behind")[0].paths) == 1


def test_a_front_and_a_back_of_a_sphere():
    bpy.ops.splinewright.add_sphere()
    front = sum(len(path.steps) for item in strokes(drawing(), bpy.context.object.name) for path in item.paths)
    whole = sum(len(path.steps) for item in strokes(drawing(behind='SHOW'), bpy.context.object.name) for path in item.paths)
    assert 0.3 * whole < front < 0.85 * whole


def test_a_net_that_is_out_is_drawn(tmp_path, from_above):
    add(CUBIC, "wave")
    enter()
    root = export(tmp_path / "net.svg")
    leave()
    assert len(elements(root, 'circle')) == 4
    net = elements(root, 'path')[1:]
    assert sum(element.get('d').count("L") for element in net) == 3 and all("C" not in element.get('d') for element in net)


def test_the_net_and_names_of_overlays_are_drawn(tmp_path, from_above):
    add(sc.BezierCurve(CUBIC.points, [1, 2, 1, 1]), "wave")
    chosen = bpy.context.scene.splinewright_sights
    chosen.polygon = chosen.labels = True
    root = export(tmp_path / "named.svg")
    assert len(elements(root, 'circle')) == 4
    texts = [element.get('aria-label') for element in elements(root, 'path') if element.get('aria-label')]
    assert texts == ["P0", "P1  w = 2", "P2", "P3"]
    letters = [element.get('d').count("Z") for element in elements(root, 'path') if element.get('aria-label')]
    assert letters[2] >= 2 and letters[1] > letters[2], "each letter has an outline at least"
    assert not elements(root, 'text')


def test_axes_and_their_numbers_are_drawn(tmp_path, from_above):
    add(CUBIC, "wave")
    plain = export(tmp_path / "plain.svg")
    bpy.context.scene.splinewright_sights.axes = True
    root = export(tmp_path / "axes.svg")
    assert len(elements(root, 'path')) > len(elements(plain, 'path'))
    numbers = {element.get('aria-label') for element in elements(root, 'path')} - {None}
    values = sorted(float(number.replace("−", "-")) for number in numbers)
    assert values[0] == -1.0 and values[-1] == 1.0 and len(values) > 4


def test_the_net_of_a_patch_has_both_ways():
    add(sc.BezierPatch(np.stack(np.meshgrid(range(3), range(4), [0], indexing='ij'), -1)[:, :, 0] - (1.0, 1.5, 0)), "sheet")
    _, net = (group for group in drawing(nets=[bpy.data.objects["sheet"]]).figure.groups if group.name == "sheet")
    items = net.items
    lines = [sum(len(path.steps) for path in item.paths) for item in items if isinstance(item, drawn.Stroke)]
    assert sorted(lines) == [2 * 4, 3 * 3] and sum(isinstance(item, drawn.Dot) for item in items) == 12


@pytest.mark.parametrize('text', ("Aé", "ąęłż", "Жбщъ", "₀²·½…"))
def test_letters_of_all_languages_have_outlines_and_leave_nothing(text):
    before, fonts = scene_state(), set(bpy.data.fonts)
    letters = outlines.letters(text + " ")
    assert scene_state() == before and set(bpy.data.fonts) == fonts
    for character in text:
        letter = letters(character)
        corners = np.vstack([np.vstack([path.start, *path.steps]) for path in letter.outlines])
        assert 0.1 < letter.advance < 1.5 and letter.outlines
        assert -0.2 < corners[:, 0].min() and corners[:, 0].max() < letter.advance + 0.2, character
        assert -0.5 < corners[:, 1].min() and corners[:, 1].max() < 1.2
    assert 0.1 < letters(" ").advance < 0.6 and not letters(" ").outlines


def test_letters_that_look_otherwise_are_otherwise():
    letters = outlines.letters("ĄAШ")
    counts = [len(letters(character).outlines) for character in "ĄAШ"]
    assert counts[1] == 2 and counts[2] == 1 and letters("Ш").advance > letters("A").advance


def test_the_view_in_perspective_lies_on_what_the_window_shows(tmp_path):
    region, seen = real_view()
    curve = sc.conics.circle((0, 0, 0), 1.0)
    add(curve, "ring")
    root = export(tmp_path / "ring.svg", width=160.0, behind='SHOW')
    (element,) = elements(root, 'path')
    ends = [tuple(map(float, pair.split(","))) for pair in element.get('d').replace("M", "").replace("C", "").replace("Z", "").split()]
    wanted = picking.on_screen(region, seen, Matrix(), curve.evaluate(np.linspace(*curve.domain, 5000)))
    wanted = wanted * (160 / region.width) * (1, -1) + (0, 160.0 * region.height / region.width)
    on_curve = np.array(ends)[::3]
    assert max(np.linalg.norm(wanted - end, axis=1).min() for end in on_curve) < 0.02


def test_a_view_without_anything_to_draw_is_refused(tmp_path, from_above):
    with pytest.raises(RuntimeError, match="Nothing to draw"):
        op(bpy.ops.splinewright.export_figure, filepath=str(tmp_path / "none.svg"))
    assert not list(tmp_path.iterdir())


def test_a_name_without_an_ending_gets_that_of_the_format(tmp_path, from_above):
    add(CUBIC, "wave")
    assert op(bpy.ops.splinewright.export_figure, filepath=str(tmp_path / "wave")) == {'FINISHED'}
    assert [path.name for path in tmp_path.iterdir()] == ["wave.svg"]
    with pytest.raises(RuntimeError, match="Name a file"):
        op(bpy.ops.splinewright.export_figure, filepath=str(tmp_path))


def test_a_pdf_is_written_or_a_sentence_says_what_it_needs(tmp_path, from_above):
    add(CUBIC, "wave")
    path = tmp_path / "wave.pdf"
    try:
        import reportlab                # noqa: F401
    except ImportError:
        with pytest.raises(RuntimeError, match="python3-reportlab"):
            op(bpy.ops.splinewright.export_figure, filepath=str(path))
        assert not path.exists()
    else:
        assert export(path).startswith(b"%PDF")


def test_what_is_not_drawn_is_reported(monkeypatch, tmp_path, from_above):
    ob = add(CUBIC, "wave")
    ob.modifiers.new("Bend", 'SIMPLE_DEFORM')
    said = []
    monkeypatch.setattr(reports, 'finished', lambda operator, report: said.append(reports.in_words(report)) or {'FINISHED'})
    export(tmp_path / "wave.svg")
    assert "wave: left out: the modifier Bend" in said[0] and "wave.svg" in said[0]


def test_pictures_keep_the_colors_of_their_functions():
    add(VALUES['nurbs']())
    bpy.ops.splinewright.add_basis('EXEC_DEFAULT', True)
    made = drawing(named=[bpy.context.object], seen=page.around(np.array([(-5.0, -5, 0), (5, 5, 0)]), np.eye(3), 160.0, 120.0, 0.0))
    colors = {item.color for item in strokes(made, bpy.context.object.name)}
    assert len(colors) >= 6
    (names,) = [group for group in made.figure.groups if group.name.startswith("Names")]
    assert {item.color for item in names.items} & colors
