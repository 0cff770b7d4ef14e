"""Sheets of the lectures: every lesson has its steps, figures and answers; one lecture is written and counted."""

import re
import sys
from pathlib import Path

import numpy as np
import pytest

from support import part, scene_state

pytest.importorskip("reportlab", reason="reportlab, which makes the sheets, is not here")
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "blend_samples/sheets"))

import content                                              # noqa: E402
import layout                                               # noqa: E402
import make                                                 # noqa: E402

shelf, figures, words = part('bridge.lessons.shelf'), part('core.figures.figure'), part('core.base.words')
LESSONS = shelf.all_lessons()


@pytest.mark.parametrize('name', LESSONS)
def test_every_step_has_its_figure_and_every_question_its_answer(name):
    lesson, before = LESSONS[name], scene_state()
    steps = content.steps_of(lesson)
    assert scene_state() == before
    assert [step.text for step in steps] == [step.text for step in lesson.steps]
    for step, own in zip(steps, lesson.steps):
        assert (step.figure is not None) == bool(own.make or own.change)
        assert bool(step.answer) == bool(step.kind) == (own.ask is not None)
        if step.figure is not None:
            corners = np.vstack([np.vstack([path.start, *path.steps]) for group in step.figure.groups for item in group.items
                                 if isinstance(item, figures.Stroke) for path in item.paths])
            on_page = corners[((corners >= 0.0) & (corners <= (content.WIDTH, content.HEIGHT))).all(axis=1)]
            assert len(on_page) and np.ptp(on_page, axis=0).max() > 10.0


def test_a_lecture_is_written_in_every_language(tmp_path, monkeypatch):
    drawn, said = [], []
    monkeypatch.setattr(make.pdf, 'draw', lambda canvas, figure: drawn.append(figure))
    monkeypatch.setattr(layout, '_paragraph', lambda text, style, known=layout._paragraph: said.append(text) or known(text, style))
    found = make.make(tmp_path, numbers=('002',))
    assert [path.name for path in found] == [f"002-{language}.pdf" for language in make.LOCALES]
    lessons = part('core.lessons.lectures').of_lecture(LESSONS.values(), '002')
    assert len(drawn) == 4 * sum(bool(step.make or step.change) for lesson in lessons for step in lesson.steps)
    for path in found:
        pages = path.read_bytes()
        assert pages.startswith(b"%PDF") and int(re.search(rb"/Count (\d+)", pages)[1]) > 2 and b"DejaVuSans" in pages
    text = " ".join(said)
    assert "Answers" in text and "Odpowiedzi" in text and re.search(r"[а-я]{5}", text)
    assert words.say(words.phrase("Answers")) == "Answers", "the language of Blender is spoken again"
