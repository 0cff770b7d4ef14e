"""Annotations of the stubs in the words of docstrings: `ArrayLike | None = None` is "array_like, optional"."""

import ast
import re

NAMES = {
    "ArrayLike": "array_like", "SupportsIndex": "int", "DTypeLike": "dtype_like", "_Curve": "curve", "_Patch": "patch", "_Floats": "numpy.ndarray", "_Points": "numpy.ndarray", "_Cancel": "callable",
    "_Interval": "tuple (float, float)", "Any": "object",
}


def plural(kind):
    """Of one word in small letters."""
    if kind == "str":
        return "strings"
    return kind + ("es" if kind.endswith("ch") else "s") if re.fullmatch("[a-z]+", kind) else kind


class Kinds:
    """Knows the aliases of all stubs."""

    def __init__(self, stubs):
        self.aliases = {}
        for stub in stubs:
            for node in ast.parse(stub.read_text("utf-8")).body:
                target = node.targets[0] if isinstance(node, ast.Assign) else getattr(node, "target", None)
                if isinstance(target, ast.Name) and node.value is not None:
                    self.aliases.setdefault(target.id, node.value)

    def argument(self, annotation, preset):
        """With its preset, unless that is None."""
        text = self.text(annotation)
        if preset is None:
            return text
        is_none = isinstance(preset, ast.Constant) and preset.value is None
        if is_none or (isinstance(preset, ast.Tuple) and "'" in ast.unparse(preset)):
            return f"{text.removesuffix(' or None')}, optional"
        return f"{text}, default {ast.unparse(preset)}"

    def text(self, node):
        if isinstance(node, ast.Constant):
            return "None" if node.value is None else str(node.value)
        if isinstance(node, ast.BinOp):
            return self.union(node)
        if isinstance(node, ast.Subscript):
            return self.generic(node)
        name = node.id if isinstance(node, ast.Name) else node.attr
        if name in NAMES:
            return NAMES[name]
        return self.text(self.aliases[name]) if name.startswith("_") and name in self.aliases else ast.unparse(node)

    def union(self, node):
        members = []
        while isinstance(node, ast.BinOp):
            members.insert(0, node.right)
            node = node.left
        texts = list(dict.fromkeys(self.text(member) for member in (node, *members)))
        return " or ".join("a pair of these" if text == f"tuple ({texts[0]}, {texts[0]})" else text for text in texts)

    def generic(self, node):
        name = self.text(node.value)
        inner = node.slice.elts if isinstance(node.slice, ast.Tuple) else [node.slice]
        if name == "Literal":
            return "{" + ", ".join(ast.unparse(one) for one in inner) + "}"
        if name == "NDArray":
            return "numpy.ndarray"
        if name == "Callable":
            return "callable"
        if name == "tuple" and not (len(inner) == 2 and ast.unparse(inner[1]) == "..."):
            return f"tuple ({', '.join(self.text(one) for one in inner)})"
        if name in ("list", "tuple", "Sequence"):
            return f"{name.lower()} of {plural(self.text(inner[0]))}"
        return f"{name} of {self.text(inner[0])}"
