"""A page for each module and each class of Python, made before the others are read."""

import importlib
import inspect
import sys
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(PROJECT / "addon"))

import manual_pages  # noqa: E402

MODULES = {
    "splinecore": "Curves, patches, sets, meshes, formulas",
    "splinecore.basis": "Knot vectors, Bernstein polynomials, matrices",
    "splinecore.build": "Curves and patches from points, formulas and other shapes",
    "splinecore.conics": "Circles, ellipses, parabolas, hyperbolas",
    "splinecore.fit": "Curves and patches through points and near them",
    "splinecore.bpt": "Bezier patches as text",
    "splinecore.meshes": "Meshes in files",
    "splinecore.plot": "Pictures with matplotlib",
}
#: Classes of the module splinecore; all others are results.
GROUPS = {
    "Curves": ("NurbsCurve", "BezierCurve", "HermiteCurve", "PowerCurve"),
    "Patches, sets and meshes": ("NurbsPatch", "BezierPatch", "HermitePatch", "PatchSet", "Tessellation"),
    "Plane regions": ("Region",),
    "Formulas": ("Formula",),
}


def heading(text, line="="):
    return f"{text}\n{line * len(text)}\n"


def summaries(names):
    """A table of names below the current module with their first sentences, each a link."""
    return ".. autosummary::\n   :nosignatures:\n\n" + "".join(f"   ~{name}\n" for name in names) if names else ""


def members(module):
    """(classes, exceptions, functions) of a module, by name."""
    names = [name for name in module.__all__ if callable(getattr(module, name))]
    things = {name: getattr(module, name) for name in names}
    classes = [name for name, thing in things.items() if inspect.isclass(thing)]
    exceptions = [name for name in classes if issubclass(things[name], Exception)]
    return [name for name in classes if name not in exceptions], exceptions, [name for name in things if name not in classes]


def class_page(module, name):
    """Tables of methods and properties, and then all that is said of them."""
    cls = getattr(importlib.import_module(module), name)
    public = [key for key in vars(cls) if not key.startswith("_")]
    properties = [key for key in public if isinstance(vars(cls)[key], property)]
    methods = sorted(set(public) - set(properties))
    tables = [heading(title, "-") + "\n" + summaries([f"{name}.{key}" for key in keys])
              for title, keys in (("Properties", sorted(properties)), ("Methods", methods)) if keys]
    details = "".join(f".. auto{kind}:: {module}.{name}.{key}\n" for kind, keys in
                      (("property", sorted(properties)), ("method", methods)) for key in keys)
    parts = [heading(name), f".. currentmodule:: {module}\n", f".. autoclass:: {module}.{name}\n", *tables]
    return "\n".join([*parts, heading("In detail", "-"), details] if details else parts)


def module_page(name):
    module = importlib.import_module(name)
    classes, exceptions, functions = members(module)
    parts = [heading(name), f".. automodule:: {name}\n"]
    grouped = [one for group in GROUPS.values() for one in group] if name == "splinecore" else classes
    groups = GROUPS | {"Results": [one for one in classes if one not in grouped]} if name == "splinecore" else {"Classes": classes}
    for title, names in groups.items():
        if names:
            parts.append(heading(title, "-") + "\n" + summaries(names))
    for title, names, kind in (("Functions", functions, "function"), ("Exceptions", exceptions, "exception")):
        if names:
            parts.append(heading(title, "-") + "\n" + (summaries(names) if len(names) > 4 else ""))
            parts += [f".. auto{kind}:: {name}.{one}\n" for one in names]
    if classes:
        parts.append(".. toctree::\n   :hidden:\n\n" + "".join(f"   {name}.{one}\n" for one in classes))
    return "\n".join(parts), classes


def write(folder):
    rows = []
    for name, title in MODULES.items():
        text, classes = module_page(name)
        (folder / f"{name}.rst").write_text(text)
        for one in classes:
            (folder / f"{name}.{one}.rst").write_text(class_page(name, one))
        rows.append(f"| [{name}]({name}.rst) | {title} |")
    names = "\n".join(MODULES)
    (folder / "index.md").write_text(
        "# The Python module\n\n| module | contents |\n| --- | --- |\n" + "\n".join(rows) + "\n\n"
        + manual_pages.section((PROJECT / "README.md").read_text(), "The module in ten lines").replace("](docs/", "](../")
        + f"\n```{{toctree}}\n:hidden:\n\n{names}\n```\n")
