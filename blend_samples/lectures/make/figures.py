"""Figures of what a scene shows, as sheets and the page of pictures have them."""

import numpy as np

from making import part

drawn, overlays, page, piece_materials, shape = (part(name) for name in (
    'bridge.figures.drawn', 'bridge.analysis.overlays', 'core.figures.page', 'bridge.shape.piece_materials', 'bridge.shape.shape'))
#: Rows to the right, up, and to the eye.
TURNS = {
    'TOP': np.eye(3), 'FRONT': np.array([(1.0, 0, 0), (0, 0, 1), (0, -1, 0)]), 'RIGHT': np.array([(0.0, 1, 0), (0, 0, 1), (1, 0, 0)]),
    'FREE': np.array([(0.8, 0.6, 0.0), (-0.3, 0.4, np.sqrt(0.75)), (0.6 * np.sqrt(0.75), -0.8 * np.sqrt(0.75), 0.5)])}


def seen(scene):
    """(drawn.View, (n, 3) points in the world) of all shapes of a scene; selected ones have the overlays that are switched on."""
    layer, chosen = scene.view_layers[0], scene.splinewright_sights
    layer.update()
    obs = [ob for ob in layer.objects if shape.has_shape(ob) and ob.visible_get(view_layer=layer)]
    selected = [ob for ob in obs if ob.select_get(view_layer=layer)]
    pictures = [ob for ob in obs if ob.type == 'CURVE' and piece_materials.KEY in ob.data.keys()]
    view = drawn.View(scene, layer, layer.depsgraph, None, tuple(selected) if chosen.polygon else (),
                      tuple(dict.fromkeys([*selected, *pictures])) if chosen.labels else (), tuple(selected))
    return view, np.concatenate([_points(ob, ob in view.nets) for ob in obs])


def draw(view, points, turn, width, height, margin):
    """The drawn.Drawing of a view on a page of a size in mm, as large as its margin allows."""
    return drawn.figure(view, page.around(points, turn, width, height, margin), drawn.Wanted(curves=0.4, isocurves=0.12, letters=2.8, points=1.1))


def turn(told, points):
    """Of steps of a lesson: from where the last one that says it is seen best; flat shapes from above."""
    said = next((step.view for step in reversed(told) if step.view), "")
    return TURNS[said or ('TOP' if not np.ptp(points[:, 2]) else 'FREE')]


def _points(ob, with_net):
    """(n, 3): of a shape, and of its control net where it is drawn, in the world."""
    world = np.array(ob.matrix_world, dtype=np.float64)
    found = [shape.points_of(ob.data)]
    if with_net:
        net = overlays.polygon_of(ob.data)
        found += [np.reshape(lines, (-1, 3)) for lines in (*net.rows, net.arrows, net.points)]
    return np.concatenate(found) @ world[:3, :3].T + world[:3, 3]
