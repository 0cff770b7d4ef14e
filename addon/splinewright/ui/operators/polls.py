"""Why an operator cannot work now, said in its grayed-out button."""

from ...core.base.words import say


def in_object_mode(cls, context):
    """For poll(): whether Object Mode is on."""
    if context.mode != 'OBJECT':
        cls.poll_message_set(say("Leave the present mode first"))
        return False
    return True


def one_or_two_selected(cls, context, fits, wanted):
    """For poll(): whether the active object and at most one more are selected in Object Mode, and fit."""
    if not in_object_mode(cls, context):
        return False
    chosen = context.selected_objects
    if context.object not in chosen or len(chosen) > 2 or not all(map(fits, chosen)):
        cls.poll_message_set(say(wanted))
        return False
    return True
