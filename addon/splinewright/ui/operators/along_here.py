"""Change the radius and the tilt of the selected points of nets of curves: by the mouse, or by typed numbers."""

import math
from contextlib import suppress

import bpy
from bpy.props import FloatProperty

from ...bridge.cage import net_object
from ...bridge.net import live
from ...bridge.recipes import recipes
from ...core.base import decimals
from ...core.base.failures import FAILURES, sentence
from ...core.base.words import phrase, say
from .. import editing
from . import reports
from .sideways import FINE, Sideways, scaled


class _Changes(Sideways):
    """What both operators do. They say what the mouse and typed numbers mean, and what that does to points."""

    @classmethod
    def poll(cls, context):
        nets = [ob for ob in editing.nets_in_edit_mode(context) if ob.type == 'CURVE']
        if not nets:
            cls.poll_message_set(say("Edit the net of a Splinewright curve first"))
        elif not any(map(_can_change, nets)):
            cls.poll_message_set(say("The shape is made by a recipe: use Apply Construction first"))
        return any(map(_can_change, nets))

    def nets(self, context):
        return _curves(context)

    @property
    def typed(self):
        """The number that was typed, or None."""
        return self._typed.number if str(self._typed) else None

    def hold(self, context):
        self._gestures, problem = _begun(context)
        return problem

    def show(self):
        for gesture in self._gestures:
            if self.is_nothing():
                gesture.put_back()
            else:
                gesture.show(*self.change())

    def confirmed(self, context):
        if self.is_nothing() or self._problem:
            self.put_back()
            return reports.cancelled(self, self._problem) if self._problem else {'CANCELLED'}
        return self._kept()

    def execute(self, context):
        self._gestures, problem = _begun(context)
        if problem:
            return reports.cancelled(self, problem)
        if self.is_nothing():
            return reports.finished(self, reports.Report("Nothing changed"))
        try:
            for gesture in self._gestures:
                gesture.show(*self.change())
        except FAILURES as error:
            self.put_back()
            return reports.cancelled(self, sentence(error))
        return self._kept()

    def _kept(self):
        for gesture in self._gestures:
            live.end_along(gesture)
        count = sum(gesture.count for gesture in self._gestures)
        return reports.finished(self, reports.Report(phrase("{text} of {count} points",
                                                            text=self.text(''), count=count) if count > 1 else self.text("")))

    def put_back(self):
        for gesture in self._gestures:
            with suppress(*FAILURES, ReferenceError):
                gesture.put_back()


class SPLINEWRIGHT_OT_radius_here(_Changes, bpy.types.Operator):
    bl_idname = "splinewright.radius_here"
    bl_label = "Change Radius"
    bl_description = "Multiply the radius of the selected control points by mouse or number, for example for a bevel"

    factor: FloatProperty(name="Factor", description="What radii are multiplied by", default=1.0, min=0.0, precision=4, step=10,
                          options={'SKIP_SAVE'})

    means = "thinner, thicker", "the factor"
    #: Pixels, of an interface that is not scaled, over which a radius doubles; what Ctrl rounds to.
    _doubles, _step = 150.0, 0.1

    def choose(self, event):
        if self.typed is not None:
            self.factor = abs(self.typed)
            return
        factor = 2.0 ** min(max(scaled(self._moved) / self._doubles, -30.0), 30.0)
        step = self._step * (FINE if event.shift else 1.0)
        self.factor = float(f"{round(factor / step) * step if event.ctrl else factor:.4g}")

    def change(self):
        return decimals.typed(self.factor), 0.0

    def is_nothing(self):
        return self.factor == 1.0

    def text(self, typed):
        return phrase("Radius × {number}", number=typed or f"{self.factor:.4g}")


class SPLINEWRIGHT_OT_tilt_here(_Changes, bpy.types.Operator):
    bl_idname = "splinewright.tilt_here"
    bl_label = "Change Tilt"
    bl_description = "Twist the profile at the selected control points by mouse or degrees, for example of a bevel"

    angle: FloatProperty(name="Angle", description="Angle added to the tilts", default=0.0, subtype='ANGLE', step=100,
                         options={'SKIP_SAVE'})

    means = "turn back, turn on", "degrees"
    #: Pixels, of an interface that is not scaled, of one degree; what Ctrl rounds to, in degrees.
    _degree, _step = 2.0, 5.0

    def choose(self, event):
        degrees = scaled(self._moved) / self._degree if self.typed is None else self.typed
        if self.typed is None:
            step = (1.0 if event.shift else self._step) if event.ctrl else 0.1 * (FINE if event.shift else 1.0)
            degrees = round(degrees / step) * step
        self.angle = math.radians(degrees)

    def change(self):
        return 1.0, self.angle

    def is_nothing(self):
        return self.angle == 0.0

    def text(self, typed):
        return phrase("Tilt {number}°", number=typed or f"{math.degrees(self.angle):.4g}")


def _can_change(ob):
    owner = net_object.shape_of(ob)
    return owner is not None and not recipes.has(owner.data)


def _curves(context):
    """The nets of curves in Edit Mode that can be changed."""
    return [ob for ob in editing.nets_in_edit_mode(context) if ob.type == 'CURVE' and _can_change(ob)]


def _begun(context):
    """(an along.Gesture for each net of curves in Edit Mode with selected points, why there is none or "")."""
    try:
        gestures = [gesture for gesture in map(live.begin_along, _curves(context)) if gesture.count]
    except FAILURES as error:
        return [], sentence(error)
    return gestures, "" if gestures else "select points of the net"


CLASSES = (SPLINEWRIGHT_OT_radius_here, SPLINEWRIGHT_OT_tilt_here)
