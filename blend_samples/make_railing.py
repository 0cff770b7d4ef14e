"""A path over a hill and its railing: a curve is projected onto a patch and follows both; posts stand at equal parts of it."""

import sys
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
import stage

POSTS, HEIGHT = 24, 0.42


def post():
    """Its foot is its origin."""
    bpy.ops.mesh.primitive_cylinder_add(vertices=24, radius=0.022, depth=HEIGHT, location=(0, 0, -20))
    ob = bpy.context.object
    ob.name = "Post"
    for vertex in ob.data.vertices:
        vertex.co.z += HEIGHT / 2
    ob.data.materials.append(stage.paint('snow'))
    return ob


stage.begin()
sc = stage.splinecore()
x, y = np.meshgrid(np.linspace(-4, 4, 8), np.linspace(-3, 3, 7), indexing='ij')
heights = 1.6 * np.exp(-((x - 0.6)**2 / 4 + (y + 0.3)**2 / 3)) + 0.5 * np.exp(-((x + 2.6)**2 + (y - 1.4)**2))
knots = [np.concatenate([np.zeros(3), np.linspace(0, 1, count - 2), np.ones(3)]) for count in x.shape]
hill = stage.patch(sc.NurbsPatch((3, 3), knots, np.stack([x, y, heights], -1)), "Hill", color='moss', resolution=12)
path = stage.shape(sc.fit.interpolate([(-3.6, -1.8, 2), (-2.0, -1.9, 2), (-0.4, -0.9, 2.4), (1.0, -0.6, 2.4), (2.0, -1.6, 2),
                                       (3.6, -1.2, 1.6)]).value, "Path from above", color='ink', resolution_u=24)
foot = stage.follow('add_projected', [path, hill], "Path on the hill", color='sand', tolerance=0.001)
stage.tube(foot, 0.035)
raised = np.eye(4)
raised[2, 3] = HEIGHT
stage.tube(stage.shape(foot.data.splinewright.value.transformed(raised), "Handrail", color='clay', resolution_u=16), 0.03)
one = post()
bpy.ops.object.select_all(action='DESELECT')
foot.select_set(True)
bpy.context.view_layer.objects.active = foot
bpy.ops.splinewright.divide_equally(make='COPIES', source=one.name, count=POSTS, turned='standing')
stage.ground(-0.02, color='paper')
stage.camera((4.6, -7.4, 4.9), (-0.35, 0.0, 0.5), lens=38)
stage.smooth()
stage.finish("railing", samples=48)
