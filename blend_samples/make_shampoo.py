"""A shampoo bottle: one loft through ellipses with caps at both ends, and a screw cap that is revolved from a contour with round
corners. Every curve is a circle that is scaled, or goes through the vertices of a line; they are in the file, hidden from the
picture only: scale one, and the bottle follows.
"""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
import stage

stage.ROUGHNESS['sea'] = 0.16
#: (height, half width, half depth) from the foot to the rim of the neck.
SECTIONS = ((0.0, 0.72, 0.42), (0.02, 0.83, 0.51), (0.12, 0.86, 0.53), (0.75, 0.90, 0.55), (1.4, 0.86, 0.53), (1.95, 0.72, 0.48),
            (2.30, 0.28, 0.28), (2.36, 0.25, 0.25), (2.62, 0.25, 0.25))
#: (radius, height)
CAP = ((0.0, 3.02), (0.27, 3.02), (0.34, 2.40), (0.0, 2.40))
TUBE = ((0.0, 3.30), (0.055, 3.30), (0.075, 2.95), (0.0, 2.95))


def section(height, width, depth, name):
    ob = stage.add('add_circle', name, (0, 0, height), color='ink', form='deformable', tolerance=1e-5)
    ob.scale = width, depth, 1
    ob.hide_render = True
    return ob


def revolved(profile, radius, name, color):
    contour = stage.through([(x, 0, z) for x, z in profile], f"Contour of the {name.lower()}", 'contour_through_points',
                            corners='round', corner_size=radius)
    ob = stage.follow('add_revolve', [contour], name, color, axis='z')
    ob.data.splinewright.resolution_u, ob.data.splinewright.resolution_v = 20, 6


stage.begin()
sections = [section(*form, f"Section {i + 1}") for i, form in enumerate(SECTIONS)]
body = stage.follow('add_loft', sections, "Bottle", 'sea', style='loose', caps='both')
body.data.splinewright.resolution_u = body.data.splinewright.resolution_v = 8
revolved(CAP, 0.06, "Cap", 'porcelain')
revolved(TUBE, 0.03, "Nozzle", 'porcelain')
stage.ground(color='cloth')
stage.lamp((-4, -5, 5), (0, 0, 1.2), 200, 1.5, 4)
stage.lamp((5, -2, 4), (0, 0, 1.2), 120, 1, 4)
stage.camera((2.9, -8.2, 5.4), (0.0, 0.0, 1.52), lens=72)
stage.smooth()
stage.finish("shampoo", samples=48, size=(560, 720))
