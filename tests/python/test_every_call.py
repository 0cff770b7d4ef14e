"""Every public call, at degrees up to the limit and at sizes up to those of a double: none crashes, none gives NaN.

A call gives finite numbers or is refused in words; what may give nan says so in its documentation. A long call hears
Ctrl-C.
"""

import json
import os
import pathlib
import subprocess
import sys

import pytest

import public_calls
import splinecore as sc

# Of the processor: after SECONDS a call is stopped as by Ctrl-C, and may take no longer than LATE to notice.
SECONDS = 0.05
LATE = 1.0
HERE = pathlib.Path(__file__).parent
DEGREES = (1, 2, 3, 5, 9, 32, 161, 255)
SIZES = (1e-275, 1e-150, 1e-36, 1e36, 1e150, 1e275)
WEIGHTS = (1e-300, -1e-300, 1e300, -1e300)
# A straight curve has no osculating plane.
MAY_BE_NAN = ("torsion", "frenet_frame")


def calls_at(degree, size=1.0, weight=1.0, spacing=1.0):
    """What came of each call, [{name, what, …}, …]."""
    path = os.pathsep.join([str(HERE), str(pathlib.Path(sc.__file__).parents[1]), os.environ.get("PYTHONPATH", "")])
    arguments = [str(degree), *map(repr, (size, weight, spacing, SECONDS))]
    done = subprocess.run([sys.executable, "-X", "faulthandler", HERE / "every_call.py", *arguments],
                          capture_output=True, text=True, timeout=1200, env={**os.environ, "PYTHONPATH": path})
    lines = [json.loads(line) for line in done.stdout.splitlines()]
    assert done.returncode == 0, (lines[-1:], done.stderr[-2000:])
    return [line for line in lines if "what" in line]


def wrong(found):
    """The calls that failed, gave what they may not, or were late."""
    def is_right(call):
        if call["what"] == "nan":
            return call["name"].endswith(MAY_BE_NAN)
        return call["what"] in ("finite", "refused", "stopped") and call.get("late", 0) <= LATE

    return [json.dumps(call) for call in found if not is_right(call)]


def test_every_public_name_is_called():
    classes, functions = {}, set()
    for short, module in public_calls.MODULES.items():
        for name in module.__all__:
            value = getattr(module, name)
            if isinstance(value, type) and not issubclass(value, Exception):
                classes[name] = public_calls.public_methods(value)
            elif callable(value) and not isinstance(value, type):
                functions.add(f"{short}.{name}")
    assert {name: sorted(keys) for name, keys in classes.items()} == {
        name: sorted(keys) for name, keys in public_calls.METHODS.items()}
    assert sorted(functions) == sorted(public_calls.FUNCTIONS)
    at = public_calls.surroundings(3)
    assert {type(one).__name__ for one in public_calls.subjects(at)} == set(classes)


def test_at_degree_3_all_calls_have_a_result():
    """So that the other tests do not pass because all is refused."""
    found = calls_at(3)
    names = {call["name"] for call in found}
    given = {call["name"] for call in found if call["what"] != "refused"}
    assert len(names) > 300
    assert names == given


@pytest.mark.parametrize("degree", DEGREES)
def test_every_call_at_a_degree(degree):
    found = calls_at(degree)
    assert len(found) > 300
    assert wrong(found) == []


@pytest.mark.parametrize("size", SIZES)
def test_every_call_at_a_size(size):
    assert wrong(calls_at(3, size)) == []


@pytest.mark.parametrize("spacing", [1e-150, 1e150])
def test_every_call_at_a_spacing_of_knots(spacing):
    assert wrong(calls_at(3, spacing=spacing)) == []


@pytest.mark.parametrize("weight", WEIGHTS)
@pytest.mark.parametrize("size", [1.0, 1e36])
def test_every_call_at_a_weight(size, weight):
    assert wrong(calls_at(3, size, weight)) == []
