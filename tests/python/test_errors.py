"""All errors of the library are one family, and each is one of Python's own kinds as well."""

import copy
import inspect
import pickle

import pytest

import splinecore as sc

KINDS = {"InvalidShape": ValueError, "FormulaError": ValueError, "PointAtInfinity": ArithmeticError,
         "ToleranceNotReached": ArithmeticError, "Cancelled": RuntimeError}
RAISED = {
    "InvalidShape": lambda: sc.BezierCurve([(0, 0), (1, 1)]).evaluate(7),
    "FormulaError": lambda: sc.Formula("1 +"),
    "PointAtInfinity": lambda: sc.BezierCurve([(0, 0), (1, 1)], [1, -1]).evaluate(0.5),
    "ToleranceNotReached": lambda: sc.BezierCurve([(0, 0), (1, 1), (2, 0)]).reduce(tolerance=1e-9),
    "Cancelled": lambda: sc.BezierCurve([(0, 0), (1, 1)]).evaluate([0, 1], cancel=lambda: True),
}


def own_errors():
    found = {}
    for module in (sc, sc.basis, sc.build, sc.conics, sc._splinecore):
        for name, value in vars(module).items():
            if inspect.isclass(value) and issubclass(value, BaseException):
                found[name] = value
    return found


def test_every_error_of_the_module_is_an_error_of_the_family():
    found = own_errors()
    assert set(found) == {"Error", *KINDS}
    assert sc.Error.__bases__ == (Exception,) and sc.Error.__doc__
    for name, kind in KINDS.items():
        assert issubclass(found[name], sc.Error) and issubclass(found[name], kind), name
    assert issubclass(sc.FormulaError, sc.InvalidShape)
    assert {value.__module__ for value in found.values()} == {"splinecore"}


@pytest.mark.parametrize("name", KINDS)
def test_what_is_raised_is_caught_as_any_of_its_bases(name):
    for base in (sc.Error, KINDS[name], getattr(sc, name)):
        with pytest.raises(base) as caught:
            RAISED[name]()
        assert type(caught.value) is getattr(sc, name) and str(caught.value)


@pytest.mark.parametrize("name", KINDS)
def test_errors_can_be_copied_and_pickled(name):
    with pytest.raises(sc.Error) as caught:
        RAISED[name]()
    for again in (copy.copy(caught.value), *(pickle.loads(pickle.dumps(caught.value, protocol))
                                             for protocol in range(pickle.HIGHEST_PROTOCOL + 1))):
        assert type(again) is type(caught.value) and again.args == caught.value.args
        assert vars(again) == vars(caught.value)


def test_a_wrong_type_is_a_type_error_and_no_error_of_the_family():
    with pytest.raises(TypeError) as caught:
        sc.BezierCurve([(0, 0), (1, 1)]).evaluate([], cancel=3)
    assert not isinstance(caught.value, sc.Error)
