"""Writes docstrings into the stubs: make_stubs.py [--check].

What they say stands in the text files here, once for all classes that share a method. Each entry begins with the names of what
it is about; `Curve` and `Patch` stand for every kind of them:

    @ Curve.evaluate
    Points of the curve.

    u: Parameters (...,) in the domain.
    return: Points (..., 3).
    raise PointAtInfinity: If ...
    note: ...
    ref: ...
    >>> curve.evaluate(0.5)
    array([...])

Parameters that are not explained in an entry are those of parameters.txt; kinds and presets come from the stub. Functions that
are Python have their docstring in their own file. A line that is indented continues the one before.
"""

import ast
import re
import sys
import textwrap
from pathlib import Path

from kinds import Kinds

HERE = Path(__file__).resolve().parent
PACKAGE = HERE.parent / "splinecore"
WIDTH = 110
EVERY = {"Curve": ("NurbsCurve", "BezierCurve", "HermiteCurve", "PowerCurve"), "Patch": ("NurbsPatch", "BezierPatch", "HermitePatch")}
CANCELLED = ("Cancelled", "If `cancel` returned true.")
INVALID = ("InvalidShape", "If an argument is not valid: the message names it, the first offending index and its value.")


class Entry:
    """The text for one or several names."""

    def __init__(self, block):
        head, *lines = block.strip("\n").splitlines()
        self.names = [name for word in head.split() for name in expanded(word)]
        self.paragraphs, self.parameters, self.raises, self.notes, self.references, self.examples = [], {}, [], [], [], []
        self.returned = None
        for part in parts(lines):
            self.add(part)

    def add(self, part):
        """A paragraph, or what begins with a keyword."""
        key, _, text = part.partition(": ")
        if part.startswith(">>>"):
            self.examples.append(part)
        elif key == "return":
            self.returned = text
        elif key.startswith("raise "):
            self.raises.append((key.removeprefix("raise "), text))
        elif key in ("note", "ref"):
            (self.notes if key == "note" else self.references).append(text)
        elif re.fullmatch(r"[\w*]+(, \w+)*", key) and text:
            self.parameters.update(dict.fromkeys(key.split(", "), text))
        else:
            self.paragraphs.append(part)


def parts(lines):
    """Paragraphs; a line with a key begins one, and so does an example, which keeps its lines."""
    found = []
    for line in lines:
        is_code = bool(found) and found[-1].startswith(">>>")
        if not line:
            found.append("")
        elif not found or not found[-1] or (not is_code and re.match(r"(\w[\w ]*(, \w+)*|\*\w+): |>>>", line)):
            found.append(line)
        else:
            found[-1] += "\n" + line if is_code else " " + line.strip()
    return [part for part in found if part]


def expanded(word):
    first, dot, rest = word.partition(".")
    return [f"{name}{dot}{rest}" for name in EVERY.get(first, (first,))]


def entries():
    """{name: Entry} of all text files."""
    found = {}
    for path in sorted(HERE.glob("*.txt")):
        if path.stem == "parameters":
            continue
        for block in re.split(r"^@ ", path.read_text("utf-8"), flags=re.M)[1:]:
            entry = Entry(block)
            for name in entry.names:
                if name in found:
                    raise SystemExit(f"{path.name}: {name} is explained twice")
                found[name] = entry
    return found


def common_parameters():
    return dict(part.split(": ", 1) for part in parts((HERE / "parameters.txt").read_text("utf-8").splitlines()))


def section(title, items):
    body = [f"{head}\n{textwrap.fill(text, WIDTH - 12, initial_indent='    ', subsequent_indent='    ')}" for head, text in items]
    return [f"{title}\n{'-' * len(title)}\n" + "\n".join(body)] if body else []


def arguments_of(function):
    """(name, annotation, preset) of all but self."""
    given = function.args
    plain = [*given.posonlyargs, *given.args]
    presets = [None] * (len(plain) - len(given.defaults)) + given.defaults
    found = [(one.arg, one.annotation, preset) for one, preset in zip(plain, presets) if one.arg != "self"]
    if given.vararg:
        found.append((f"*{given.vararg.arg}", given.vararg.annotation, None))
    return found + [(one.arg, one.annotation, preset) for one, preset in zip(given.kwonlyargs, given.kw_defaults)]


class Writer:
    """Puts the texts of entries together with the signatures of a stub."""

    def __init__(self, kinds):
        self.kinds = kinds
        self.entries, self.common = entries(), common_parameters()
        self.used = set()

    def text(self, name, function):
        """The docstring of a name, and of a class with its constructor; None where there is no entry."""
        entry = self.entries.get(name)
        if entry is None:
            return None
        self.used.add(name)
        arguments = arguments_of(function) if function else []
        unknown = set(entry.parameters) - {argument for argument, _, _ in arguments}
        if unknown:
            raise SystemExit(f"{name} has no parameter {', '.join(sorted(unknown))}")
        blocks = [*(textwrap.fill(paragraph, WIDTH - 8) for paragraph in entry.paragraphs)]
        blocks += section("Parameters", [self.parameter(name, entry, *argument) for argument in arguments])
        is_constructor = function is not None and function.name == "__init__"
        if function and not is_constructor:
            if entry.returned is None:
                raise SystemExit(f"{name} does not say what it returns")
            blocks += section("Returns", [(self.kinds.text(function.returns), entry.returned)])
        blocks += section("Raises", self.raised(entry, arguments))
        blocks += section("Notes", [])
        for title, texts in (("Notes", entry.notes), ("References", entry.references)):
            if texts:
                body = "\n\n".join(textwrap.fill(text, WIDTH - 8) for text in texts)
                blocks.append(f"{title}\n{'-' * len(title)}\n{body}")
        if entry.examples:
            blocks.append("Examples\n--------\n" + "\n\n".join(entry.examples))
        return "\n\n".join(blocks)

    def parameter(self, owner, entry, name, annotation, preset):
        text = entry.parameters.get(name) or self.common.get(name)
        if text is None:
            raise SystemExit(f"{owner} does not explain {name}")
        return f"{name} : {self.kinds.argument(annotation, preset)}", text

    def raised(self, entry, arguments):
        found = list(entry.raises)
        if arguments and "InvalidShape" not in [kind for kind, _ in found]:
            found.insert(0, INVALID)
        return found + [CANCELLED] * any(name == "cancel" for name, _, _ in arguments)


def docstring(text, indent):
    lines = text.splitlines()
    prefix = 'r"""' if "\\" in text else '"""'
    if len(lines) == 1:
        return [f'{indent}{prefix}{text}"""']
    return [f"{indent}{prefix}{lines[0]}", *(f"{indent}{line}".rstrip() for line in lines[1:]), f'{indent}"""']


def of_python(stub):
    """{name: docstring} of the functions of a module that is Python."""
    path = stub.with_suffix(".py")
    found = {node.name: ast.get_docstring(node) for node in ast.parse(path.read_text("utf-8")).body if isinstance(node, ast.FunctionDef)}
    return {name: text for name, text in found.items() if text and not name.startswith("_")}


def changes(stub, tree, writer):
    """(node, docstring) of what a stub declares."""
    prefix = "" if stub.stem == "__init__" else f"{stub.stem}."
    python = of_python(stub)
    for node in tree.body:
        if isinstance(node, ast.FunctionDef):
            yield node, python.get(node.name) or writer.text(prefix + node.name, node)
        elif isinstance(node, ast.ClassDef):
            methods = [part for part in node.body if isinstance(part, ast.FunctionDef)]
            constructor = next((part for part in methods if part.name == "__init__"), None)
            yield node, writer.text(prefix + node.name, constructor)
            for part in methods:
                is_property = any(getattr(one, "id", "") == "property" for one in part.decorator_list)
                yield part, writer.text(f"{prefix}{node.name}.{part.name}", None if is_property else part)


def rewritten(stub, writer):
    """The text of a stub with its docstrings."""
    source = stub.read_text("utf-8")
    lines = source.splitlines()
    tree = ast.parse(source)
    for node, text in sorted(changes(stub, tree, writer), key=lambda change: -change[0].lineno):
        if text is None:
            continue
        is_class = isinstance(node, ast.ClassDef)
        indent = " " * (node.col_offset + 4)
        first = node.body[0]
        has_one = isinstance(first, ast.Expr) and isinstance(getattr(first.value, "value", None), str)
        new = docstring(text, indent)
        if has_one:
            lines[first.lineno - 1:first.end_lineno] = new
        elif is_class:
            above = first.lineno - 1 - len(getattr(first, "decorator_list", []))
            lines[above:above] = [*new, ""]
        else:
            head = lines[first.lineno - 1][:first.col_offset].rstrip()
            lines[first.lineno - 1:first.end_lineno] = [*([head] if head.strip() else []), *new]
    return "\n".join(lines) + "\n"


def main():
    stubs = sorted(PACKAGE.glob("*.pyi"))
    writer = Writer(Kinds(stubs))
    made = {stub: rewritten(stub, writer) for stub in stubs}
    left = sorted(set(writer.entries) - writer.used)
    if left:
        raise SystemExit(f"not in a stub: {', '.join(left)}")
    old = [stub.name for stub, text in made.items() if stub.read_text("utf-8") != text]
    if "--check" not in sys.argv:
        for stub, text in made.items():
            stub.write_text(text, "utf-8")
    elif old:
        raise SystemExit(f"out of date: {', '.join(old)}; run {Path(__file__).name}")


if __name__ == "__main__":
    main()
