"""Edges are clicked in the 3D view that are rounded: of selected surfaces, or of those that a Round Edge rounds already."""

import bpy
import numpy as np

from ...bridge.analysis import surveys
from ...bridge.follow import recipe_results
from ...bridge.net import keyed
from ...bridge.recipes import placing, recipes
from ...bridge.shape import shape
from ...core.base.failures import FAILURES, Refusal, blenders_refusals, sentence
from ...core.base.words import phrase, say
from ...core.recipes.table import RECIPES
from .. import edges_overlay, picking
from ..ui_state import ui_state
from . import from_objects, polls, reports
from .gesture import redraw
from .pointing import Pointing

_RECIPE = RECIPES['rounded_edge']


class SPLINEWRIGHT_OT_round_here(Pointing, bpy.types.Operator):
    bl_idname = "splinewright.round_here"
    bl_label = "Round Edges"
    bl_description = "Click the edges to round, of selected surfaces or of the active Round Edge; Enter finishes"
    bl_options = {'REGISTER'}

    @classmethod
    def poll(cls, context):
        if not polls.in_object_mode(cls, context):
            return False
        reason = "" if _is_rounded(context.object) else from_objects.lacking(context, _RECIPE)
        if reason:
            cls.poll_message_set(say(reason))
        return not reason

    def invoke(self, context, event):
        try:
            lines, chosen = _edges(context)
        except FAILURES as error:
            return reports.failed(self, error)
        if not lines:
            return reports.cancelled(self, "there is no edge: no two sides lie on each other with an angle between their surfaces")
        ui_state.rounding = edges_overlay.Edges(tuple(lines), frozenset(chosen), 0)
        return self.begin(context, event)

    @property
    def hint(self):
        chosen = ui_state.rounding.chosen
        count = "1 Edge" if len(chosen) == 1 else phrase("{count} Edges", count=len(chosen))
        enter = phrase("Enter: Round {count}   |   ", count=count) if chosen else ""
        return phrase("Click: Add or Remove an Edge   |   A: All or None   |   {enter}Esc, Right Mouse: Cancel", enter=enter)

    def look(self, context, event):
        number = edge_at(context, event.mouse_x, event.mouse_y, ui_state.rounding.lines)
        if number != ui_state.rounding.hovered:
            ui_state.rounding = ui_state.rounding._replace(hovered=number)
            redraw()
        return bool(number)

    def clicked(self, context):
        self._choose(context, ui_state.rounding.chosen ^ {ui_state.rounding.hovered})
        return {'RUNNING_MODAL'}

    def step(self, context, event):
        if event.value == 'PRESS' and event.type == 'A':
            everything = frozenset(range(1, len(ui_state.rounding.lines) + 1))
            self._choose(context, frozenset() if ui_state.rounding.chosen == everything else everything)
            return {'RUNNING_MODAL'}
        if event.value == 'PRESS' and event.type in ('RET', 'NUMPAD_ENTER'):
            if ui_state.rounding.chosen:
                return self._make(context)
            self.tell(context, "Click an edge first")
            return {'RUNNING_MODAL'}
        return super().step(context, event)

    def _choose(self, context, chosen):
        ui_state.rounding = ui_state.rounding._replace(chosen=chosen)
        self.tell(context)
        redraw()

    def _make(self, context):
        """A refusal is shown in the status bar, and others may be clicked."""
        text, ob = text_of(ui_state.rounding.chosen), context.object
        try:
            if _is_rounded(ob):
                keyed.set_parameters(ob.data, {'edges': text})
                recipes.show(ob.data)
            else:
                with blenders_refusals():
                    bpy.ops.splinewright.add_rounded_edge('EXEC_DEFAULT', True, edges=text)
        except FAILURES as error:
            self.tell(context, sentence(error))
            return {'RUNNING_MODAL'}
        self.end_modal(context)
        if not _is_rounded(ob):
            return {'FINISHED'}
        bpy.ops.ed.undo_push(message=self.bl_label)
        return reports.finished(self, reports.Report(recipes.read(ob.data).said))

    def forget(self):
        ui_state.rounding = None


def _is_rounded(ob):
    """Whether an object is a Round Edge that can be changed."""
    return ob is not None and shape.has_shape(ob) and not ob.data.library and recipes.kind(ob.data) == _RECIPE.kind


def _edges(context):
    """(polylines (n, 3) of edges in the world, the numbers of those that are rounded). Raises Refusal or
    store.UnreadableDefinition."""
    ob, depsgraph = context.object, context.evaluated_depsgraph_get()
    if not _is_rounded(ob):
        sources = from_objects.sources_of(context, _RECIPE)
        matrices = [recipe_results.matrix_in(source, None, depsgraph) for source in sources]
        return surveys.edge_lines_of(sources, matrices)[0], ()
    sources = recipes.read(ob.data).sources
    if not all(source is not None and shape.has_shape(source) for source in sources):
        raise Refusal("a surface that it rounds is missing")
    space = placing.now(ob.data, ob, sources, depsgraph)
    matrix = np.array(ob.matrix_world, dtype=np.float64) @ space.applied
    lines, numbers = surveys.edge_lines_of(sources, list(map(space.of, sources)), recipes.parameters(ob.data)['edges'])
    return [line @ matrix[:3, :3].T + matrix[:3, 3] for line in lines], numbers


def edge_at(context, x, y, lines):
    """The number from 1 of the edge at a pixel of the window, one that is seen before one that is hidden; 0 where there is none."""
    found = picking.view_at(x, y)
    if found is None:
        return 0
    region, view = found
    pixel, near = (x - region.x, y - region.y), []
    for number, line in enumerate(lines, 1):
        distance, place = picking.nearest_place(region, view, line, pixel)
        if distance <= picking.near():
            near.append((distance, number, place))
    depsgraph = context.evaluated_depsgraph_get()
    seen = [one for one in near if picking.is_seen(context, region, view, one[2], depsgraph)]
    return min(seen or near, key=lambda one: one[0], default=(0.0, 0))[1]


def text_of(numbers):
    """As Edges takes them: 1, 4-6."""
    runs = []
    for number in sorted(numbers):
        if runs and runs[-1][1] == number - 1:
            runs[-1][1] = number
        else:
            runs.append([number, number])
    return ", ".join(str(first) if first == last else f"{first}-{last}" if last > first + 1 else f"{first}, {last}" for first, last in runs)


CLASSES = (SPLINEWRIGHT_OT_round_here,)
