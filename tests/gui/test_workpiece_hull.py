"""A hull by menus, clicks and keys: frames of keel, chine and sheer are drawn as contours, and lofted: the chine is one edge, also when
a corner is dragged; undone, saved, opened."""

import os
import sys
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
import by_keys
from window import into_net, nets, out_of_net, redrawn, run, save_picture, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])
#: (place along the hull, keel, chine and sheer in the front view)
FRAMES = ((0, (0, 0), (0.9, 0.35), (1.0, 1.0)), (2, (0, -0.1), (0.8, 0.4), (1.05, 1.1)), (4, (0, 0.2), (0.25, 0.7), (0.4, 1.3)))
NAMES = []


def picture(name):
    return save_picture(OUTPUT / f"hull-{name}.png")


def value(name=None):
    return bpy.data.objects[name or NAMES[-1]].data.splinewright.value


def in_world(name, points):
    matrix = np.array(bpy.data.objects[name].matrix_world)
    return np.asarray(points) @ matrix[:3, :3].T + matrix[:3, 3]


def corner(name):
    """The place of the one corner of a frame."""
    curve, = [value(name)] if not isinstance(value(name), list) else value(name)
    (where, joint), = [found for found in curve.to_nurbs().joints() if found[1].g == 0]
    return in_world(name, [curve.to_nurbs().evaluate(where)])[0]


def require_chine():
    """One line of knots across the frames, as often as the degree: a sharp edge through the corner of each."""
    hull = value()
    edges = []
    for number, axis in enumerate('uv'):
        knots, (start, end) = np.asarray(hull.knots[number]), hull.domain[number]
        inner, times = np.unique(knots[(knots > start) & (knots < end)], return_counts=True)
        edges += [(axis, at) for at, count in zip(inner, times) if count >= hull.degree[number]]
        assert len(edges) == 0 or axis != edges[-1][0] or len(inner) == 1
    (axis, at), = edges
    corners = np.array([corner(name) for name in NAMES[:-1]])
    matrix = np.linalg.inv(np.array(bpy.data.objects[NAMES[-1]].matrix_world))
    local = corners @ matrix[:3, :3].T + matrix[:3, 3]
    assert hull.isocurve(axis, at).nearest(local).distances.max() < 1e-5


def frames(view):
    for place, *points in FRAMES:
        before = len(bpy.data.objects)
        yield from by_keys.add(view, "Curve > NURBS > Draw > Draw Contour")
        for x, z in points:
            view.move(*view.pixel_of((x, 0, z)))
            yield from redrawn()
            view.press('LEFTMOUSE')
            yield from redrawn()
        view.press('RET')
        yield from until(lambda: len(bpy.data.objects) == before + 1, "Enter ends the contour")
        NAMES.append(bpy.context.object.name)
        view.move(420, 690)
        yield from by_keys.keys(view, f"G Y {place} Enter" if place else "Esc")
        reached = [point for point in points if np.abs(corner(NAMES[-1])[[0, 2]] - point).max() < 0.02]
        assert reached == [points[1]], corner(NAMES[-1])


def lofted(view):
    view.press('A')
    yield from until(lambda: len(bpy.context.selected_objects) == 3, "A selects all")
    yield from by_keys.search(view, "loft")
    yield from until(lambda: len(bpy.data.objects) == 4, "F3 finds Loft")
    NAMES.append(bpy.context.object.name)
    with view.override():
        view.area.spaces.active.region_3d.view_rotation = (0.65, 0.45, 0.35, 0.50)
        bpy.ops.view3d.view_all(center=False)
    yield from redrawn()
    require_chine()
    picture("lofted")


def dragged(view):
    """The corner of the middle frame is dragged in its net."""
    yield from by_keys.choose(view, NAMES[1])
    before, was = value(), corner(NAMES[1])
    view.press('TAB')
    yield from into_net()
    with view.override():
        bpy.ops.curve.select_all(action='DESELECT')
        spline = nets()[0].data.splines[0]
        points = spline.bezier_points if spline.type == 'BEZIER' else spline.points
        nearest = min(points, key=lambda point: np.linalg.norm(np.array(nets()[0].matrix_world @ point.co.to_3d()) - was))
        if spline.type == 'BEZIER':
            nearest.select_control_point = True
        else:
            nearest.select = True
        nets()[0].data.update_tag()
        bpy.ops.ed.undo_push(message="choose")
    yield from by_keys.keys(view, "G Z 0.1 Enter")
    yield from until(lambda: value() != before, "the hull follows")
    require_chine()
    assert abs(corner(NAMES[1])[2] - was[2] - 0.1) < 1e-5
    view.press('TAB')
    yield from out_of_net()
    picture("dragged")
    after = value()
    yield from by_keys.keys(view, "Ctrl+Z")
    yield from by_keys.keys(view, "Ctrl+Z")
    yield from until(lambda: value() == before, "Ctrl+Z takes it back")
    yield from by_keys.keys(view, "Ctrl+Shift+Z")
    yield from by_keys.keys(view, "Ctrl+Shift+Z")
    yield from until(lambda: value() == after, "Ctrl+Shift+Z")
    if nets():
        view.press('TAB')
        yield from out_of_net()


def kept(view):
    yield from by_keys.followed_when_opened(view, OUTPUT / "hull.blend", value, require_chine, NAMES[2], "G Y 1 Enter")
    picture("opened")


def near(view):
    """From the front, so near that a click beside a point takes none of another frame."""
    view.press('NUMPAD_1')
    yield from redrawn()
    region = view.area.spaces.active.region_3d
    region.view_location, region.view_distance = (0.5, 0.0, 0.5), 3.5
    yield from redrawn()
    yield from redrawn()


run(by_keys.one_by_one(near, frames, lofted, dragged, kept))
