"""Materials of a picture: each function has its color, axes and sums have theirs, marks of one letter have one. A slot's material is the user's to change."""

import bpy

from ...core.base.words import phrase
from ...core.formulas import axes, functions, influence, signs
from ..data import store
from ..mesh import mesh_looks

#: The names by which splines or faces were given their slots last, on the data-block.
KEY = "splinewright_names"
#: sRGB of functions one after the other, told apart by people who see few colors (Okabe and Ito 2008); then of axes and sums.
_COLORS = ((0.0, 0.45, 0.70), (0.84, 0.37, 0.0), (0.0, 0.62, 0.45), (0.80, 0.47, 0.65), (0.90, 0.62, 0.0), (0.34, 0.71, 0.91),
              (0.62, 0.12, 0.18), (0.45, 0.45, 0.1), (0.10, 0.15, 0.45), (0.60, 0.85, 0.55), (0.50, 0.30, 0.70), (0.45, 0.27, 0.12))
_AXES, _SUM, _GRID = (0.55, 0.55, 0.55), (0.9, 0.9, 0.9), (0.3, 0.3, 0.3)
#: Slots before those of functions.
_FIRST = ("Splinewright Axes", _AXES), ("Splinewright Sum", _SUM), ("Splinewright Grid", _GRID)
#: What has a color of its own, in whatever slot.
_INFLUENCE = "Splinewright Influence", (0.9, 0.05, 0.05)
_SURFACE_SUM = "Splinewright Surface Sum", _SUM
#: The slots of what is no function.
_OTHERS = {functions.AXIS: 0, functions.TICK: 0, functions.SUM: 1, functions.DOMAIN: 2, axes.GRID: 2}


def show(data, names):
    """Give splines the slots of what they are called, where that is not what it was."""
    if not _is_new(data, names):
        return
    slots = slots_of(names)
    kinds = dict(zip(slots, map(_kind, names)))
    for slot in range(len(data.materials), max(slots) + 1):
        data.materials.append(_material(*_wanted(slot, kinds.get(slot))))
    for spline, slot in zip(data.splines, slots):
        spline.material_index = slot


def show_faces(data, names):
    """Give the faces of patches the slots of what those are called, where that is not what it was."""
    if not _is_new(data, names):
        return
    slots = face_slots_of(names)
    kinds = dict(zip(slots, map(_kind, names)))
    for slot in range(len(data.materials), max(slots) + 1):
        data.materials.append(_face_material(slot, kinds.get(slot)))
    mesh_looks.set_materials(data, slots)


def _is_new(data, names):
    """Whether names are there, and others than were noted last; they are noted."""
    if not any(names):
        data.pop(KEY, None)
        return False
    text = "\n".join(names)
    if data.get(KEY) == text:
        return False
    store.assign(data, KEY, text)
    return True


def face_slots_of(names):
    """The slot of each name of a patch, in their order."""
    known = list(dict.fromkeys(map(signs.group_of, names)))
    return [known.index(signs.group_of(name)) for name in names]


def slots_of(names):
    """The slot of each name: of axes and ticks, of sums, of grids, of others in their order. Marks and arrows of a letter have one."""
    groups = [signs.group_of(name) for name in names]
    known = list(dict.fromkeys(group for name, group in zip(names, groups) if _kind(name) not in _OTHERS))
    return [_OTHERS[_kind(name)] if _kind(name) in _OTHERS else len(_FIRST) + known.index(group) for name, group in zip(names, groups)]


def _kind(name):
    """Names of ticks end in their number."""
    return signs.of_text(name).partition(" ")[0]


def colors_of(data):
    """{name: RGBA} of the pieces of a picture, as their materials are in views."""
    names = data.get(KEY, "").split("\n")
    wanted = slots_of if isinstance(data, bpy.types.Curve) else face_slots_of
    slots = dict(zip(names, wanted(names))) if any(names) else {}
    materials = {name: data.materials[slot] for name, slot in slots.items() if slot < len(data.materials)}
    return {name: (*map(_srgb, material.diffuse_color[:3]), 1.0) for name, material in materials.items() if material}


def _wanted(slot, kind):
    if kind == influence.INFLUENCE:
        return _INFLUENCE
    if slot < len(_FIRST):
        return _FIRST[slot]
    number = (slot - len(_FIRST)) % len(_COLORS)
    return phrase("Splinewright Color {number}", number=number + 1), _COLORS[number]


def _face_material(slot, kind):
    """Shaded, so that the form of a surface is seen; the influence of a point is red in every light."""
    if kind == influence.INFLUENCE:
        return _material(*_INFLUENCE)
    if kind == functions.SUM:
        return _material(*_SURFACE_SUM, is_shaded=True)
    number = slot % len(_COLORS)
    return _material(phrase("Splinewright Surface Color {number}", number=number + 1), _COLORS[number], is_shaded=True)


def _material(name, color, is_shaded=False):
    """One of this file of that name, or a new one: as bright in every light, unless it is shaded."""
    known = bpy.data.materials.get((name, None))
    if known is not None:
        return known
    made, linear = bpy.data.materials.new(name), [_linear(channel) for channel in color]
    made.diffuse_color = (*linear, 1.0)
    if made.node_tree is None:          # since 5.0 there always is one
        made.use_nodes = True
    nodes, links = made.node_tree.nodes, made.node_tree.links
    nodes.clear()
    output = nodes.new('ShaderNodeOutputMaterial')
    shader, socket = ('ShaderNodeBsdfDiffuse', 'BSDF') if is_shaded else ('ShaderNodeEmission', 'Emission')
    surface = nodes.new(shader)
    surface.inputs['Color'].default_value = (*linear, 1.0)
    links.new(surface.outputs[socket], output.inputs['Surface'])
    return made


def _srgb(channel):
    """Of a linear one. Blender's own conversion is 5e-6 off."""
    return 12.92 * channel if channel <= 0.0031308 else 1.055 * channel ** (1 / 2.4) - 0.055


def _linear(channel):
    """Of sRGB."""
    return channel / 12.92 if channel <= 0.04045 else ((channel + 0.055) / 1.055) ** 2.4
