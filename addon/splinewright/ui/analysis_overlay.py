"""Over the 3D view: what the Overlays popover asks for, of selected shapes and those whose nets are out."""

import bpy
import gpu

from ..bridge.cage import net_object
from ..bridge.data.settings import overlays_of
from ..bridge.shape import images, shape
from . import analysis_lines, deviation_paint, editing, line_batches, surface_paint
from .analysis_lines import SIGHTS
from .ui_state import ui_state


def draw_paint():
    """Called by Blender for each 3D view: what lies below all lines."""
    context, chosen = bpy.context, _chosen(('deviation', 'stripes', 'curvature'))
    if chosen is not None:
        if chosen.deviation:
            deviation_paint.draw(chosen, active_shapes(context))
        else:
            surface_paint.draw(chosen, shapes_seen(context))


def draw():
    """Called by Blender for each 3D view: lines and points."""
    context, chosen = bpy.context, _chosen(('deviation', *(sight.switch for sight in SIGHTS)), is_any_on=bool(ui_state.nets))
    if chosen is None:
        return
    if chosen.deviation:
        deviation_paint.draw_lines(chosen, active_shapes(context))
    for ob in shapes_seen(context):
        for matrix in images.of(ob, context.view_layer, context.space_data):
            with gpu.matrix.push_pop(), line_batches.nearer():
                gpu.matrix.multiply_matrix(matrix)
                for behind, drawn in _strokes(ob, chosen):
                    gpu.state.depth_test_set('NONE' if behind or ob.show_in_front else 'LESS_EQUAL')
                    line_batches.draw(drawn)
    gpu.state.depth_test_set('NONE')


def draw_legend():
    """Called by Blender for each 3D view, in pixels."""
    context, chosen = bpy.context, _chosen(('deviation', 'curvature'))
    if chosen is not None:
        if chosen.deviation:
            deviation_paint.draw_legend(context, chosen, active_shapes(context))
        else:
            surface_paint.draw_legend(context, chosen, shapes_seen(context))


def _chosen(switches, is_any_on=False):
    """The switches, or None where all of these are off, or overlays are."""
    chosen = overlays_of(bpy.context.scene)
    is_any_on = is_any_on or any(getattr(chosen, switch) for switch in switches)
    return chosen if is_any_on and bpy.context.space_data.overlay.show_overlays else None


def active_shapes(context):
    """Shapes that are selected or active, and those whose nets are out, as far as they are seen."""
    found = {ob: None for ob in (*context.selected_objects, context.object) if shape.has_shape(ob)}
    for held in editing.nets() if ui_state.nets else ():
        owner = net_object.shape_of(held)
        if shape.has_shape(owner):
            found[owner] = None
    space = context.space_data
    in_view = {'viewport': space} if space is not None and space.type == 'VIEW_3D' else {}
    return [ob for ob in found if ob.visible_get(**in_view)]


def shapes_seen(context):
    """active_shapes(), and those in selected instances of collections."""
    found = dict.fromkeys(active_shapes(context))
    for ob in context.selected_objects:
        found.update(dict.fromkeys(images.shapes_in(ob)))
    return list(found)


def _strokes(ob, chosen):
    """(whether what lies before is drawn over, Strokes) of an object; what lies above others comes last. A curve whose net is out
    is always drawn: Blender's thin line is lost beside its polygon."""
    is_out = _is_net_out(ob.data)
    for sight in SIGHTS:
        is_net = sight.switch == 'polygon'
        is_on = getattr(chosen, sight.switch) or (is_out and sight.switch == 'curve')
        if is_on and sight.type in ('', ob.type) and not (is_net and is_out):
            behind = chosen.points_behind and (is_net or ob.type == 'CURVE')
            yield behind, analysis_lines.prepared(sight, ob.data, chosen)


def _is_net_out(data):
    """Whether a net is in Edit Mode that edits this: then Blender draws it."""
    token = net_object.editor(data)
    return token is not None and any(
        held.mode == 'EDIT' and net_object.token(held.data) == token for held in editing.nets())
