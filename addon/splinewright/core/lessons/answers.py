"""Answers of lessons, kept as JSON, and as a table for a spreadsheet."""

import csv
import io
import json
from typing import NamedTuple

#: Most characters of a text in a cell.
_MOST = 500


class Row(NamedTuple):
    """An answer."""

    file: str
    lesson: str
    step: int                           # from 1
    answer: str
    right: bool
    tries: int


def read(text):
    """{number of a step as text: {'answer', 'right', 'tries'}} of a kept text; {} where that is damaged."""
    found = _parsed(text)
    return found if all(isinstance(one, dict) for one in found.values()) else {}


def read_record(text):
    """{name of a lesson: what read() gives} of a kept text; {} where that is damaged."""
    found = _parsed(text)
    are_right = all(isinstance(one, dict) and all(isinstance(answer, dict) for answer in one.values()) for one in found.values())
    return found if are_right else {}


def _parsed(text):
    try:
        found = json.loads(text)
    except (TypeError, ValueError, RecursionError):
        return {}
    return found if isinstance(found, dict) else {}


def merged(records):
    """One record of several: of each step the answer with the most tries."""
    found = {}
    for record in records:
        for name, given in record.items():
            known = found.setdefault(name, {})
            for step, answer in given.items():
                if step not in known or tries(answer) >= tries(known[step]):
                    known[step] = answer
    return found


def rows(file, record, lessons):
    """The Rows of a record; lessons: {name: Lesson} of those that are known, whose choices are written as they read."""
    found = [Row(file, name, int(step) + 1, _in_words(answer.get('answer'), _ask(lessons.get(name), int(step))),
                 answer.get('right') is True, tries(answer))
             for name, given in record.items() for step, answer in given.items() if step.isdecimal() and len(step) < 7]
    return sorted(found)


def tries(answer):
    """How often it was tried; 0 where that is damaged."""
    found = answer.get('tries')
    return found if type(found) is int else 0


def _ask(lesson, step):
    return lesson.steps[step].ask if lesson is not None and step < len(lesson.steps) else None


def _in_words(answer, ask):
    if ask is not None and ask.kind == 'choose' and type(answer) is int and 0 <= answer < len(ask.choices):
        return ask.choices[answer]
    if isinstance(answer, list):
        return " ".join(map(str, answer))[:_MOST]
    return "" if answer is None else str(answer)[:_MOST]


def table(found):
    """The text of a CSV file of Rows. No cell begins as a formula of a spreadsheet does."""
    file = io.StringIO()
    writer = csv.writer(file, lineterminator="\n")
    writer.writerow(Row._fields)
    for row in found:
        writer.writerow((_plain(row.file), _plain(row.lesson), row.step, _plain(row.answer), "yes" if row.right else "no", row.tries))
    return file.getvalue()


def _plain(text):
    is_formula = text[:1] in ("=", "+", "@", "-", "\t", "\r") and not _is_number(text)
    return f"'{text}" if is_formula else text


def _is_number(text):
    try:
        float(text)
    except ValueError:
        return False
    return True
