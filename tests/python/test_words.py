"""Plain American English, in words that other programs have, too: in texts, in what the interface says, in docstrings and names.

docs/glossary.md has the words. What must be otherwise stands in EXCEPTIONS, with its reason.
"""

import ast
import re
from functools import lru_cache
from pathlib import Path

import pytest

PROJECT = Path(__file__).resolve().parents[2]
NATIVE, ADDON = PROJECT / "native", PROJECT / "addon"

#: Parts of words that are spelled otherwise in America, in texts and in names.
BRITISH = (
    "colour", "neighbour", "behaviour", "favour", "honour", "centre(?!x)", "centring", "metre(?!x)", "fibre", "grey", "licence", "defence",
    "catalogue", "analyse", "artefact", "modell(?:ed|er|ing)", "labelled", "travell", "levelled", "mitre", "mould", "programme(?!d|r)",
    "draught", "whilst", "amongst", "learnt", "spelt", "judgement", "ageing", "skilful", "fulfil(?!l)",
    "(?:organ|recogn|optim|minim|maxim|normal|parametr|general|initial|special|summar|real|local|equal|symmetr|linear|discret|"
    "regular|serial|synchron|visual|util|character|factor|categor|custom)is(?:e|ed|es|ing|ation)(?![a-rt-z])",
)
#: Phrases, and what is said in their place.
PHRASES = {
    r"\b(?:go|goes|going|went) on\b": "continue, keep, extend",
    r"of (?:its|their|his|our|your|my) own\b(?! accord)": "its, separate, or nothing",
    r"of one's own\b": "separate",
    r"of ours\b": "of Splinewright, or nothing",
    r"tak(?:e|es|en|ing) in\b": "add, include",
    r"in hand\b": "active, selected",
    r"[,(] say\b|\bsay[,:]": "for example",
    r"what is\b": "a noun",
    r"so many\b": "a given number of",
    r"the very\b": "the same, exactly",
    r"turn about\b|by its turn": "alternately",
    r"at one pace|another pace": "at equal parameters",
    r"(?:is|are) found out|told of\b": "is detected, is reported",
    r"each for itself": "separately",
    r"comes? of\b": "results from",
    r"goes? along\b": "move with, are kept",
    r"st(?:ands?|ood|anding) still": "has a zero derivative; does not move",
    r"(?<!there )is no (?:number|shape|curve|patch|text|knot|edge)\b": "is not a",
    r"it is no\b": "it is not",
    r"at hand\b": "current",
    r"all round\b|turned round\b|go(?:es)? round\b": "around, reversed",
    r"anew\b": "again",
    r"wherever\b": "where",
    r"ever so|next to nothing|as ever\b": "as usual, too small",
}
#: (path, what is found): why it is right there.
EXCEPTIONS = {
    **{(f"addon/splinewright/{path}", "parametrisation"): "names a parameter in files and scripts" for path in (
        "core/recipes/curve_recipes.py", "ui/operators/fit_patch.py")},
    ("addon/splinewright/core/recipes/conic_recipes.py", "centre"): "a choice in files",
    **{("native/bindings/wrong_calls.cpp", word): "a name of before that is still understood" for word in (
        "neighbour", "centre", "parametrisation")},
    ("docs/glossary.md", "in hand"): "a word of ours that is explained",
    ("addon/manual/python.md", "take in"): "a label of before",
}


def _python_texts(path):
    """(line, text, whether it is a docstring) of the string literals of a file of Python."""
    tree = ast.parse(path.read_text())
    docs = {id(node.body[0].value) for node in ast.walk(tree)
            if isinstance(node, (ast.Module, ast.ClassDef, ast.FunctionDef)) and node.body and isinstance(node.body[0], ast.Expr)}
    for node in ast.walk(tree):
        if isinstance(node, ast.JoinedStr):
            yield node.lineno, "".join(part.value if isinstance(part, ast.Constant) else "{}" for part in node.values), False
        elif isinstance(node, ast.Constant) and isinstance(node.value, str):
            yield node.lineno, node.value, id(node) in docs


def _markdown_texts(path):
    """(line, text) of paragraphs, without code and addresses."""
    text = re.sub(r"^```.*?^```", lambda found: "\n" * found[0].count("\n"), path.read_text(), flags=re.S | re.M)
    text = re.sub(r"`[^`]*`|\]\([^)]*\)|<!--.*?-->|<[^>]*>", lambda found: "\n" * found[0].count("\n") or "x", text, flags=re.S)
    line = 1
    for paragraph in text.split("\n\n"):
        yield line, paragraph
        line += paragraph.count("\n") + 2


_LITERAL = re.compile(r'"(?:\\.|[^"\\\n])*"')


def _native_strings(path):
    """(line, text) of the strings of a file of C++ but for lines of comments; neighbors are one text."""
    text = re.sub(r"^[ \t]*(?:#include|//).*$", "", path.read_text(), flags=re.M)
    for found in re.finditer(rf"{_LITERAL.pattern}(?:\s*{_LITERAL.pattern})*", text):
        words = "".join(part[1:-1] for part in _LITERAL.findall(found[0])).replace(r"\n", " ")
        yield text.count("\n", 0, found.start()) + 1, words


def _native_comments(path):
    """(line, text) of the comments of a header for its users; those in a row are one text."""
    text = path.read_text()
    for found in re.finditer(r"(?:^[ \t]*///.*\n)+|///<.*\n", text, re.M):
        yield text.count("\n", 0, found.start()) + 1, re.sub(r"^[ \t]*///<? ?", "", found[0], flags=re.M)


def _files(folder, *suffixes):
    return [path for path in sorted(folder.rglob("*")) if path.suffix in suffixes and "__pycache__" not in path.parts]


ADDON_CODE = _files(ADDON, ".py")
MODULE = _files(NATIVE / "bindings", ".py", ".pyi")
HEADERS = _files(NATIVE / "include", ".hpp")
SOURCES = _files(NATIVE / "src", ".cpp", ".hpp")
BINDINGS = _files(NATIVE / "bindings", ".cpp", ".hpp")
PAGES = [*sorted((ADDON / "manual").glob("*.md")), *_files(PROJECT / "docs", ".md"),
         *(PROJECT / name for name in ("README.md", "CONTRIBUTING.md", "SECURITY.md", "addon/splinewright/CHANGELOG.md"))]
#: Where texts are: (path, line, text).
ROOMS = {
    'pages': lambda: ((path, *text) for path in PAGES for text in _markdown_texts(path)),
    'interface': lambda: ((path, line, text) for path in ADDON_CODE for line, text, is_doc in _python_texts(path) if not is_doc),
    'addon docstrings': lambda: ((path, line, text) for path in ADDON_CODE for line, text, is_doc in _python_texts(path) if is_doc),
    'library': lambda: ((path, *text) for path in SOURCES for text in _native_strings(path)),
    'module': lambda: (*((path, *text) for path in BINDINGS for text in _native_strings(path)),
                       *((path, line, text) for path in MODULE for line, text, _ in _python_texts(path))),
    'headers': lambda: ((path, *text) for path in HEADERS for text in _native_comments(path)),
}


@lru_cache(None)
def texts(room):
    return list(ROOMS[room]())


def findings(room, banned):
    """(path, line, what is found) of the texts of a room."""
    for one in (re.compile(each, re.I) for each in banned):
        for path, line, text in texts(room):
            for found in one.finditer(text):
                yield str(path.relative_to(PROJECT)), line + text.count("\n", 0, found.start()), " ".join(found[0].lower().split())


def unexcused(found):
    return [one for one in found if (one[0], one[2]) not in EXCEPTIONS]


@pytest.mark.parametrize('room', ROOMS)
def test_spelling_is_american(room):
    assert not unexcused(findings(room, BRITISH))


@pytest.mark.parametrize('room', ROOMS)
def test_phrases_are_plain(room):
    assert not unexcused(findings(room, tuple(PHRASES)))


def test_names_are_american():
    """Of files, and of whatever stands in code."""
    british = re.compile("|".join(BRITISH), re.I)
    found = []
    for path in (*ADDON_CODE, *MODULE, *HEADERS, *SOURCES, *BINDINGS):
        words = set(re.findall(r"[A-Za-z_]\w*", f"{path.name} {path.read_text()}"))
        found += [(str(path.relative_to(PROJECT)), 0, word.lower()) for word in words if british.search(word)]
    assert not unexcused(found)


def test_an_odd_word_is_found():
    assert re.search(BRITISH[0], "Colour", re.I) and any(re.search(one, "parametrisation") for one in BRITISH)
    assert not any(re.search(one, text, re.I) for one in BRITISH for text in ("size", "precise", "parametrized", "centrexyz", "diameter"))
    for text in ("it goes on", "an axis of its own", "by E, say", "by Apply say: move it", "What is shown", "the piece in hand"):
        assert any(re.search(one, text, re.I) for one in PHRASES), text
