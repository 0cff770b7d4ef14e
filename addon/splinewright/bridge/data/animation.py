"""What animates a data-block: keys, strips of the nonlinear animation, drivers."""

from . import versions


def holders(animation):
    """What holds an action of an AnimData: itself, and the strips of its tracks."""
    strips = [strip for track in animation.nla_tracks for strip in track.strips]
    return [holder for holder in (animation, *strips) if holder.action is not None]


def curve_lists(holder):
    """The lists of F-curves of a holder's action: one before Blender 4.4, one for each strip since."""
    action = holder.action
    if not versions.actions_have_layers:
        return [action.fcurves]
    bags = [bag for layer in action.layers for strip in layer.strips for bag in strip.channelbags]
    return [bag.fcurves for bag in bags if bag.slot == holder.action_slot]


def own_action(holder):
    """Make the action of a holder its own: one that others use, too, or of another file, is copied first."""
    if holder.action.users > 1 or holder.action.library:
        slot = getattr(holder, 'action_slot', None)
        handle = slot.handle if slot else None
        holder.action = holder.action.copy()
        if slot:
            holder.action_slot = next(slot for slot in holder.action.slots if slot.handle == handle)


def paths(owner):
    """The data paths of all that animates an Object or data-block."""
    return {channel.data_path for channel in channels(owner)}


def channels(owner):
    """All F-curves and drivers of an Object or data-block, which is none or has a data path and an index each."""
    animation = owner.animation_data
    if animation is None:
        return
    yield from animation.drivers
    yield from curves(owner)


def curves(owner):
    """All F-curves of an Object or data-block."""
    animation = owner.animation_data
    for holder in holders(animation) if animation is not None else ():
        for of_one in curve_lists(holder):
            yield from of_one


def remove(owner, is_meant, drivers_too=True):
    """Remove the F-curves, and drivers, that are meant; an action that others use, too, is copied first."""
    animation = owner.animation_data
    if animation is None:
        return
    for driver in [driver for driver in animation.drivers if drivers_too and is_meant(driver)]:
        animation.drivers.remove(driver)
    for holder in holders(animation):
        if any(is_meant(curve) for curves in curve_lists(holder) for curve in curves):
            own_action(holder)
            for curves in curve_lists(holder):
                for curve in [curve for curve in curves if is_meant(curve)]:
                    curves.remove(curve)
