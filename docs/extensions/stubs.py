"""Signatures of the compiled module from its stubs, which say more than the module itself does."""

import ast
import re
from pathlib import Path

STUBS = Path(__file__).resolve().parents[2] / "native/bindings/splinecore"


def signatures():
    """{"splinecore.NurbsCurve.evaluate": "(u, *, side='right', …)"} of everything that can be called."""
    found = {}
    for stub in STUBS.glob("*.pyi"):
        module = "splinecore" if stub.stem == "__init__" else f"splinecore.{stub.stem}"
        for node in ast.parse(stub.read_text()).body:
            if isinstance(node, ast.FunctionDef):
                found[f"{module}.{node.name}"] = signature(node)
            elif isinstance(node, ast.ClassDef):
                for method in node.body:
                    if isinstance(method, ast.FunctionDef):
                        name = node.name if method.name == "__init__" else f"{node.name}.{method.name}"
                        found[f"{module}.{name}"] = signature(method)
    return found


def signature(function):
    """The arguments without their types and without self."""
    arguments = function.args
    for argument in (*arguments.posonlyargs, *arguments.args, *arguments.kwonlyargs):
        argument.annotation = None
    is_static = any(ast.unparse(decorator) == "staticmethod" for decorator in function.decorator_list)
    first = arguments.posonlyargs or arguments.args
    if first and first[0].arg == "self" and not is_static:
        first.pop(0)
    return f"({ast.unparse(arguments)})"


def setup(app):
    app.setup_extension("sphinx.ext.autodoc")
    known = signatures()

    def give_signature(app, what, name, thing, options, found, annotation):
        says_one = re.match(r"\w+\(", thing.__doc__ or "")     # without one Sphinx 9 does not take another
        return (known[name], "") if name in known and says_one else None

    def drop_signature(app, what, name, thing, options, lines):
        """pybind11 and our docstrings begin with one; continued lines are one paragraph."""
        if lines and re.match(r"\w+\(.*\)( -> .*)?$", lines[0]):
            del lines[0]
        lines[:] = [re.sub(r"(?<![\\*])\*(?=\w)|\|", r"\\\g<0>", line) for line in lines]

    def mark_code(app, what, name, thing, options, lines):
        """What a module's docstring sets apart is code."""
        if what == "module":
            starts = [i for i in range(1, len(lines)) if lines[i].startswith("    ") and not lines[i - 1]]
            for i in reversed(starts):
                lines[i:i] = ["::", ""]

    app.connect("autodoc-process-docstring", mark_code)
    app.connect("autodoc-process-signature", give_signature)
    app.connect("autodoc-process-docstring", drop_signature)
    return {"parallel_read_safe": True}
