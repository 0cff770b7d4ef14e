"""Two patches joined C0, G1, C1 and G2, under stripes that show what the eye sees of it (lecture row S21)."""

import sys
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
import stage

stage.begin()
sc = stage.splinecore()


def fender(start, heights):
    """A bicubic patch over [start, start + 1.5] x [0, 2.4], the heights of whose points are given along x."""
    x, y = np.meshgrid(start + np.linspace(0, 1.5, 4), np.linspace(0, 2.4, 4), indexing='ij')
    bow = np.array([0.0, 0.55, 0.55, 0.0])
    return sc.BezierPatch(np.stack([x, y, np.array(heights)[:, None] + bow], -1))


stripes = stage.striped()
for number, name in enumerate(('C0', 'G1', 'C1', 'G2')):
    place = (4.2 * (number % 2), -4.0 * (number // 2), 0)
    first, second = fender(-1.5, (0.0, 0.55, 0.85, 0.9)), fender(0.0, (0.9, 0.55, 0.5, 0.55))
    joined = sc.build.join_patches(first, 'u_end', second, 'u_start', name, 'both')
    ob = stage.add('add_bezier_patch', f"Joined {name}", place, resolution_u=48, resolution_v=48)
    ob.data.splinewright.value = sc.PatchSet.from_patches([joined.first, joined.second])
    ob.data.materials[0] = stripes
    found = sc.seam_continuity(joined.first, 'u_end', joined.second, 'u_start')
    stage.label(f"{name}: C{found.c} G{found.g}\nangle {np.degrees(found.angle):.1f}°, curvature "
                f"{found.curvature_difference:.2f}", (place[0], place[1] - 0.55), 0.28, 'CENTER')
stage.ground(stage.PAPER, color='snow')
for color in ('snow', 'ink'):
    stage.flatten(bpy.data.materials[color])
stage.camera((2.1, -9.0, 13.5), (2.1, -1.3, 0.1), 55)
bpy.context.scene.render.dither_intensity = 0.0
stage.finish("seams", samples=16, size=(1060, 820))
