"""A call with too few, too many or unknown arguments is refused with a sentence, whatever is called."""

import inspect
import re

import pytest

import splinecore as sc

LINE = sc.BezierCurve([(0, 0), (1, 1)])


def functions():
    """(name, function) of all that can be called without self."""
    for module in (sc, sc.basis, sc.build, sc.conics):
        for name in module.__all__:
            value = getattr(module, name)
            if inspect.isbuiltin(value):
                yield name, value
            elif inspect.isclass(value) and not issubclass(value, Exception):
                if inspect.isroutine(vars(value).get("__init__")) and hasattr(vars(value)["__init__"], "__func__"):
                    yield name, value
                yield from ((f"{name}.{key}", getattr(value, key)) for key, part in vars(value).items()
                            if isinstance(part, staticmethod))


def methods():
    for module in (sc, sc.basis, sc.build, sc.conics):
        for name in module.__all__:
            value = getattr(module, name)
            if inspect.isclass(value) and not issubclass(value, Exception):
                for key, part in vars(value).items():
                    if not key.startswith("_") and not isinstance(part, (staticmethod, property)):
                        yield f"{name}.{key}", value, key


def refusal(call, *given, **named):
    with pytest.raises(TypeError) as caught:
        call(*given, **named)
    return str(caught.value)


ALL = dict(functions())


@pytest.mark.parametrize("name", ALL)
def test_every_function_says_what_it_takes(name):
    said = refusal(ALL[name], no_such_argument=1)
    assert re.fullmatch(r"[\w.]+\(\) has no argument 'no_such_argument'; it takes \(.*\)", said), said
    takes = said[said.index("; it takes"):]
    if "*values" not in takes:
        many = refusal(ALL[name], *range(99))
        assert re.match(r"[\w.]+\(\) takes \d+ arguments? by place, 99 are given; it takes", many), many
    assert said.startswith(name.rpartition(".")[0])


def test_there_are_many_of_both():
    assert len(ALL) >= 40 and len(list(methods())) >= 190


OBJECTS = [LINE, LINE.to_nurbs(), LINE.to_power(), LINE.to_nurbs().knot_vector, sc.Formula("t"),
           sc.HermiteCurve([(0, 0), (1, 1)], [(1, 0), (1, 0)]), sc.BezierPatch([[(0, 0), (0, 1)], [(1, 0), (1, 1)]])]


@pytest.mark.parametrize("owner", OBJECTS, ids=lambda one: type(one).__name__)
def test_every_method_says_what_it_takes(owner):
    tried = 0
    for name, cls, key in methods():
        if cls is type(owner):
            said = refusal(getattr(owner, key), no_such_argument=1)
            assert said.startswith(f"{name}() has no argument 'no_such_argument'; it takes ("), said
            tried += 1
    assert tried >= 4


@pytest.mark.parametrize("call, sentence", [
    (lambda: LINE.evaluate(),
     "BezierCurve.evaluate() is missing u; it takes (u, *, side='right', at_infinity='raise', dtype=None, out=None, "
     "threads=0, cancel=None)"),
    (lambda: LINE.evaluate(0.5, "left"),
     "BezierCurve.evaluate() takes 1 argument by place, 2 are given; it takes (u, "),
    (lambda: LINE.evaluate(0.5, u=0.5), "BezierCurve.evaluate() is given u twice; "),
    (lambda: LINE.evaluate(0.5, sides="left"), "BezierCurve.evaluate() has no argument 'sides'; "),
    (lambda: LINE.degree_of(), "'splinecore._splinecore.BezierCurve' object has no attribute 'degree_of'"),
    (lambda: LINE.reversed(1), "BezierCurve.reversed() takes 0 arguments by place, 1 is given; it takes ()"),
    (lambda: LINE.derivatives(0.5), "BezierCurve.derivatives() is missing order; it takes (u, order, *, side="),
    (lambda: sc.BezierCurve(), "BezierCurve() is missing points; it takes (points, weights=None)"),
    (lambda: sc.NurbsPatch((1, 1), ([0, 0, 1, 1],) * 2),
     "NurbsPatch() is missing points; it takes (degree, knots, points, weights=None, periodic=(False, False))"),
    (lambda: sc.NurbsCurve(1, [0, 0, 1, 1], [(0, 0), (1, 1)], weight=[1, 1]),
     "NurbsCurve() has no argument 'weight'; "),
    (lambda: sc.BezierCurve.from_homogeneous(), "BezierCurve.from_homogeneous() is missing points; it takes (points)"),
    (lambda: sc.dumps(LINE, 1), "dumps() takes 1 argument by place, 2 are given; it takes (value)"),
    (lambda: sc.loads(), "loads() is missing text; it takes (text)"),
    (lambda: sc.build.join_patches(),
     "join_patches() is missing first; it takes (first, first_side, second, second_side, "),
])
def test_the_sentence(call, sentence):
    with pytest.raises((TypeError, AttributeError)) as caught:
        call()
    assert sentence in str(caught.value) and "\n" not in str(caught.value)


def test_documentation_and_equality_stay():
    assert sc.NurbsCurve.evaluate.__doc__.startswith("Evaluate points of the curve.\n")
    assert "Overloaded" not in "".join(getattr(cls, key).__doc__ for _, cls, key in methods())
    assert LINE != 3 and LINE == sc.loads(sc.dumps(LINE)) and (LINE == "x") is False


def test_a_method_called_without_an_object_misses_it():
    with pytest.raises(TypeError, match=r"NurbsCurve.evaluate\(\) is missing self"):
        sc.NurbsCurve.evaluate()


def test_arguments_are_understood_as_they_were_spelled_before():
    build = sc.build
    assert build.sphere(centre=(0, 0, 0), radius=1.0) == build.sphere(center=(0, 0, 0), radius=1.0)
    patch = sc.BezierPatch([[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 0.5)]])
    line = sc.BezierCurve([(2, 0, 1), (2, 1, 1)])
    made = [build.loft([line], **{name: (patch, "u_end", "G1")}).value for name in ("start_neighbour", "start_neighbor")]
    assert made[0] == made[1]
    for wrong in ({"centre": (0, 0, 0), "center": (0, 0, 0), "radius": 1.0}, {"neighbours": 3, "center": (0, 0, 0), "radius": 1.0}):
        with pytest.raises(TypeError, match="has no argument"):
            build.sphere(**wrong)
