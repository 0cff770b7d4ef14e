"""Change the weights of the selected points of nets: by the mouse, by typed numbers, or in the panel."""

from contextlib import suppress

import bpy
import numpy as np
from bpy.props import BoolProperty, EnumProperty, FloatProperty

from ...bridge.cage import net_object
from ...bridge.net import live, selection, weighing
from ...bridge.recipes import recipes
from ...core.base import decimals
from ...core.base.failures import FAILURES, Refusal, sentence
from ...core.base.words import phrase, say
from .. import editing
from . import reports
from .sideways import FINE, Sideways, scaled

#: Pixels, of an interface that is not scaled, over which a weight doubles.
_DOUBLES = 150.0
#: What Ctrl rounds to.
_STEP = 0.1


class SPLINEWRIGHT_OT_weight_here(Sideways, bpy.types.Operator):
    bl_idname = "splinewright.weight_here"
    bl_label = "Change Weight"
    bl_description = ("Change the weights of the selected control points by mouse or number; larger weights pull the shape "
                      "nearer")
    means = "less, more", "the weight"

    kind: EnumProperty(name="Change", description="How the weights change", options={'SKIP_SAVE'}, items=(
        ('SET', "Set", "All get one weight"), ('SCALE', "Scale", "All are multiplied by one number")))
    weight: FloatProperty(name="Weight", description="The weight of all selected points; not 0", default=1.0, precision=4,
                          step=10, options={'SKIP_SAVE'})
    factor: FloatProperty(name="Factor", description="What weights are multiplied by; not 0", default=1.0, precision=4,
                          step=10, options={'SKIP_SAVE'})
    by_hand: BoolProperty(options={'HIDDEN', 'SKIP_SAVE'})

    @classmethod
    def poll(cls, context):
        nets = editing.nets_in_edit_mode(context)
        if not nets:
            cls.poll_message_set(say("Edit the net of a Splinewright shape first"))
        elif not any(map(has_weights, nets)):
            cls.poll_message_set(say("The shape is made by a recipe: use Apply Construction first"))
        return any(map(has_weights, nets))

    def draw(self, context):
        self.layout.row().prop(self, "kind", expand=True)
        self.layout.prop(self, "weight" if self.kind == 'SET' else "factor")

    def nets(self, context):
        return list(filter(has_weights, editing.nets_in_edit_mode(context)))

    def is_meant(self, net):
        return net.weighted

    def hold(self, context):
        problem = _why_none(context)
        if problem:
            return problem
        self.by_hand = True
        self._before = _chosen(context)
        weights = np.concatenate([weights for _, _, weights in self._before])
        self._is_one = bool((weights == weights[0]).all())
        self._base = float(weights[0]) if self._is_one else 1.0
        return ""

    def show(self):
        if self._is_as_before():
            self.put_back()
        else:
            _put(self._before, self._numbers, is_passing=True)

    def put_back(self):
        _put_back(self._before)

    def choose(self, event):
        if str(self._typed):
            self.kind, self.weight = 'SET', self._typed.number or 0.0
            return
        step = (_STEP * (FINE if event.shift else 1.0)) if event.ctrl else 0.0
        number = moved(self._base, scaled(self._moved) / _DOUBLES, step)
        self.kind = 'SET' if self._is_one else 'SCALE'
        setattr(self, "weight" if self._is_one else "factor", number)

    def _is_as_before(self):
        """Whether nothing was said: not what was typed."""
        return not str(self._typed) and abs(self._moved) < 1.0

    def is_odd(self):
        return bool(self._problem) or (self.weight if self.kind == 'SET' else self.factor) <= 0.0

    def text(self, typed):
        if self.kind == 'SCALE':
            return phrase("Weights × {factor:.4g}", factor=self.factor)
        return phrase("Weight {number}", number=typed or f"{self.weight:.4g}")

    def _numbers(self, weights):
        """The new weights for weights (k,). Raises Refusal where that is 0."""
        number = decimals.typed(self.weight if self.kind == 'SET' else self.factor)
        if number == 0.0:
            raise Refusal("a weight of 0 would take the point out of the shape: Move to Infinity makes it a direction")
        return np.full(len(weights), number) if self.kind == 'SET' else weights * number

    def confirmed(self, context):
        if self._is_as_before():
            self.put_back()
            return {'CANCELLED'}
        return self._done(self._before, is_refused_for_good=True)

    def execute(self, context):
        why = _why_none(context)
        if why:
            return reports.cancelled(self, why)
        return self._done(_chosen(context), is_refused_for_good=not self.by_hand)

    def _done(self, chosen, is_refused_for_good):
        try:
            _put(chosen, self._numbers)
        except FAILURES as error:
            _put_back(chosen)
            if is_refused_for_good:
                return reports.cancelled(self, sentence(error))
            return reports.finished(self, reports.Report("Nothing changed", warnings=(sentence(error),)))
        count = sum(len(vertices) for _, vertices, _ in chosen)
        text = f"{self.weight:.4g}" if self.kind == 'SET' else f"× {self.factor:.4g}"
        return reports.finished(self, reports.Report(phrase("Weight of {count} points: {text}",
                                                            count=count, text=text) if count > 1 else phrase("Weight: {text}",
                                                                                                                  text=text)))


def moved(base, doublings, step=0.0):
    """A weight that the mouse has moved, as short as it is shown: its sign stays, and it is never 0. step: what it is
    rounded to, 0 for nothing."""
    number = base * 2.0 ** min(max(doublings, -60.0), 60.0)
    if step:
        number = max(round(abs(number) / step), 1) * step * (1.0 if base > 0.0 else -1.0)
    return float(f"{number:.4g}")


def has_weights(ob):
    """Whether points of a net may be given weights."""
    owner = net_object.shape_of(ob)
    return owner is not None and not recipes.has(owner.data)


def _chosen(context):
    """[(name of a net, its selected points that have weights, these)]"""
    nets = filter(has_weights, editing.nets_in_edit_mode(context))
    found = [(ob.name, *weighing.of_selected(ob)) for ob in nets]
    return [one for one in found if one[1]]


def _why_none(context):
    """Why there is no weight to change, or ""."""
    if _chosen(context):
        return ""
    if any(selection.selected(ob, session.net) for ob in editing.nets_in_edit_mode(context)
           if (session := live.known_session(ob.data))):
        return "the selected points have no weights: tangents, directions at infinity and points of cubic chains have none"
    return "select points of the net"


def _put(chosen, numbers, is_passing=False):
    """numbers: gives the weights of those that were."""
    for name, vertices, weights in chosen:
        ob = bpy.data.objects.get(name)
        if ob is not None:
            weighing.put(ob, vertices, numbers(weights), is_passing)


def _put_back(chosen):
    for one in chosen:
        with suppress(*FAILURES):       # live.problem() tells of it
            _put([one], lambda weights: weights, is_passing=True)


CLASSES = (SPLINEWRIGHT_OT_weight_here,)
