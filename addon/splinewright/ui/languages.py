"""The languages of the interface: what Blender draws is translated by Blender, what the add-on puts together by core/base/words."""

from functools import cache
from pathlib import Path

import bpy

from ..core.base import catalog, words

_FOLDER = Path(__file__).parents[1] / "languages"
#: Files by Blender's names of languages.
FILES = {'it_IT': "it.po", 'pl_PL': "pl.po", 'ru_RU': "ru.po"}
_DOMAIN = __package__
#: Contexts in which Blender looks texts up: of operators and of everything else. A text that has but one is the same in both.
_CONTEXTS = ("*", "Operator")

CLASSES = ()


@cache
def of(locale):
    """The Catalog of a language, or None where there is none."""
    path = _FOLDER / FILES.get(locale, "")
    return catalog.read(path.read_text(encoding='utf-8')) if path.is_file() else None


def _spoken():
    view = bpy.context.preferences.view
    return of(bpy.app.translations.locale) if view.use_translate_interface else None


def spoken():
    """The language of the interface as pages are named by it, such as "pl"; "" for those that have no file, and for English."""
    view = bpy.context.preferences.view
    return Path(FILES.get(bpy.app.translations.locale, "")).stem if view.use_translate_interface else ""


def _for_blender(found):
    texts = found.of_blender
    return {**{(context, text): said for (_, text), said in texts.items() for context in _CONTEXTS}, **texts}


def register():
    bpy.app.translations.register(_DOMAIN, {locale: _for_blender(of(locale)) for locale in FILES if of(locale)})
    words.use(_spoken)


def unregister():
    words.use(None)
    bpy.app.translations.unregister(_DOMAIN)
    of.cache_clear()
