"""Makes pictures of the lectures inside Blender, step by step."""

import importlib

import bpy

from steps import CHOOSE, CLICK


class Failed(RuntimeError):
    """A step that an operator refused."""


def make(picture):
    """Make a picture in the present scene; [object] in the order in which they were made. Raises Failed."""
    names = []
    for number, step in enumerate(picture.steps, 1):
        try:
            done = _run(step, names)
        except RuntimeError as error:
            raise Failed(f"{picture.number}, step {number}, {step.operator}: {error}") from error
        if done != {'FINISHED'}:
            raise Failed(f"{picture.number}, step {number}, {step.operator}: {done}")
        bpy.context.view_layer.update()
        names = [name if name in bpy.data.objects else "" for name in names]       # a name that is free again is given again
        if bpy.context.mode == 'OBJECT':
            names += [ob.name for ob in bpy.context.scene.objects if ob.name not in names]
    return [bpy.data.objects[name] for name in names if name]


def _run(step, names):
    if step.operator == CLICK:
        return _click([bpy.data.objects[names[number]] for number in step.settings['numbers']])
    if step.operator == CHOOSE:
        return _choose(step.settings['numbers'])
    room, _, name = step.operator.partition(".")
    # Without an undo step fields that are not given stay as they come, not as they were last.
    return getattr(getattr(bpy.ops, room), name)('EXEC_DEFAULT', not name.startswith("add_"), **step.settings)


def _click(obs):
    for ob in bpy.context.view_layer.objects:
        ob.select_set(ob in obs)
    bpy.context.view_layer.objects.active = obs[0]
    return {'FINISHED'}


def _choose(numbers):
    ob = bpy.context.object
    part('bridge.net.selection').select(ob, part('bridge.net.live').session(ob.data).net, numbers)
    bpy.ops.ed.undo_push(message="select")
    return {'FINISHED'}


def part(name):
    """A module of the installed add-on, by its dotted name below the add-on."""
    addon = next(key for key in bpy.context.preferences.addons.keys() if key.split('.')[-1] == 'splinewright')
    return importlib.import_module(f"{addon}.{name}")
