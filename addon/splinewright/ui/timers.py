"""Functions that are called outside of the present call. In background Blender never calls them."""

import bpy


def soon(function):
    """Call a function once: where it is to be called already, then."""
    if not bpy.app.timers.is_registered(function):
        bpy.app.timers.register(function, first_interval=0.0)


def later(function, seconds):
    """Call a function when nobody has asked for it for a given number of seconds."""
    call_off(function)
    bpy.app.timers.register(function, first_interval=seconds)


def call_off(function):
    if bpy.app.timers.is_registered(function):
        bpy.app.timers.unregister(function)
