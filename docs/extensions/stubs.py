"""Docstrings of the module as Sphinx wants them."""

import inspect
import re

import splinecore


def escape_marks(app, what, name, thing, options, lines):
    """Stars and bars are no marks, but in examples."""
    is_example = False
    for i, line in enumerate(lines):
        is_example = line.lstrip().startswith(">>>") or (is_example and bool(line.strip()))
        if not is_example:
            lines[i] = re.sub(r"(?<![\\*])\*(?=\w)|\|", r"\\\g<0>", line)


def keep_properties(app, what, name, thing, options, lines):
    """A colon in the sentence of a property ends no type, as napoleon has it."""
    if what == "property":
        lines[:] = (inspect.getdoc(thing) or "").splitlines()
        escape_marks(app, what, name, thing, options, lines)


def mark_code(app, what, name, thing, options, lines):
    """What a module's docstring sets apart is code."""
    if what == "module":
        starts = [i for i in range(1, len(lines)) if lines[i].startswith("    ") and not lines[i - 1]]
        for i in reversed(starts):
            lines[i:i] = ["::", ""]


def link_classes(app, config):
    """Kinds of parameters and results lead to their classes."""
    config.napoleon_type_aliases = {name: f"~splinecore.{name}" for name in splinecore.__all__ if name[0].isupper()} | {
        "KnotVector": "~splinecore.basis.KnotVector", "ImplicitConic": "~splinecore.conics.ImplicitConic"}


def setup(app):
    app.setup_extension("sphinx.ext.napoleon")
    app.connect("config-inited", link_classes)
    app.connect("autodoc-process-docstring", mark_code)
    app.connect("autodoc-process-docstring", escape_marks, priority=100)     # before napoleon writes marks
    app.connect("autodoc-process-docstring", keep_properties, priority=900)
    return {"parallel_read_safe": True}
