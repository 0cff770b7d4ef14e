"""Materials of a picture: each function has its color, axes and sums have theirs, marks of one letter have one. A slot's material is the user's to change."""

import bpy

from ...core.base.words import phrase
from ...core.formulas import axes, functions, influence, signs
from ..data import store

#: The names by which splines were given their slots last, on the Curve.
KEY = "splinewright_names"
#: sRGB of functions one after the other, told apart by people who see few colors (Okabe and Ito 2008); then of axes and sums.
_COLORS = ((0.0, 0.45, 0.70), (0.84, 0.37, 0.0), (0.0, 0.62, 0.45), (0.80, 0.47, 0.65), (0.90, 0.62, 0.0), (0.34, 0.71, 0.91),
              (0.62, 0.12, 0.18), (0.45, 0.45, 0.1), (0.10, 0.15, 0.45), (0.60, 0.85, 0.55), (0.50, 0.30, 0.70), (0.45, 0.27, 0.12))
_AXES, _SUM, _GRID = (0.55, 0.55, 0.55), (0.9, 0.9, 0.9), (0.3, 0.3, 0.3)
#: Slots before those of functions.
_FIRST = ("Splinewright Axes", _AXES), ("Splinewright Sum", _SUM), ("Splinewright Grid", _GRID)
#: What has a color of its own, in whatever slot.
_INFLUENCE = "Splinewright Influence", (0.9, 0.05, 0.05)
#: The slots of what is no function.
_OTHERS = {functions.AXIS: 0, functions.TICK: 0, functions.SUM: 1, axes.GRID: 2}


def show(data, names):
    """Give splines the slots of what they are called, where that is not what it was."""
    text = "\n".join(names)
    if not any(names):
        data.pop(KEY, None)
        return
    if data.get(KEY) == text:
        return
    store.assign(data, KEY, text)
    slots = slots_of(names)
    kinds = dict(zip(slots, map(_kind, names)))
    for slot in range(len(data.materials), max(slots) + 1):
        data.materials.append(_material(*_wanted(slot, kinds.get(slot))))
    for spline, slot in zip(data.splines, slots):
        spline.material_index = slot


def slots_of(names):
    """The slot of each name: of axes and ticks, of sums, of grids, of others in their order. Marks and arrows of a letter have one."""
    groups = [signs.group_of(name) for name in names]
    known = list(dict.fromkeys(group for name, group in zip(names, groups) if _kind(name) not in _OTHERS))
    return [_OTHERS[_kind(name)] if _kind(name) in _OTHERS else len(_FIRST) + known.index(group) for name, group in zip(names, groups)]


def _kind(name):
    """Names of ticks end in their number."""
    return name.partition(" ")[0]


def colors_of(data):
    """{name: RGBA} of the pieces of a picture, as their materials are in views."""
    names = data.get(KEY, "").split("\n")
    slots = dict(zip(names, slots_of(names))) if any(names) else {}
    materials = {name: data.materials[slot] for name, slot in slots.items() if slot < len(data.materials)}
    return {name: (*map(_srgb, material.diffuse_color[:3]), 1.0) for name, material in materials.items() if material}


def show_faces(data, names):
    """Give a Mesh that is a picture its material, where it has none."""
    if any(names) and not data.materials:
        data.materials.append(_material(*_INFLUENCE))


def _wanted(slot, kind):
    if kind == influence.INFLUENCE:
        return _INFLUENCE
    if slot < len(_FIRST):
        return _FIRST[slot]
    number = (slot - len(_FIRST)) % len(_COLORS)
    return phrase("Splinewright Color {number}", number=number + 1), _COLORS[number]


def _material(name, color):
    """One of this file of that name, or a new one that is as bright in every light."""
    known = bpy.data.materials.get((name, None))
    if known is not None:
        return known
    made, linear = bpy.data.materials.new(name), [_linear(channel) for channel in color]
    made.diffuse_color = (*linear, 1.0)
    if made.node_tree is None:          # since 5.0 there always is one
        made.use_nodes = True
    nodes, links = made.node_tree.nodes, made.node_tree.links
    nodes.clear()
    output, light = nodes.new('ShaderNodeOutputMaterial'), nodes.new('ShaderNodeEmission')
    light.inputs['Color'].default_value = (*linear, 1.0)
    links.new(light.outputs['Emission'], output.inputs['Surface'])
    return made


def _srgb(channel):
    """Of a linear one. Blender's own conversion is 5e-6 off."""
    return 12.92 * channel if channel <= 0.0031308 else 1.055 * channel ** (1 / 2.4) - 0.055


def _linear(channel):
    """Of sRGB."""
    return channel / 12.92 if channel <= 0.04045 else ((channel + 0.055) / 1.055) ** 2.4
