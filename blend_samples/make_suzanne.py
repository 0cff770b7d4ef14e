"""Blender's monkey as exact patches that follow its mesh: move a vertex of the mesh, and the surface follows."""

import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).parent))
import stage

stage.begin()
bpy.ops.mesh.primitive_monkey_add(location=(0, 0, 0.985), rotation=(-0.62, 0, 0.35))
mesh = bpy.context.object
mesh.hide_render, mesh.display_type = True, 'WIRE'
monkey = stage.follow('add_of_mesh', [mesh], "Suzanne as patches", 'clay', resolution_u=1)
stage.ground(color='cloth')
stage.lamp((-3, -4, 5), (0, 0, 1), 130, 2)
stage.lamp((5, -1, 3), (0, 0, 1), 60, 2)
stage.camera((1.3, -6.2, 2.6), (0.0, 0, 0.85), 66)
stage.smooth()
stage.finish("suzanne", samples=48, size=(640, 520))
