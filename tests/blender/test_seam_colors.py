"""Seams have colors of their own: far, to the eye, from those of nets, of what is selected and of outlines."""

import glob
import itertools
import os

import bpy
import numpy as np
import pytest

from support import part

colors, preferences = (part(name) for name in ('ui.colors', 'ui.preferences'))
#: Of Blender's theme, as far as a version has them: rows of nets, what is selected, outlines, and points.
OTHERS = ('nurb_sel_uline', 'nurb_sel_vline', 'vertex', 'vertex_select', 'edge_select', 'edge_mode_select',
          'object_active', 'object_selected', 'wire', 'wire_edit')
#: In Oklab, where 1 leads from black to white.
LEAST = 0.15


def seen(color):
    """In Oklab (B. Ottosson, 2020), where colors lie as far apart as they seem."""
    color = np.asarray(color[:3], float)
    light = np.where(color <= 0.04045, color / 12.92, ((color + 0.055) / 1.055) ** 2.4)
    cones = np.array([[0.4122214708, 0.5363325363, 0.0514459929], [0.2119034982, 0.6806995451, 0.1073969566],
                      [0.0883024619, 0.2817188376, 0.6299787005]]) @ light
    return np.array([[0.2104542553, 0.7936177850, -0.0040720468], [1.9779984951, -2.4285922050, 0.4505937099],
                     [0.0259040371, 0.7827717662, -0.8086757660]]) @ np.cbrt(cones)


def distance(one, other):
    return float(np.linalg.norm(seen(one) - seen(other)))


def defaults():
    known = preferences.SplinewrightPreferences.bl_rna.properties
    return {name: tuple(known[name].default_array) for name in known.keys() if name.startswith("color_")}


def seams():
    return {name: defaults()[name] for name, _ in colors.SEAMS.values()}


def themes():
    found = [path for folder in bpy.utils.preset_paths('interface_theme')
             for path in glob.glob(os.path.join(folder, "*.xml"))]
    return sorted(path for path in found if os.path.basename(path).lower() in ("blender_light.xml", "blender_dark.xml"))


def of_theme():
    theme = bpy.context.preferences.themes[0].view_3d
    return {name: tuple(getattr(theme, name)) for name in OTHERS if hasattr(theme, name)}


def test_distances_are_those_to_the_eye():
    assert distance((0, 0, 0), (1, 1, 1)) == pytest.approx(1, abs=1e-3) and distance((1, 0, 0), (1, 0, 0)) == 0
    assert distance((1, 0, 0), (0, 1, 0)) > 0.5 > distance((1, 0, 0), (1, 0.3, 0)) > 0


@pytest.mark.parametrize('theme', ("as it opens", "Light"))
def test_no_color_of_a_seam_is_like_one_of_the_theme(theme):
    before = of_theme()
    if theme == "Light":
        light = [path for path in themes() if "light" in path.lower()]
        assert light, "Blender has no light theme"
        bpy.ops.script.execute_preset(filepath=light[0], menu_idname="USERPREF_MT_interface_theme_presets")
    try:
        assert len(of_theme()) >= 8
        near = {(seam, name): round(distance(a, b), 3) for seam, a in seams().items() for name, b in of_theme().items()
                if distance(a, b) < LEAST}
        assert not near
    finally:
        for name, value in before.items():
            setattr(bpy.context.preferences.themes[0].view_3d, name, value)


def test_nor_like_one_of_our_own_nor_like_each_other():
    others = {name: value for name, value in defaults().items() if name not in seams()}
    assert set(others) == {"color_u", "color_v", "color_arrow"}
    pairs = [*itertools.product(seams().items(), others.items()), *itertools.combinations(seams().items(), 2)]
    assert not [(a, b) for (a, one), (b, other) in pairs if distance(one, other) < LEAST]
    drawn = {"warning": colors.WARNING, "rim": colors.SEAM_RIM}
    assert not [(a, b) for (a, one), (b, other) in itertools.product(seams().items(), drawn.items())
                if distance(one, other) < LEAST]
