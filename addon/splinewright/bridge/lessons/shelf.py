"""Lessons as files: those of the add-on."""

from functools import lru_cache
from pathlib import Path

from ...core.base.failures import Refusal
from ...core.lessons import reading

FOLDER = Path(__file__).resolve().parents[2] / "lessons"


@lru_cache(None)
def all_lessons():
    """{name: core.lessons.lesson.Lesson} in the order of their files. Raises Refusal where one is damaged."""
    found = {}
    for path in sorted(FOLDER.glob("*.json")):
        lesson = read(path)
        if lesson.name in found:
            raise Refusal(f"{path.name}: a lesson {lesson.name!r} is there already")
        found[lesson.name] = lesson
    return found


def read(path):
    """The lesson of a file. Raises Refusal."""
    try:
        return reading.read(Path(path).read_text(encoding='utf-8'))
    except (OSError, UnicodeDecodeError) as error:
        raise Refusal(f"{Path(path).name} cannot be read: {error}") from None
    except Refusal as error:
        raise Refusal(f"{Path(path).name}: {error}") from None
