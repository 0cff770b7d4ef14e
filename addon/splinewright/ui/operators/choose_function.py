"""A function or span of a triangle of functions is pointed out while it is at the mouse; a click keeps it."""

from contextlib import suppress

import bpy
import numpy as np

from ...bridge.data import problems, store
from ...bridge.net import keyed
from ...bridge.recipes import recipes
from ...bridge.shape import shape
from ...core.base.failures import FAILURES, sentence
from ...core.base.words import say
from ...core.formulas import triangle_picture
from .. import fed_overlay, picking
from ..ui_state import ui_state
from . import polls
from .gesture import redraw
from .pointing import Pointing

_KINDS = ('triangle', 'basis_triangle')
#: Parameters of both recipes.
_FUNCTIONS, _SPANS = 'chosen', 'spans'


class SPLINEWRIGHT_OT_choose_function(Pointing, bpy.types.Operator):
    bl_idname = "splinewright.choose_function"
    bl_label = "Choose Function"
    bl_description = "Point at a function or span of a triangle to see what feeds it; a click keeps it chosen"
    bl_options = {'UNDO'}

    hint = "Point at a function or a span   |   Click: keep it   |   Shift: add it to the chosen ones   |   Esc, Right Mouse: Cancel"

    @classmethod
    def poll(cls, context):
        if not polls.in_object_mode(cls, context):
            return False
        if not triangles(context):
            cls.poll_message_set(say("Select a triangle of functions"))
            return False
        return True

    def invoke(self, context, event):
        self._shown, self._said, self._before = None, None, {}
        return self.begin(context, event)

    def meant(self, context):
        return triangles(context)

    def look(self, context, event):
        found = item_at(context, event.mouse_x, event.mouse_y)
        shown = found and (found[0].name, found[1].is_span, found[1].i, found[1].degree, event.shift)
        if shown != self._shown:
            self._shown = shown
            self.put_back()
            self._said = self._point_out(*found, event.shift) if found else None
        x, y = event.mouse_x, event.mouse_y
        ui_state.fed = fed_overlay.Fed(picking.view_at(x, y)[0].as_pointer(), x, y, *self._said) if found else None
        redraw()
        return found is not None

    def _point_out(self, ob, item, is_added):
        """(lines of it in the world, what it says, whether that is why it cannot be done)"""
        before = chosen_of(ob.data)
        try:
            keyed.set_parameters(ob.data, chosen_with(before, item, is_added))
        except FAILURES as error:
            return (), sentence(error), True
        self._before = {ob.name: before}
        problems.set_problem(ob.data, problems.SETTING, "")
        shown, matrix = store.read(ob.data), np.array(ob.matrix_world, dtype=np.float64)
        lines = tuple(line @ matrix[:3, :3].T + matrix[:3, 3] for line in triangle_picture.lines_of(shown, item))
        return lines, triangle_picture.in_words(shown, item), False

    def put_back(self):
        for name, before in self._before.items():
            ob = bpy.data.objects.get(name)
            with suppress(*FAILURES):
                if ob is not None and recipes.kind(ob.data) in _KINDS:
                    keyed.set_parameters(ob.data, before)
        self._before = {}

    def forget(self):
        ui_state.fed = None

    def clicked(self, context):
        is_done, self._before = bool(self._before), {}
        self.end_modal(context)
        return {'FINISHED'} if is_done else {'CANCELLED'}


def triangles(context):
    """The selected triangles, and the active one, as far as they can be changed and are to be seen."""
    obs = dict.fromkeys(filter(None, (*context.selected_objects, context.object)))
    return [ob for ob in obs if shape.has_shape(ob) and recipes.kind(ob.data) in _KINDS and not shape.file_of(ob) and ob.visible_get()]


def item_at(context, x, y):
    """(object, triangle_picture.Item) nearest to a pixel of the window; None where none is near."""
    view = picking.view_at(x, y)
    if view is None:
        return None
    region, view = view
    found = []
    for ob in triangles(context):
        with suppress(*FAILURES):       # one that cannot be read has none
            items = triangle_picture.items(store.read(ob.data))
            pixels = picking.on_screen(region, view, ob.matrix_world, np.array([item.point for item in items]))
            distances = np.nan_to_num(np.linalg.norm(pixels - (x - region.x, y - region.y), axis=1), nan=np.inf)
            nearest = int(distances.argmin())
            found.append((distances[nearest], ob, items[nearest]))
    nearest = min(found, key=lambda one: one[0], default=(np.inf,))
    return nearest[1:] if nearest[0] <= picking.near() else None


def chosen_of(data):
    """What a triangle points out, as values of its parameters."""
    values = recipes.parameters(data)
    return {name: values[name] for name in (_FUNCTIONS, _SPANS)}


def chosen_with(before, item, is_added):
    """Values with an Item chosen, alone or last of those that are."""
    name, word = (_SPANS, str(item.i)) if item.is_span else (_FUNCTIONS, f'{item.i},{item.degree}')
    others = before if is_added else {_FUNCTIONS: "", _SPANS: ""}
    words = [each for each in others[name].split() if each != word]
    return {**others, name: " ".join([*words, word])}


CLASSES = (SPLINEWRIGHT_OT_choose_function,)
