"""A hull of six frames, lofted, mirrored and offset by a script: it uses the public interface alone.

    blender --background --python hull.py -- hull.blend
"""

import math
import sys

import bpy

try:
    from bl_ext.user_default.splinewright import api        # installed as an extension
except ImportError:
    from splinewright import api                            # installed as an add-on

LENGTH, WIDTH, DEPTH = 6.0, 1.2, 0.8


def frame(number, count=6):
    """The half of a frame from the keel to the deck, as an exact cubic curve."""
    along = number / (count - 1)
    width, depth = WIDTH * math.sin(math.pi * (0.08 + 0.72 * along)), DEPTH * (1.0 - 0.4 * along ** 2)
    points = [(along * LENGTH, 0.0, -depth), (along * LENGTH, 0.8 * width, -depth), (along * LENGTH, width, -0.3 * depth),
              (along * LENGTH, width, 0.2)]
    curve = api.splinecore.NurbsCurve(3, [0, 0, 0, 0, 1, 1, 1, 1], points)
    return api.new_shape(f"Frame {number + 1}", curve)


frames = [frame(number) for number in range(6)]
half = api.loft(frames)
hull = api.make('mirror', half, {'axis': 'y'})
lining = api.offset(half, -0.05, tolerance=1e-3)

# One frame is made wider. What is made from it follows when the script asks for that.
wider = api.value(frames[3])
api.set_value(frames[3], wider.with_points(wider.points * (1.0, 1.15, 1.0)))
problems = api.update()
for ob, sentence in problems.items():
    print(f"{ob.name}: {sentence}")

print("The hull is made from", ", ".join(ob.name for ob in api.inputs(hull)))
print("Frame 4 is used by", ", ".join(ob.name for ob in api.followers(frames[3])))
if '--' in sys.argv and not problems:
    bpy.ops.wm.save_as_mainfile(filepath=sys.argv[sys.argv.index('--') + 1])
