"""Makes the sheets of the lectures inside Blender: blender --background --python make.py -- FOLDER [LANGUAGE...]

A PDF for each lecture in each language, or in those that are named: en, it, pl, ru.
"""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

try:
    import layout
except ImportError as error:
    sys.exit(f"The sheets need the Python package reportlab ({error}): sudo apt install python3-reportlab")

from content import part, steps_of                          # noqa: E402

languages, lectures, pdf, shelf, words = (part(name) for name in (
    'ui.languages', 'core.lessons.lectures', 'core.figures.pdf', 'bridge.lessons.shelf', 'core.base.words'))
#: Blender's names of languages by those of files.
LOCALES = {'en': "", **{locale[:2]: locale for locale in languages.FILES}}


def make(folder, wanted=tuple(LOCALES), numbers=tuple(lectures.LECTURES)):
    """Write the sheets of lectures in languages; [path]."""
    folder.mkdir(parents=True, exist_ok=True)
    shown, found = {}, []
    for number in numbers:
        lessons = lectures.of_lecture(shelf.all_lessons().values(), number)
        for lesson in lessons:
            if lesson.name not in shown:
                shown[lesson.name] = steps_of(lesson)
        for language in wanted:
            path = folder / f"{number}-{language}.pdf"
            _write(path, number, [(words.phrase(lesson.title), shown[lesson.name]) for lesson in lessons], language)
            found.append(path)
    return found


def _write(path, number, lessons, language):
    catalog = languages.of(LOCALES[language]) if LOCALES[language] else None
    words.use(lambda: catalog)
    try:
        title = f"{number} {words.say(words.phrase(lectures.LECTURES[number]))}"
        layout.write(path, title, lessons, words.say, pdf.draw)
    finally:
        languages.unregister()
        languages.register()


if __name__ == '__main__':
    place, *named = sys.argv[sys.argv.index('--') + 1:]
    for made in make(Path(place), tuple(named) or tuple(LOCALES)):
        print(f"{made.name}: made, {made.stat().st_size:,} bytes")
