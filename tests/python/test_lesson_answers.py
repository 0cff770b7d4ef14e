"""Answers of lessons as a table: whatever a file keeps, each row has its six cells."""

import csv
import io
import json

import numpy as np
import pytest

from addon_core import core

answers, lesson = core("lessons.answers"), core("lessons.lesson")
ASK = lesson.Ask('choose', choices=("n", "n - 1"), right=1)
LESSONS = {'cut': lesson.Lesson("cut", "Cut", (), (lesson.Step("x"), lesson.Step("y", ask=ASK)))}


def rows(record):
    return answers.rows("ann.blend", record, LESSONS)


def test_rows_have_what_was_answered():
    record = {'cut': {"1": {'answer': 1, 'right': True, 'tries': 2}, "0": {'answer': None, 'right': False, 'tries': 1}},
              'own': {"2": {'answer': 0.75, 'right': True, 'tries': 1}, "3": {'answer': [1, 3], 'right': False, 'tries': 4}}}
    assert rows(record) == [("ann.blend", "cut", 1, "", False, 1), ("ann.blend", "cut", 2, "n - 1", True, 2),
                            ("ann.blend", "own", 3, "0.75", True, 1), ("ann.blend", "own", 4, "1 3", False, 4)]


def cells(found):
    return list(csv.reader(io.StringIO(answers.table(found))))


def test_a_table_reads_back_and_holds_no_formulas():
    found = [answers.Row('a,"b.blend', "=cmd()", 1, "@x\ny", True, 2), answers.Row("-c.blend", "l", 2, "-1.5", False, 1), answers.Row("d", "l", 3, "+", True, 1)]
    assert cells(found) == [["file", "lesson", "step", "answer", "right", "tries"], ['a,"b.blend', "'=cmd()", "1", "'@x\ny", "yes", "2"],
                            ["'-c.blend", "l", "2", "-1.5", "no", "1"], ["d", "l", "3", "'+", "yes", "1"]]


@pytest.mark.parametrize('text', (None, 3, "", "{", "[]", '{"a": 1}', "[" * 100_000, '{"a": {"1": 2}}'))
def test_damaged_records_are_none(text):
    assert answers.read_record(text) == {}


def test_of_two_records_the_one_with_more_tries_counts():
    one = {'cut': {"0": {'tries': 3, 'answer': 1}, "1": {'tries': 1, 'answer': 1}}}
    other = {'cut': {"0": {'tries': 2, 'answer': 2}, "1": {'tries': "many"}, "2": {'tries': 1}}, 'own': {}}
    assert answers.merged([one, other]) == {'cut': {"0": one['cut']["0"], "1": one['cut']["1"], "2": {'tries': 1}}, 'own': {}}


def test_whatever_is_kept_becomes_rows_of_six_cells():
    rng = np.random.default_rng(4)
    odd = (None, True, -1, 10 ** 30, "", "=x", [], {}, [[1], "a"], 1e308, float('nan'), "\n", "5", "²", "-1", "9" * 40)
    pick = lambda: odd[rng.integers(len(odd))]
    for _ in range(500):
        record = {str(pick()): {str(pick()): {'answer': pick(), 'right': pick(), 'tries': pick()} for _ in range(3)} for _ in range(2)}
        kept = answers.read_record(json.dumps(record))
        assert all(len(line) == 6 for line in cells(rows(answers.merged([kept, record]))))
