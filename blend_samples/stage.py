"""What the sample scripts share: an empty scene with light and camera, a ground, saving and rendering."""

import math
import os
import shutil
import sys
import tempfile
import time
from pathlib import Path

import bmesh
import bpy
from mathutils import Matrix, Vector

PALETTE = {
    'clay': (0.72, 0.22, 0.09), 'sea': (0.10, 0.36, 0.52), 'moss': (0.24, 0.42, 0.16),
    'sand': (0.75, 0.50, 0.18), 'plum': (0.33, 0.10, 0.30), 'snow': (0.62, 0.62, 0.60), 'ink': (0.05, 0.05, 0.06),
    'paper': (0.95, 0.95, 0.92), 'porcelain': (0.80, 0.79, 0.75), 'cobalt': (0.03, 0.10, 0.30),
    'tea': (0.16, 0.035, 0.008), 'jam': (0.35, 0.01, 0.02), 'biscuit': (0.62, 0.36, 0.13), 'silver': (0.75, 0.74, 0.72),
    'cloth': (0.55, 0.60, 0.56),
}
#: Of the colors that are not as dull as the others.
ROUGHNESS = {'porcelain': 0.12, 'cobalt': 0.12, 'tea': 0.04, 'jam': 0.1, 'silver': 0.18, 'biscuit': 0.7, 'cloth': 0.8}
METALS = {'silver'}
#: Of so many samples of a picture a draft has one, and of its sides this much.
DRAFT, DRAFT_PERCENTAGE = 4, 50
#: Where the paper of a drawing lies.
PAPER = -0.05
_rows = []
_started = time.perf_counter()


def splinecore():
    """The module that the installed add-on carries."""
    return next(module for name, module in sys.modules.items() if name.endswith('splinewright.splinecore'))


def begin():
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
    scene = bpy.context.scene
    world = bpy.data.worlds.new("Sky")
    world.use_nodes = True
    world.node_tree.nodes["Background"].inputs["Color"].default_value = (0.85, 0.9, 1.0, 1.0)
    world.node_tree.nodes["Background"].inputs["Strength"].default_value = 0.4
    scene.world = world
    light = bpy.data.lights.new("Sun", 'SUN')
    light.energy, light.angle = 1.9, math.radians(12)
    sun = bpy.data.objects.new("Sun", light)
    sun.rotation_euler = (math.radians(48), math.radians(8), math.radians(35))
    scene.collection.objects.link(sun)


def add(operator, name, place=(0, 0, 0), rotation=(0, 0, 0), color='snow', **settings):
    """Call an Add operator; returns the named and painted object, and keeps a row for the table."""
    started = time.perf_counter()
    getattr(bpy.ops.splinewright, operator)(location=place, rotation=rotation, **settings)
    return _named(name, color, operator, started)


def follow(operator, sources, name, color='snow', **settings):
    """Call an operator that makes a shape from other objects, which it follows; the first one is the active one."""
    started = time.perf_counter()
    _select(*sources)
    getattr(bpy.ops.splinewright, operator)(**settings)
    return _named(name, color, operator, started)


def through(points, name, operator='curve_through_points', closed=False, color='ink', **settings):
    """What Curve Through Points, or Contour Through Points, makes of the vertices of a line; hidden from pictures."""
    started = time.perf_counter()
    data = bpy.data.meshes.new(name)
    data.from_pydata(list(points), [(i, i + 1) for i in range(len(points) - 1)], [])
    line = bpy.data.objects.new(name, data)
    bpy.context.scene.collection.objects.link(line)
    _select(line)
    bpy.ops.object.mode_set(mode='EDIT')
    bpy.ops.mesh.select_all(action='SELECT')
    getattr(bpy.ops.splinewright, operator)(closed=closed, **settings)
    made = bpy.context.object
    bpy.data.meshes.remove(data)
    bpy.context.view_layer.objects.active = made
    ob = _named(name, color, operator, started)
    ob.hide_render = True
    return ob


def _select(*obs):
    """The first one is the active one."""
    bpy.context.view_layer.update()
    for ob in bpy.context.view_layer.objects:
        ob.select_set(ob in obs)
    bpy.context.view_layer.objects.active = obs[0]


def fitted(cloud, name, color='snow', **settings):
    """What Fit Patch makes near all vertices of a mesh."""
    started = time.perf_counter()
    bpy.context.view_layer.objects.active = cloud
    cloud.select_set(True)
    bpy.ops.object.mode_set(mode='EDIT')
    bpy.ops.mesh.select_all(action='SELECT')
    bpy.ops.splinewright.fit_patch(**settings)
    return _named(name, color, 'fit_patch', started)


def _named(name, color, operator, started):
    ob = bpy.context.object
    ob.name = ob.data.name = name
    ob.data.materials.append(paint(color))
    _rows.append((ob, operator, 1e3 * (time.perf_counter() - started)))
    return ob


def patch(value, name, place=(0, 0, 0), color='snow', resolution=8, **settings):
    """An object of any splinecore patch or PatchSet."""
    ob = add('add_nurbs_patch', name, place, color=color, resolution_u=resolution, resolution_v=resolution, **settings)
    ob.data.splinewright.value = value
    return ob


def shape(value, name, place=(0, 0, 0), color='snow', **settings):
    """An object of any splinecore curve or list of curves."""
    ob = add('add_bezier_curve', name, place, color=color, **settings)
    ob.data.splinewright.value = value
    return ob


def polygon(points, name, place=(0, 0, 0), color='ink', radius=0.008):
    """Blender's own poly curve through points, thin."""
    data = bpy.data.curves.new(name, 'CURVE')
    data.dimensions, data.bevel_depth = '3D', radius
    spline = data.splines.new('POLY')
    spline.points.add(len(points) - 1)
    for point, co in zip(spline.points, points):
        point.co = (*co, 1.0)
    return _plain(name, data, place, color)


def beads(points, name, place=(0, 0, 0), color='ink', radius=0.04):
    """A little ball at each point."""
    ball = bpy.data.meshes.new(name)
    form = bmesh.new()
    for point in points:
        bmesh.ops.create_icosphere(form, subdivisions=3, radius=radius, matrix=Matrix.Translation(point))
    for face in form.faces:
        face.smooth = True
    form.to_mesh(ball)
    form.free()
    return _plain(name, ball, place, color)


def label(text, place, size=0.16, align='LEFT', height=PAPER + 0.002):
    data = bpy.data.curves.new(text, 'FONT')
    data.body, data.size, data.align_x, data.align_y = text, size, align, 'CENTER'
    return _plain(text, data, (*place, height), 'ink')


def _plain(name, data, place, color):
    ob = bpy.data.objects.new(name, data)
    ob.location = place
    data.materials.append(paint(color))
    bpy.context.scene.collection.objects.link(ob)
    return ob


def tube(ob, radius=0.03):
    """Give a curve shape thickness, so that it is seen in a render."""
    ob.data.bevel_depth, ob.data.bevel_resolution = radius, 4
    return ob


def paint(color):
    if color in bpy.data.materials:
        return bpy.data.materials[color]
    material = bpy.data.materials.new(color)
    material.use_nodes = True
    shader = material.node_tree.nodes["Principled BSDF"]
    shader.inputs["Base Color"].default_value = (*PALETTE[color], 1.0)
    shader.inputs["Roughness"].default_value = ROUGHNESS.get(color, 0.35)
    shader.inputs["Metallic"].default_value = color in METALS
    material.diffuse_color = (*PALETTE[color], 1.0)
    return material


def striped(direction='X', scale=2.2, color=(0.9, 0.9, 0.9)):
    """Stripes by the direction in which light is reflected: a kink cuts them, a jump of curvature bends them."""
    material = bpy.data.materials.new("stripes")
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    seen, wave = nodes.new('ShaderNodeTexCoord'), nodes.new('ShaderNodeTexWave')
    wave.bands_direction = direction
    wave.inputs["Scale"].default_value = scale
    ramp = nodes.new('ShaderNodeValToRGB')
    for element, place, light in zip(ramp.color_ramp.elements, (0.46, 0.54), ((0.02, 0.02, 0.02), color)):
        element.position, element.color = place, (*light, 1.0)
    light = nodes.new('ShaderNodeEmission')
    links.new(seen.outputs["Reflection"], wave.inputs["Vector"])
    links.new(wave.outputs["Fac"], ramp.inputs["Fac"])
    links.new(ramp.outputs["Color"], light.inputs["Color"])
    links.new(light.outputs["Emission"], nodes["Material Output"].inputs["Surface"])
    return material


def ground(height=0.0, size=400.0, color='snow'):
    bpy.ops.mesh.primitive_plane_add(size=size, location=(0, 0, height))
    bpy.context.object.name = "Ground"
    bpy.context.object.data.materials.append(paint(color))


def camera(place, target, lens=50):
    data = bpy.data.cameras.new("Camera")
    data.lens = lens
    ob = bpy.data.objects.new("Camera", data)
    ob.location = place
    ob.rotation_euler = (Vector(target) - Vector(place)).to_track_quat('-Z', 'Y').to_euler()
    bpy.context.scene.collection.objects.link(ob)
    bpy.context.scene.camera = ob


def lamp(place, target, power, size, height=None):
    """A square of light, or so high a rectangle."""
    light = bpy.data.lights.new("Lamp", 'AREA')
    light.energy, light.size = power, size
    if height:
        light.shape, light.size_y = 'RECTANGLE', height
    ob = bpy.data.objects.new("Lamp", light)
    ob.location = place
    ob.rotation_euler = (Vector(target) - Vector(place)).to_track_quat('-Z', 'Y').to_euler()
    bpy.context.scene.collection.objects.link(ob)


def smooth(strength=2):
    """Blur noise of the rendering where it is no edge: pictures of solid things get a third of the bytes."""
    scene = bpy.context.scene
    scene.use_nodes, scene.render.dither_intensity = True, 0.0
    nodes, links = scene.node_tree.nodes, scene.node_tree.links
    nodes.clear()
    layers, blur = nodes.new('CompositorNodeRLayers'), nodes.new('CompositorNodeBilateralblur')
    output = nodes.new('CompositorNodeComposite')
    blur.iterations, blur.sigma_color, blur.sigma_space = strength, 0.06, 4.0
    links.new(layers.outputs["Image"], blur.inputs["Image"])
    links.new(layers.outputs["Image"], blur.inputs["Determinator"])
    links.new(blur.outputs["Image"], output.inputs["Image"])


def drawing(center, width):
    """Seen straight from above, in flat colors, as on paper that is `width` wide."""
    ground(PAPER, color='paper')
    for material in bpy.data.materials:
        flatten(material)
    camera((*center, 20.0), (*center, 0.0))
    bpy.context.scene.camera.data.type = 'ORTHO'
    bpy.context.scene.camera.data.ortho_scale = width
    bpy.context.scene.render.dither_intensity = 0.0


def flatten(material):
    """Let a material look the same in any light."""
    nodes, links = material.node_tree.nodes, material.node_tree.links
    light = nodes.new('ShaderNodeEmission')
    light.inputs["Color"].default_value = material.diffuse_color
    links.new(light.outputs["Emission"], nodes["Material Output"].inputs["Surface"])


def finish(name, samples=40, size=(960, 600)):
    """Save NAME.blend, render NAME.png, print what was made."""
    output = Path(sys.argv[sys.argv.index('--') + 1])
    _set_up(samples, size)
    for ob in bpy.context.selected_objects:
        ob.select_set(False)
    _save(output / f"{name}.blend")
    made = time.perf_counter() - _started
    scene = bpy.context.scene
    if os.environ.get('SPLINEWRIGHT_DRAFT'):
        scene.cycles.samples = max(1, samples // DRAFT)
        scene.render.resolution_percentage = DRAFT_PERCENTAGE
    _render(output / f"{name}.png")
    _print_table(name, made, time.perf_counter() - _started - made)


def render(path, samples, size):
    """Render a PNG of a size in pixels."""
    _set_up(samples, size)
    _render(path)


def _set_up(samples, size):
    scene = bpy.context.scene
    scene.render.engine = 'CYCLES'
    scene.cycles.device, scene.cycles.samples, scene.cycles.use_denoising = 'CPU', samples, False
    scene.render.resolution_x, scene.render.resolution_y = size
    scene.view_settings.view_transform = 'Standard'
    scene.render.image_settings.compression = 100
    for setting in dir(scene.render):       # pictures carry no dates and no paths
        if setting.startswith('use_stamp_'):
            setattr(scene.render, setting, False)


def _render(path):
    bpy.context.scene.render.filepath = str(path)
    bpy.ops.render.render(write_still=True)


def _save(path):
    """Save by way of a temporary folder, since a file keeps the place it was saved at."""
    bpy.context.preferences.filepaths.save_version = 0
    bpy.context.scene.render.filepath = f"//{path.stem}.png"
    with tempfile.TemporaryDirectory() as folder:
        place = Path(folder) / path.name
        bpy.ops.wm.save_as_mainfile(filepath=str(place), compress=True, relative_remap=False, copy=True)
        shutil.move(place, path)


def _print_table(name, made, rendered):
    print(f"\n{name}.blend: made in {made:.2f} s, rendered in {rendered:.1f} s")
    print(f"  {'object':<28}{'operator':<20}{'pieces':>7}{'points':>8}{'vertices':>10}{'ms':>8}")
    for ob, operator, ms in _rows:
        value = ob.data.splinewright.value
        pieces = len(value) if hasattr(value, '__len__') else 1
        points = sum(item.points.size // 3 for item in value) if isinstance(value, list) else value.points.size // 3
        count = (len(ob.data.vertices) if ob.type == 'MESH'
                 else sum(len(spline.points) for spline in ob.data.splines))
        print(f"  {ob.name:<28}{operator:<20}{pieces:>7}{points:>8}{count:>10}{ms:>8.1f}")
    sys.stdout.flush()
