"""Materials of a picture: each function has its color, axes and sums have theirs, marks of one letter have one. A slot's material is the user's to change."""

import bpy

from ...core.formulas import functions, signs
from ..data import store

#: The names by which splines were given their slots last, on the Curve.
KEY = "splinewright_names"
#: sRGB of functions one after the other, told apart by people who see few colors (Okabe and Ito 2008); then of axes and sums.
_COLORS = ((0.0, 0.45, 0.70), (0.84, 0.37, 0.0), (0.0, 0.62, 0.45), (0.80, 0.47, 0.65), (0.90, 0.62, 0.0), (0.34, 0.71, 0.91),
              (0.62, 0.12, 0.18), (0.45, 0.45, 0.1))
_AXES, _SUM = (0.55, 0.55, 0.55), (0.9, 0.9, 0.9)
#: Slots before those of functions.
_FIRST = ("Splinewright Axes", _AXES), ("Splinewright Sum", _SUM)


def show(data, names):
    """Give splines the slots of what they are called, where that is not what it was."""
    text = "\n".join(names)
    if not any(names) or data.get(KEY) == text:
        return
    store.assign(data, KEY, text)
    slots = slots_of(names)
    for slot in range(len(data.materials), max(slots) + 1):
        data.materials.append(_material(*_wanted(slot)))
    for spline, slot in zip(data.splines, slots):
        spline.material_index = slot


def slots_of(names):
    """The slot of each name: of axes and ticks, of sums, of others in their order."""
    groups = [signs.group_of(name) for name in names]
    known = {}
    for name, group in zip(names, groups):
        if not _is_of_axes(name) and name != functions.SUM:
            known.setdefault(group, len(_FIRST) + len(known))
    return [0 if _is_of_axes(name) else 1 if name == functions.SUM else known[group] for name, group in zip(names, groups)]


def _is_of_axes(name):
    return name.partition(" ")[0] in (functions.AXIS, functions.TICK)


def colors_of(data):
    """{name: RGBA} of the pieces of a picture, as their materials are in views."""
    names = data.get(KEY, "").split("\n")
    slots = dict(zip(names, slots_of(names))) if any(names) else {}
    materials = {name: data.materials[slot] for name, slot in slots.items() if slot < len(data.materials)}
    return {name: (*map(_srgb, material.diffuse_color[:3]), 1.0) for name, material in materials.items() if material}


def _wanted(slot):
    if slot < len(_FIRST):
        return _FIRST[slot]
    number = (slot - len(_FIRST)) % len(_COLORS)
    return f"Splinewright Color {number + 1}", _COLORS[number]


def _material(name, color):
    """One of this file of that name, or a new one that is as bright in every light."""
    known = bpy.data.materials.get((name, None))
    if known is not None:
        return known
    made, linear = bpy.data.materials.new(name), [_linear(channel) for channel in color]
    made.diffuse_color = (*linear, 1.0)
    made.use_nodes = True
    nodes, links = made.node_tree.nodes, made.node_tree.links
    nodes.clear()
    output, light = nodes.new('ShaderNodeOutputMaterial'), nodes.new('ShaderNodeEmission')
    light.inputs['Color'].default_value = (*linear, 1.0)
    links.new(light.outputs['Emission'], output.inputs['Surface'])
    return made


def _srgb(channel):
    """Of a linear one."""
    return 12.92 * channel if channel <= 0.0031308 else 1.055 * channel ** (1 / 2.4) - 0.055


def _linear(channel):
    """Of sRGB."""
    return channel / 12.92 if channel <= 0.04045 else ((channel + 0.055) / 1.055) ** 2.4
