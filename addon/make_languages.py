"""The catalog of everything that users read, and the translations that are made from it.

    make_languages.py            writes languages/splinewright.pot, and adds new texts to the .po files beside it
    make_languages.py LANGUAGE   begins a file for another language, such as de

A text is a string in double quotes that reads as words: identifiers stand in single quotes throughout the add-on. Texts that are put
together when Blender starts stand in composed_texts.txt. Texts of lessons come from their files, errors of the library from where they are thrown.
"""

import ast
import json
import re
import sys
from pathlib import Path
from typing import NamedTuple

import library_texts

ADDON = Path(__file__).parent / "splinewright"
FOLDER = ADDON / "languages"
TEMPLATE = FOLDER / "splinewright.pot"
COMPOSED = Path(__file__).parent / "composed_texts.txt"
#: What Blender looks labels of operators up with, and everything else.
OPERATOR, ANY = "Operator", "*"
#: Calls that draw a button, whose text is an operator's.
_BUTTONS = {'operator', 'operator_menu_enum', 'operator_enum', 'Entry'}
#: Calls whose texts nobody reads in a window.
_SILENT = {'print', 'getLogger', 'property', 'parser', 'warn', 'deepcopy', 'startswith', 'endswith', 'replace', 'removeprefix', 'removesuffix',
           'split', 'partition', 'rpartition', 'strip', 'rstrip', 'lstrip', 'get_icon', 'class_', 'path_resolve', 'open_dataset'}
#: Documents that are written and drawn, not parts of the interface.
_DOCUMENTS = ("core/formulas/formulas.py", "core/formulas/patch_formulas.py", "core/formulas/spline.py", "core/formulas/triangles.py",
              "core/formulas/written.py", "core/formulas/signs.py", "core/formulas/chain_points.py", "core/base/self_test.py",
              "bridge/edit/self_test.py", "core/lessons/answers.py")
#: What looks like words and is none: a path of data, a name of a class or choice, a file.
_IDENTIFIER = re.compile(r"[\w.]+\.[\w.*]+|SPLINEWRIGHT_\w+|[A-Z]+(_[A-Z0-9]+)+|[\w/.*]+\.\w{2,5}")
_COUNT = re.compile(r"\{count[:}!]")


class Text(NamedTuple):
    """plural: the pattern for other numbers than 1, "" where no number counts."""

    context: str
    text: str
    plural: str = ""


def collected():
    """{Text: [file]} of the whole add-on, in the order of files."""
    found = {}
    for path in sorted(ADDON.rglob("*.py")):
        name = path.relative_to(ADDON).as_posix()
        for text in _File(path.read_text(), name in _DOCUMENTS).texts():
            found.setdefault(text, []).append(name)
    for path in sorted((ADDON / "lessons").glob("*.json")):
        for text in lesson_texts(json.loads(path.read_text())):
            found.setdefault(Text(ANY, text), []).append(f"lessons/{path.name}")
    for line in COMPOSED.read_text().splitlines():
        context, _, text = line.partition("\t")
        if (context, text) not in {(known.context, known.text) for known in found}:
            found.setdefault(Text(context, text), []).append(COMPOSED.name)
    for text, name in library_texts.patterns().items():
        found.setdefault(Text(ANY, text), []).append(name)
    return _merged(found)


def _merged(found):
    """One text once in a context: with forms for numbers where it has them anywhere."""
    counted = {(text.context, text.text): text for text in found if text.plural}
    merged = {}
    for text, files in found.items():
        of_text = merged.setdefault(counted.get((text.context, text.text), text), [])
        of_text += [name for name in files if name not in of_text]
    return merged


def lesson_texts(lesson):
    """What a learner reads of a lesson."""
    yield lesson['title']
    for step in lesson['steps']:
        yield step['text']
        yield from (step['hint'],) if 'hint' in step else ()
        yield from (watch['text'] for watch in step.get('watch', ()) if _is_wordy(watch['text']))
        yield from (choice for choice in step.get('ask', {}).get('choose', ()) if _is_wordy(choice))


def _is_wordy(text):
    return re.search(r"[A-Za-z]{2,}", re.sub(r"\{[^}]*\}", "", text)) is not None


class _File:
    """A file of Python, and where its texts are."""

    def __init__(self, source, is_document):
        self.source, self.is_document = source, is_document
        self.lines = source.encode().split(b"\n")
        self.tree = ast.parse(source)
        self.above = {child: node for node in ast.walk(self.tree) for child in ast.iter_child_nodes(node)}

    def texts(self):
        for node in ast.walk(self.tree):
            if isinstance(node, ast.Constant) and isinstance(node.value, str) and self._is_read(node):
                if not self._is_one_of(node):
                    yield self._text(node)

    def _is_read(self, node):
        above = self.above[node]
        if isinstance(above, (ast.Expr, ast.JoinedStr, ast.FormattedValue, ast.Compare, ast.Subscript)) or self._quote(node) != b'"':
            return False
        if isinstance(above, ast.BinOp) and isinstance(above.op, ast.Mod):
            return False
        call = self._call(node)
        is_label = isinstance(above, ast.keyword) and above.arg == 'label'
        if (call in _SILENT and not is_label) or (self.is_document and not self._is_refused(node)):
            return False
        if isinstance(above, ast.Assign) and ast.unparse(above.targets[0]) in ('bl_idname', 'bl_parent_id', 'bl_category', '__version__', 'icon'):
            return False
        return is_text(node.value)

    def _quote(self, node):
        """The quotation mark of a string."""
        return self.lines[node.lineno - 1][node.col_offset:node.col_offset + 1]

    def _call(self, node):
        """The name of the call of which a string is an argument."""
        above = self.above[node]
        while isinstance(above, (ast.IfExp, ast.keyword, ast.Tuple, ast.Starred)):
            above = self.above[above]
        return ast.unparse(above.func).rpartition('.')[2] if isinstance(above, ast.Call) else ""

    def _is_refused(self, node):
        above = node
        while above in self.above and not isinstance(above, ast.stmt):
            above = self.above[above]
        return isinstance(above, ast.Raise)

    def _is_one_of(self, node):
        """Whether it is the form for 1 of another text."""
        above = self.above[node]
        if isinstance(above, ast.keyword):
            return above.arg == 'one'
        siblings = above.args if isinstance(above, ast.Call) else above.elts if isinstance(above, ast.Tuple) else ()
        first = siblings[0] if len(siblings) > 1 and node is siblings[1] else None
        return isinstance(first, ast.Constant) and isinstance(first.value, str) and self._one(first) == node.value

    def _one(self, node):
        """The form for 1 of a pattern, or ""."""
        above = self.above[node]
        if not _COUNT.search(node.value):
            rest = [keyword for keyword in getattr(above, 'keywords', ()) if keyword.arg == 'one']
            return rest[0].value.value if rest else ""
        if isinstance(above, ast.Call):
            named = [keyword.value.value for keyword in above.keywords if keyword.arg == 'one']
            return named[0] if named else self._second(above.args)
        return self._second(above.elts) if isinstance(above, ast.Tuple) else ""

    @staticmethod
    def _second(siblings):
        second = siblings[1] if len(siblings) > 1 else None
        return second.value if isinstance(second, ast.Constant) and isinstance(second.value, str) else ""

    def _text(self, node):
        one = self._one(node)
        if "{}" in node.value:
            letters = iter("abcdefghij")
            return Text(ANY, re.sub(r"\{\}", lambda _: f"{{{next(letters)}}}", node.value))
        if one or _COUNT.search(node.value):
            return Text(ANY, one or node.value, node.value)
        return Text(OPERATOR if self._is_of_operator(node) else ANY, node.value)

    def _is_of_operator(self, node):
        above = self.above[node]
        if isinstance(above, ast.keyword) and above.arg == 'text':
            return self._call(node) in _BUTTONS
        if isinstance(above, ast.Assign) and ast.unparse(above.targets[0]) == 'bl_label':
            holder = self.above[above]
            return isinstance(holder, ast.ClassDef) and '_OT_' in holder.name
        return False


def is_text(value):
    """Whether a string reads as words: a sentence, or a word that begins with a capital."""
    bare = re.sub(r"\{[^}]*\}", "", value)
    if ";\n" in value:                  # a shader
        return False
    if value.startswith("3D View") or not re.search(r"[A-Za-z]{2,}", bare) or _IDENTIFIER.fullmatch(value):
        return False
    return " " in value.strip() or re.match(r"[A-Z][a-z]", value) is not None


def catalog(texts=None):
    """Babel's catalog of the texts."""
    from babel.messages.catalog import Catalog
    made = Catalog(project="Splinewright", copyright_holder="the authors of Splinewright", msgid_bugs_address="", fuzzy=False)
    for text, files in (texts or collected()).items():
        flags = ("python-brace-format",) if re.search(r"\{\w+", text.text + text.plural) else ()
        made.add((text.text, text.plural) if text.plural else text.text, context=text.context,
                 locations=[(name, None) for name in files], flags=flags)
    return made


def write(made, path):
    from babel.messages.pofile import write_po
    with path.open("wb") as file:
        write_po(file, made, width=120, include_lineno=False, ignore_obsolete=False)


def main(languages):
    from babel.messages.catalog import Catalog
    from babel.messages.pofile import read_po
    template = catalog()
    write(template, TEMPLATE)
    for path in sorted({*FOLDER.glob("*.po"), *(FOLDER / f"{language}.po" for language in languages)}):
        if path.exists():
            with path.open("rb") as file:
                translated = read_po(file, locale=path.stem)
        else:
            translated = Catalog(locale=path.stem, project="Splinewright", fuzzy=False)
        translated.update(template, no_fuzzy_matching=True)
        write(translated, path)


if __name__ == "__main__":
    main(sys.argv[1:])
