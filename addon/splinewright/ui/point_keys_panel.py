"""Control points with keys, in the sidebar: their numbers as fields that keys and drivers are set on."""

import bpy
import numpy as np

from ..bridge.cage import net_object
from ..bridge.data import store
from ..bridge.keys import point_keys
from ..bridge.net import live, point_keying, selection
from ..core.base.words import phrase, say
from ..core.shape import keyed_rows
from . import active_shape, net_panel, texts
from .sub_panel import SubPanel

#: Points that are shown at once.
_MOST = 8


class SPLINEWRIGHT_PT_keyed_points(SubPanel, bpy.types.Panel):
    bl_idname = "SPLINEWRIGHT_PT_keyed_points"
    bl_label = "Keyed Points"

    @classmethod
    def poll(cls, context):
        owner = active_shape.shape_of(context.object)
        return owner is not None and active_shape.is_free(owner)

    def draw(self, context):
        data = active_shape.shape_of(context.object).data
        column = self.layout.column(align=True)
        column.operator("splinewright.key_points", icon='KEY_HLT')
        column.operator("splinewright.clear_point_keys", icon='KEY_DEHLT')
        of_item = point_keys.rows(data)
        gone = int((of_item == point_keys.GONE).sum())
        if gone:
            texts.draw_note(self.layout, phrase("Keys of {count} points that are gone go when the net is left",
                                                count=gone) if gone > 1 else
                            "Keys of a point that is gone go when the net is left")
        try:
            has_weight, names = keyed_rows.weighted(store.read(data)), _names(context.object, data, of_item)
        except store.UnreadableDefinition:
            return                      # the panel above says it
        if not names:
            self.layout.label(text="None selected" if len(of_item) else "None")
        for i, name in list(names.items())[:_MOST]:
            _draw_point(self.layout, point_keys.of(data)[i], name, has_weight[of_item[i]])
        if len(names) > _MOST:
            self.layout.label(text=say(phrase("and {count} more", count=len(names) - _MOST)))


def _names(ob, data, of_item):
    """{number of an item: name of its point} of the selected points of a net in Edit Mode, in Object Mode of all."""
    there = np.flatnonzero((0 <= of_item) & (of_item < len(store.read(data).pool))).tolist()
    if not net_object.is_net(ob) or ob.mode != 'EDIT':
        return {i: phrase("Point {number}", number=of_item[i]) for i in there}
    session = live.known_session(ob.data)
    if session is None:
        return {}
    vertices = selection.selected(ob, session.net)
    vertex_of = dict(zip(point_keying.rows_of(session.net, data, vertices), vertices))
    return {i: net_panel.name_of(session.net, vertex_of[of_item[i]]) for i in there if of_item[i] in vertex_of}


def _draw_point(layout, item, name, has_weight):
    column = layout.column(align=True)
    column.label(text=say(name))
    for axis in range(3):
        column.prop(item, "place", index=axis, text=say("XYZ"[axis]))
    if has_weight:
        column.prop(item, "weight", text="Weight")


CLASSES = (SPLINEWRIGHT_PT_keyed_points,)
