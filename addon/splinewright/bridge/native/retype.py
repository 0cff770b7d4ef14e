"""An object becomes one of another type and stays the same Object: what points to it, and all it has, stays."""

import bpy

from ...core.base.failures import Refusal, blenders_refusals
from ...core.base.words import phrase
from ..data import blocks
from . import staging


def all_become(context, users, data, become, back):
    """become(context, ob, data) for all objects that share a data-block, which goes if nothing else
    uses it. Returns what they lost. Where one fails, those before it go `back`, and `data` goes."""
    old, done, lost = users[0].data, [], []
    _copy_properties(old, data)
    try:
        for ob in users:
            lost += [noun for noun in become(context, ob, data) if noun not in lost]
            done.append(ob)
    except Exception:
        for ob in done:
            back(context, ob, old)
        blocks.remove(data)
        raise
    old.use_fake_user = False
    blocks.remove(old)
    return lost


def _copy_properties(old, data):
    """What a user noted on the data-block, and whether it is kept without users."""
    data.use_fake_user = old.use_fake_user
    for key in old.keys():
        if not key.startswith('splinewright') and key not in old.bl_rna.properties:
            data[key] = old[key]


def become_mesh(context, ob, mesh):
    """Make a SURFACE object a MESH object. Returns what it lost, as nouns.

    The mesh has as many materials as the surface. Raises Refusal, and has changed nothing,
    if Blender does not convert it, and outside Object Mode.
    """
    return _become(context, ob, bpy.data.curves.new(ob.name, 'SURFACE'), 'MESH', mesh)


def become_surface(context, ob, surface):
    """Make a MESH object a SURFACE object, as become_mesh()."""
    lost = []
    if ob.rigid_body:
        lost.append("the rigid body")
    if ob.vertex_groups:
        lost.append("the vertex groups")
    # Blender makes no surfaces, but curves of wires, and a curve object takes the data of a surface.
    wire = bpy.data.meshes.new(ob.name)
    wire.from_pydata([(0, 0, 0), (1, 0, 0)], [(0, 1)], [])
    return lost + _become(context, ob, wire, 'CURVE', surface)


def _become(context, ob, stand_in, target, data):
    """The stand-in, with almost nothing in it, is what Blender converts."""
    slots = [(slot.link, slot.material) for slot in ob.material_slots]
    keeper = ob.copy()              # of the modifiers: converting takes them away
    try:
        with staging.alone(context, ob):
            with blenders_refusals():
                _convert(ob, stand_in, target)
            made, ob.data = ob.data, data
            blocks.remove(made)
            if keeper.modifiers:
                with staging.linked(context, keeper):
                    bpy.ops.object.make_links_data(type='MODIFIERS')
        for slot, (link, material) in zip(ob.material_slots, slots):
            slot.link = link
            if link == 'OBJECT':
                slot.material = material
        return [phrase("the modifier {name}",
                       name=modifier.name) for modifier in keeper.modifiers if modifier.name not in ob.modifiers]
    finally:
        bpy.data.objects.remove(keeper)
        blocks.remove(stand_in)


def _convert(ob, stand_in, target):
    old, shown = ob.data, [modifier.show_viewport for modifier in ob.modifiers]
    for material in old.materials:
        stand_in.materials.append(material)
    try:
        ob.data = stand_in
        for modifier in ob.modifiers:
            modifier.show_viewport = False
        bpy.ops.object.convert(target=target)
        if ob.type != target:
            raise Refusal("Blender did not convert {name}", name=ob.name)
    except (RuntimeError, Refusal):
        ob.data = old
        for modifier, is_shown in zip(ob.modifiers, shown):
            modifier.show_viewport = is_shown
        raise
