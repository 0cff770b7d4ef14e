"""What users read, in their language. Code keeps and compares English; a text is translated where it is shown, by say().

A message with names or numbers in it is a phrase: a pattern and what fills it, so that the pattern is translated before it is filled. One
with {count} has as many forms as the language has for that number. What was put together elsewhere, by the library or in a file, is
recognized by the patterns of the catalog.
"""

from functools import lru_cache, reduce


class Phrase(str):
    """An English sentence that knows the pattern it was filled from."""

    def __new__(cls, text, pattern, one, arguments):
        found = super().__new__(cls, text)
        found.pattern, found.one, found.arguments = pattern, one, arguments
        return found

    def __reduce__(self):
        return str, (str(self),)


def phrase(pattern, /, one="", **arguments):
    """The sentence of a pattern with {names} of arguments. one: the pattern where `count` is 1."""
    if isinstance(pattern, Phrase) and not arguments:
        return pattern
    arguments = {name: _text_of(value) if isinstance(value, BaseException) else value for name, value in arguments.items()}
    chosen = one if one and arguments.get('count') == 1 else pattern
    return Phrase(chosen.format(**arguments) if arguments else chosen, pattern, one, arguments)


def listed(sentences, between=", "):
    """One Phrase of some, each of which is translated by itself."""
    return reduce(lambda before, more: phrase("{before}" + between + "{more}", before=before, more=more), sentences)


def _text_of(error):
    """The sentence of an exception, which must not be kept: it holds all that was alive where it was raised."""
    return error.args[0] if error.args and isinstance(error.args[0], Phrase) else str(error)


def _silence():
    """The Catalog of the language that is spoken; None for English."""


_spoken = _silence
#: What joins sentences and parts of them, in the order in which they are taken apart.
_BETWEEN = ("   |   ", "; ", ": ", ", ")


def use(spoken):
    """Have a function tell which Catalog is spoken at the moment; None for English alone."""
    global _spoken
    _spoken = spoken or _silence


def say(text):
    """A text as it is shown."""
    catalog = _spoken() if text else None
    return text if catalog is None else _say(catalog, text)


def _say(catalog, text):
    return _said(catalog, text) if isinstance(text, Phrase) else _found(catalog, text)


@lru_cache(maxsize=2000)
def _found(catalog, text):
    """A text as it is shown: panels ask for the same ones at every redraw."""
    found = catalog.find(text)
    if found is None and " " in text:
        found = _recognized(catalog, text) or _parts(catalog, text)
    return found or text


def _recognized(catalog, text):
    """What was filled elsewhere, or ""."""
    found = catalog.recognized(text)
    if not found or any(between in value for value in found[1].values() for between in _BETWEEN[:-1]):
        return ""                       # several sentences
    return _filled(catalog, *found)


def _parts(catalog, text):
    for between in _BETWEEN:
        if between in text:
            return between.join(_say(catalog, part) if " " in part else part for part in text.split(between))
    return ""


def _said(catalog, sentence):
    """A Phrase as it is shown."""
    found = catalog.find(sentence.one or sentence.pattern, sentence.arguments.get('count'))
    if found is None and sentence.arguments:
        found = _recognized(catalog, str(sentence))
        return found or _filled(catalog, sentence.pattern, sentence.arguments) or str(sentence)
    return _filled(catalog, found or sentence.pattern, sentence.arguments) or str(sentence)


def _filled(catalog, translation, arguments):
    """A translated pattern with its arguments, or "" where it does not fit them."""
    try:
        return translation.format(**{name: _argument(catalog, value) for name, value in arguments.items()}) if arguments else translation
    except (LookupError, ValueError):
        return ""


def _argument(catalog, value):
    """What fills a pattern: phrases are translated, and sentences are recognized; a single word may be a user's name."""
    return _say(catalog, value) if isinstance(value, Phrase) or (isinstance(value, str) and " " in value) else value
