"""The way out of a net, in the panel of its shape; and its control points, in the sidebar."""

import bpy

from ..bridge.cage import net_object
from ..bridge.data import store
from ..bridge.data.settings import overlays_of
from ..bridge.net import live
from ..bridge.recipes import recipes
from ..core.base.words import phrase, say
from ..core.shape import describe
from . import active_shape, handles_panel, net_props, texts
from .sub_panel import SidePanel

#: Pieces whose knots are shown at once.
_PIECES = 4
#: Points whose coordinates are shown one above the other; of more side by side.
_IN_COLUMNS = 2


class SPLINEWRIGHT_PT_points(SidePanel, bpy.types.Panel):
    bl_idname = "SPLINEWRIGHT_PT_points"
    bl_label = "Control Points"
    bl_order = 4

    @classmethod
    def poll(cls, context):
        ob = context.object
        return net_object.is_net(ob) and ob.mode == 'EDIT' and active_shape.shape_of(ob) is not None and live.known_session(ob.data) is not None

    def draw(self, context):
        ob, owner, layout = context.object, active_shape.shape_of(context.object), self.layout
        session, has_recipe = live.known_session(ob.data), recipes.has(owner.data)
        _draw_points(layout, ob, session, has_weights=not has_recipe)
        try:
            handles_panel.draw(layout, ob.data, owner.data, session, net_props.chosen(ob.data)[1])
            if not has_recipe:
                _draw_knots(layout, store.read(owner.data), active_shape.pieces_of_points(ob))
        except store.UnreadableDefinition as error:
            texts.draw_problem(layout, str(error))


def draw_state(layout, ob):
    """For a net object, in Edit Mode or kept: the way out of it, or back, and what its shape does not take."""
    owner = net_object.shape_of(ob)
    if owner is None:
        texts.draw_problem(layout, live.problem(ob) or "The shape of this net was deleted, or is in no scene")
        return
    if ob.mode == 'EDIT':
        layout.operator("splinewright.leave_net", text=say(phrase("Done with {name}", name=texts.short(owner.name))), icon='CHECKMARK')
        layout.prop(overlays_of(bpy.context.scene), "points_behind", text="X-Ray Control Points")
    else:
        layout.operator("splinewright.edit_net", text=say(phrase("Continue with {name}", name=texts.short(owner.name))), icon='EDITMODE_HLT')
    problem, note = live.problem(ob), live.note(ob)
    if problem:
        texts.draw_problem(layout, problem)
    elif note:
        texts.draw_note(layout, note)
    if (problem or note) and ob.mode == 'EDIT':
        layout.operator("splinewright.renew_net", icon='FILE_REFRESH')


def _draw_points(layout, ob, session, has_weights):
    data = ob.data
    _, vertices = net_props.chosen(data)
    box = layout.column(align=True)
    if not vertices:
        texts.draw_note(box, "Select points to edit them", icon='NONE')
        return
    box.label(text=say(phrase("{count} of {whole} points and handles", count=len(vertices), whole=int((session.net.rows >= 0).sum()))))
    points = data.splinewright_points
    box.row(align=True).prop(points, "space", expand=True)
    if len(vertices) > 1:
        column = box.column(align=True)
        column.label(text="Median")
        for axis in range(3):
            column.prop(points, "median", index=axis, text="XYZ"[axis])
    for i, vertex in enumerate(vertices[:net_props.SHOWN]):
        column = box.column(align=True)
        column.label(text=say(name_of(session.net, vertex)))
        axes = column.row(align=True) if len(vertices) > _IN_COLUMNS else column
        for axis in range(3):           # the text is what Undo History says
            axes.prop(points, "numbers", index=4 * i + axis, text="XYZ"[axis])
        if has_weights and session.net.weighted[vertex]:
            column.prop(points, "numbers", index=4 * i + 3, text="Weight")
    hidden = len(vertices) - net_props.SHOWN
    if hidden > 0:
        box.label(text=say(phrase("and {hidden} more", hidden=hidden)))
    if not has_weights:
        return
    if len(vertices) > 1 and session.net.weighted[vertices].any():
        box.prop(points, "weight", text="All Weights")
    column = layout.column(align=True)
    column.operator("splinewright.point_to_infinity", text="To Infinity")
    column.operator("splinewright.point_from_infinity", text="Back")


def name_of(net, vertex):
    """What a vertex of a net is called."""
    if net.origins[vertex, 0] < 0:
        return phrase("Point {vertex}", vertex=vertex)
    if any(head == vertex for _, head in net.arrows):
        return phrase("Direction at infinity {vertex}", vertex=vertex)
    return phrase("Handle {vertex}", vertex=vertex)


def _draw_knots(layout, definition, pieces):
    """The knots of each axis of some pieces, each with a button to edit them."""
    with_knots = [i for i in pieces if definition.pieces[i].knots]
    for i in with_knots[:_PIECES]:
        piece = definition.pieces[i]
        label = "Parameters" if piece.kind == 'hermite' else "Knots"
        axes = ("",) if definition.has_curves else ("U", "V")
        for axis, knots in zip(axes, piece.knots):
            name = " ".join(filter(None, (say(label), axis, str(i + 1) if len(definition.pieces) > 1 else "")))
            row = layout.row(align=True)
            row.label(text=f"{name}: {describe.knots_text(knots, 8)}")
            button = row.operator("splinewright.set_knots", text="", icon='GREASEPENCIL')
            button.piece, button.axis = i + 1, axis or 'U'
    if len(with_knots) > _PIECES:
        layout.label(text=say(phrase("Knots of {count} more: select their points", count=len(with_knots) - _PIECES)))


CLASSES = (SPLINEWRIGHT_PT_points,)
