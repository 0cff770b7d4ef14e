"""The languages of the interface: what Blender draws is translated by Blender, what the add-on puts together by core/base/words.

A file is read when its language is spoken first. Blender takes texts for the present language at once, tells when another is chosen,
and forgets that it should when a file is opened.
"""

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
#: Languages whose texts Blender has, while the add-on is on.
_given = ()
_owner = object()

CLASSES = ()


@cache
def of(locale):
    """The Catalog of a language, or None where there is none."""
    path = _FOLDER / FILES.get(locale, "")
    return catalog.read(path.read_text(encoding='utf-8')) if path.is_file() else None


def _spoken():
    view = bpy.context.preferences.view
    if not view.use_translate_interface:
        return None
    give()
    return of(bpy.app.translations.locale)


def spoken():
    """The language of the interface as pages are named by it, such as "pl"; "" for those that have no file, and for English."""
    view = bpy.context.preferences.view
    return Path(FILES.get(bpy.app.translations.locale, "")).stem if view.use_translate_interface else ""


def give():
    """Give Blender the texts of the present language, if it has them not yet."""
    global _given
    locale = bpy.app.translations.locale
    if locale in _given or locale not in FILES or of(locale) is None:
        return
    if _given:
        bpy.app.translations.unregister(_DOMAIN)
    _given = (*_given, locale)
    bpy.app.translations.register(_DOMAIN, {known: _for_blender(of(known)) for known in _given})


def follow():
    """Have give() called when another language is chosen."""
    bpy.msgbus.clear_by_owner(_owner)
    bpy.msgbus.subscribe_rna(key=(bpy.types.PreferencesView, 'language'), owner=_owner, args=(), notify=give)
    give()


@cache
def _for_blender(found):
    texts = found.of_blender
    return {**{(context, text): said for (_, text), said in texts.items() for context in _CONTEXTS}, **texts}


def register():
    words.use(_spoken)
    follow()


def unregister():
    global _given
    bpy.msgbus.clear_by_owner(_owner)
    words.use(None)
    if _given:
        bpy.app.translations.unregister(_DOMAIN)
    _given = ()
    of.cache_clear()
    _for_blender.cache_clear()
