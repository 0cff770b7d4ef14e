"""A lesson in a window in each language: text in the view, panels and menus follow the preferences at once."""

import os
import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).parent))
from window import View, empty_file, mean_difference, part, redrawn, run, save_picture, until

OUTPUT = Path(os.environ['SPLINEWRIGHT_OUTPUT'])
stage = part('bridge.lessons.stage')
LANGUAGES = {'it': 'it_IT', 'pl': 'pl_PL', 'ru': 'ru_RU'}


def steps():
    view = View()
    view.move()
    empty_file()
    preferences = bpy.context.preferences.view
    with view.override():
        assert bpy.ops.splinewright.start_lesson('EXEC_DEFAULT', True, lesson="c2-chain") == {'FINISHED'}
    yield from until(lambda: stage.lesson_of(view.window.scene), "the lesson")
    view.open_sidebar()
    yield from view.show_tab("NURBS", (1045, 552))
    yield from redrawn()
    pictures = {'en': save_picture(OUTPUT / "lesson-en.png")}
    preferences.use_translate_interface = preferences.use_translate_tooltips = True
    for short, language in LANGUAGES.items():
        preferences.language = language
        yield from redrawn()
        yield from redrawn()
        assert bpy.app.translations.pgettext_iface("Insert Knot", "Operator") != "Insert Knot", "Blender was not given the language"
        pictures[short] = save_picture(OUTPUT / f"lesson-{short}.png")
    shown = list(pictures.values())
    for i, picture in enumerate(shown):
        for other in shown[i + 1:]:
            assert mean_difference(picture.astype(int), other.astype(int)) > 0.5, "two languages look alike"
    preferences.language = 'en_US'
    with view.override():
        assert bpy.ops.splinewright.leave_lesson('EXEC_DEFAULT', True) == {'FINISHED'}
    yield from until(lambda: len(bpy.data.scenes) == 1, "one scene")


run(steps())
