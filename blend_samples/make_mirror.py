"""A car's door mirror under stripes. The housing is the surface of a network of rings and ribs, the arm and the foot are lofts;
Blend Surfaces joins them, and rolls the rim in to the bezel, G2: stripes run on over every join. The glass is filled. All curves
are in the file, hidden from the picture only: edit one, and all of it follows.
"""

import sys
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
import stage

stage.PALETTE['mirror'], stage.ROUGHNESS['mirror'] = (0.86, 0.89, 0.92), 0.0
stage.METALS.add('mirror')
stage.begin()
sc = stage.splinecore()
#: The planes of the rings are upright and fan out from here: from the glass, at angle 0, to the arm.
HINGE = np.array((-1.3, -0.05, 0.0))
#: (angle in degrees, nearest to and farthest from the hinge, height of the middle, half height, exponent of the superellipse)
RINGS = ((0, 0.16, 2.45, 0.02, 0.62, 3.0), (9, 0.15, 2.42, 0.02, 0.66, 2.8), (24, 0.14, 2.10, 0.01, 0.64, 2.6),
         (45, 0.13, 1.50, -0.05, 0.53, 2.4), (68, 0.13, 1.04, -0.16, 0.37, 2.2), (90, 0.16, 0.84, -0.25, 0.25, 2.1))
RIBS = 12
#: (place, lean in degrees, half width, half thickness)
ARM = (((-1.66, 0.45, -0.42), 46, 0.27, 0.16), ((-1.71, 0.45, -0.475), 50, 0.27, 0.16), ((-1.75, 0.45, -0.53), 54, 0.27, 0.16))
FOOT = (((-1.95, 0.45, -0.98), 90, 0.35, 0.22), ((-1.95, 0.45, -1.03), 90, 0.37, 0.24), ((-1.95, 0.45, -1.08), 90, 0.40, 0.27))
#: (size by that of the rim, depth)
BEZEL = ((0.955, 0.02), (0.95, 0.08), (0.94, 0.2))
#: Its sides are arcs that meet behind the bezel: (size in the middle of a side, size at a corner, depth).
GLASS = (0.965, 0.99, 0.1)


def superellipse(middle, first, second, exponent=2.0, angles=np.arange(RIBS) * 2 * np.pi / RIBS):
    """Points round a middle, from the first half axis on to the second one."""
    cosine, sine = (np.sign(wave) * np.abs(wave) ** (2 / exponent) for wave in (np.cos(angles), np.sin(angles)))
    return np.array(middle) + np.outer(cosine, first) + np.outer(sine, second)


def upright(angle, near, far, height, half_height, exponent, **more):
    turn = np.radians(angle)
    way = np.array((np.cos(turn), np.sin(turn), 0))
    middle = HINGE + 0.5 * (near + far) * way + (0, 0, height)
    return superellipse(middle, 0.5 * (far - near) * way, (0, 0, half_height), exponent, **more)


def leaning(place, lean, wide, thick):
    """Of what runs sideways (0) or down (90 degrees)."""
    turn = np.radians(lean)
    return superellipse(place, (0, wide, 0), thick * np.array((-np.sin(turn), 0, np.cos(turn))))


def inset(size, depth, **more):
    """Of the rim, smaller and deeper in the housing."""
    middle = upright(*RINGS[0]).mean(axis=0)
    return middle + size * (upright(*RINGS[0], **more) - middle) + (0, depth, 0)


def ring(points):
    """The closed cubic B-spline of control points."""
    return sc.NurbsCurve(3, np.arange(len(points) + 1), points, periodic=True)


def source(value, name):
    ob = stage.shape(value, name, color='ink')
    ob.hide_render = True
    return ob


def surface(operator, sources, name, v=12, **settings):
    ob = stage.follow(operator, sources, name, 'mirror', **settings)
    ob.data.materials[0] = lacquer
    ob.data.splinewright.resolution_u, ob.data.splinewright.resolution_v = 12, v
    return ob


def housing():
    rings = [ring(upright(*form)) for form in RINGS]
    crossings = np.array([curve.evaluate(np.arange(RIBS)) for curve in rings])
    steps = np.linalg.norm(np.diff(crossings, axis=0), axis=2).mean(axis=1)
    places = np.r_[0, np.cumsum(steps)] / steps.sum()
    ribs = [sc.fit.interpolate(points, parameters=places).value for points in crossings.transpose(1, 0, 2)]
    return surface('add_network', [*numbered(rings, "Ring"), *numbered(ribs, "Rib")], "Housing")


def numbered(curves, name):
    return [source(curve, f"{name} {i + 1}") for i, curve in enumerate(curves)]


def lofted(sections, name):
    return surface('add_loft', numbered(map(ring, sections), f"Section of the {name.lower()},"), name)


def blend(first, second, name):
    return surface('add_surface_blend', [first, second], name, 24, continuity='G2')


def glass():
    middle, corner, depth = GLASS
    parts = np.linspace(-1, 1, 7)
    sizes = (middle + (corner - middle) * parts ** 2)[:, None]
    sides = [sc.fit.interpolate(inset(sizes, depth, angles=0.25 * np.pi * (2 * i + parts))).value for i in range(4)]
    ob = surface('add_filling', numbered(sides, "Side of the glass,"), "Glass")
    ob.data.materials[0] = stage.paint('mirror')
    return ob


def once_more(parts, place, turn):
    """The same mirror from its other side."""
    mirror = bpy.data.collections.new("Mirror")
    for ob in parts:
        mirror.objects.link(ob)
    other = bpy.data.objects.new("Mirror, turned round", None)
    other.instance_type, other.instance_collection = 'COLLECTION', mirror
    other.location, other.rotation_euler.z = place, np.radians(turn)
    bpy.context.scene.collection.objects.link(other)


def sky():
    """What the glass shows: brighter upwards; the rest is in an even light."""
    world = bpy.context.scene.world.node_tree
    nodes, link = world.nodes, world.links.new
    way, parts, ramp, path, mixed = (nodes.new(f"ShaderNode{kind}") for kind in ("TexCoord", "SeparateXYZ", "ValToRGB", "LightPath", "MixRGB"))
    for element, place, color in zip(ramp.color_ramp.elements, (0.30, 0.42), ((0.10, 0.14, 0.20, 1), (0.80, 0.86, 0.92, 1))):
        element.position, element.color = place, color
    height = nodes.new("ShaderNodeMapRange")
    height.inputs["From Min"].default_value = -1.0
    link(way.outputs["Generated"], parts.inputs["Vector"])
    link(parts.outputs["Z"], height.inputs["Value"])
    link(height.outputs["Result"], ramp.inputs["Fac"])
    link(ramp.outputs["Color"], mixed.inputs["Color2"])
    link(path.outputs["Is Glossy Ray"], mixed.inputs["Fac"])
    mixed.inputs["Color1"].default_value = (0.5, 0.5, 0.5, 1.0)
    link(mixed.outputs["Color"], nodes["Background"].inputs["Color"])
    nodes["Background"].inputs["Strength"].default_value = 1.0


lacquer = stage.striped('Z', 0.8, (0.50, 0.66, 0.80))
shell = housing()
arm, foot, bezel = (lofted([form(*numbers) for numbers in sections], name) for form, sections, name in (
    (leaning, ARM, "Arm"), (leaning, FOOT, "Foot"), (inset, BEZEL, "Bezel")))
blends = [blend(shell, arm, "Blend of housing and arm"), blend(arm, foot, "Blend of arm and foot"), blend(shell, bezel, "Rim")]
bezel.data.materials[0] = stage.paint('ink')
once_more([shell, arm, foot, bezel, *blends, glass()], (2.05, -3.3, 0), 166)
sky()
stage.ground(-1.08, color='cloth')
bpy.context.object.visible_glossy = False
stage.camera((1.4, 9.4, 3.2), (0.45, 0, -0.12), 57)
stage.smooth(1)
stage.finish("mirror", samples=64, size=(900, 520))
