"""The workflows of the manual, step by step with the commands that it names, and the labels on its pages of tasks."""

import math
import re
from pathlib import Path

import bpy
import numpy as np
import pytest

from shapes import activate, op
from support import part, splinecore as sc

MANUAL = Path(__file__).resolve().parents[2] / "addon/manual"
TASKS = ('workflows', 'choosing', 'keyboard', 'performance', 'troubleshooting', 'animation')
api, keymaps = part('api'), part('ui.keymaps')


def classes():
    return [cls for room in part('ui')._all_rooms() for cls in room.CLASSES]


def labels():
    """Of all operators, panels and menus, and of their properties and what those choose from."""
    found = set()
    for cls in classes():
        found.add(cls.bl_rna.name)
        found.add(getattr(cls, 'bl_label', ""))
        kind = cls
        if issubclass(cls, bpy.types.Operator):
            space, name = cls.bl_idname.split(".")
            kind = getattr(getattr(bpy.ops, space), name).get_rna_type()
        for known in (kind if kind is not cls else cls.bl_rna).properties:
            found.add(known.name)
            if known.type == 'ENUM':
                found.update(item.name for item in known.enum_items)
    for menu in part('ui.menu_table').MENUS:
        found.add(menu.label)
        found.update(entry.text for entry in menu.entries if getattr(entry, 'text', ""))
    return found


KEY = r"(?:(?:Ctrl|Shift|Alt)\+)?(?:[A-Z](?: [A-Z])*|Tab|Enter|Esc|Delete|Numpad \d|F\d|wheel)"
#: Words of Blender's, of its menus and of continuity.
BLENDERS = {"Object Mode", "Overlays", "Object", "Edit", "Preferences", "Add-ons", "Render", "Lock Interface", "Shift+A", "Curve", "Surface",
            "Splinewright", "Align", "View", "Y", "G1", "G2", "NURBS", "Follow Path", "Insert Single Keyframe"}


def words_of(page):
    """What a page sets in bold, and in italics; lines of what is no name are left out."""
    text = re.sub(r"^    .*$|<!--.*?-->", "", (MANUAL / f"{page}.md").read_text(), flags=re.M)
    bold = [" ".join(found.split()) for found in re.findall(r"\*\*([^*]+)\*\*", text)]
    italic = [" ".join(found.split()) for found in re.findall(r"(?<![*\w])\*([^*\n]+(?:\n[^*\n]+)?)\*(?![*\w])", re.sub(r"\*\*[^*]+\*\*", "", text))]
    return bold, italic


@pytest.mark.parametrize('page', TASKS)
def test_what_the_pages_of_tasks_name_is_there_under_that_name(page):
    known = labels()
    bold, italic = words_of(page)
    assert len(bold) >= 3
    for name in bold:
        sentence = name.endswith(".") or name in ("Objects", "Numbers of recipes", "Control points", "Modifiers")
        assert name in known or re.fullmatch(KEY, name) or sentence or name in BLENDERS, f"{page}: {name}"
    for name in italic:
        for part_of_it in re.split(r" > |: ", name):
            assert part_of_it in known or part_of_it in BLENDERS, f"{page}: {name}"


def test_the_page_of_keys_has_all_keys():
    text = (MANUAL / "keyboard.md").read_text()
    for _, operator, key, held in keymaps._ITEMS:
        label = getattr(bpy.ops.splinewright, operator.split(".")[1]).get_rna_type().name
        pressed = f"{held.title()}+{key}" if held else key.title() if len(key) > 1 else key
        assert re.search(rf"^\| \*\*{re.escape(pressed)}\*\* \|.*\*\*{re.escape(label)}\*\*", text, re.M), (pressed, label)
    for operator, key, _ in keymaps._ON_STRIP:
        label = getattr(bpy.ops.splinewright, operator.split(".")[1]).get_rna_type().name
        assert f"**{label}**" in text


class Steps:
    """Calls commands, and keeps their labels in order."""

    def __init__(self):
        self.done = []

    def __call__(self, name, **settings):
        call = getattr(bpy.ops.splinewright, name)
        assert call.poll(), name
        assert op(call, **settings) == {'FINISHED'}
        self.done.append(call.get_rna_type().name)
        bpy.context.view_layer.update()
        return bpy.context.object

    def are_in(self, title):
        """Whether a section of the page names these commands in this order."""
        text = (MANUAL / "workflows.md").read_text()
        section = " ".join(re.search(rf"^## {title}\n(.*?)(?=^## |\Z)", text, re.S | re.M)[1].split())
        at = 0
        for label in dict.fromkeys(self.done):
            at = section.find(f"**{label}**", at)
            assert at >= 0, f"{title}: {label} is not where it is done"



def open_sides(value):
    return sum(map(len, sc.build.open_ends([value[i] for i in range(len(value))])))


def test_a_vase():
    step = Steps()
    outline = step('add_nurbs_curve', count=6, rotation=(math.pi / 2, 0.0, 0.0))
    api.set_value(outline, api.value(outline).with_points(
        [(0, 0, 0), (0.6, 0, 0), (1.0, 0.6, 0), (0.7, 1.5, 0), (0.3, 1.9, 0), (0.5, 2.4, 0)]))
    vase = step('add_revolve')
    assert api.settings(vase)['axis'] == 'y'
    walled = step('add_thickened', distance=0.05)
    assert open_sides(api.value(walled)) == 0 and abs(api.value(walled).volume()) > 0.1
    box = np.array([walled.matrix_world @ vertex.co for vertex in walled.data.vertices])
    assert 2.3 < box[:, 2].max() < 2.6 and -0.1 < box[:, 2].min() <= 0.0
    before = api.value(walled)
    value = api.value(outline)
    api.set_value(outline, value.with_points(value.points * (1.2, 1, 1)))
    assert api.update() == {} and api.value(walled) != before
    activate(walled)
    step('make_editable')
    assert api.inputs(walled) == []
    step.are_in("A vase")


def test_a_bottle():
    step = Steps()
    made = []
    for height, size in ((0.0, 0.8), (1.0, 1.0), (1.8, 0.3)):
        made.append(step('add_circle', location=(0, 0, height), radius=size))
    made.append(step('add_ellipse', location=(0, 0, 2.4), size=0.3))
    activate(*made)
    bottle = step('add_loft')
    bottle.data.splinewright_parameters.loft_caps = 'start'
    bpy.context.view_layer.update()
    assert api.settings(bottle)['caps'] == 'start' and api.problem(bottle) == "" and api.inputs(bottle) == made
    wall = step('add_thickened', distance=0.03)
    assert open_sides(api.value(wall)) == 0
    before = api.value(wall)
    made[1].scale = (1.3, 1.3, 1.3)
    assert api.update() == {} and api.value(wall) != before
    step.are_in("A bottle")


def panel(step, x, name):
    curves = []
    for y in (0.0, 1.0, 2.0):
        curve = step('add_nurbs_curve', count=4, location=(0, 0, 0), rotation=(0, 0, 0))
        bend = 0.1 * y * (2 - y)
        api.set_value(curve, api.value(curve).with_points([(x + t, y, 0.3 * abs(x + t - 1.5) ** 2 * -0.3 + bend) for t in (0, 0.33, 0.66, 1.0)]))
        curves.append(curve)
    bpy.context.view_layer.update()
    activate(*curves)
    made = step('add_loft')
    made.name = name
    return made


def test_a_car_panel():
    step = Steps()
    hood, fender = panel(step, 0.0, "Hood"), panel(step, 2.0, "Fender")
    activate(hood, fender)
    blend = step('add_surface_blend')
    assert api.settings(blend)['continuity'] == 'G2' and api.update() == {}
    activate(blend, hood, fender)
    step('make_editable')
    whole = step('join')
    value = api.value(whole)
    assert len(value) == 3 and len(value.seams()) == 2
    for (first, side), (second, other) in value.seams():
        found = sc.seam_continuity(value[first], side, value[second], other)
        assert found.gap < 1e-9 and found.g >= 2
    for seam in value.seams():
        (first, side), (second, other) = seam
        sides = {'first': first + 1, 'first_side': side, 'second': second + 1, 'second_side': other}
        if not part('core.joints.held').can_hold(part('bridge.data.store').read(whole.data), *seam):
            step('join_patches', continuity='C0', **sides)
        step('hold_seam', continuity='G2', **sides)
    value = api.value(whole)
    assert len(part('bridge.data.held').read(whole.data)) == 2 == len(value.seams())
    for (first, side), (second, other) in value.seams():
        found = sc.seam_continuity(value[first], side, value[second], other)
        assert found.gap == 0.0 and found.g >= 2
    step.are_in("A car panel with G2")


def test_a_pipe_run():
    step = Steps()
    run = step('add_contour')
    run.data.splinewright_parameters.contour_corners = 'round'
    run.data.splinewright_parameters.contour_corner_size = 0.2
    bpy.context.view_layer.update()
    assert api.problem(run) == "" and api.settings(run)['corner_size'] == 0.2
    inner = step('add_pipe', radius=0.05, caps='flat')
    activate(run)
    outer = step('add_pipe', radius=0.08, caps='round')
    assert open_sides(api.value(outer)) == 0 and api.settings(inner)['end_radius'] == 0.05
    before = api.value(inner), api.value(outer)
    points = api.points(run)
    points = points.copy()
    points[0, 2] += 0.5
    api.set_points(run, points)
    assert api.update() == {} and (api.value(inner) != before[0]) and api.value(outer) != before[1]
    step.are_in("A pipe run")
