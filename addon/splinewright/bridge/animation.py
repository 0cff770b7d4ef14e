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
    """Make the action of a holder its own: one that others use, too, is copied first."""
    if holder.action.users > 1:
        slot = getattr(holder, 'action_slot', None)
        handle = slot.handle if slot else None
        holder.action = holder.action.copy()
        if slot:
            holder.action_slot = next(slot for slot in holder.action.slots if slot.handle == handle)


def paths(owner):
    """The data paths of all that animates an Object or data-block."""
    animation = owner.animation_data
    if animation is None:
        return set()
    found = {driver.data_path for driver in animation.drivers}
    for holder in holders(animation):
        found |= {curve.data_path for curves in curve_lists(holder) for curve in curves}
    return found
