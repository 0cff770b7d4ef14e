"""Pull a shape by the point at the mouse, or the tangent or osculating circle there: the control points follow by the least
change."""

import math

import bpy
import numpy as np
from bpy.props import BoolProperty, EnumProperty, FloatProperty, FloatVectorProperty, IntProperty, StringProperty
from bpy_extras import view3d_utils
from mathutils import Vector

from ...bridge.cage import net_object
from ...bridge.data import store
from ...bridge.net import pulling
from ...bridge.recipes import recipes
from ...bridge.shape import shape
from ...core.base import decimals
from ...core.base.failures import FAILURES, Refusal, sentence
from ...core.base.words import phrase, say
from ...core.deform import pulling as pulls
from ...core.shape import parameters
from ...core.verbs import patch_verbs, verbs
from .. import active_shape, editing, picking, seeing, snapping
from ..pull_keys import Keys
from ..pull_overlay import Pull
from ..ui_state import ui_state
from . import reports
from .gesture import Gesture, redraw

_STEPS = {'WHEELUPMOUSE': 0.5, 'WHEELDOWNMOUSE': -0.5}
#: The mouse has not been moved where it is nearer to where it was pressed, in pixels.
_STILL = 3.0
#: As near to a point of a net a press selects it, in pixels.
_ON_POINT = 8.0
_AIMING = "Press on the shape and pull   |   D, C on curves: the tangent, the osculating circle   |   Esc, Right Mouse: Cancel"
_PULLING = ("Release: done   |   X, Y, Z: axis   |   Numbers: distance   |   Ctrl: magnet on, off   |   "
            "Wheel: how many points follow   |   {more}Esc, Right Mouse: Cancel")
_OF_CURVES = "T: keep the tangent   |   D, C: pull it, or the circle   |   "
#: Keys that say what is pulled instead of the point, and of it again.
_HANDLE_KEYS = {'D': 'TANGENT', 'C': 'CIRCLE'}


class SPLINEWRIGHT_OT_pull_here(Gesture, bpy.types.Operator):
    bl_idname = "splinewright.pull_here"
    bl_label = "Pull Shape"
    bl_description = "Drag any point of a curve or patch; the control points follow with the least change"
    bl_options = {'REGISTER', 'UNDO', 'PRESET'}
    cursor = 'CROSSHAIR'
    works_on_nets = True

    shape_name: StringProperty(options={'HIDDEN', 'SKIP_SAVE'})
    piece: IntProperty(name="Piece", description="Which piece of the shape, counted from 1", default=1, min=1,
                       options={'SKIP_SAVE'})
    parameter_u: FloatProperty(name="Parameter U", description="Where on the curve or patch it is pulled", default=0.5,
                               precision=5, step=1, options={'SKIP_SAVE'})
    parameter_v: FloatProperty(name="Parameter V", description="Where on the patch it is pulled", default=0.5,
                               precision=5, step=1, options={'SKIP_SAVE'})
    vector: FloatVectorProperty(name="Move", description="By what the point is moved, in the world", size=3,
                                subtype='TRANSLATION', precision=5, options={'SKIP_SAVE'})
    locality: FloatProperty(
        name="Locality", description="How few control points follow: 0 for all that the point depends on, with more those "
        "nearest to it do it alone", default=0.0, min=0.0, soft_max=10.0, step=50)
    handle: EnumProperty(
        name="Pulls", description="What of a curve is pulled",
        items=[('POINT', "Point", "The point of the curve"),
               ('TANGENT', "Tangent", "The end of the tangent, as of a handle; the point stays"),
               ('CIRCLE', "Osculating Circle", "A point on the osculating circle; the point and the tangent stay")],
        options={'SKIP_SAVE'})
    keep_tangent: BoolProperty(
        name="Keep Tangent", description="The derivative of the curve at the point stays as it is")

    at_once: BoolProperty(options={'HIDDEN', 'SKIP_SAVE'})          # where the mouse is pressed, or leave the key to others

    @classmethod
    def poll(cls, context):
        shapes = active_shape.shapes(context)
        if not shapes:
            cls.poll_message_set(say("Select a Splinewright shape, or edit its net"))
        elif not any(map(active_shape.is_free, shapes)):
            cls.poll_message_set(say("The shape is made by a recipe: use Apply Construction first"))
        return any(map(active_shape.is_free, shapes))

    # From here on: with numbers.

    def execute(self, context):
        ob = self._owner(context)
        if ob is None:
            return reports.cancelled(self, "the shape that was pulled is no longer active")
        try:
            held = _held(context, ob)
            held.write(self._pulled(held.definition, ob))
        except FAILURES as error:
            return reports.failed(self, error, ob.name)
        return reports.finished(self, reports.Report(phrase("Pulled {name} by {distance}",
                                                            name=self._named(ob), distance=decimals.text_of(np.linalg.norm(self._typed()))),
                                                      warnings=tuple(filter(None, [held.lost]))))

    def draw(self, context):
        ob = self._owner(context)
        column = self.layout.column()
        column.use_property_split, column.use_property_decorate = True, False
        of_curve = ob is not None and ob.type == 'CURVE'
        if of_curve:
            column.prop(self, 'handle')
        column.prop(self, 'vector')
        if not of_curve or self.handle == 'POINT':
            column.prop(self, 'locality')
            if of_curve:
                column.prop(self, 'keep_tangent')
        if ob and active_shape.count_of(ob.data) > 1:
            column.prop(self, 'piece')
        column.prop(self, 'parameter_u')
        if ob and ob.type == 'MESH':
            column.prop(self, 'parameter_v')

    def _owner(self, context):
        """The active shape that was pulled; the active one where none was."""
        shapes = [ob for ob in active_shape.shapes(context) if active_shape.is_free(ob)]
        named = [ob for ob in shapes if ob.name == self.shape_name]
        active = [ob for ob in shapes if ob == active_shape.shape_of(context.object)]
        found = named if self.shape_name else active or shapes
        return found[0] if found else None

    def _typed(self):
        return np.array([decimals.typed(number) for number in self.vector])

    def _pulled(self, definition, ob):
        return pulls.pulled(definition, self.piece - 1, self._at(definition), _into(ob) @ self._typed(), self.locality,
                            self.keep_tangent and definition.has_curves, self.handle)

    def _at(self, definition):
        """The parameters at which it is pulled."""
        pieces = verbs.pieces_of(definition)
        verbs.require_piece(pieces, self.piece)
        piece = pieces[self.piece - 1]
        axes = [piece] if definition.has_curves else [patch_verbs.Along(piece, axis) for axis in 'uv']
        return [parameters.snapped(number, parameters.knots_of(axis))
                for number, axis in zip((self.parameter_u, self.parameter_v), axes)]

    # From here on: by the mouse.

    def invoke(self, context, event):
        if self.at_once and not self._is_at(context, event):
            return {'PASS_THROUGH', 'CANCELLED'}
        problem = editing.unread(editing.nets_in_edit_mode(context))
        if problem:
            return reports.cancelled(self, problem)
        self._drag = None
        self.begin_modal(context)
        context.workspace.status_text_set(say(_AIMING))
        self._aim(context, event)
        return self._grab(context, event) if self.at_once else {'RUNNING_MODAL'}

    def _is_at(self, context, event):
        """Whether the mouse is over a shape that can be pulled, and at no point of a net, which is selected by a click."""
        found = picking.area_at(event.mouse_x, event.mouse_y)
        pixel = (event.mouse_x - found[1].x, event.mouse_y - found[1].y) if found else None
        if found and seeing.point_at(context, *found, pixel, editing.nets_in_edit_mode(context), within=_ON_POINT):
            return False
        self._aim(context, event)
        return bool(self.shape_name)

    def lets_pass(self, event):
        return self._drag is None and super().lets_pass(event)

    def step(self, context, event):
        if self._drag is not None:
            return self._pull(context, event)
        if event.value == 'PRESS':
            self._choose(event.type)
        self._aim(context, event)
        if event.type != 'LEFTMOUSE' or event.value != 'PRESS' or not self.shape_name:
            return {'RUNNING_MODAL'}
        return self._grab(context, event)

    def hide(self):
        ui_state.pulled = None

    def put_back(self):
        if self._drag is not None:
            self._drag.held.put_back()

    def _aim(self, context, event):
        """Find the point at the mouse, and show it with the control points that would follow."""
        ui_state.pulled, self.shape_name, self.vector = None, "", (0.0, 0.0, 0.0)
        obs = [ob for ob in active_shape.shapes(context) if active_shape.is_free(ob) and ob.visible_get()]
        try:
            found = picking.pointed_at(event.mouse_x, event.mouse_y, obs, context.evaluated_depsgraph_get())
            if found is not None:
                ob, self.piece, at = found
                self.parameter_u, self.parameter_v = (*at, 0.0)[:2]
                ui_state.pulled = self._aimed_at(ob, store.read(ob.data), at)
                self.shape_name = ob.name
        except FAILURES:
            ui_state.pulled = None             # such a shape shows nothing to take hold of
        redraw()

    def _choose(self, key):
        """Let a key choose the target of the pull."""
        wanted = _HANDLE_KEYS.get(key, self.handle)
        self.handle = 'POINT' if wanted == self.handle and key in _HANDLE_KEYS else wanted

    def _choose_again(self, key):
        """_choose() while it is pulled; what cannot be pulled there is not chosen."""
        drag, was = self._drag, self.handle
        self._choose(key)
        try:
            ui_state.pulled = self._aimed_at(drag.ob, drag.held.definition, self._at(drag.held.definition))
        except FAILURES:
            self.handle = was
        drag.hold_at(ui_state.pulled.start)

    def _aimed_at(self, ob, before, at):
        """The Pull of a definition that has not been moved yet."""
        start, lines = self._handle(before, at)
        away = lines[0, 1] - lines[0, 0] if len(lines) else np.zeros(3)
        by = max(before.size, 1e-30) * np.eye(3)[np.abs(away).argmin()]
        after = pulls.pulled(before, self.piece - 1, at, by, self.locality, self.keep_tangent and before.has_curves, self.handle)
        return Pull(ob.name, start, start, pulls.followers(after, before)[0], pulls.followers(before, after)[1], lines)

    def _handle(self, definition, at):
        """(where that is by which a piece is pulled, the lines that show it)."""
        piece = verbs.pieces_of(definition)[self.piece - 1]
        if not definition.has_curves:
            return piece.evaluate(*at), np.empty((0, 2, 3))
        return pulls.handle_at(piece, *at, self.handle), pulls.drawn(piece, *at, self.handle)

    def _grab(self, context, event):
        ob = self._owner(context)
        try:
            self._drag = _Drag(event, ob, _held(context, ob), ui_state.pulled.start)
        except FAILURES as error:
            self.cancel(context)
            return reports.failed(self, error, ob.name)
        context.window.cursor_modal_set('SCROLL_XY')
        context.workspace.status_text_set(say(phrase(_PULLING, more=phrase(_OF_CURVES if ob.type == 'CURVE' else ""))))
        return self._pull(context, event)

    def _pull(self, context, event):
        drag = self._drag
        if event.type in _STEPS:
            self.locality = max(self.locality + _STEPS[event.type], 0.0)
        elif event.type == 'T' and event.value == 'PRESS' and drag.ob.type == 'CURVE':
            self.keep_tangent = not self.keep_tangent
        elif event.type in _HANDLE_KEYS and event.value == 'PRESS' and drag.ob.type == 'CURVE':
            self._choose_again(event.type)
        elif not drag.keys.take(event) and drag.ends(event):
            return self._let_go(context)
        self.vector = drag.vector(context, event)
        problem = ""
        try:
            after = self._pulled(drag.held.definition, drag.ob)
            drag.held.show(after)
            problem = drag.held.lost and f"  {drag.held.lost}"
            points, parts = pulls.followers(drag.held.definition, after)
            end = ui_state.pulled.start + _into(drag.ob) @ self._typed()
            lines = self._handle(after, self._at(after))[1]
            ui_state.pulled = ui_state.pulled._replace(end=end, followers=points, parts=parts, lines=lines)
        except FAILURES as error:
            problem = f"  {sentence(error)}"
        self.write_header(drag.area, self._header(drag) + problem)
        redraw()
        return {'RUNNING_MODAL'}

    def _header(self, drag):
        kept = "   Tangent kept" if self.keep_tangent and drag.ob.type == 'CURVE' and self.handle == 'POINT' else ""
        numbers = ", ".join(decimals.text_of(part) for part in self.vector)
        length = np.linalg.norm(self._typed())
        locality = phrase("   Locality {locality:.1f}",
                          locality=self.locality) if drag.ob.type == 'MESH' or self.handle == 'POINT' else ""
        return phrase("Pull {name} {length} ({numbers}){direction}{locality}{kept}",
                      name=self._named(drag.ob), length=decimals.text_of(length), numbers=numbers, direction=drag.keys.words(), locality=locality, kept=kept)

    def _named(self, ob):
        words = {'TANGENT': "the tangent of ", 'CIRCLE': "the osculating circle of "} if ob.type == 'CURVE' else {}
        return words.get(self.handle, "") + ob.name

    def _let_go(self, context):
        self.cancel(context)
        return self.execute(context) if any(self.vector) else {'CANCELLED'}


class _Drag:
    """A point of a shape at the mouse, in the plane of the view through it."""

    def __init__(self, event, ob, held, start):
        self.ob, self.held, self.keys = ob, held, Keys()
        self.area, self._region, self._view = picking.area_at(event.mouse_x, event.mouse_y)
        self.hold_at(start)
        self._ignored = {ob.name, *(net.name for net in editing.nets()), *_followers()}
        self._pressed = np.array([event.mouse_x, event.mouse_y])
        self._begin = self._place(event)
        self._was_released = False

    def hold_at(self, start):
        """By this point of the shape's space it is held from now on."""
        self._anchor = self.ob.matrix_world @ Vector(start)

    def vector(self, context, event):
        """By what the point is to be moved, in the world."""
        sight = np.array(view3d_utils.region_2d_to_vector_3d(self._region, self._view, self._pixel(event)))
        step = 10.0 ** math.floor(math.log10(max(self._view.view_distance, 1e-30))) / 10.0
        is_on, place = snapping.is_on(event), None
        if is_on:
            place = snapping.place_at(context, self._region, self._view, self._pixel(event), self._ignored)
        self.keys.snaps = is_on and place is None and snapping.takes_steps()
        return self.keys.vector(self._place(event) - self._begin if place is None else self.keys.along_axis(place - np.array(self._anchor)),
                                sight, step)

    def ends(self, event):
        """Whether the mouse lets go: a click without a move holds on until the next one."""
        if event.type in ('RET', 'NUMPAD_ENTER'):
            return event.value == 'PRESS'
        if event.type != 'LEFTMOUSE':
            return False
        is_still = np.hypot(event.mouse_x - self._pressed[0], event.mouse_y - self._pressed[1]) < _STILL
        if event.value == 'RELEASE' and not self._was_released:
            self._was_released = True
            return not is_still or bool(str(self.keys.typed))
        return event.value == 'PRESS' and self._was_released

    def _pixel(self, event):
        return event.mouse_x - self._region.x, event.mouse_y - self._region.y

    def _place(self, event):
        place = view3d_utils.region_2d_to_location_3d(self._region, self._view, self._pixel(event), self._anchor)
        return np.array(place)


def _held(context, ob):
    """The target of the pull: the net of a shape where that is edited."""
    nets = [net for net in editing.nets_in_edit_mode(context) if net_object.shape_of(net) == ob]
    return pulling.HeldNet(nets[0]) if nets else pulling.HeldShape(ob)


def _followers():
    """The names of objects that follow others, as they may follow the pulled shape."""
    return (ob.name for ob in bpy.context.view_layer.objects if shape.has_shape(ob) and recipes.follows(ob.data))


def _into(ob):
    """(3, 3): vectors of the world into the space of an object."""
    matrix = np.array(ob.matrix_world, dtype=np.float64)[:3, :3]
    if not abs(np.linalg.det(matrix)) > 0.0:
        raise Refusal("the object is scaled to nothing: it cannot be pulled")
    return np.linalg.inv(matrix)


CLASSES = (SPLINEWRIGHT_OT_pull_here,)
