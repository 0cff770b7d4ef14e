"""The type stubs say what the module has, and the tests name all of it."""

import ast
import inspect
import pathlib
import re
import types

import pytest

import splinecore as sc

PACKAGE = pathlib.Path(sc.__file__).parent
MODULES = {"__init__": sc, "basis": sc.basis, "build": sc.build, "conics": sc.conics, "fit": sc.fit}


def stub_of(name):
    return ast.parse((PACKAGE / f"{name}.pyi").read_text("utf-8"))


def stub_parameters(function):
    """[(name, kind, has a default), …] without self."""
    arguments = function.args
    plain = [*arguments.posonlyargs, *arguments.args]
    defaults = [False] * (len(plain) - len(arguments.defaults)) + [True] * len(arguments.defaults)
    found = [(one.arg, "plain", default) for one, default in zip(plain, defaults) if one.arg != "self"]
    return found + [(one.arg, "keyword", default is not None)
                    for one, default in zip(arguments.kwonlyargs, arguments.kw_defaults)]


def module_parameters(function):
    """The same from the signature that the module gives."""
    parameters = inspect.signature(function).parameters.values()
    kinds = {inspect.Parameter.KEYWORD_ONLY: "keyword", inspect.Parameter.POSITIONAL_OR_KEYWORD: "plain"}
    return [(one.name, kinds[one.kind], one.default is not one.empty) for one in parameters
            if one.name != "self" and one.kind in kinds]


def stub_members(tree):
    members = {}
    for node in tree.body:
        if isinstance(node, ast.ClassDef) and not node.name.startswith("_"):
            members[node.name] = {part.name: part for part in node.body if isinstance(part, ast.FunctionDef)}
            if any(ast.unparse(base).startswith("tuple[") for base in node.bases):      # a pair inherits these
                members[node.name] |= dict.fromkeys(("__getitem__", "__iter__", "__len__"))
        elif isinstance(node, ast.FunctionDef):
            members[node.name] = node
    return members


def is_public(name):
    return not name.startswith("_") or name in ("__init__", "__len__", "__getitem__", "__iter__", "__eq__", "__hash__",
                                                "__copy__", "__deepcopy__", "__bool__", "__or__", "__and__", "__sub__", "__xor__")


def module_members(module):
    members = {}
    for name in module.__all__:
        value = getattr(module, name)
        if inspect.isclass(value):
            own = {} if issubclass(value, Exception) else vars(value)
            # A class without a constructor has object's.
            members[name] = {key: part for key, part in own.items()
                             if is_public(key) and not isinstance(part, types.WrapperDescriptorType)}
        elif not inspect.ismodule(value):
            members[name] = value
    return members


@pytest.mark.parametrize("name", MODULES)
def test_stubs_list_the_public_names(name):
    (names,) = [node.value for node in stub_of(name).body
                if isinstance(node, ast.Assign) and node.targets[0].id == "__all__"]
    assert ast.literal_eval(names) == MODULES[name].__all__ == sorted(MODULES[name].__all__)
    assert set(stub_members(stub_of(name))) == set(module_members(MODULES[name]))


@pytest.mark.parametrize("name", MODULES)
def test_stubs_have_the_members_of_every_class_and_no_others(name):
    stubs = stub_members(stub_of(name))
    for key, parts in module_members(MODULES[name]).items():
        if isinstance(parts, dict):
            assert sorted(stubs[key]) == sorted(parts), key


@pytest.mark.parametrize("name", MODULES)
def test_stubs_have_the_parameters_of_every_function(name):
    stubs = stub_members(stub_of(name))
    compared = 0
    for key, value in module_members(MODULES[name]).items():
        pairs = [(stubs[key], value)] if not isinstance(value, dict) else [
            (stubs[key][part], getattr(getattr(MODULES[name], key), part)) for part in value]
        for stub, real in (pair for pair in pairs if pair[0] is not None):
            if isinstance(real, property):
                assert [one.id for one in stub.decorator_list] == ["property"], (key, stub.name)
            elif not re.fullmatch("__(eq|hash|len|copy|deepcopy|bool|or|and|sub|xor)__", stub.name):
                static = any(getattr(one, "id", "") == "staticmethod" for one in stub.decorator_list)
                assert static == inspect.isbuiltin(real) or not isinstance(value, dict), (key, stub.name)
                assert stub_parameters(stub) == module_parameters(real), (key, stub.name)
                compared += 1
    assert compared


def test_every_public_name_is_named_in_a_test():
    here = pathlib.Path(__file__)
    text = "".join(path.read_text("utf-8") for path in here.parent.glob("*.py") if path != here)
    words = set(re.findall(r"\w+", text))
    missing = [f"{key}.{part}" for module in MODULES.values() for key, parts in module_members(module).items()
               for part in (parts if isinstance(parts, dict) else [key])
               if part not in words and not part.startswith("__") or key not in words]
    assert not missing


def test_everything_public_says_what_it_is():
    for module in MODULES.values():
        for key, parts in module_members(module).items():
            assert getattr(module, key).__doc__, key
            for part, value in parts.items() if isinstance(parts, dict) else ():
                if not part.startswith("__") and not isinstance(value, property):
                    assert len(value.__doc__.splitlines()) > 1, f"{key}.{part}"


def test_the_package_is_marked_as_typed():
    assert (PACKAGE / "py.typed").exists()
