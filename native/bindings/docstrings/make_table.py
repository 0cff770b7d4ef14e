"""Writes the docstrings of the stubs as a table in C++: make_table.py OUT.cpp STUB.pyi…"""

import ast
import json
import sys
from pathlib import Path


def documented(stub):
    """(name below the module, docstring) of whatever has one in a stub."""
    prefix = "" if stub.stem == "__init__" else f"{stub.stem}."
    for node in ast.parse(stub.read_text("utf-8")).body:
        if isinstance(node, (ast.ClassDef, ast.FunctionDef)):
            yield prefix + node.name, ast.get_docstring(node)
        if isinstance(node, ast.ClassDef):
            for part in node.body:
                if isinstance(part, ast.FunctionDef):
                    yield f"{prefix}{node.name}.{part.name}", ast.get_docstring(part)


def literal(text):
    """A string of C++, one line for each of the text, in ASCII."""
    lines = [json.dumps(line, ensure_ascii=False) for line in text.splitlines(keepends=True)]
    escaped = ["".join(letter if letter.isascii() else "".join(f"\\{byte:03o}" for byte in letter.encode()) for letter in line)
               for line in lines]
    return "\n".join(f"    {line}" for line in escaped)


def table(stubs):
    found = {name: text for stub in stubs for name, text in documented(stub) if text}
    texts = sorted(set(found.values()))
    numbers = {text: number for number, text in enumerate(texts)}
    lines = ["// Made from the stubs.", '#include "documentation.hpp"', "", "namespace bindings {", "", "namespace {", ""]
    lines += [f"constexpr char kText{number}[] =\n{literal(text)};" for number, text in enumerate(texts)]
    lines += ["", "constexpr Documented kAll[] = {"]
    lines += [f'    {{"{name}", kText{numbers[found[name]]}}},' for name in sorted(found, key=str.encode)]
    lines += ["};", "", "}  // namespace", "", "std::span<const Documented> documentation() { return kAll; }", "",
              "}  // namespace bindings", ""]
    return "\n".join(lines)


if __name__ == "__main__":
    Path(sys.argv[1]).write_text(table([Path(name) for name in sys.argv[2:]]), "utf-8")
