"""Why an operator cannot work now, said in its greyed-out button."""


def in_object_mode(cls, context):
    """For poll(): whether Object Mode is on."""
    if context.mode != 'OBJECT':
        cls.poll_message_set("Leave the present mode first")
        return False
    return True
