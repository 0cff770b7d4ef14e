"""Over the 3D view: what the Overlays popover asks for, of selected shapes and those whose nets are out."""

import bpy
import gpu

from ..bridge import shape, sights
from ..bridge.file_state import state
from ..bridge.net import net_object
from . import colors, editing, strokes, surface_paint

_handles = ()


def draw():
    """Called by Blender for each 3D view."""
    context = bpy.context
    chosen = sights.of(context.scene)
    if not context.space_data.overlay.show_overlays or not _is_any_on(chosen):
        return
    obs = shapes_in_hand(context)
    if chosen.stripes or chosen.curvature:
        surface_paint.draw(chosen, obs)
    for ob in obs:
        with gpu.matrix.push_pop(), strokes.nearer():
            gpu.matrix.multiply_matrix(ob.matrix_world)
            for behind, drawn in _strokes(ob, chosen):
                gpu.state.depth_test_set('NONE' if behind or ob.show_in_front else 'LESS_EQUAL')
                strokes.draw(drawn)
    gpu.state.depth_test_set('NONE')


def draw_legend():
    """Called by Blender for each 3D view, in pixels."""
    context = bpy.context
    chosen = sights.of(context.scene)
    if chosen.curvature and context.space_data.overlay.show_overlays:
        surface_paint.draw_legend(context, chosen, shapes_in_hand(context))


def _is_any_on(chosen):
    return chosen.curve or chosen.polygon or chosen.knots or chosen.isocurves or chosen.comb or (
        chosen.stripes or chosen.curvature)


def shapes_in_hand(context):
    """Shapes that are selected or active, and those whose nets are out, as far as they are seen."""
    found = {ob: None for ob in (*context.selected_objects, context.object) if shape.has_shape(ob)}
    for held in editing.nets() if state.nets else ():
        owner = net_object.shape_of(held)
        if shape.has_shape(owner):
            found[owner] = None
    return [ob for ob in found if ob.visible_get()]


def _strokes(ob, chosen):
    """(whether what lies before is drawn over, Strokes) of an object; what lies above others comes last."""
    data, is_curve, behind = ob.data, ob.type == 'CURVE', chosen.points_behind
    if chosen.isocurves and not is_curve:
        yield False, sights.kept(data, 'isocurves', (chosen.isocurve_count,), _isocurves)
    if chosen.knots and not is_curve:
        yield False, sights.kept(data, 'knots', (), _knot_lines)
    if chosen.polygon and not _is_net_out(data):
        yield behind, sights.kept(data, 'polygon', (), _polygon)
    if chosen.comb and is_curve:
        yield behind, sights.kept(data, 'comb', (chosen.comb_density, chosen.comb_scale), _comb)
    if chosen.curve and is_curve:
        yield behind, sights.kept(data, 'curve', (), _curve)
    if chosen.knots and is_curve:
        yield behind, sights.kept(data, 'knots', (), _knot_marks)


def _is_net_out(data):
    """Whether a net is in Edit Mode that edits this: then Blender draws it."""
    token = net_object.editor(data)
    return token is not None and any(
        held.mode == 'EDIT' and net_object.token(held.data) == token for held in editing.nets())


def _isocurves(data, count):
    return [strokes.lines(sights.isocurves_of(data, count), lambda: colors.ISOCURVES, 1.2)]


def _knot_lines(data):
    return [strokes.lines(sights.knots_of(data), lambda: colors.KNOTS_OF_PATCHES, 2.4)]


def _knot_marks(data):
    marks = sights.knots_of(data)
    return [strokes.points(marks, lambda: colors.RIM, lambda: 9.0),
            strokes.points(marks, lambda: colors.KNOTS, lambda: 6.0)]


def _polygon(data):
    found = sights.polygon_of(data)
    rows = [strokes.lines(pairs, lambda axis=axis: colors.of_net()[axis], 1.5) for axis, pairs in enumerate(found.rows)]
    return [*rows, strokes.arrows(found.arrows, colors.of_arrows),
            strokes.points(found.points, colors.of_points, lambda: 5.0)]


def _comb(data, density, scale):
    found = sights.comb_of(data, density, scale)
    return [strokes.lines(found.teeth, lambda: colors.TEETH, 1.0), strokes.lines(found.back, lambda: colors.BACK, 1.8)]


def _curve(data):
    return [strokes.lines(sights.curves_of(data), lambda: colors.CURVE, 2.5)]


CLASSES = ()


def register():
    global _handles
    if not bpy.app.background:
        view = bpy.types.SpaceView3D
        _handles = (view.draw_handler_add(draw, (), 'WINDOW', 'POST_VIEW'),
                    view.draw_handler_add(draw_legend, (), 'WINDOW', 'POST_PIXEL'))


def unregister():
    global _handles
    for handle in _handles:
        bpy.types.SpaceView3D.draw_handler_remove(handle, 'WINDOW')
    _handles = ()
