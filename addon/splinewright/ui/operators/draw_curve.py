"""A pen: a stroke of the mouse in a 3D view becomes a clean curve near it."""

import bpy
import numpy as np
from bpy.props import BoolProperty, FloatProperty, StringProperty
from bpy_extras import view3d_utils
from mathutils import Vector

from ...bridge.recipes import parameters, recipes
from ...bridge.shape import recipe_edit
from ...core.base.failures import FAILURES, Refusal
from ...core.base.words import say
from ...core.recipes.table import RECIPES
from ...core.shape import polylines
from .. import picking, recipe_props
from ..ui_state import ui_state
from . import new_shapes, reports
from .adding import add_in_front, can_add, require_place, resolution_property
from .gesture import Gesture, redraw

_SPLINE = RECIPES['approximating']
_PARAMETERS = {parameter.name: parameter for parameter in _SPLINE.parameters}
_MOVES = ('MOUSEMOVE', 'INBETWEEN_MOUSEMOVE')
_TOO_SHORT = "the stroke is too short: press the left mouse button, drag and release"
#: Pixels, of an interface that is not scaled: of the shortest stroke, and within which the ends of one meet.
_SHORTEST, _MEETING = 10.0, 12.0


class _Pen(Gesture):
    """A stroke is drawn, and becomes a curve."""

    bl_options = {'REGISTER', 'UNDO', 'PRESET'}
    cursor = 'PAINT_BRUSH'

    stroke: StringProperty(options={'HIDDEN', 'SKIP_SAVE'})
    at_once: BoolProperty(options={'HIDDEN', 'SKIP_SAVE'})          # begin where the mouse is pressed
    pixels: FloatProperty(name="Tolerance in Pixels", description="How far the next stroke may lie from its curve, as it is seen",
                          default=4.0, min=0.1, soft_max=50.0)
    tolerance: recipe_props.property_of(_PARAMETERS['tolerance'], options={'SKIP_SAVE'})
    degree: recipe_props.property_of(_PARAMETERS['degree'])
    closed: recipe_props.property_of(_PARAMETERS['closed'], options={'SKIP_SAVE'})
    resolution_u: resolution_property(default=_SPLINE.resolution)

    #: Whether it begins on what is under the mouse; else on the plane through the 3D cursor that faces the view.
    begins_on_surface = False

    @classmethod
    def poll(cls, context):
        return can_add(cls, context)

    def invoke(self, context, event):
        self._pixels, self._view, self._on_surface = [], None, self.begins_on_surface
        self._hint(context)
        self.begin_modal(context)
        return self._wait(context, event) if self.at_once else {'RUNNING_MODAL'}

    def lets_pass(self, event):
        return self._view is None and super().lets_pass(event)

    def step(self, context, event):
        if self._view is None:
            return self._wait(context, event)
        if event.type in _MOVES:
            self._go_on(context, event)
        if event.type == 'LEFTMOUSE' and event.value == 'RELEASE':
            self._go_on(context, event)
            return self._end(context)
        return {'RUNNING_MODAL'}

    def hide(self):
        ui_state.drawn_stroke = ()

    def execute(self, context):
        new_shapes.fill_from_preferences(self)
        try:
            require_place(context)
            points = _points_of(self.stroke)
            data = recipe_edit.new_data("Drawn Curve", _SPLINE, self._values(), points, new_shapes.start(self))
        except FAILURES as error:
            return reports.failed(self, error)
        ob = bpy.data.objects.new(data.name, data)
        add_in_front(context, ob, context.selected_objects)
        return reports.finished(self, reports.Report(new_shapes.said_of([ob], recipes.error(data))))

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        for name in ('tolerance', 'degree', 'closed'):
            layout.prop(self, name)
        new_shapes.draw(self, layout)
        layout.separator()
        layout.label(text="Next Stroke")
        layout.prop(self, "pixels")

    def _values(self):
        given = {name: parameters.as_typed(_PARAMETERS[name], getattr(self, name)) for name in ('tolerance', 'degree', 'closed')}
        return {**{name: parameter.default for name, parameter in _PARAMETERS.items()}, **given}

    def _hint(self, context):
        context.workspace.status_text_set(say(
            "Left mouse: press, drag and release to draw; S: on surface (on); Esc or right mouse: cancel" if self._on_surface else
            "Left mouse: press, drag and release to draw; S: on surface (off); Esc or right mouse: cancel"))

    def _wait(self, context, event):
        """step() until the stroke begins."""
        if event.type == 'S' and event.value == 'PRESS':
            self._on_surface = not self._on_surface
            self._hint(context)
        if event.type == 'LEFTMOUSE' and event.value == 'PRESS':
            self._view = picking.view_at(event.mouse_x, event.mouse_y)
            if self._view:
                self._depth = context.scene.cursor.location.copy()
                self._go_on(context, event)
        return {'RUNNING_MODAL'}

    def _go_on(self, context, event):
        region, view = self._view
        pixel = Vector((event.mouse_x - region.x, event.mouse_y - region.y))
        if self._pixels and pixel == self._pixels[-1]:
            return
        seen = self._on_surface and picking.face_seen(
            context, region, view, pixel, context.evaluated_depsgraph_get(), ())
        self._depth = seen[2] if seen else view3d_utils.region_2d_to_location_3d(region, view, pixel, self._depth)
        self._pixels.append(pixel)
        ui_state.drawn_stroke = (*ui_state.drawn_stroke, tuple(self._depth))
        redraw()

    def _end(self, context):
        points, pixels = ui_state.drawn_stroke, self._pixels
        self.end_modal(context)
        length = sum((after - before).length for before, after in zip(pixels, pixels[1:]))
        if length < picking.near(_SHORTEST):
            return reports.stopped(self, _TOO_SHORT)
        meeting = picking.near(_MEETING)
        self.closed = length > 4 * meeting and (pixels[-1] - pixels[0]).length < meeting
        if self.closed:
            points = points[:1 + max(i for i, pixel in enumerate(pixels) if (pixel - pixels[0]).length >= meeting)]
        self.stroke = " ".join(repr(number) for point in points for number in point)
        self.tolerance = self.pixels * picking.size_of_pixel(*self._view, points[len(points) // 2])
        return self.execute(context)


class SPLINEWRIGHT_OT_draw_curve(_Pen, bpy.types.Operator):
    bl_idname = "splinewright.draw_curve"
    bl_label = "Draw Curve"
    bl_description = "Draw a stroke in the view that becomes a clean curve within a tolerance, closed if its ends meet"


class SPLINEWRIGHT_OT_draw_on_surface(_Pen, bpy.types.Operator):
    bl_idname = "splinewright.draw_on_surface"
    bl_label = "Draw Curve on Surface"
    bl_description = "Draw a stroke on the surface under the mouse that becomes a clean curve within a tolerance"
    begins_on_surface = True


def _points_of(text):
    """(n, 3) of the numbers of a stroke. Raises Refusal."""
    try:
        points = np.array(text.split(), dtype=np.float64).reshape(-1, 3)
    except ValueError:
        raise Refusal("the stroke is no list of three numbers for each point") from None
    points = polylines.without_repeats(points)
    if len(points) < 2:
        raise Refusal(_TOO_SHORT)
    return points


CLASSES = (SPLINEWRIGHT_OT_draw_curve, SPLINEWRIGHT_OT_draw_on_surface)
