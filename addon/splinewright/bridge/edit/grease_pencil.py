"""Strokes that were drawn, with Grease Pencil or as annotations, in all versions of Blender."""

import numpy as np

from ...core.base.failures import Refusal

_OBJECTS = ('GPENCIL', 'GREASEPENCIL')
#: Blender 4.3 does not say where a stroke lies.
_IN_SPACE = '3DSPACE'


def is_drawn(ob):
    """Whether it is a Grease Pencil object."""
    return ob.type in _OBJECTS


def of_object(ob, frame):
    """[((n, 3) points, whether they close)] that a Grease Pencil object shows at a frame of the scene, in its space."""
    found = []
    for layer in ob.data.layers:
        if layer.hide:
            continue
        matrix = np.array(getattr(layer, 'matrix_layer', None) or getattr(layer, 'matrix_local', None) or np.eye(4),
                          dtype=np.float64)
        for stroke in _strokes(layer, frame):
            points = np.array([_place(point) for point in stroke.points], dtype=np.float64).reshape(-1, 3)
            closed = stroke.cyclic if hasattr(stroke, 'cyclic') else stroke.use_cyclic
            found.append((points @ matrix[:3, :3].T + matrix[:3, 3], bool(closed)))
    return found


def of_annotations(context):
    """The same of the annotations that lie in space, which the view or the scene shows.

    Raises Refusal where there are none, or they lie on the screen alone.
    """
    strokes = [stroke for layer in _layers(context) for stroke in _strokes(layer, context.scene.frame_current)]
    in_space = [stroke for stroke in strokes if getattr(stroke, 'display_mode', _IN_SPACE) == _IN_SPACE]
    if strokes and not in_space:
        raise Refusal("the annotations lie on the screen: draw them with Placement at the 3D cursor or on surfaces")
    return [(np.array([point.co for point in stroke.points], dtype=np.float64).reshape(-1, 3), False)
            for stroke in in_space]


def has_annotations(context):
    """Whether some are shown."""
    return any(len(_strokes(layer, context.scene.frame_current)) for layer in _layers(context))


def _layers(context):
    data = getattr(context, 'annotation_data', None) or _of_scene(context.scene)
    return [layer for layer in data.layers if not layer.annotation_hide] if data else []


def _of_scene(scene):
    return scene.annotation if hasattr(scene, 'annotation') else scene.grease_pencil


def _strokes(layer, frame):
    """Of the drawing that a layer shows: the last one that begins by then."""
    shown = max((each for each in layer.frames if each.frame_number <= frame), key=lambda each: each.frame_number,
                default=None)
    if shown is None:
        return ()
    return shown.drawing.strokes if hasattr(shown, 'drawing') else shown.strokes


def _place(point):
    return point.position if hasattr(point, 'position') else point.co
