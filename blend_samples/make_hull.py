"""A planing hull whose chine is one edge: the half is one loft through contours of keel, chine and sheer, whose corners
Match Corners joins by one line of knots; Mirror makes the other half. The spray rails are pipes along the chine, which was
extracted from the loft. The frames go through the vertices of lines; they are in the file, hidden from the picture only: move
one, and the hull follows.
"""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
import stage

#: Frames from the stern to the bow: (place, half width and height of the sheer, of the chine, height of the keel).
FRAMES = ((-2.4, 0.86, 0.95, 0.74, 0.34, 0.10), (-1.2, 0.92, 0.98, 0.78, 0.35, 0.02), (0.2, 0.92, 1.04, 0.74, 0.40, 0.0),
          (1.4, 0.72, 1.14, 0.50, 0.54, 0.06), (2.2, 0.40, 1.26, 0.23, 0.74, 0.30), (2.75, 0.06, 1.38, 0.035, 0.98, 0.78))


def contour(points, name, closed=False):
    return stage.through(points, name, 'contour_through_points', closed=closed, corners='sharp')


def frame(place, wide, high, chine, low, keel):
    return [(place, 0, keel), (place, chine, low), (place, wide, high)]


def across(ob):
    """The object and its image."""
    made = stage.follow('add_mirror', [ob], f"{ob.name}, both", ob.data.materials[0].name, axis='y', smooth=False)
    ob.hide_render = True
    return made


def rail(border, name, radius, **settings):
    """A pipe along a curve of the half, and its image."""
    curve = stage.follow(border, [half], f"Curve of the {name.lower()}", 'ink', **settings)
    curve.hide_render = True
    pipe = {'radius': radius, 'end_radius': 0.6 * radius, 'caps': 'round', 'resolution_u': 6}
    across(stage.follow('add_pipe', [curve], name, 'biscuit', **pipe))


stage.begin()
frames = [contour(frame(*numbers), f"Frame {i + 1}") for i, numbers in enumerate(FRAMES)]
half = stage.follow('add_loft', frames, "Half", 'sea')
half.data.splinewright.resolution_u, half.data.splinewright.resolution_v = 6, 12
chine_at = half.data.splinewright.value.knots[0][2]
rail('extract_isocurve', "Spray rail", 0.03, direction='U', parameter_u=chine_at)
rail('extract_boundary', "Gunwale", 0.045, side='U_END')
across(half)
place, wide, high, chine, low, keel = FRAMES[0]
border = contour([(place, 0, keel), (place, chine, low), (place, wide, high), (place, -wide, high), (place, -chine, low)],
                 "Border of the transom", closed=True)
stage.follow('add_filling', [border], "Transom", 'biscuit')
stage.ground(color='cloth')
stage.lamp((-4, -5, 6), (0, 0, 0.6), 190, 3)
stage.lamp((6, -3, 3), (0.5, 0, 0.6), 120, 2)
stage.camera((4.6, -7.4, 2.6), (0.1, 0, 0.55), 56)
stage.smooth()
stage.finish("hull", samples=48, size=(800, 460))
