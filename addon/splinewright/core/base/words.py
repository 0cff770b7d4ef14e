"""What users read, in their language. Code keeps and compares English; a text is translated where it is shown, by say().

A message with names or numbers in it is a phrase: a pattern and what fills it, so that the pattern is translated before it is filled. One
with {count} has as many forms as the language has for that number. What was put together elsewhere, by the library or in a file, is
recognized by the patterns of the catalog.
"""


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
    chosen = one if one and arguments.get('count') == 1 else pattern
    return Phrase(chosen.format(**arguments) if arguments else chosen, pattern, one, arguments)


class English:
    """The language of the code: every text is itself."""

    def find(self, text, count=None):
        """The translation of a text or pattern, that for a number where it has forms; None where there is none."""

    def recognized(self, text):
        """(pattern, {name: text}) of a sentence, or None."""


_ENGLISH = English()
_language = _ENGLISH


def use(language):
    """Speak a language: an object as English is one; None for English."""
    global _language
    _language = language or _ENGLISH


def say(text):
    """A text as it is shown."""
    if _language is _ENGLISH or not text:
        return text
    if isinstance(text, Phrase):
        return _said(text)
    found = _language.find(text)
    if found is not None:
        return found
    found = _language.recognized(text)
    if found is not None:
        pattern, arguments = found
        return _filled(_language.find(pattern, _number(arguments.get('count'))), pattern, arguments) or text
    for between in ("; ", ": "):
        if between in text:
            parts = text.split(between)
            return between.join(say(part) if " " in part else part for part in parts)
    return text


def _said(sentence):
    """A Phrase as it is shown."""
    key = sentence.one or sentence.pattern
    found = _language.find(key, sentence.arguments.get('count'))
    return _filled(found or sentence.pattern, sentence.pattern, sentence.arguments) or str(sentence)


def _filled(translation, pattern, arguments):
    """A translated pattern with its arguments, or "" where it does not fit them."""
    try:
        return translation.format(**{name: _argument(value) for name, value in arguments.items()}) if arguments else translation
    except (LookupError, ValueError):
        return ""


def _argument(value):
    """What fills a pattern: phrases are translated, and sentences are recognized; a single word may be a user's name."""
    if isinstance(value, BaseException):
        value = value.args[0] if value.args and isinstance(value.args[0], str) else str(value)
    return say(value) if isinstance(value, Phrase) or (isinstance(value, str) and " " in value) else value


def _number(text):
    digits = str(text or "").replace(",", "")
    return int(digits) if digits.isdigit() else None
