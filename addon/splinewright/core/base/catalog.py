"""A language: translations from a .po file, as ordinary tools write it."""

import re
from functools import cache
from gettext import c2py

_HOLE = re.compile(r"(?<!\{)\{([a-z]\w*)(![rs])?(?::[^{}]*)?\}")
_ESCAPED = {"n": "\n", "t": "\t", '"': '"', "\\": "\\"}
#: Of letters that a pattern has beside its holes, the least by which a sentence is recognized.
_LEAST = 4


class Catalog:
    """texts: {(context, text): [translation for each form]}; form_of: (number) -> which form it takes."""

    def __init__(self, texts, form_of, plurals=()):
        self.texts, self._form_of, self._plurals = texts, form_of, dict(plurals)
        self._by_text, self._patterns = {}, None
        for (_, text), forms in texts.items():
            self._by_text.setdefault(text, forms)

    def find(self, text, count=None):
        """The translation of a text or pattern, that for a number where it has forms; None where there is none."""
        forms = self._by_text.get(text)
        if forms is None:
            return None
        return forms[min(self._form_of(int(count)), len(forms) - 1) if hasattr(count, '__index__') else -1]

    def recognized(self, text):
        """(translation, {name: text}) of a sentence that was filled elsewhere, or None; of several patterns the one that is filled least."""
        if self._patterns is None:
            self._patterns = _patterns_of(self._by_text, self._plurals)
        found = [(sum(map(len, match.groups())), key, match)
                 for word in {_first(text), ""} for longest, key, pattern in self._patterns.get(word, ())
                 if longest in text and (match := _expression(pattern).fullmatch(text))]
        if not found:
            return None
        _, key, match = min(found, key=lambda one: one[:2])
        arguments = match.groupdict()
        return _bare(self.find(key, _number(arguments.get('count')))), arguments

    @property
    def of_blender(self):
        """{(context, text): translation}, for bpy.app.translations."""
        return {key: forms[-1] for key, forms in self.texts.items() if not _HOLE.search(key[1])}


def _first(text):
    return text.split(" ", 1)[0]


def _number(text):
    digits = (text or "").replace(",", "")
    return int(digits) if digits.isdigit() else None


def _bare(translation):
    """A translated pattern whose numbers are filled in as they were written."""
    return _HOLE.sub(lambda hole: f"{{{hole[1]}}}", translation)


def _patterns_of(texts, plurals):
    """{first word, "" where that is filled in: [(the longest of what it has beside its holes, text, pattern)]}."""
    found = {}
    for text in texts:
        for pattern in (text, plurals.get(text, "")):
            between = [part.replace("{{", "{").replace("}}", "}") for part in _HOLE.split(pattern)[::3]]
            if len(between) > 1 and sum(map(str.isalpha, "".join(between))) >= _LEAST:
                word = _first(pattern)
                found.setdefault("" if "{" in word else word, []).append((max(between, key=len), text, pattern))
    return found


@cache
def _expression(pattern):
    """A regular expression for a pattern: what fills a hole twice is equal."""
    expression, end, seen = "", 0, set()
    for hole in _HOLE.finditer(pattern):
        expression += re.escape(pattern[end:hole.start()].replace("{{", "{").replace("}}", "}"))
        name = hole[1]
        filled = r"\d[\d,]*" if name == "count" else ".+?"
        expression += f"(?P={name})" if name in seen else f"(?P<{name}>{filled})"
        seen.add(name)
        end = hole.end()
    return re.compile(expression + re.escape(pattern[end:].replace("{{", "{").replace("}}", "}")), re.S)


def holes(text):
    """The names of what fills a pattern."""
    return {hole[1] for hole in _HOLE.finditer(text)}


#: Strings fill whole lines, as every tool writes them.
_STRINGS = r'((?:".*"(?:\n|$))+)'
_ENTRY = re.compile(rf'((?:#.*\n)*)(?:msgctxt {_STRINGS})?msgid {_STRINGS}(?:msgid_plural {_STRINGS})?((?:msgstr(?:\[\d\])? {_STRINGS})+)')
_FORM = re.compile(rf'msgstr(?:\[\d\])? {_STRINGS}')
_ESCAPE = re.compile(r"\\(.)")


def read(text):
    """The Catalog of a .po file's text, without texts that have no translation or one marked as unsure. Obsolete entries are comments there."""
    texts, plurals, rule = {}, {}, None
    for comments, context, original, plural, translated, _ in _ENTRY.findall(text.replace("\r\n", "\n")):
        forms = [_plain(form) for form in _FORM.findall(translated)]
        original = _plain(original)
        if not original:
            rule = re.search(r"plural=([^;\n]+)", forms[0])
        elif all(forms) and not ("fuzzy" in comments and re.search(r"^#,.*\bfuzzy", comments, re.M)):
            texts[_plain(context) or "*", original] = forms
            if plural:
                plurals[original] = _plain(plural)
    return Catalog(texts, c2py(rule[1]) if rule else _as_in_english, plurals)


def _as_in_english(number):
    return int(number != 1)


def _plain(strings):
    """What the strings of a file say."""
    joined = "".join(line[1:-1] for line in strings.splitlines())
    return _ESCAPE.sub(lambda found: _ESCAPED.get(found[1], found[1]), joined) if "\\" in joined else joined
