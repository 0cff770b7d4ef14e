"""The question of a lesson's last step: a number of the active shape from the closed list, choices, or points."""

import bpy
from bpy.props import BoolProperty, EnumProperty, FloatProperty, IntProperty, StringProperty

from ...bridge.lessons import authoring
from ...bridge.shape import shape
from ...core.base import decimals
from ...core.base.failures import Refusal
from ...core.base.words import phrase
from ...core.lessons import drafts, measure_words
from ...core.lessons.lesson import Measure
from ...core.lessons.measures import KINDS, measured
from ..ui_state import ui_state
from . import reports
from .lesson_making import _OnDraft, draft_of, write

#: What an argument of a measure is asked by.
_FIELDS = {'at': ('at', 'at_setting'), 'at_v': ('at_v',), 'index': ('index',), 'name': ('setting',), 'to': ()}
_MEASURES = tuple((kind, kind.replace("_", " ").capitalize(), phrase("Takes {names}",
                                                                     names=', '.join(known.takes)) if known.takes else "A number of the whole curve")
                  for kind, known in KINDS.items() if set(known.takes) <= set(_FIELDS))
_TYPED = ('NUMBER', "Typed", "The parameter is typed")


def _numbers_of(ob):
    """The numbers among the settings of a shape's recipe."""
    found = authoring.recipe_of(ob) if shape.has_shape(ob) else None
    return [one for one in found.parameters if type(one.default) in (int, float)] if found else []


def _settings(_self, context):
    return _kept([(one.name, one.label, one.description) for one in _numbers_of(context.object)] or [('NONE', "None", "The shape has no numbers")])


def _places(_self, context):
    found = [(f"{name}\n{one.name}", phrase("{label} of {name}",
                                            label=phrase(one.label), name=name), one.description) for ob, name in authoring.known(context.scene).items()
             for one in _numbers_of(ob)]
    return _kept([_TYPED, *found])


def _kept(items):
    """Blender needs the texts to live on; equal ones are kept once."""
    known = {item: item for item in ui_state.lesson_items}
    ui_state.lesson_items = (*ui_state.lesson_items, *(item for item in items if item not in known))[-5000:]
    return [known.get(item, item) for item in items]


class SPLINEWRIGHT_OT_ask_question(_OnDraft, bpy.types.Operator):
    bl_idname = "splinewright.ask_question"
    bl_label = "Ask Question"
    bl_description = "Ask something at the last step of the lesson; of what learners do, the present scene is the solution"

    kind: EnumProperty(name="Answer", description="How the question is answered", options={'SKIP_SAVE'}, items=(
        ('do', "Do", "The shapes are moved until the number is right"), ('number', "Number", "The number is typed"),
        ('choose', "Choose", "One of several answers is chosen"), ('point', "Points", "Control points of the active shape are picked")))
    measure: EnumProperty(name="Measure", description="Which number of the active shape counts", items=_MEASURES, default='x', options={'SKIP_SAVE'})
    piece: IntProperty(name="Piece", description="Which curve of the shape, counted from 1", default=1, min=1, options={'SKIP_SAVE'})
    at_setting: EnumProperty(name="At", description="Where on the curve: a typed parameter, or a setting of a shape", items=_places, options={'SKIP_SAVE'})
    at: FloatProperty(name="Parameter", description="Where on the curve", default=0.5, precision=5, options={'SKIP_SAVE'})
    at_v: FloatProperty(name="Parameter V", description="Where on the surface, along v", default=0.5, precision=5, options={'SKIP_SAVE'})
    index: IntProperty(name="Point", description="Which control point, counted from 0", min=0, options={'SKIP_SAVE'})
    setting: EnumProperty(name="Setting", description="Which number of the construction", items=_settings, options={'SKIP_SAVE'})
    relation: EnumProperty(name="Right If", description="When the number is right", options={'SKIP_SAVE'}, items=(
        ('near', "Near the Present", "It is near what it is now"), ('above', "Above", "It is above a bound"), ('below', "Below", "It is below a bound")))
    bound: FloatProperty(name="Bound", description="What the number must be above or below", precision=5, options={'SKIP_SAVE'})
    within: FloatProperty(name="Within", description="How near the number must be", default=0.01, min=1e-9, precision=5, options={'SKIP_SAVE'})
    choices: StringProperty(name="Answers", description="The answers to choose from, with a bar | between them", options={'SKIP_SAVE'})
    right: IntProperty(name="Right One", description="Which of the answers is right, counted from 1", default=1, min=1, options={'SKIP_SAVE'})
    points: StringProperty(name="Points", description="The numbers of the right points, counted from 0, with spaces between them", options={'SKIP_SAVE'})
    hint: StringProperty(name="Hint", description="A sentence that is shown after a wrong answer", options={'SKIP_SAVE'})
    more: BoolProperty(name="One More Condition", description="Conditions that the question already has must hold, too", options={'SKIP_SAVE'})

    def invoke(self, context, event):
        return context.window_manager.invoke_props_dialog(self, width=420)

    def draw(self, context):
        column = self.layout.column()
        column.use_property_split = True
        for name in self._asked(context):
            column.prop(self, name)

    def _asked(self, context):
        """Names of the fields that count."""
        if self.kind == 'choose':
            return 'kind', 'choices', 'right', 'hint'
        if self.kind == 'point':
            return 'kind', 'points', 'hint'
        takes = KINDS[self.measure].takes
        fields = [name for one in takes for name in (('at_setting', 'at') if one == 'at' else _FIELDS[one])]
        if 'at' in takes and self.at_setting != _TYPED[0]:
            fields.remove('at')
        if self.kind == 'number':
            return 'kind', 'measure', *fields, 'piece', 'within', 'hint'
        return ('kind', 'measure', *fields, 'piece', 'relation', 'within' if self.relation == 'near' else 'bound', 'hint', 'more')

    def done(self, context, scene):
        block, draft, lesson = draft_of(context)
        names, known = authoring.known(scene), drafts.state_of(lesson)
        names = {ob: name for ob, name in names.items() if name in known}
        if self.kind == 'choose':
            question, changed, said = self._choice(), (), "one of the answers is to be chosen"
        else:
            if names.get(context.object) is None:
                raise Refusal("the active object is not a shape of the lesson: select one that a step has made")
            found = authoring.present(list(names), names, authoring.graph())
            question, changed, said = self._of_shape(context, names, known, found)
        may_move = drafts.moves(known, found, changed) if changed else ()
        if not self.more and 'ask' in draft['steps'][-1]:
            draft = {**draft, 'steps': [*draft['steps'][:-1], {key: value for key, value in draft['steps'][-1].items() if key != 'ask'}]}
        write(block, drafts.ask(draft, question, self.hint.strip(), changed, may_move))
        return reports.finished(self, reports.Report(phrase("Step {number} asks: {said}", number=len(lesson.steps), said=said)))

    def _choice(self):
        choices = [one.strip() for one in self.choices.split("|") if one.strip()]
        if len(choices) < 2 or self.right > len(choices):
            raise Refusal("type two answers or more with a bar | between them, and the number of the right one")
        return {'choose': choices, 'right': self.right - 1}

    def _of_shape(self, context, names, known, found):
        """(the question, changes that lead to its solution, what it says)"""
        name = names[context.object]
        if self.kind == 'point':
            return {'point': self._numbers(), 'of': name}, (), phrase("points of {name} are to be picked", name=name)
        said = self._measure(context, names, name)
        measure, shown = _measure_of(said), authoring.shown(found)
        number = measured(measure, shown)
        if self.kind == 'number':
            return {'number': said, 'within': decimals.typed(self.within)}, (), phrase("the number is {number:.6g}", number=number)
        changed = drafts.changes(known, found)
        if not changed:
            raise Refusal("the shapes are as the step begins: bring them to where the question is answered, then ask")
        return {'do': [self._condition(said, number)]}, changed, phrase("{measure}, which is {number:.6g} in the solution",
                                                                        measure=measure_words.named(measure, shown), number=number)

    def _numbers(self):
        try:
            return sorted({int(one) for one in self.points.replace(",", " ").split()})
        except ValueError:
            raise Refusal("{points!r} are no numbers of points: 1 3 4 would be some", points=self.points) from None

    def _condition(self, said, number):
        if self.relation == 'near':
            return {'that': said, 'near': float(f"{number:.12g}"), 'within': decimals.typed(self.within)}
        bound = decimals.typed(self.bound)
        is_above = self.relation == 'above'
        if not (number > bound if is_above else number < bound):
            raise Refusal("the number is {number:.6g} now, and not above {bound:g}: the present state must be a solution" if is_above else
                          "the number is {number:.6g} now, and not below {bound:g}: the present state must be a solution",
                          number=number, bound=bound)
        return {'that': said, self.relation: bound}

    def _measure(self, context, names, name):
        """What a file says of the number that is asked."""
        arguments = {}
        for one in KINDS[self.measure].takes:
            arguments[one] = self._argument(one, context, names, name)
        piece = {'piece': self.piece} if self.piece > 1 else {}
        return {'measure': self.measure, 'of': name, **arguments, **(piece if self.measure != 'setting' else {})}

    def _argument(self, one, context, names, name):
        if one == 'at' and self.at_setting != _TYPED[0]:
            of, _, setting = self.at_setting.partition("\n")
            return {'measure': 'setting', 'of': of, 'name': setting}
        if one in ('at', 'at_v'):
            return decimals.typed(getattr(self, one))
        if one == 'to':
            others = [names[ob] for ob in context.selected_objects if ob in names and names[ob] != name]
            if len(others) != 1:
                raise Refusal("select the curve to which the distance is, too")
            return others[0]
        return self.setting if one == 'name' else self.index


def _measure_of(said):
    """The Measure that a file says."""
    arguments = {key: _measure_of(value) if isinstance(value, dict) else value for key, value in said.items() if key not in ('measure', 'of')}
    return Measure(said['measure'], said['of'], arguments)


CLASSES = (SPLINEWRIGHT_OT_ask_question,)
