"""Sentences of the library's errors, as patterns: read from the places in native where they are thrown."""

import re
from pathlib import Path

NATIVE = Path(__file__).parent.parent / "native"
_THROWN = re.compile(r"\b(?:throw\s+(?:\w+::)*(\w+)|InvalidShape|refused|fail)\(")
#: What the library says after it where a tolerance is missed.
_MISSED = " within {tolerance}: the error would be {error}"
_TOKEN = re.compile(r'R?"((?:[^"\\]|\\.)*)"|([()\[\]{},;])|(\'(?:[^\'\\]|\\.)\')|([^"()\[\]{},;\']+)', re.S)


def patterns():
    """{pattern: path} of every sentence, with {a}, {b} ... for the filled values."""
    found = {}
    for folder in ("src", "include", "bindings"):
        for path in sorted((NATIVE / folder).rglob("*.?pp")):
            text = re.sub(r"(?m)^\s*//.*$|(?<=\s)//[^\"\n]*$", "", path.read_text())
            for match in _THROWN.finditer(text):
                pattern = _pattern(text[match.end():match.end() + 2000])
                if pattern:
                    pattern += _MISSED if match[1] == "ToleranceNotReached" else ""
                    found.setdefault(pattern, path.relative_to(NATIVE.parent).as_posix())
    return found


def _pattern(text):
    """The first argument of a call as a pattern, or "" where it has no words."""
    parts, depth, is_hole = [], 0, False
    for literal, mark, _, other in _TOKEN.findall(text):
        if mark in ("(", "[", "{"):
            depth, is_hole = depth + 1, True
        elif mark in (")", "]", "}"):
            if not depth:
                break
            depth -= 1
        elif mark and not depth:
            break
        elif literal and not depth:
            if is_hole:
                parts.append(None)
                is_hole = False
            parts.append(literal)
        elif other and not depth:
            if "?" in other or ":" in other.replace("::", ""):
                return ""
            is_hole = is_hole or bool(other.strip(" \n+"))
    if is_hole:
        parts.append(None)
    return _joined(parts)


def _joined(parts):
    holes = iter("abcdefghijklmnop")
    text = "".join("{" + next(holes) + "}" if part is None else _unescaped(part).replace("{", "{{").replace("}", "}}") for part in parts)
    bare = re.sub(r"\{\w\}", "", text)
    return text if len(re.findall(r"[a-z]{2,}", bare)) > 1 and " " in bare.strip() else ""


def _unescaped(literal):
    return re.sub(r"\\(.)", lambda found: {"n": "\n", "t": "\t"}.get(found[1], found[1]), literal)
