"""Lessons by the lectures that they are about: the items that they name begin with the number of one, as 000.25 does."""

import re

#: Of each lecture its number, and what it is called.
LECTURES = {'000': "Parametric Curves", '001': "Graphics and Surfaces", '002': "B-Spline Basis Functions",
            '003': "Parametric Curves, 2nd Copy", '004': "Curves and Surfaces"}
OTHERS = "Others"
_ITEM = re.compile(r"(\d{3})\.(\d+)")


def groups(lessons):
    """[(label, [Lesson])]: each lesson at the first lecture that it names, in the order of its items."""
    found = {label: [] for label in (*map(label_of, LECTURES), OTHERS)}
    for lesson in lessons:
        items = _items(lesson)
        found[label_of(items[0][0]) if items else OTHERS].append(((items or [("", 0)])[0], lesson))
    return [(label, [lesson for _, lesson in sorted(those, key=lambda one: one[0])]) for label, those in found.items() if those]


def of_lecture(lessons, number):
    """Those that name any item of a lecture, in the order of its items."""
    named = [(min(item for lecture, item in _items(lesson) if lecture == number), lesson) for lesson in lessons
             if any(lecture == number for lecture, _ in _items(lesson))]
    return [lesson for _, lesson in sorted(named, key=lambda one: one[0])]


def label_of(number):
    return f"{number} {LECTURES[number]}"


def _items(lesson):
    """(the number of a lecture, that of an item) of what a lesson names and is known."""
    found = [_ITEM.match(name) for name in lesson.lectures]
    return [(one[1], int(one[2])) for one in found if one and one[1] in LECTURES]
