"""What holds on to the single points of a data-block, and loses them when there are others."""

import bpy

from ...core.base.words import phrase
from ..data import animation


def hooked_points(users):
    """Nouns for the points that hooks on these objects name by number."""
    return [phrase("the points of the modifier {name}", name=modifier.name)
            for ob in users for modifier in ob.modifiers if modifier.type == 'HOOK']


def parented_points(users):
    """Nouns for the points of these objects that others are parented to."""
    children = [child for ob in users for child in ob.children if child.parent_type in ('VERTEX', 'VERTEX_3')]
    return [phrase("the points that {name} is parented to", name=child.name) for child in children]


def drop_point_animation(data):
    """Take away the animation of single points; whether there was any. Their paths would name others."""
    is_animated = any(map(_is_of_point, animation.paths(data)))
    if is_animated:
        drivers = data.animation_data.drivers
        for driver in [driver for driver in drivers if _is_of_point(driver.data_path)]:
            drivers.remove(driver)
        for holder in animation.holders(data.animation_data):
            _drop_curves(holder)
    return is_animated


def _drop_curves(holder):
    if not any(_is_of_point(curve.data_path) for curves in animation.curve_lists(holder) for curve in curves):
        return
    animation.own_action(holder)
    for curves in animation.curve_lists(holder):
        for curve in [curve for curve in curves if _is_of_point(curve.data_path)]:
            curves.remove(curve)


def _is_of_point(path):
    return path.startswith("splines[")


def users_of(data):
    """The objects that show a data-block."""
    return [ob for ob in bpy.data.objects if ob.data == data]
