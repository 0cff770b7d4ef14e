"""The preferences: how new shapes are shown, the colors over the 3D view, and keys."""

from types import SimpleNamespace

import bpy
import numpy as np
import pytest

import rna_keymap_ui
from layouts import Layout
from shapes import VALUES, activate, add, op, require_exact
from support import part, splinecore as sc

colors, keymaps, preferences, table = (part(name) for name in (
    'ui.colors', 'ui.keymaps', 'ui.preferences', 'core.recipes.table'))


@pytest.fixture
def wanted():
    """The preferences, and afterwards as they were."""
    found = preferences.get()
    names = [name for name in type(found).__annotations__]
    before = {name: getattr(found, name) for name in names}
    before = {name: tuple(value) if name.startswith("color_") else value for name, value in before.items()}
    yield found
    for name, value in before.items():
        setattr(found, name, value)


def settings():
    return bpy.context.object.data.splinewright


CURVES = ['add_line', 'add_bezier_curve', 'add_bezier_chain', 'add_hermite_curve', 'add_nurbs_curve',
          *(f'add_{recipe.kind}' for recipe in table.STARTING if not recipe.is_surface)]
SURFACES = ['add_bezier_patch', 'add_hermite_patch', 'add_nurbs_patch', 'add_teapot',
            *(f'add_{recipe.kind}' for recipe in table.STARTING if recipe.is_surface)]


@pytest.mark.parametrize('name', [*CURVES, *SURFACES])
def test_a_resolution_that_was_not_given_is_that_of_the_preferences(name, wanted):
    operator = getattr(bpy.ops.splinewright, name)
    wanted.curve_resolution, wanted.surface_resolution, wanted.surface_mode = 5, 7, 'COUNT'
    op(operator)
    assert settings().resolution_u == (5 if name in CURVES else 7) and settings().mode == 'COUNT'
    require_exact(bpy.context.object)
    op(operator, resolution_u=3)
    assert settings().resolution_u == 3
    op(operator)
    assert settings().resolution_u != 3, "Blender remembers the last call, but nobody asked for it now"
    wanted.curve_resolution = wanted.surface_resolution = 0
    op(operator, resolution_u=4)
    op(operator)
    assert settings().resolution_u == 4, "as Blender's own operators remember"


@pytest.mark.parametrize('name', SURFACES)
def test_new_surfaces_have_automatic_faces_where_the_preferences_say_so(name, wanted):
    wanted.surface_mode = 'AUTOMATIC'
    op(getattr(bpy.ops.splinewright, name))
    assert settings().mode == 'AUTOMATIC'
    require_exact(bpy.context.object)


@pytest.mark.parametrize('name', SURFACES)
def test_new_surfaces_are_shown_by_the_tolerance_of_the_preferences(name, wanted):
    operator = getattr(bpy.ops.splinewright, name)
    wanted.surface_mode, wanted.surface_tolerance = 'TOLERANCE', 0.125
    op(operator)
    assert (settings().mode, settings().tolerance) == ('TOLERANCE', 0.125)
    require_exact(bpy.context.object)
    op(operator, faces_tolerance=0.25)
    assert (settings().mode, settings().tolerance) == ('TOLERANCE', 0.25)
    op(operator, faces_mode='COUNT')
    assert settings().mode == 'COUNT'
    op(operator, resolution_u=3)
    assert (settings().mode, settings().resolution_u) == ('COUNT', 3), "a resolution that was given is a wish for it"


def test_angles_and_the_parameters_of_recipes_are_told_apart(wanted):
    wanted.surface_mode, wanted.surface_angle, wanted.surface_tolerance = 'BOTH', 0.5, 0.125
    op(bpy.ops.splinewright.add_surface_formula)
    assert (settings().mode, settings().angle, settings().tolerance) == ('BOTH', 0.5, 0.125)
    data = bpy.context.object.data
    assert part('bridge.recipes.recipes').parameters(data)['tolerance'] == table.RECIPES['surface_formula'].parameters[-1].default


def test_surfaces_from_curves_and_imported_shapes_are_shown_as_the_preferences_say(wanted, tmp_path):
    wanted.surface_mode, wanted.surface_tolerance, wanted.curve_resolution = 'TOLERANCE', 0.125, 5
    curve = add(VALUES['cubic']())
    op(bpy.ops.splinewright.add_revolve)
    assert (settings().mode, settings().tolerance) == ('TOLERANCE', 0.125)
    path = str(tmp_path / "shapes.json")
    for ob, expected in ((curve, ('COUNT', 5)), (bpy.context.object, ('TOLERANCE', 10))):
        activate(ob)
        bpy.ops.splinewright.export_json(filepath=path)
        bpy.ops.splinewright.import_json(filepath=path)
        assert (settings().mode, settings().resolution_u) == expected
        require_exact(bpy.context.object)
        bpy.ops.splinewright.import_json(filepath=path, resolution_u=3, resolution_v=4)
        assert (settings().mode, settings().resolution_u, settings().resolution_v) == ('COUNT', 3, 4)


def test_without_preferences_their_defaults_are_used():
    defaults, real = preferences._Defaults(), preferences.get()
    for name in type(real).__annotations__:
        known, found = getattr(defaults, name), getattr(real, name)
        assert np.allclose(known, tuple(found)) if name.startswith("color_") else known == found, name


def test_nets_have_the_colors_of_the_theme_or_of_the_user(wanted):
    theme = bpy.context.preferences.themes[0].view_3d
    before = tuple(theme.nurb_sel_uline)
    theme.nurb_sel_uline = (0.25, 0.5, 0.75)        # a theme has 256 of each
    try:
        u, v = colors.of_net()
    finally:
        theme.nurb_sel_uline = before
    assert np.allclose(u, (0.25, 0.5, 0.75, 1.0), atol=0.003) and np.allclose(v[:3], theme.nurb_sel_vline)
    wanted.use_theme, wanted.color_u, wanted.color_v, wanted.color_arrow = False, (1, 0, 0), (0, 1, 0), (0, 0, 1)
    assert colors.of_net() == ((1, 0, 0, 1), (0, 1, 0, 1)) and colors.of_arrows() == (0, 0, 1, 1)


def test_seams_have_the_colors_of_the_preferences(wanted):
    flat = [sc.BezierPatch([[(x + 3 * i, y, 0) for y in range(4)] for x in range(4)]) for i in range(2)]
    ob = add(sc.PatchSet.from_patches(flat))
    wanted.color_g2 = (0.25, 0.5, 0.75)
    (_, found), = part('ui.seams_overlay').colored_lines(ob.data)
    assert np.allclose(found, (0.25, 0.5, 0.75, 1.0))


class Preferences(SimpleNamespace):
    """Stands for the preferences while they are drawn."""

    def __getattr__(self, name):
        found = getattr(preferences.SplinewrightPreferences, name)
        return found.__get__(self)


def drawn(wanted, monkeypatch):
    """The layout of the preferences, and the items of keys that were drawn by Blender's own function."""
    items, layout = [], Layout()
    monkeypatch.setattr(rna_keymap_ui, 'draw_kmi', lambda known, config, keymap, item, *_: items.append((keymap, item)))
    values = {name: getattr(wanted, name) for name in type(wanted).__annotations__}
    preferences.SplinewrightPreferences.draw(Preferences(layout=layout, **values), bpy.context)
    return layout, items


def test_the_preferences_show_what_applies(wanted, monkeypatch):
    wanted.surface_mode = 'COUNT'
    props = drawn(wanted, monkeypatch)[0].props
    assert {"curve_resolution", "surface_resolution", "nurb_sel_uline", "color_arrow", "color_g1"} <= set(props)
    assert not {"color_u", "surface_tolerance", "surface_angle"} & set(props)
    wanted.surface_mode, wanted.use_theme = 'BOTH', False
    props = drawn(wanted, monkeypatch)[0].props
    assert {"color_u", "color_v", "surface_tolerance", "surface_angle"} <= set(props)
    assert not {"surface_resolution", "nurb_sel_uline"} & set(props)


def test_the_preferences_show_the_keys_as_the_user_has_them(wanted, monkeypatch):
    if not keymaps.of_user():           # keymaps come late in background
        keymaps.register()
    bpy.context.window_manager.keyconfigs.update()
    layout, items = drawn(wanted, monkeypatch)
    found = {item.idname: (keymap, item) for keymap, item in items}
    assert set(found) == {"splinewright.edit_net", "splinewright.edit_source", "splinewright.edit_linked", "splinewright.leave_net",
                          "splinewright.join", "splinewright.insert_here", "splinewright.pull_here",
                          "splinewright.separate_pieces", "splinewright.key_points", "splinewright.pie", "splinewright.radius_here", "splinewright.tilt_here",
                          "splinewright.insert_on_strip", "splinewright.remove_on_strip"}
    assert {item.type for _, item in items if item.idname == "splinewright.remove_on_strip"} == {'X', 'DEL'}
    count, (keymap, item) = len(items), found["splinewright.join"]
    assert (item.type, item.ctrl, item.active) == ('J', True, True)
    keymap.keymap_items.remove(item)
    try:
        layout, items = drawn(wanted, monkeypatch)
        assert len(items) == count - 1 and any("splinewright.join has no key" in text for text in layout.texts)
    finally:
        keymap.restore_to_default()


def test_no_address_on_the_web_is_shown_before_there_is_one(wanted, monkeypatch):
    addresses = part('ui.addresses')
    assert addresses.known() == [] and "wm.url_open" not in drawn(wanted, monkeypatch)[0].operators
    monkeypatch.setattr(addresses, 'WEBSITE', "https://example.org")
    assert addresses.known() == [("Website", "https://example.org")]
    assert drawn(wanted, monkeypatch)[0].operators.count("wm.url_open") == 1
