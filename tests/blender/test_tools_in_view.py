"""Tools while a net is out: weights in the hand, the toolbar, the pie and the hints. The gestures are tried in a window."""

import re
from pathlib import Path
from types import SimpleNamespace

import bpy
import numpy as np
import pytest

import patches
from layouts import Layout
from shapes import VALUES, add, enter, leave, numbers_of, op, require_exact, select
from support import part, splinecore as sc

live, typed_number, weight_here, weighing = (part(name) for name in (
    'bridge.net.live', 'core.base.typed_number', 'ui.operators.weight_here', 'bridge.net.weighing'))
WEIGHTED = ('rational cubic', 'nurbs', 'periodic', 'nurbs patch', 'bezier patch', 'teapot')


def value():
    return bpy.data.objects["shape"].data.splinewright.value


def pool():
    return part('bridge.data.store').read(bpy.data.objects["shape"].data).pool


def in_hand(name, count=1):
    """The net of a shape, its first points with weights selected, and these."""
    add(VALUES[name]())
    held = enter()
    chosen = np.flatnonzero(numbers_of(held).weighted)[:count].tolist()
    select(held, *chosen)
    return held, numbers_of(held).rows[chosen]


@pytest.mark.parametrize('count', (1, 2))
@pytest.mark.parametrize('name', WEIGHTED)
def test_weights_are_set_as_typed_and_undo_is_one_step(name, count):
    held, rows = in_hand(name, count)
    before, old = value(), pool()
    assert op(bpy.ops.splinewright.weight_here, weight=0.7) == {'FINISHED'}
    now = pool()
    assert (now[rows, 3] == 0.7).all(), "as it was typed, not as float32 has it"
    assert np.array_equal(np.delete(now[:, 3], rows), np.delete(old[:, 3], rows)) and np.array_equal(now[:, :3], old[:, :3])
    require_exact(bpy.data.objects["shape"])
    bpy.ops.ed.undo()
    assert value() == before and bpy.context.mode.startswith('EDIT')
    bpy.ops.ed.redo()
    assert (pool()[rows, 3] == 0.7).all()


@pytest.mark.parametrize('name', WEIGHTED)
def test_weights_are_multiplied_each_for_itself(name):
    held, rows = in_hand(name, 3)
    before = pool()[rows, 3]
    assert op(bpy.ops.splinewright.weight_here, kind='SCALE', factor=1.25) == {'FINISHED'}
    assert np.array_equal(pool()[rows, 3], before * 1.25)


@pytest.mark.parametrize('settings', ({'weight': 0.0}, {'kind': 'SCALE', 'factor': 0.0}))
@pytest.mark.parametrize('name', ('rational cubic', 'nurbs patch'))
def test_a_weight_of_zero_is_refused_and_nothing_changed(name, settings):
    held, _ = in_hand(name)
    before = value()
    with pytest.raises(RuntimeError, match="Move to Infinity"):
        op(bpy.ops.splinewright.weight_here, **settings)
    assert value() == before and live.problem(held) == ""
    # In the panel of the last operator, where another number may do, it stays.
    assert op(bpy.ops.splinewright.weight_here, by_hand=True, **settings) == {'FINISHED'}
    assert value() == before


def test_a_negative_weight_is_taken_by_a_curve():
    held, rows = in_hand('rational cubic')
    assert op(bpy.ops.splinewright.weight_here, weight=-0.5) == {'FINISHED'}
    assert pool()[rows, 3] == -0.5 and live.problem(held) == ""


def test_what_a_patch_does_not_take_is_refused_and_its_weights_are_as_they_were():
    add(sc.BezierPatch([[(0, 0, 0), (1, 0, 0)], [(0, 1, 0), (1, 1, 1)]]))
    held = enter()
    select(held, 0)
    before, weights = value(), weighing.of_selected(held)[1]
    with pytest.raises(RuntimeError, match="infinity"):
        op(bpy.ops.splinewright.weight_here, weight=-3.0)           # the middle goes there
    assert value() == before and live.problem(held) == ""
    assert np.array_equal(weighing.of_selected(held)[1], weights)
    require_exact(bpy.data.objects["shape"])


def test_what_has_no_weights_is_refused_in_words():
    operator = bpy.ops.splinewright.weight_here
    assert not operator.poll()
    bpy.ops.mesh.primitive_cube_add()
    bpy.ops.object.mode_set(mode='EDIT')
    with pytest.raises(RuntimeError, match="net of a Splinewright shape"):
        operator()
    bpy.ops.object.mode_set(mode='OBJECT')
    add(VALUES['hermite']())
    held = enter()
    select(held, 0, 1)
    with pytest.raises(RuntimeError, match="tangents, directions at infinity and points of cubic chains"):
        op(operator)
    select(held)
    with pytest.raises(RuntimeError, match="select points of the net"):
        op(operator)


def test_a_net_of_points_of_a_recipe_has_no_weights():
    op(bpy.ops.splinewright.add_catmull_rom)
    enter()
    with pytest.raises(RuntimeError, match="Apply Construction"):
        op(bpy.ops.splinewright.weight_here)


def test_what_a_drag_passes_leaves_nothing_behind():
    """Hundreds of moves of the mouse would slow down every later one."""
    held, rows = in_hand('nurbs', 2)
    before = value()
    chosen = [(held.name, *weighing.of_selected(held))]
    typed = len(part('bridge.cage.net_object').typed(held.data))
    for factor in np.linspace(0.5, 3, 50):
        weight_here._put(chosen, lambda weights: weights * factor, is_passing=True)
        assert np.allclose(pool()[rows, 3], chosen[0][2] * factor, rtol=1e-7)
    weight_here._put_back(chosen)
    assert value() == before and len(part('bridge.cage.net_object').typed(held.data)) == typed


@pytest.mark.parametrize('base', (1.0, 0.3, -2.0, 1e-3))
def test_the_mouse_never_makes_a_weight_zero_or_turns_its_sign(base):
    for doublings in (-1e9, -3, -0.2, 0, 0.1, 2, 1e9):
        for step in (0, 0.1, 0.01):
            number = weight_here.moved(base, doublings, step)
            assert number * base > 0 and np.isfinite(number) and float(f"{number:.4g}") == number
            assert not step or abs(round(number / step) - number / step) < 1e-6 * max(abs(number / step), 1)
    assert weight_here.moved(1.0, 1.0) == 2.0 and weight_here.moved(0.7, 0.1, 0.1) == 0.8


def test_numbers_are_typed_as_in_blenders_own_gestures():
    def after(text):
        typed = typed_number.Typed()
        for character in text:
            typed = typed_number.shortened(typed) if character == '<' else typed_number.after(typed, character) or typed
        return typed
    for text, number in (("2", 2.0), ("0.5", 0.5), (".5", 0.5), ("0,25", 0.25), ("1.2.3", 1.23), ("1x2", 12.0), ("3-", -3.0),
                         ("-4", -4.0), ("--4", 4.0), ("12<", 1.0), ("", None), ("-", None), (".", None), ("7<<", None)):
        assert after(text).number == number, text
    assert str(after("1-<")) == "" or str(after("1-<")) == "-"
    assert str(after("-<")) == "", "nothing is typed any more"


def test_a_point_is_found_where_it_is_seen():
    picking = part('ui.picking')
    held, _ = in_hand('nurbs')
    region = SimpleNamespace(width=200, height=200)
    view = SimpleNamespace(perspective_matrix=np.diag([0.25, 0.25, 0.25, 1.0]))
    points = live.session(held.data).points
    for vertex in range(len(points)):
        pixel = 100 + 25 * points[vertex, :2]
        found, nearest = picking.point_at(region, view, pixel + (0.01, 0), [held])
        assert found == held and np.allclose(points[nearest, :2], points[vertex, :2], atol=0.02)
    assert picking.point_at(region, view, (1000, 1000), [held]) is None
    assert picking.point_at(region, view, (100, 100), []) is None
    pixel = 100 + 25 * points[0, :2]
    assert picking.point_at(region, view, pixel, [held], lambda net: net.rows > 0) != (held, 0)
    assert picking.point_at(region, view, pixel + (0, 7.9), [held], within=0.01) is None


@pytest.fixture
def toolbar():
    """The toolbar with our tools, which it has not in background until there are keymaps."""
    found = part('ui.toolbar')
    is_there = bool(found._sections)
    if not is_there:
        bpy.context.window_manager.keyconfigs.update()
        found.register()
    assert found._sections
    yield found
    if not is_there:
        found.unregister()


def listed(mode):
    """Names of the tools that Blender shows in a mode."""
    from bl_ui.space_toolsystem_toolbar import VIEW3D_PT_tools_active as panel
    found = panel._tools_flatten(list(panel.tools_from_context(bpy.context, mode)))
    return [item.idname for item in found if item is not None]


TOOLS = part('ui.tool_table').TOOLS
OURS = {mode: [tool.idname for tool in TOOLS.values() if mode in tool.modes] for mode in ('OBJECT', 'EDIT_MESH', 'EDIT_CURVE')}
DRAWING = [tool.idname for tool in TOOLS.values() if tool.is_always]


def ours(mode):
    return [name for name in listed(mode) if name.startswith("splinewright.")]


def test_tools_are_there_for_nets_and_shapes_and_only_those_that_draw_without_them(toolbar):
    assert ours('OBJECT') == DRAWING == OURS['OBJECT'][:3] and not ours('EDIT_MESH') and not ours('EDIT_CURVE')
    add(VALUES['nurbs patch']())
    assert ours('OBJECT') == OURS['OBJECT']
    enter()
    assert ours('EDIT_MESH') == OURS['EDIT_MESH'] and "splinewright.radius" not in OURS['EDIT_MESH']
    leave()
    add(VALUES['nurbs']())
    enter()
    assert ours('EDIT_CURVE') == OURS['EDIT_CURVE'] == [*OURS['EDIT_MESH'][:-1], "splinewright.radius", "splinewright.tilt",
                                                        OURS['EDIT_MESH'][-1]]
    leave()
    bpy.ops.mesh.primitive_cube_add()
    bpy.ops.object.mode_set(mode='EDIT')
    assert not ours('EDIT_MESH') and "builtin.transform" in listed('EDIT_MESH')


def test_tools_are_in_groups_with_one_button_each(toolbar):
    from bl_ui.space_toolsystem_toolbar import VIEW3D_PT_tools_active as panel
    add(VALUES['nurbs']())
    buttons = [item for item in panel.tools_from_context(bpy.context, 'OBJECT') if item is not None]
    first = [tool.idname for group in part('ui.tool_table').GROUPS for tool in group[:1] if 'OBJECT' in tool.modes]
    groups = [item for item in buttons if not hasattr(item, "idname") and item[0].idname.startswith("splinewright.")]
    assert [group[0].idname for group in groups] == first and all(len(group) > 1 for group in groups)
    assert not [item for item in buttons if hasattr(item, "idname") and item.idname.startswith("splinewright.")]


def test_tools_of_ours_go_without_a_trace(toolbar):
    from bl_ui.space_toolsystem_toolbar import VIEW3D_PT_tools_active as panel
    config = bpy.context.window_manager.keyconfigs

    def census():
        return ({mode: [getattr(item, 'idname', item) for item in panel._tools_flatten(panel._tools[mode])]
                 for mode in ('EDIT_MESH', 'EDIT_CURVE', 'OBJECT')},
                [len(which.keymaps) for which in (config.default, config.addon)])
    with_ours = census()
    toolbar.unregister()
    without = census()
    toolbar.register()
    assert census() == with_ours
    toolbar.unregister()
    assert census() == without and with_ours != without
    toolbar.register()


@pytest.mark.parametrize('name', TOOLS)
def test_each_tool_is_whole(name):
    """Its icon, keys of the status bar, cursor, words, operator, and settings that this has."""
    tool = TOOLS[name]
    icon = f"{part('ui.toolbar').icon_of(tool)}.dat"
    folder = Path(bpy.utils.system_resource('DATAFILES', path="icons"))     # where Blender looks; ours have whole paths
    assert bpy.app.icons.new_triangles_from_file(str(folder / icon)) > 0
    others = [Path(f"{part('ui.toolbar').icon_of(other)}.dat").read_bytes() for other in TOOLS.values() if other is not tool]
    assert Path(icon).read_bytes() not in others, "an icon of its own"
    known = {item.identifier for kind in (bpy.types.UILayout,) for item in kind.bl_rna.functions['label'].parameters['icon'].enum_items}
    assert tool.keys and all(words and set(icons) <= known for icons, words in tool.keys)
    assert len(tool.keys) == 1 + len(tool.modifiers)
    assert tool.label == tool.label.strip() and tool.label and tool.label[0].isupper() and "Click" not in tool.label
    assert 3 <= len(tool.description.split()) <= 20 and not re.search(r"[.!?]", tool.description), "one sentence without a stop"
    assert tool.description[0].isupper()
    operator = getattr(bpy.ops.splinewright, tool.operator.partition(".")[2]).get_rna_type()
    properties = operator.properties
    assert {key for key, _ in tool.settings} <= set(properties.keys())
    for shown in (*tool.shown, *tool.of_patches):
        assert properties[shown].name and properties[shown].description and not properties[shown].is_hidden, shown
    assert tool.modes and set(tool.modes) <= {'OBJECT', 'EDIT_MESH', 'EDIT_CURVE'}
    works_on_nets = getattr(getattr(bpy.types, operator.identifier), 'works_on_nets', False)
    assert works_on_nets or tool.modes == ('OBJECT',), "a tool of nets whose operator works there"


def test_cursors_are_such_as_blender_has():
    known = {item.identifier for item in bpy.types.Window.bl_rna.functions['cursor_set'].parameters['cursor'].enum_items}
    assert {tool.cursor for tool in TOOLS.values()} <= known


def test_the_header_shows_the_settings_of_the_tool():
    """Those of patches only with one."""
    toolbar, shown = part('ui.toolbar'), []

    class Header(Layout):
        def label(self, **_):
            """What stands before a choice."""

        def row(self, **_):
            return self

        def prop(self, _, name, **__):
            shown.append(name)
    for name, tool in TOOLS.items():
        properties = SimpleNamespace(bl_rna=getattr(bpy.ops.splinewright, tool.operator.partition(".")[2]).get_rna_type())
        for is_of_patches in (False, True):
            shown.clear()
            toolbar.draw_settings(tool, Header(), properties, is_of_patches)
            assert tuple(shown) == (*tool.shown, *(tool.of_patches if is_of_patches else ())), name


def test_a_tool_is_no_entry_of_menus_in_background():
    add(VALUES['nurbs']())
    assert not bpy.ops.splinewright.use_tool.poll()


class Pie(Layout):
    def menu_pie(self):
        return self._part()

    def _part(self, *_, **__):
        return Pie(self)

    row = _part


def pie():
    layout = Pie()
    part('ui.pie').SPLINEWRIGHT_MT_pie.draw(SimpleNamespace(layout=layout), bpy.context)
    return layout


@pytest.mark.parametrize('name, gray', (
    ('nurbs', set()), ('periodic', set()), ('nurbs patch', set()), ('teapot', set()), ('both periodic', {"make_periodic"})))
def test_the_pie_has_eight_entries_and_what_would_be_refused_is_gray(name, gray):
    add(VALUES[name]() if name in VALUES else patches.value_of(name))
    enter()
    layout = pie()
    assert {"splinewright.pull_here", "splinewright.rebuild"} <= set(layout.operators)
    assert len(layout.operators) == len(set(layout.operators)) == 8
    assert set(layout.disabled) == {f"splinewright.{name}" for name in gray}
    assert bpy.ops.splinewright.pie.poll()


def test_the_key_of_the_pie_is_left_to_others_elsewhere():
    bpy.ops.mesh.primitive_cube_add()
    bpy.ops.object.mode_set(mode='EDIT')
    assert not bpy.ops.splinewright.pie.poll()


@pytest.fixture
def keys():
    keymaps = part('ui.keymaps')
    if not keymaps.of_user():           # they come late in background
        keymaps.register()
    bpy.context.window_manager.keyconfigs.update()


@pytest.mark.parametrize('name', ('nurbs', 'nurbs patch'))
def test_the_status_bar_names_keys_while_a_net_is_out(name, keys):
    hints, state = part('ui.hints'), part('ui.ui_state').ui_state
    assert hints.shown_keys(bpy.context) == []
    add(VALUES[name]())
    enter()
    assert hints.shown_keys(bpy.context) == [
        (["EVENT_TAB"], "Done"), (["EVENT_CTRL", "EVENT_R"], "Insert Knot"), (["EVENT_ALT", "EVENT_G"], "Pull Shape"),
        *([(["EVENT_ALT", "EVENT_S"], "Radius"), (["EVENT_CTRL", "EVENT_T"], "Tilt")] if name == 'nurbs' else []),
        (["EVENT_I"], "Insert Point Keyframes"), (["EVENT_SHIFT", "EVENT_Q"], "Pie Menu")]
    state.status = "a problem"
    try:
        assert hints.shown_keys(bpy.context) == [], "problems have the first right"
    finally:
        state.status = ""
    part('ui.preferences').get().show_hints = False
    try:
        assert hints.shown_keys(bpy.context) == []
    finally:
        part('ui.preferences').get().show_hints = True


@pytest.mark.parametrize('name', TOOLS)
def test_the_status_bar_names_the_keys_of_the_tool_until_a_gesture_begins(name, monkeypatch):
    hints, state = part('ui.hints'), part('ui.ui_state').ui_state
    monkeypatch.setattr(hints.toolbar, 'active', lambda _: TOOLS[name])
    assert hints.shown_keys(bpy.context) == [(list(icons), words) for icons, words in TOOLS[name].keys] != []
    for field, value in (('is_pointing', True), ('drawn_stroke', ((0, 0, 0),)), ('contour', ("drawn", "longer"))):
        monkeypatch.setattr(state, field, value)
        assert hints.shown_keys(bpy.context) == [], f"{field}: a gesture has keys of its own"
        monkeypatch.undo()
        monkeypatch.setattr(hints.toolbar, 'active', lambda _: TOOLS[name])


def test_over_the_knot_strip_it_names_what_the_mouse_does_there(keys):
    hints, state, pointed = part('ui.hints'), part('ui.ui_state').ui_state, part('ui.knot_strip').Pointed
    sights = bpy.context.scene.splinewright_sights
    sights.strip, state.pointed_knot = True, pointed(1, "shape", 0, 2, 1.0)
    inserting = (["MOUSE_LMB"], "twice: Insert Knot")
    try:
        assert hints.shown_keys(bpy.context) == [(["MOUSE_LMB_DRAG"], "Move Knot"), inserting, (["EVENT_X"], "Remove Knot")]
        state.pointed_knot = pointed(1, "shape", 0, None, 1.0)
        assert hints.shown_keys(bpy.context) == [inserting]
        sights.strip = False
        assert hints.shown_keys(bpy.context) == []
    finally:
        state.pointed_knot = None
        sights.property_unset('strip')


def tools_shown():
    """The names of Blender's own tools in the toolbar of Edit Mode of meshes."""
    from bl_ui.space_toolsystem_toolbar import VIEW3D_PT_tools_active
    found = VIEW3D_PT_tools_active.tools_from_context(bpy.context, mode='EDIT_MESH')
    return [tool.idname for tool in VIEW3D_PT_tools_active._tools_flatten(found) if tool is not None
            and tool.idname.startswith('builtin.')]


WITHOUT_MEANING = {f"builtin.{name}" for name in ('inset_faces', 'bevel', 'knife', 'bisect', 'poly_build', 'spin', 'rip_region', 'primitive_cube_add')}


def test_the_toolbar_of_nets_has_no_tools_without_meaning_there():
    """Meshes have them all, as before; so they do where the add-on is not."""
    module = part('ui.net_toolbar')
    bpy.ops.mesh.primitive_cube_add()
    bpy.ops.object.mode_set(mode='EDIT')
    all_tools = tools_shown()
    assert WITHOUT_MEANING <= set(all_tools)
    bpy.ops.object.mode_set(mode='OBJECT')
    add(VALUES['nurbs patch']())
    enter()
    shown = tools_shown()
    assert not WITHOUT_MEANING & set(shown) and {'builtin.move', 'builtin.extrude_region', 'builtin.loop_cut'} <= set(shown)
    assert [name for name in all_tools if name in shown] == shown
    module.unregister()
    try:
        assert tools_shown() == all_tools
    finally:
        module.register()
    leave()
