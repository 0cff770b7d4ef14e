"""What help and editors show: parameters, results and errors of every public function, and examples that run."""

import ast
import doctest
import inspect
import re
import subprocess
import sys
import types
from pathlib import Path

import numpy as np
import pytest

import splinecore as sc

BINDINGS = Path(__file__).resolve().parents[2] / "native/bindings"
MODULES = (sc, sc.basis, sc.bpt, sc.build, sc.conics, sc.fit, sc.meshes, sc.plot)
STUBS = {"splinecore" if path.stem == "__init__" else f"splinecore.{path.stem}": path
         for path in (BINDINGS / "splinecore").glob("*.pyi")}


def public():
    """(name, thing) of every public class, function, method and property."""
    for module in MODULES:
        for name in ("dumps", "loads") if module is sc.bpt else module.__all__:
            thing = getattr(module, name)
            if not isinstance(thing, types.ModuleType):
                yield f"{module.__name__}.{name}", thing
            if inspect.isclass(thing) and not issubclass(thing, Exception):
                yield from ((f"{module.__name__}.{name}.{key}", getattr(thing, key)) for key in vars(thing) if not key.startswith("_"))


PUBLIC = dict(public())
CALLS = {name: thing for name, thing in PUBLIC.items() if not inspect.isclass(thing) and not isinstance(thing, property)}


def in_stubs():
    """{name: docstring} of all stubs."""
    found = {}
    for module, path in STUBS.items():
        for node in ast.parse(path.read_text("utf-8")).body:
            for part in (node, *(node.body if isinstance(node, ast.ClassDef) else ())):
                if isinstance(part, (ast.ClassDef, ast.FunctionDef)):
                    name = f"{module}.{node.name}" + (f".{part.name}" if part is not node else "")
                    found[name] = ast.get_docstring(part)
    return found


def has_constructor(cls):
    return not isinstance(cls.__init__, types.WrapperDescriptorType) and not issubclass(cls, Exception)


def test_the_stubs_are_made_from_the_texts():
    done = subprocess.run([sys.executable, BINDINGS / "docstrings/make_stubs.py", "--check"], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr


def test_the_module_says_what_its_stubs_say():
    said = in_stubs()
    assert len(PUBLIC) > 600
    for name, thing in PUBLIC.items():
        assert inspect.getdoc(thing) == said[name], name


@pytest.mark.parametrize("name", CALLS)
def test_a_function_says_what_it_takes_and_gives(name):
    text = inspect.getdoc(CALLS[name])
    parameters = [str(one).split("=")[0] for one in inspect.signature(CALLS[name]).parameters.values() if one.name != "self"]
    assert text.split("\n\n")[0].endswith(".")
    assert "\nReturns\n-------\n" in text
    if parameters:
        listed = text.split("\nParameters\n----------\n")[1].split("\n\n")[0]
        assert re.findall(r"^(\S+) : \S", listed, re.M) == parameters
        assert "\nRaises\n------\n" in text


@pytest.mark.parametrize("name", [name for name, thing in PUBLIC.items() if inspect.isclass(thing) and has_constructor(thing)])
def test_a_class_says_what_its_constructor_takes(name):
    listed = inspect.getdoc(PUBLIC[name]).split("\nParameters\n----------\n")[1].split("\n\n")[0]
    assert re.findall(r"^(\w+) : \S", listed, re.M) == list(inspect.signature(PUBLIC[name]).parameters)


def test_lectures_stand_in_references_alone():
    for name, text in in_stubs().items():
        before = (text or "").split("\nReferences\n----------\n")[0]
        assert not re.search(r"\b(?:[Ll]ecture|[Rr]ows? S\d)", before), name


def examples():
    """Docstrings with examples, each once, by the first name that has it."""
    known = {}
    for name, text in in_stubs().items():
        if ">>>" in (text or ""):
            known.setdefault(text, name)
    return {name: text for text, name in known.items()}


def shown_by_its_class(name, said):
    """Whether the example of its class shows a property."""
    owner, _, own = name.rpartition(".")
    return isinstance(PUBLIC[name], property) and re.search(rf"\.{own}\b", (said[owner] or "").partition("\nExamples\n")[2])


def test_every_public_name_has_an_example():
    said = in_stubs()
    without = [name for name in PUBLIC if ">>>" not in (said[name] or "") and not shown_by_its_class(name, said)]
    assert not without


@pytest.mark.parametrize("name", examples())
def test_examples_run(name):
    if name.startswith("splinecore.plot"):
        pytest.importorskip("matplotlib").use("agg")
    test = doctest.DocTestParser().get_doctest(examples()[name], {"sc": sc, "np": np}, name, None, 0)
    said = []
    result = doctest.DocTestRunner(verbose=False).run(test, out=said.append)
    assert result.attempted and not result.failed, "".join(said)


def native_calls():
    """Every class with a constructor, and every function and method that is not Python, special ones included."""
    native = ("builtin_function_or_method", "instancemethod")
    for name, thing in PUBLIC.items():
        if inspect.isclass(thing) and has_constructor(thing):
            yield name, thing
        if inspect.isclass(thing) and not issubclass(thing, Exception):
            own = {key: getattr(thing, key) for key in vars(thing)}
            yield from ((f"{name}.{key}", part) for key, part in own.items() if type(part).__name__ in native)
        elif inspect.isbuiltin(thing):
            yield name, thing


@pytest.mark.parametrize("name, function", native_calls(), ids=lambda one: one if isinstance(one, str) else "")
def test_inspect_reads_signatures(name, function):
    inspect.signature(function)


def test_signatures_are_those_of_the_calls():
    curve = sc.BezierCurve([(0, 0), (1, 1)])
    names = ["u", "order", "side", "at_infinity", "out", "threads", "cancel"]
    assert list(inspect.signature(sc.BezierCurve.derivatives).parameters) == ["self", *names]
    assert list(inspect.signature(curve.derivatives).parameters) == names
    assert inspect.signature(curve.derivatives).parameters["side"].default == "right"
    assert str(inspect.signature(sc.BezierCurve)) == "(points, weights=None)"
    assert str(inspect.signature(sc.NurbsCurve.from_homogeneous)) == "(degree, knots, points, periodic=False)"
    assert str(inspect.signature(sc.Formula.evaluate)).startswith("(self, *values, ")
    assert inspect.signature(curve.derivatives).bind(0.5, 1, side="left").arguments["order"] == 1


def test_results_are_pairs():
    result = sc.BezierCurve([(0, 0), (1, 1), (2, 0)]).reduce()
    value, error = result
    assert len(result) == 2 and result[0] == value == result.value and result[1] == result[-1] == error == result.error
    with pytest.raises(IndexError):
        result[2]
