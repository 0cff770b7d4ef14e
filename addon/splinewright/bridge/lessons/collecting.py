"""Answers that are kept in other files, which are not opened."""

from pathlib import Path

import bpy

from ...core.base.failures import Refusal
from ...core.lessons import answers
from . import shelf, stage


def rows_of(path, lessons):
    """The core.lessons.answers.Rows of a .blend file; lessons: as of answers.rows(). Raises Refusal."""
    path = Path(path)
    name = path.name.encode('utf-8', 'replace').decode('utf-8')
    if not path.is_file():
        raise Refusal("{name}: there is no such file", name=name)
    try:
        record, own = _read(path)
    except (OSError, RuntimeError) as error:
        raise Refusal("{name} is no file of Blender: {error}", name=name, error=error) from None
    return answers.rows(name, record, {**lessons, **own})


def _read(path):
    """(all answers as stage.all_answers(), {name: Lesson} of lessons that the file has with it)."""
    with bpy.data.temp_data() as data:
        with data.libraries.load(str(path)) as (there, wanted):
            wanted.scenes = list(there.scenes)
        scenes = [scene for scene in wanted.scenes if scene is not None]
        own = dict(filter(None, map(_lesson, scenes)))
        return answers.merged([stage.all_answers(scene) for scene in scenes]), own


def _lesson(scene):
    """(name, Lesson) of one that is not the add-on's."""
    text = stage.text_of(scene)
    try:
        return (stage.lesson_of(scene), shelf.read_text(text)) if text else None
    except Refusal:
        return None                     # its answers are written as they are kept
