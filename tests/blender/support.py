"""The installed add-on, as the tests see it."""

import importlib

import bpy
import numpy as np


def _addon_name():
    for name in bpy.context.preferences.addons.keys():
        if name.split('.')[-1] == 'splinewright':
            return name
    raise RuntimeError("the add-on is not enabled: run these tests with tests/blender/run.sh")


ADDON = _addon_name()


def part(name):
    """A module of the add-on, by its dotted name below the add-on."""
    return importlib.import_module(f"{ADDON}.{name}")


splinecore = part('core.base.library').sc


def vertices(mesh):
    co = np.empty(3 * len(mesh.vertices), np.float32)
    mesh.vertices.foreach_get('co', co)
    return co.reshape(-1, 3)


def corner_normals(mesh):
    """Normals as Blender will draw them."""
    flat = np.empty(3 * len(mesh.loops), np.float32)
    if hasattr(mesh, 'corner_normals'):
        mesh.corner_normals.foreach_get('vector', flat)
    else:
        mesh.calc_normals_split()
        mesh.loops.foreach_get('normal', flat)
    return flat.reshape(-1, 3)


def curve_points(spline):
    co = np.empty(4 * len(spline.points), np.float32)
    spline.points.foreach_get('co', co)
    return co.reshape(-1, 4)[:, :3]


def scene_state():
    """Names of everything that a failed operator must leave as it was."""
    kinds = ('objects', 'meshes', 'curves', 'collections', 'materials')
    return {kind: sorted(block.name for block in getattr(bpy.data, kind)) for kind in kinds}
