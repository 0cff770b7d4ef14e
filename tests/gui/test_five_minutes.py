"""The README's five minutes, as it has them: keys, paths of menus, words to search and numbers are read from its text, and done in a
window; the pictures are the README's."""

import os
import re
import sys
from pathlib import Path

import bpy
import numpy as np
from mathutils import Vector

sys.path.insert(0, str(Path(__file__).parent))
import by_keys
from one_shape import places_seen_on
from window import View, empty_file, in_net, into_net, is_out, nets, part, redrawn, run, save_picture, select_points, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])
README = (Path(__file__).resolve().parents[2] / "README.md").read_text()
#: What a paragraph says to do, in order: **keys**, *words of buttons*, and gestures.
GESTURES = ("click the lowest point", "click the highest point", "turn the wheel", "pull it to the left", "click the lock",
            "alt+click the row", "click")
TOKEN = re.compile(r"\*\*(?P<keys>[^*]+)\*\*|\*(?P<word>[^*]+)\*|\b(?P<gesture>" + "|".join(map(re.escape, GESTURES)) + r")\b", re.I)
PICTURES = ("profile", "revolved", "insert", "pull", "zebra")


def instructions():
    """Of each step the tokens of its first paragraph but for its title."""
    section = README.partition("## Five minutes")[2].partition("\n## ")[0]
    found = re.findall(r"^\d\. \*\*[^*]+\.\*\* (.*?)\n\n", section, re.M | re.S)
    assert "on the belly" in found[2] and "on the neck" in found[4]
    assert len(found) == len(PICTURES) and [name for name in PICTURES if f"five-{name}.png" not in section] == []
    return [[(kind, match[kind]) for match in TOKEN.finditer(re.sub(r"\s+", " ", text)) for kind in [match.lastgroup]] for text in found]


def picture(name):
    return save_picture(OUTPUT / f"five-{name}.png")


def vase():
    return next((ob for ob in bpy.data.objects if ob.type == 'MESH' and part('bridge.shape.shape').has_shape(ob)), None)


def value():
    return vase().data.splinewright.value


def seam():
    """Both sides along which the two patches meet; others are those at which one closes."""
    return next(pair for pair in value().seams() if pair[0][0] != pair[1][0])


def profile():
    return next(ob for ob in bpy.data.objects if ob.type == 'CURVE' and part('bridge.shape.shape').has_shape(ob))


def seen_at(view, at):
    """The pixel at which the vase has a parameter."""
    return view.pixel_of(vase().matrix_world @ Vector(value().evaluate(*at)))


#: How high the parts of the vase are that the text names.
HEIGHTS = {"belly": -0.5, "neck": 0.4}


def place_on(view, name):
    """(u, v) where a part of the vase is seen."""
    height = lambda at: (vase().matrix_world @ Vector(value().evaluate(*at))).z
    return min(places_seen_on(view, vase()), key=lambda at: abs(height(at) - HEIGHTS[name]))


def state():
    return part('ui.ui_state').ui_state


def keys(view, text):
    """Keys as they are written; what only some of them need."""
    if text.startswith("Shift+A > "):
        yield from by_keys.add(view, text.removeprefix("Shift+A > "))
    elif text == "numpad 1":
        view.press('NUMPAD_1')
        view.area.spaces.active.region_3d.view_distance = 5.0          # large in the picture
        yield from redrawn()
    elif text == "Tab":
        was_in = in_net()
        view.press('TAB')
        yield from until(is_out if was_in else in_net, "Tab brings the net out, and puts it away")
    elif text == "N":
        yield from by_keys.keys(view, "N")
    elif text == "NURBS":
        yield from view.show_tab(text, (1045, 538))
    elif text == "F3":
        view.press('F3')
        yield from redrawn()
        yield from redrawn()
    elif text in ("Ctrl+R", "Alt+G"):
        view.at = place_on(view, "belly")
        view.move(*seen_at(view, view.at))
        yield from redrawn()
        yield from by_keys.keys(view, text)
        if text == "Ctrl+R":
            yield from until(lambda: state().aimed is not None, "the knot is shown at the mouse")
        else:
            yield from until(lambda: state().pulled is not None, "what is at the mouse is shown")
    else:
        yield from by_keys.keys(view, text)
    yield from redrawn()


def word(view, text):
    """A word of the interface: what is searched for, or a field."""
    if text in ("Apply Construction", "Tools Split"):
        for letter in text.lower():
            view.press(by_keys.KEYS.get(letter, letter.upper()), letter)
        yield from redrawn()
        yield from redrawn()
    elif text == "Deformable":
        before = value()
        yield from view.go_to_field("deformable")
        view.press('LEFTMOUSE')
        yield from until(lambda: value() != before and np.ptp(value().weights) == 0, "a deformable vase")
        view.move(420, 420)
        look(view)
        yield from redrawn()
    elif text == "V":
        tool = part('ui.toolbar').active(bpy.context)
        assert tool.name == "split", "F3 chose the tool"
        part('ui.toolbar').settings(bpy.context, tool).direction = text
        view.move(*seen_at(view, place_on(view, "neck")))
        yield from redrawn()
        yield from redrawn()
    elif text == "G2":
        held(view, text)
        yield from redrawn()
    elif text == "Stripes":
        setattr(bpy.context.scene.splinewright_sights, text.lower(), True)
        yield from redrawn()
    else:
        assert text == "Continuity", text


def look(view):
    """From above; where a step is looked at from it does not say."""
    with view.override():
        region = bpy.context.space_data.region_3d
        region.view_perspective, region.view_rotation = 'PERSP', (0.83, 0.46, 0.13, 0.28)
        bpy.ops.view3d.view_all(center=False)
        region.view_distance *= 1.02


def held(view, continuity):
    """What the lock beside the one seam does, and the choice in its panel."""
    (first, side), (second, other) = seam()
    with view.override():
        bpy.ops.splinewright.hold_seam('EXEC_DEFAULT', True, continuity=continuity, first=first + 1, first_side=side,
                                       second=second + 1, second_side=other)


def gesture(view, text):
    text = text.lower()
    if text in ("click the lowest point", "click the highest point"):
        net = nets()[0]
        chosen = (min if "lowest" in text else max)(net.data.splines[0].points, key=lambda point: point.co[1])
        view.move(*view.pixel_of(net.matrix_world @ chosen.co.to_3d()))
        yield from redrawn()
        view.press('LEFTMOUSE')
        yield from until(lambda: [point.select for point in nets()[0].data.splines[0].points].count(True) == 1, "one point is selected")
    elif text == "turn the wheel":
        if state().aimed is None:
            view.move(*seen_at(view, place_on(view, "neck")))
            yield from until(lambda: state().aimed is not None, "the cut is shown at the mouse")
        view.wheel_up()
        yield from redrawn()
        if in_net():
            picture("insert")
    elif text == "pull it to the left":
        before, x, y = value(), view.x, view.y
        view.window.event_simulate('LEFTMOUSE', 'PRESS', x=x, y=y)
        view.move(x - 60, y)
        yield from until(lambda: value() != before and abs(seen_at(view, view.at)[0] - view.x) < 4, "the shape goes with the mouse")
        yield from redrawn()
        picture("pull")
        view.release()
        yield from until(lambda: state().pulled is None, "letting go ends it")
    elif text == "alt+click the row":
        (first, side), _ = seam()
        net = part('bridge.net.live').session(nets()[0].data).net
        vertices = {int(row): vertex for vertex, row in enumerate(net.rows)}
        indices = net.definition.pieces[first].indices
        rows = {'u_start': indices[1], 'u_end': indices[-2], 'v_start': indices[:, 1], 'v_end': indices[:, -2]}[side]
        with view.override():
            select_points(*(vertices[int(row)] for row in rows))
    elif text == "click":
        before = value()
        view.press('LEFTMOUSE')
        yield from until(lambda: value() != before, "a click inserts, or cuts")
    yield from redrawn()


def drawn(view):
    points = np.asarray(profile().data.splinewright.value.points)
    matrix = np.array(profile().matrix_world)
    there = points @ matrix[:3, :3].T + matrix[:3, 3]
    wanted = [(0, -1), (0.7, -1), (1.176, -0.6), (0.994, -0.2), (0.406, 0.2), (0.224, 0.6), (0.7, 1), (0.95, 1.3)]
    assert np.abs(there[:, [0, 2]] - wanted).max() < 1e-3 and np.abs(there[:, 1]).max() < 1e-5, there


def revolved(view):
    """A vase whose foot is closed, whose belly is as wide as its points and whose lip is where the last of them is."""
    points = np.array([vase().matrix_world @ vertex.co for vertex in vase().data.vertices])
    radii = np.hypot(points[:, 0], points[:, 1])
    assert radii.min() < 2e-3 and abs(points[:, 2].min() + 1) < 0.02 and abs(points[:, 2].max() - 1.3) < 0.01
    assert abs(radii[points[:, 2] > 1.295].mean() - 0.95) < 0.01 and 0.9 < radii[points[:, 2] < 0].max() < 1.2


def inserted(view):
    assert in_net() and part('bridge.recipes.recipes').kind(vase().data) in (None, "")


def pulled(view):
    assert not part('core.joints.creases').creases_of(part('bridge.data.store').read(vase().data))[0], "a pull makes no crease"


def stays_smooth(view):
    found = value()
    (first, side), (second, other) = seam()
    assert part('core.base.library').sc.seam_continuity(found[first], side, found[second], other).g >= 2 and is_out()


def steps():
    view = View()
    empty_file()
    view.move(420, 690)
    yield from redrawn()
    for number, tokens in enumerate(instructions()):
        for kind, text in tokens:
            print(number + 1, kind, text, flush=True)
            yield from {'keys': keys, 'word': word, 'gesture': gesture}[kind](view, text)
        if number in (0, 1, 4):
            picture(PICTURES[number])
        (drawn, revolved, inserted, pulled, stays_smooth)[number](view)
    print("the first five minutes are as the README says:", bpy.app.version_string, flush=True)


run(steps())
