"""What holds on to the single points of a data-block, and loses them when there are others."""

import bpy


def hooked_points(users):
    """Nouns for the points that hooks on these objects name by number."""
    return [f"the points of the modifier {modifier.name}"
            for ob in users for modifier in ob.modifiers if modifier.type == 'HOOK']


def parented_points(users):
    """Nouns for the points of these objects that others are parented to."""
    children = [child for ob in users for child in ob.children if child.parent_type in ('VERTEX', 'VERTEX_3')]
    return [f"the points that {child.name} is parented to" for child in children]


def drop_point_animation(data):
    """Take away the animation of single points; whether there was any. Their paths would name others.

    An action that others use, too, is copied first.
    """
    animation = data.animation_data
    if animation is None:
        return False
    drivers = [driver for driver in animation.drivers if _is_of_point(driver)]
    for driver in drivers:
        animation.drivers.remove(driver)
    action = animation.action
    if action is None or not any(_is_of_point(curve) for curves in _curve_lists(animation) for curve in curves):
        return bool(drivers)
    if action.users > 1:
        slot = getattr(animation, 'action_slot', None)
        handle = slot.handle if slot else None
        animation.action = action.copy()
        if slot:
            animation.action_slot = next(slot for slot in animation.action.slots if slot.handle == handle)
    for curves in _curve_lists(animation):
        for curve in [curve for curve in curves if _is_of_point(curve)]:
            curves.remove(curve)
    return True


def _curve_lists(animation):
    """The lists of F-curves of the action: one before Blender 4.4, one for each strip since."""
    action = animation.action
    if not hasattr(action, 'layers'):
        return [action.fcurves]
    bags = [bag for layer in action.layers for strip in layer.strips for bag in strip.channelbags]
    return [bag.fcurves for bag in bags if bag.slot == animation.action_slot]


def _is_of_point(curve):
    return curve.data_path.startswith("splines[")


def users_of(data):
    """The objects that show a data-block."""
    return [ob for ob in bpy.data.objects if ob.data == data]
