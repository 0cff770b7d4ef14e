"""No text of the sidebar's tab is cut off, in any language: every panel in many states, at the width with which the sidebar opens."""

import os
import sys
from pathlib import Path

import bpy

sys.path[:0] = [str(Path(__file__).parents[1] / "blender"), str(Path(__file__).parent)]
from fitting import Recorder, cut_off, drawn, placed, too_long
from operator_cases import FOLLOWED
from shapes import activate
from window import View, empty_file, into_net, out_of_net, part, redrawn, run, save_picture, select_points, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])
LANGUAGES = ('en_US', 'it_IT', 'pl_PL', 'ru_RU')
table, stage, shelf, words = part('core.recipes.table'), part('bridge.lessons.stage'), part('bridge.lessons.shelf'), part('core.base.words')
lessons_panel, texts = part('ui.lessons_panel'), part('ui.texts')
#: Recipes whose operators have names of their own.
ELSEWHERE = {'follow': 'follow_object', 'through_objects': 'curve_through_points'}
#: {(language, panel, words)} that are cut off, names of panels that were seen, and what was in them when they were measured.
cut, seen, measured = set(), set(), set()


def panels():
    found = {cls for cls in bpy.types.Panel.__subclasses__() if cls.__module__.startswith(part('ui').__name__)}
    return sorted((cls for cls in found if getattr(cls, 'bl_category', "") == "NURBS"), key=lambda cls: cls.__name__)


def content(cls, region):
    """The panel's English texts, with the width that each has."""
    return cls.__name__, tuple((*field, round(width)) for field, width in placed(drawn(cls, bpy.context), region.width))


def look(view, state):
    """Measure the panels that there are now, in each language. What was measured is not measured again."""
    preferences, region = bpy.context.preferences.view, view._region('UI')
    with bpy.context.temp_override(window=view.window, area=view.area, region=region):
        shown = [cls for cls in panels() if not hasattr(cls, 'poll') or cls.poll(bpy.context)]
        seen.update(cls.__name__ for cls in shown)
        contents = {cls: content(cls, region) for cls in shown}
        shown = [cls for cls in shown if contents[cls] not in measured]
        measured.update(contents.values())
        for language in LANGUAGES if shown else ():
            preferences.language = language
            preferences.use_translate_interface = True
            words.say("NURBS")          # Blender has the language's texts from now on
            for cls in shown:
                for text, needed, has in too_long(cls, bpy.context, region):
                    if (language, cls.__name__, text) not in cut:
                        cut.add((language, cls.__name__, text))
                        print(f"{language}  {cls.__name__:40} {needed:5.0f} > {has:5.0f}  {text}   [{state}]", flush=True)
    if preferences.language != 'en_US':
        preferences.language = 'en_US'


def select(*obs):
    for ob in bpy.context.view_layer.objects:
        ob.select_set(ob in obs)
    bpy.context.view_layer.objects.active = obs[-1] if obs else None


def call(view, name, **settings):
    with view.override():
        done = getattr(bpy.ops.splinewright, name)('EXEC_DEFAULT', True, **settings)
    assert done == {'FINISHED'}, name
    return bpy.context.object


def recipes(view):
    """What each recipe makes, and what there is to do with what it is made from."""
    for kind in table.RECIPES:
        empty_file()
        if kind in ELSEWHERE or kind not in FOLLOWED and table.RECIPES[kind].inputs:
            continue
        obs = FOLLOWED[kind]() if kind in FOLLOWED else []
        if obs:
            activate(*obs)
            look(view, f"inputs of {kind}")
        call(view, f"add_{kind}")
        look(view, kind)
        yield


def shapes(view):
    """Shapes with control points, alone and together, and their nets."""
    empty_file()
    look(view, "nothing")
    with view.override():
        bpy.ops.curve.primitive_bezier_curve_add('EXEC_DEFAULT', True)
    look(view, "a curve of Blender's")
    empty_file()
    curve, chain, patch = call(view, 'add_nurbs_curve'), call(view, 'add_bezier_chain', count=3), call(view, 'add_nurbs_patch', knots_u='PERIODIC')
    pot = call(view, 'add_teapot')
    for state, obs in {"curve": (curve,), "chain": (chain,), "curves": (chain, curve), "patch": (patch,), "patches": (pot,), "two surfaces": (pot, patch)}.items():
        select(*obs)
        yield
        look(view, state)
    sights = bpy.context.scene.splinewright_sights
    shown = [name for name, known in sights.bl_rna.properties.items() if known.type == 'BOOLEAN' and not getattr(sights, name)]
    for name in shown:
        setattr(sights, name, True)
    for ob in (curve, pot):
        select(ob)
        yield
        look(view, "all overlays")
    for name in shown:
        setattr(sights, name, False)
    pot.data.splinewright.show_seams = True
    look(view, "seams")
    for ob in (curve, chain, patch):
        select(ob)
        view.press('TAB')
        yield from into_net()
        look(view, "a net")
        select_points(1, 2, 3)
        yield from redrawn()
        look(view, "points")
        view.press('TAB')
        yield from out_of_net()


def kind_of(step):
    """What the panel of a step draws: steps of one kind differ in their words alone."""
    return step.ask and step.ask.kind, bool(step.watch), bool(step.move)


def lessons(view):
    """A step of each kind as the panel draws it, and the words of all."""
    empty_file()
    known = set()
    for name, lesson in shelf.all_lessons().items():
        kinds = list(map(kind_of, lesson.steps))
        if known.issuperset(kinds):
            continue
        call(view, 'start_lesson', lesson=name)
        yield from until(lambda: stage.lesson_of(view.window.scene), "a lesson")
        for number, kind in enumerate(kinds, 1):
            if kind not in known:
                look(view, f"lesson {name}, step {number}")
                known.add(kind)
            if number < len(kinds):
                call(view, 'lesson_step', way='NEXT')
            yield
        call(view, 'leave_lesson')
    preferences = bpy.context.preferences.view
    for language in LANGUAGES:
        preferences.language = language
        preferences.use_translate_interface = True
        words.say("NURBS")
        look_at_words(view, language)
        yield
    preferences.language = 'en_US'


def look_at_words(view, language):
    """Measure what all lessons say, as the panel draws it."""
    region = view._region('UI')
    with bpy.context.temp_override(window=view.window, area=view.area, region=region):
        for name, lesson in shelf.all_lessons().items():
            for number, step in enumerate(lesson.steps, 1):
                layout = Recorder()
                texts.draw_note(layout, lesson.title, icon='NONE')
                texts.draw_note(layout, step.text, icon='NONE')
                box = layout.box()
                for watch in step.watch:
                    texts.draw_note(box, words.say(watch.text), icon='NONE', beside=lessons_panel._BOX)
                if step.ask is not None and step.ask.choices:
                    lessons_panel._draw_choices(box, list(map(words.say, step.ask.choices)))
                if step.hint:
                    texts.draw_note(box, step.hint, icon='LIGHT', beside=lessons_panel._BOX)
                for text, needed, has in cut_off(layout, region):
                    cut.add((language, name, text))
                    print(f"{language}  {name:40} {needed:5.0f} > {has:5.0f}  {text}   [step {number}]", flush=True)


def steps():
    yield from View().in_sidebar(lessons, shapes, recipes)
    save_picture(OUTPUT / "workspace_texts.png")
    lacking = {cls.__name__ for cls in panels()} - seen
    assert not lacking, lacking
    assert not cut, f"{len(cut)} texts are cut off"


run(steps())
