"""A language: translations from a .po file, as ordinary tools write it."""

import re
from gettext import c2py

_STRING = re.compile(r'"((?:[^"\\]|\\.)*)"')
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
        return forms[min(self._form_of(int(count)), len(forms) - 1) if isinstance(count, int) else -1]

    def recognized(self, text):
        """(translation, {name: text}) of a sentence that was filled elsewhere, or None; of several patterns the one that is filled least."""
        if self._patterns is None:
            self._patterns = _compiled(self._by_text, self._plurals)
        found = [(sum(map(len, match.groups())), key, match) for word in {_first(text), ""} for key, pattern in self._patterns.get(word, ())
                 if (match := pattern.fullmatch(text))]
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


def _compiled(texts, plurals):
    """{first word, "" where that is filled in: [(text, what a sentence must be to come of it)]}."""
    found = {}
    for text in texts:
        for pattern in (text, plurals.get(text, "")):
            if _HOLE.search(pattern) and len(re.findall(r"[^\W\d]", _HOLE.sub("", pattern))) >= _LEAST:
                word = _first(pattern)
                found.setdefault("" if "{" in word else word, []).append((text, re.compile(_expression(pattern), re.S)))
    return {word: tuple(patterns) for word, patterns in found.items()}


def _expression(pattern):
    """A regular expression for a pattern: what fills a hole twice is equal."""
    expression, end, seen = "", 0, set()
    for hole in _HOLE.finditer(pattern):
        expression += re.escape(pattern[end:hole.start()].replace("{{", "{").replace("}}", "}"))
        name = hole[1]
        expression += f"(?P={name})" if name in seen else f"(?P<{name}>.+?)"
        seen.add(name)
        end = hole.end()
    return expression + re.escape(pattern[end:].replace("{{", "{").replace("}}", "}"))


def holes(text):
    """The names of what fills a pattern."""
    return {hole[1] for hole in _HOLE.finditer(text)}


def read(text):
    """The Catalog of a .po file's text. What is not translated, or marked as unsure, is left out."""
    entries = list(_entries(text))
    header = next((entry['msgstr'][0] for entry in entries if not entry['msgid']), "")
    rule = re.search(r"plural=([^;\n]+);?", header)
    texts, plurals = {}, {}
    for entry in entries:
        if entry['msgid'] and all(entry['msgstr'].values()) and not entry['fuzzy']:
            texts[entry['msgctxt'] or "*", entry['msgid']] = [form for _, form in sorted(entry['msgstr'].items())]
            if entry['msgid_plural']:
                plurals[entry['msgid']] = entry['msgid_plural']
    return Catalog(texts, c2py(rule[1]) if rule else (lambda number: int(number != 1)), plurals)


def _entries(text):
    """The entries as dictionaries; obsolete ones are comments."""
    for block in re.split(r"\n\s*\n", text.replace("\r\n", "\n")):
        entry = {'msgctxt': "", 'msgid': None, 'msgid_plural': "", 'msgstr': {}, 'fuzzy': False}
        name = None
        for line in block.split("\n"):
            if line.startswith("#"):
                entry['fuzzy'] |= line.startswith("#,") and "fuzzy" in line
                continue
            keyword = re.match(r"(msg\w+)(?:\[(\d+)\])?\s", line)
            if keyword:
                name, form = keyword[1], int(keyword[2] or 0)
            said = _STRING.search(line)
            if said and name:
                piece = re.sub(r"\\(.)", lambda found: _ESCAPED.get(found[1], found[1]), said[1])
                if name == 'msgstr':
                    entry['msgstr'][form] = entry['msgstr'].get(form, "") + piece
                else:
                    entry[name] = (entry[name] or "") + piece
        if entry['msgid'] is not None:
            yield entry
