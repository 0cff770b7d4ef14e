"""Control points with keys, in the sidebar: their numbers as fields that keys and drivers are set on."""

import bpy
import numpy as np

from ..bridge import point_keying, point_keys, store
from ..bridge.net import live, net_object, selection
from . import hand, texts
from .sub_panel import SubPanel

#: Points that are shown at once.
_MOST = 8


class SPLINEWRIGHT_PT_keyed_points(SubPanel, bpy.types.Panel):
    bl_idname = "SPLINEWRIGHT_PT_keyed_points"
    bl_label = "Keyed Points"

    @classmethod
    def poll(cls, context):
        owner = hand.shape_of(context.object)
        return owner is not None and hand.is_free(owner)

    def draw(self, context):
        data = hand.shape_of(context.object).data
        column = self.layout.column(align=True)
        column.operator("splinewright.key_points", icon='KEY_HLT')
        column.operator("splinewright.clear_point_keys", icon='KEY_DEHLT')
        of_item = point_keys.rows(data)
        gone = int((of_item == point_keys.GONE).sum())
        if gone:
            texts.draw_note(self.layout, f"Keys of {gone} points that are gone go with the net" if gone > 1 else
                            "Keys of a point that is gone go with the net")
        shown = _in_hand(context.object, data, of_item)
        if not len(shown):
            self.layout.label(text="None in hand" if len(of_item) else "None")
            return
        for i in shown[:_MOST].tolist():
            _draw_point(self.layout, point_keys.of(data)[i])
        if len(shown) > _MOST:
            self.layout.label(text=f"and {len(shown) - _MOST} more")


def _in_hand(ob, data, of_item):
    """Numbers of the items of the selected points of a net in Edit Mode, in Object Mode of all."""
    there = np.flatnonzero(of_item != point_keys.GONE)
    if not net_object.is_net(ob) or ob.mode != 'EDIT' or not len(there):
        return there
    session = live.known_session(ob.data)
    try:
        rows = point_keying.rows_of(session.net, data, selection.selected(ob, session.net)) if session else []
    except store.UnreadableDefinition:
        return there[:0]                # the panel above says it
    return there[np.isin(of_item[there], rows)]


def _draw_point(layout, item):
    column = layout.column(align=True)
    column.label(text=f"Point {item.row}")
    for axis in range(3):
        column.prop(item, "place", index=axis, text="XYZ"[axis])
    column.prop(item, "weight")


CLASSES = (SPLINEWRIGHT_PT_keyed_points,)
