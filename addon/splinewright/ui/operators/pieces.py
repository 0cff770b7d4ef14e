"""What the verbs of curve shapes and of patch shapes have in common as operators, in Object Mode and while nets are edited.

A number in the redo panel is float32. It stands for the shortest decimal that it is, and for a knot that is the same
number as float32: core.shape.parameters.snapped().
"""

import numpy as np
from bpy.props import BoolProperty, EnumProperty, FloatProperty, IntProperty, StringProperty

from ...bridge.cage import net_object
from ...bridge.data import held, store
from ...bridge.edit import replace_pieces
from ...core.base import decimals
from ...core.base.failures import FAILURES
from ...core.base.words import phrase, say
from ...core.joints import seams
from ...core.verbs import verbs
from .. import active_shape, editing, scene_tolerance
from . import reports
from .long_work import LongWork
from .pick_piece import draw_number
from .selected import OnSelected


def parameter_property(name, what):
    """Its first value in a session of the redo panel is FromActive.invoke()'s to find."""
    return FloatProperty(name=name, description=what + "; a knot is met where both are equal in single precision",
                         default=0.5, precision=5, step=1, options={'SKIP_SAVE'})


def times_property(what):
    return IntProperty(name="Times", description=what, default=1, min=1, soft_max=8)


def tolerance_property(what, default, least=0.0, **more):
    return FloatProperty(name="Tolerance", description=f"{what}, in units of the object", default=default, min=least,
                         precision=6, step=0.01, **more)


def scene_tolerance_property(what):
    """Of operators that take the scene's where none is given."""
    return tolerance_property(what, 1e-4, options={'SKIP_SAVE'})


class UpToTolerance(OnSelected):
    """Changes shapes up to its `tolerance`, the scene's where none is given."""

    has_settings = True

    def can_work(self, ob):
        return replace_pieces.can_change(ob.data)

    def execute(self, context):
        scene_tolerance.settle_in_object(self, context, self.chosen(context)[-1])
        return super().execute(context)

    def draw(self, context):
        self.layout.use_property_split = True
        self.draw_result()
        self.layout.prop(self, "tolerance")


class OnPieces(OnSelected):
    """Does verb() with pieces of every selected shape that fits, or of those whose nets are edited; `already` is said
    where that changes nothing."""

    bl_options = {'REGISTER', 'UNDO', 'PRESET'}
    already = "nothing changes"
    works_on_nets = True
    #: Names of settings whose choices are shown side by side.
    expanded = ()
    #: Whether its tolerance is the scene's where none is given.
    has_scene_tolerance = False

    piece: IntProperty(name="Piece", description="Which piece of the shape, counted from 1; 0 for all of them",
                       default=0, min=0, options={'SKIP_SAVE'})
    #: The name of a shape where it is to be done with that alone.
    only: StringProperty(options={'HIDDEN', 'SKIP_SAVE'})

    def verb(self):
        """A verb of core.verbs.verbs."""
        raise NotImplementedError

    @classmethod
    def poll(cls, context):
        nets = editing.nets_in_edit_mode(context) if cls.works_on_nets else []
        if not nets:
            return super().poll(context)
        if not any(map(cls.fits, map(net_object.shape_of, nets))):
            cls.poll_message_set(say("The net is of another kind of shape"))
            return False
        return True

    @staticmethod
    def _in_order(context):
        nets = editing.nets_in_edit_mode(context)
        if not nets:
            return OnSelected._in_order(context)
        return [net_object.shape_of(ob) for ob in sorted(nets, key=lambda ob: ob == context.object)]

    def chosen(self, context):
        found = super().chosen(context)
        named = context.view_layer.objects.get(self.only)
        return [ob for ob in found if named and ob.data == named.data] if self.only else found

    @property
    def length(self):
        """The tolerance, as it was typed."""
        return decimals.typed(self.tolerance)

    def settings(self):
        """Names of the properties in the redo panel above the piece."""
        return [name for name in type(self).__annotations__ if name not in ('piece', 'only')]

    @property
    def has_settings(self):
        return bool(self.settings())

    def can_work(self, ob):
        return replace_pieces.can_change(ob.data)

    def invoke(self, context, event):
        active_shape.begin(self, self.chosen(context), editing.nets_in_edit_mode(context))
        return super().invoke(context, event)

    def execute(self, context):
        problem = editing.unread(editing.nets_in_edit_mode(context))
        if problem:
            return reports.cancelled(self, problem)
        if self.only and not self.chosen(context):
            return reports.cancelled(self, phrase("{name} is not selected, or of another kind", name=self.only))
        active_shape.forget_asked()
        for ob in self.chosen(context):
            active_shape.note(self, 'piece', ob)
        if self.has_scene_tolerance:
            scene_tolerance.settle_in_object(self, context, self.chosen(context)[-1])
        self._holding = self._count_holding(context)
        return super().execute(context)

    def _count_holding(self, context):
        return sum(len(held.known(ob.data)) for ob in self.chosen(context))

    def verb_of(self, ob):
        """The verb for a shape."""
        return self.verb()

    def work(self, context, ob):
        return self.do(ob, self.verb_of(ob))

    def do(self, ob, verb):
        """Do a verb with the piece of a shape, or with all; the definition before and the verbs.Changed."""
        outcome = replace_pieces.do(ob.data, self.piece, verb, self.already)
        self._note(ob, outcome[1])
        return outcome

    def _note(self, ob, changed):
        active_shape.keep(ob.data, changed.parents)
        active_shape.note(self, 'piece', ob, [parent + 1 for parent in changed.parents])

    def after(self, context):
        """Nets that are edited come out again, of the shapes as they are now."""
        nets = editing.nets_in_edit_mode(context)
        warnings = editing.anew(context, nets) if nets else ()
        released = self._holding - self._count_holding(context)
        if released <= 0:
            return warnings
        if any(ob.type == 'CURVE' for ob in self.chosen(context)):
            return *warnings, phrase("{count} joints hold no more", one="a joint holds no more", count=released)
        return *warnings, phrase("{count} seams hold no more", one="a seam holds no more", count=released)

    def said(self, outcomes):
        return reports.Report(self.summary(outcomes) + told(outcomes.values()), warnings=tuple(_opened(outcomes)))

    def draw(self, context):
        self.layout.use_property_split = True
        self.draw_result()
        labels = self.labels()
        for name in self.settings():
            if name in self.expanded:
                self.layout.row().prop(self, name, expand=True)
            else:
                self.layout.prop(self, name, **({'text': labels[name]} if name in labels else {}))
        draw_number(self.layout, self, 'piece')

    def labels(self):
        """{name of a setting: what it is called here}, where that is not its own name."""
        return {}


class LongOnPieces(LongWork, OnPieces):
    """OnPieces whose verb may take long."""

    def verb_with(self, ob):
        """A function that gives verb_of() for a `cancel` as the library takes it."""
        raise NotImplementedError

    def verb_of(self, ob):
        return self.verb_with(ob)(None)

    def invoke(self, context, event):
        return OnPieces.invoke(self, context, event)

    def tasks(self, context):
        return {ob.name: self._task(ob, replace_pieces.read(ob.data)) for ob in self.chosen(context) if replace_pieces.can_change(ob.data)}

    def _task(self, ob, before):
        verb_with, number, already = self.verb_with(ob), self.piece, self.already
        return lambda cancel: verbs.changed(before, number, verb_with(cancel), already)

    def work(self, context, ob):
        before = replace_pieces.read(ob.data)
        changed = self.result_of(ob.name, self._task(ob, before))
        replace_pieces.put(ob.data, before, changed)
        self._note(ob, changed)
        return before, changed


def _opened(outcomes):
    """Sentences of what came open."""
    for name, (before, changed) in outcomes.items():
        pairs = [phrase("{first} and {second}",
                        first=first + 1, second=second + 1) for first, second in seams.opened(before, changed.definition, changed.parents)]
        if pairs:
            said = ", ".join(pairs[:4]) + (phrase(" and {count} more pairs",
                                                  one=" and {count} more pair", count=len(pairs) - 4) if len(pairs) > 4 else "")
            yield phrase("{name} is open now between the patches {said}: with Piece 0 all are changed alike", name=name, said=said)


def told(outcomes):
    """What changed, for pairs of a definition and the verbs.Changed that came of it."""
    outcomes = list(outcomes)
    texts = []
    if len(outcomes) == 1:
        before, changed = outcomes[0]
        old, new = len(before.pieces), len(changed.definition.pieces)
        if old != new:
            texts.append(phrase("{count} pieces became {now}", one="{count} piece became {now}", count=old, now=new))
        old, new = points(before), points(changed.definition)
        if old != new:
            texts.append(phrase("{count} points became {now}", one="{count} point became {now}", count=old, now=new))
    error = max(changed.error for _, changed in outcomes)
    if error > 0:
        texts.append(phrase("largest distance {error}", error=decimals.text_of(error, 2)))
    return ": " + ", ".join(texts) if texts else ""


def points(definition):
    """How many control points there are, without tangents and twists; of patches, those that they share count once."""
    if definition.has_curves:
        return sum(piece.indices.shape[-1] for piece in definition.pieces)
    nets = [piece.indices[0] if piece.kind == 'hermite' else piece.indices for piece in definition.pieces]
    return len(np.unique(np.concatenate([net.ravel() for net in nets])))


class FromActive:
    """Begins with values that fit the active shape, for the properties named `asked`."""

    asked = ()

    def first_values(self, piece):
        """For each of `asked`, from a curve or patch of the active shape."""
        raise NotImplementedError

    def invoke(self, context, event):
        """With one piece, where no value fits all."""
        is_given = self.properties.is_property_set
        active_shape.begin(self, self.chosen(context), editing.nets_in_edit_mode(context))
        try:
            found = verbs.pieces_of(store.read(self._a_shape(context).data))
            if self.piece == 0 and not is_given('piece') and len({piece.domain for piece in found}) > 1:
                self.piece = 1
            values = self.first_values(found[max(self.piece, 1) - 1])
        except (*FAILURES, IndexError):
            values = ()                 # execute() says it
        for name, value in zip(self.asked, values):
            if not is_given(name):
                setattr(self, name, value)
        self.by_hand = True
        return self.execute(context)

    def _a_shape(self, context):
        return self.chosen(context)[-1]


class WithinTolerance:
    """An error that is allowed, if the user wants a limit."""

    has_scene_tolerance = True

    limited: BoolProperty(name="Limit Error", description="Refuse what moves the shape farther than the tolerance")
    tolerance: scene_tolerance_property("Largest distance that is allowed")

    @property
    def allowed(self):
        return self.length if self.limited else None

    def limits(self):
        return ['limited', 'tolerance'] if self.limited else ['limited']


class Reparameterizes:
    """Another domain, or a Moebius map of the parameter."""

    how: EnumProperty(name="How", items=(
        ('AFFINE', "New Domain", "Map the domain to another one; control points and weights stay"),
        ('MOEBIUS', "Moebius", "Keep the domain and change the weights, so that the parameter is spread unevenly; "
         "a periodic curve is opened")))
    start: FloatProperty(name="Start", description="Where the new domain starts", default=0.0, precision=5)
    end: FloatProperty(name="End", description="Where the new domain ends", default=1.0, precision=5)
    rho: FloatProperty(name="Rho", description="Ratio of the speeds at both ends; above 0, 1 changes nothing",
                       default=2.0, soft_min=0.01, soft_max=100.0, precision=5)

    def how_settings(self):
        """Names of the properties that count."""
        return ['how', 'start', 'end'] if self.how == 'AFFINE' else ['how', 'rho']

    def change(self):
        """The verb of core.verbs.verbs."""
        return verbs.set_domain(self.start, self.end) if self.how == 'AFFINE' else verbs.moebius(self.rho)
