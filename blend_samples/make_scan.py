"""A noisy cloud of points, as of a scan, and the clean patch that Fit Patch makes near it, colored by how far the points are."""

import sys
from pathlib import Path

import bpy
import numpy as np
from mathutils import Vector
from mathutils.kdtree import KDTree

sys.path.insert(0, str(Path(__file__).parent))
import stage

COUNT, NOISE = 9000, 0.012
#: The distance that has the last color, and of how many points near a place the mean is shown.
REACH, NEAR = 0.06, 16
#: From none to REACH.
COLORS = np.array([(0.06, 0.16, 0.42), (0.05, 0.40, 0.45), (0.60, 0.62, 0.20), (0.85, 0.35, 0.08), (0.62, 0.03, 0.03)])
COLUMN = "Distance"
GROUND = -0.35


def heights(x, y):
    """A hill with a fold across it, too sharp for the points that the patch is given."""
    fold = np.exp(-((y - 0.3 * x + 0.55) / 0.16)**2) / (1 + np.exp(-4 * (x + 0.2)))
    return 1.3 * np.exp(-x**2 / 5 - y**2 / 2.4) + 0.22 * np.sin(1.3 * x) + 0.34 * fold


def scanned():
    rng = np.random.default_rng(14)
    x, y = rng.uniform((-3, -2), (3, 2), (COUNT, 2)).T
    return np.stack([x, y, heights(x, y)], -1) + rng.normal(0, NOISE, (COUNT, 3))


def cloud(points, name):
    mesh = bpy.data.meshes.new(name)
    mesh.vertices.add(len(points))
    mesh.vertices.foreach_set('co', points.astype(np.float32).ravel())
    mesh.update()
    ob = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(ob)
    return ob


def shown_as_balls(ob, radius):
    bpy.ops.mesh.primitive_ico_sphere_add(subdivisions=2, radius=radius)
    ball = bpy.context.object
    ball.name, ball.parent = "Point", ob
    for face in ball.data.polygons:
        face.use_smooth = True
    ball.data.materials.append(stage.paint('ink'))
    ob.instance_type = 'VERTS'


def color(ob, distances):
    """Give the vertices of a mesh colors of distances, and a material that shows them."""
    parts = np.clip(distances / REACH, 0, 1) * (len(COLORS) - 1)
    shades = np.stack([np.interp(parts, range(len(COLORS)), channel) for channel in COLORS.T] + [np.ones(len(parts))], -1)
    column = ob.data.attributes.new(COLUMN, 'FLOAT_COLOR', 'POINT')
    column.data.foreach_set('color', shades.astype(np.float32).ravel())
    if COLUMN not in bpy.data.materials:
        material = bpy.data.materials.new(COLUMN)
        material.use_nodes = True
        nodes, links = material.node_tree.nodes, material.node_tree.links
        attribute = nodes.new('ShaderNodeAttribute')
        attribute.attribute_name = COLUMN
        shader = nodes["Principled BSDF"]
        shader.inputs["Roughness"].default_value = 0.5
        links.new(attribute.outputs["Color"], shader.inputs["Base Color"])
    ob.data.materials.clear()
    ob.data.materials.append(bpy.data.materials[COLUMN])


def mean_near(vertices, points, distances):
    """Of each vertex the mean distance of the points that are nearest to it."""
    tree = KDTree(len(points))
    for i, point in enumerate(points):
        tree.insert(Vector(point), i)
    tree.balance()
    return np.array([distances[[i for _, i, _ in tree.find_n(vertex.co, NEAR)]].mean() for vertex in vertices])


def legend(left, right, y):
    steps = 65
    x = np.linspace(left, right, steps)
    bpy.ops.mesh.primitive_grid_add(x_subdivisions=steps - 1, y_subdivisions=1, size=1)
    bar = bpy.context.object
    bar.name = "Legend"
    across = np.array([vertex.co[:2] for vertex in bar.data.vertices])
    bar.scale, bar.location = (right - left, 0.16, 1), (0.5 * (left + right), y, GROUND + 0.01)
    color(bar, REACH * (across[:, 0] + 0.5))
    for part in (0.0, 0.5, 1.0):
        stage.label(f"{part * REACH:g}", (left + part * (right - left), y - 0.24), 0.22, 'CENTER', GROUND + 0.01)


stage.begin()
points = scanned()
scan = cloud(points, "Scan")
patch = stage.fitted(scan, "Fitted patch", count_u=16, count_v=12, smoothing=1e-7, resolution_u=8, resolution_v=8)
distances = patch.data.splinewright.value.nearest(np.array([vertex.co for vertex in scan.data.vertices])).distances
color(patch, mean_near(patch.data.vertices, points, distances))
fading = np.random.default_rng(15).random(COUNT) < np.clip(-0.25 - 0.6 * points[:, 0], 0, 1)
shown_as_balls(cloud(points[fading], "Points that are seen"), 0.016)
scan.hide_render = True
sights = bpy.context.scene.splinewright_sights
sights.deviation, sights.deviation_object = True, scan
legend(-1.7, 1.1, -2.6)
stage.ground(GROUND, color='paper')
stage.camera((1.2, -9.6, 6.2), (0.0, -0.5, 0.05), 50)
stage.smooth(1)
stage.finish("scan", samples=48, size=(960, 560))
