"""Lessons as files: those of the add-on, those in the user's folder, and texts of the open file."""

from functools import lru_cache
from pathlib import Path

import bpy

from ...core.base.failures import Refusal
from ...core.lessons import reading
from ..data import versions

FOLDER = Path(__file__).resolve().parents[2] / "lessons"
#: The add-on.
_PACKAGE = __package__.partition(".bridge")[0]
_ENDING = ".json"


@lru_cache(None)
def all_lessons():
    """{name: core.lessons.lesson.Lesson} in the order of their files. Raises Refusal where one is damaged."""
    found = {}
    for path in sorted(FOLDER.glob("*.json")):
        lesson = read(path)[0]
        if lesson.name in found:
            raise Refusal("{name}: a lesson {lesson_name!r} is there already", name=path.name, lesson_name=lesson.name)
        found[lesson.name] = lesson
    return found


def read(path):
    """(the lesson of a file, its text). Raises Refusal."""
    path = Path(path)
    try:
        if not path.is_file():
            raise Refusal("there is no such file")
        if path.stat().st_size > reading.MOST_BYTES:
            raise Refusal("it has {count:,} bytes: {most_bytes:,} are the most",
                          count=path.stat().st_size, most_bytes=reading.MOST_BYTES)
        text = path.read_text(encoding='utf-8-sig')
        return read_text(text), text
    except UnicodeDecodeError:
        raise Refusal("{name}: it is not a text file", name=_printable(path.name)) from None
    except (OSError, ValueError) as error:      # a Refusal is a ValueError, as is what a path must not hold
        raise Refusal("{name}: {error}", name=_printable(path.name), error=getattr(error, 'strerror', None) or error) from None


def _printable(text):
    """Names of files may hold bytes that are no text."""
    return text.encode('utf-8', 'replace').decode('utf-8')


@lru_cache(16)
def read_text(text):
    """The lesson of a text. Raises Refusal."""
    return reading.read(text)


def read_block(name):
    """(the lesson of a text of the open file, its text). Raises Refusal."""
    block = bpy.data.texts.get(name)
    if block is None:
        raise Refusal("there is no text {name!r} in this file", name=name)
    text = block.as_string()
    try:
        return read_text(text), text
    except Refusal as error:
        raise Refusal("{name}: {error}", name=name, error=error) from None


def blocks():
    """Names of the texts of the open file that may be lessons: they end as files of lessons do."""
    return [block.name for block in bpy.data.texts if block.name.lower().endswith(_ENDING)]


def own_folder(create=False):
    """The folder for lessons of the user, or None where there is none. Raises OSError where it cannot be made."""
    if versions.has_extension_folders:
        try:
            found = Path(bpy.utils.extension_path_user(_PACKAGE, path="lessons", create=create))
            return found if found.is_dir() else None
        except ValueError:
            pass                        # it was installed as add-ons were before there were extensions
    found = bpy.utils.user_resource('DATAFILES', path="splinewright/lessons", create=create)
    return Path(found) if found and Path(found).is_dir() else None


def own_files():
    """The files in it, by name."""
    folder = own_folder()
    return sorted(path for path in folder.iterdir() if path.suffix.lower() == _ENDING) if folder else []
