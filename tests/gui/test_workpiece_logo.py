"""A logo by clicks, menus and keys: a contour with an arc is drawn, its corners are filleted, an offset lies in it, and both are extruded
to a closed ring with caps; the contour is changed in its net, undone, saved, opened."""

import os
import sys
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
import by_keys
from window import into_net, nets, out_of_net, part, redrawn, run, save_picture, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])
#: The slot that is drawn: straight below and above, round at the right.
CORNERS = ((-2, -1, 0), (2, -1, 0), (2, 1, 0), (-2, 1, 0))
NAMES = {}


def picture(name):
    return save_picture(OUTPUT / f"logo-{name}.png")


def value(name):
    return bpy.data.objects[NAMES[name]].data.splinewright.value


def curve(name):
    """The one curve of a shape."""
    found = value(name)
    made, = found if isinstance(found, list) else [found]
    return made.to_nurbs()


def corners(name):
    return sum(joint.g == 0 for _, joint in curve(name).joints())


def settings(name):
    return bpy.data.objects[NAMES[name]].data.splinewright_parameters


def above(view):
    view.press('NUMPAD_7')
    view.area.spaces.active.region_3d.view_distance = 9.0
    yield from redrawn()
    yield from redrawn()


def contour(view):
    """A goes on by an arc, and back; C closes."""
    yield from by_keys.add(view, "Curve > NURBS > Draw > Draw Contour")
    for number, corner in enumerate(CORNERS):
        view.move(*view.pixel_of(corner))
        yield from redrawn()
        view.press('LEFTMOUSE')
        yield from redrawn()
        if number in (1, 2):
            view.press('A')
            yield from redrawn()
    picture("drawing")
    view.press('C')
    yield from until(lambda: len(bpy.data.objects) == 1, "C closes the contour")
    NAMES['outline'] = bpy.context.object.name
    length = 4 + np.pi + 4 + 2
    assert abs(curve('outline').length() - length) < 0.03 * length and corners('outline') == 2
    view.move(420, 690)
    yield from redrawn()
    picture("contour")


def filleted(view):
    before = curve('outline')
    yield from by_keys.search(view, "fillet corners")
    yield from until(lambda: curve('outline') != before, "F3 finds Fillet Corners")
    assert corners('outline') == 0 and curve('outline').length() < before.length()
    yield from redrawn()
    picture("filleted")


def offset(view):
    """Inside, by a distance that is typed in the panel."""
    yield from by_keys.search(view, "offset curve")
    yield from until(lambda: len(bpy.data.objects) == 2, "an offset")
    NAMES['inside'] = bpy.context.object.name
    yield from by_keys.sidebar(view)
    inwards = -1 if area(curve('inside')) > area(curve('outline')) else 1
    was = settings('inside').offset_distance
    wanted = inwards * np.sign(was) * 0.3
    yield from by_keys.typed(view, "offset_distance", f"{wanted:.1f}")
    yield from until(lambda: abs(settings('inside').offset_distance - wanted) < 1e-6, "the distance that is typed")
    apart = curve('outline').nearest(curve('inside').evaluate(np.linspace(*curve('inside').domain, 60))).distances
    assert np.abs(apart - 0.3).max() < 1e-4 and area(curve('inside')) < area(curve('outline'))
    picture("offset")
    view.area.spaces.active.show_region_ui = False
    yield from redrawn()


def area(made):
    """That a curve in the plane z = 0 encloses."""
    x, y = made.evaluate(np.linspace(*made.domain, 2000))[:, :2].T
    return abs(np.sum(x[:-1] * np.diff(y) - y[:-1] * np.diff(x))) / 2


def extruded(view):
    """Fill makes the flat ring between both; Extrude with caps the solid of the outline."""
    yield from by_keys.select_all(view, 2)
    yield from by_keys.add(view, "Surface > NURBS > Surface from Curves > Fill")
    yield from until(lambda: len(bpy.data.objects) == 3, "a filling")
    NAMES['ring'] = bpy.context.object.name
    wanted = area(curve('outline')) - area(curve('inside'))
    found = value('ring')
    patches = [found[i] for i in range(len(found))] if isinstance(found, part('core.base.library').sc.PatchSet) else [found]
    assert abs(sum(patch.area() for patch in patches) - wanted) < 1e-3 * wanted
    yield from by_keys.keys(view, "G Z 2 Enter")
    yield from by_keys.choose(view, NAMES['outline'])
    yield from by_keys.add(view, "Surface > NURBS > Surface from Curves > Extrude")
    yield from until(lambda: len(bpy.data.objects) == 4, "an extrusion")
    NAMES['solid'] = bpy.context.object.name
    settings('solid').extrude_caps = 'both'
    yield from until(is_closed, "caps")
    require_solid()
    view.area.spaces.active.region_3d.view_rotation = (0.83, 0.46, 0.13, 0.28)
    yield from by_keys.see_all(view)
    picture("extruded")


def is_closed():
    mesh = bpy.data.objects[NAMES['solid']].data
    counts = np.bincount([loop.edge_index for loop in mesh.loops])
    return len(counts) > 0 and bool((counts == 2).all())


def require_solid():
    """Watertight, and as large as what is drawn is long and wide."""
    height = np.ptp(np.array(bpy.data.objects[NAMES['solid']].bound_box)[:, 2])
    outline = bpy.data.objects[NAMES['outline']]
    wanted = area(curve('outline')) * outline.scale.x * outline.scale.y * height
    assert is_closed() and abs(value('solid').volume() - wanted) < 1e-3 * wanted, (value('solid').volume(), wanted)


def wider(view):
    """Points of the outline in its net: all that is made of it follows."""
    before = {name: value(name) for name in ('inside', 'ring', 'solid')}
    yield from by_keys.choose(view, NAMES['outline'])
    view.press('TAB')
    yield from into_net()
    view.press('A')
    yield from redrawn()
    yield from by_keys.keys(view, "S X 1.5 Enter")
    yield from until(lambda: all(value(name) != was for name, was in before.items()), "all follow")
    view.press('TAB')
    yield from out_of_net()
    require_solid()
    picture("wider")
    after = {name: value(name) for name in before}
    steps = 0
    while any(value(name) != was for name, was in before.items()):
        yield from by_keys.keys(view, "Ctrl+Z")
        steps += 1
        assert steps < 4
    for _ in range(steps):
        yield from by_keys.keys(view, "Ctrl+Shift+Z")
    yield from until(lambda: all(value(name) == was for name, was in after.items()), "Ctrl+Shift+Z")
    if nets():
        view.press('TAB')
        yield from out_of_net()


def kept(view):
    solid = lambda: value('solid')
    yield from by_keys.followed_when_opened(view, OUTPUT / "logo.blend", solid, require_solid, NAMES['outline'], "S X 1.5 Enter")
    picture("opened")


run(by_keys.one_by_one(above, contour, filleted, offset, extruded, wider, kept))
