"""Type checkers of PyPI accept the stubs, and programs that use them; the examples run."""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import splinecore as sc
from from_pypi import ENVIRONMENT, programs

PROJECT = Path(__file__).resolve().parents[2]
STUBS = PROJECT / "native/bindings/splinecore"
CHECKERS = ("mypy==2.4.1", "pyright[nodejs]==1.1.414")
EXAMPLES = sorted((PROJECT / "examples/python").glob("*.py"))
USE = """
from typing import assert_type

import splinecore as sc

curve = sc.NurbsCurve(1, [0, 0, 1, 1], [(0, 0), (1, 1)])
start: float = curve.domain[0]
curve.evaluate(start, side="left", cancel=lambda: False)
simpler, error = curve.reduce()
assert_type(simpler, sc.NurbsCurve)
assert_type(error, float)
patches, most = sc.build.pipe(curve, 1.0, caps="flat")
assert_type(patches, list[sc.NurbsPatch])
surface, moved = sc.build.loft([curve, curve])
assert_type(surface, sc.NurbsPatch)
assert_type(moved, float)
network, away = sc.build.network([curve, curve], [curve, curve])
assert_type(network, sc.NurbsPatch)
"""
WRONG = """
import splinecore as sc

curve = sc.BezierCurve([(0, 0), (1, 1)])
curve.evaluate(0.5, side="middle")
value, error = curve.reduce()
error.domain
"""


@pytest.fixture
def checked(tmp_path):
    """A folder with the stubs and programs to check."""
    shutil.copytree(STUBS, tmp_path / "splinecore", ignore=shutil.ignore_patterns("*.so", "__pycache__"))
    for path in EXAMPLES:
        shutil.copy(path, tmp_path)
    (tmp_path / "use.py").write_text(USE)
    return tmp_path


@pytest.fixture(scope="module")
def python(tmp_path_factory):
    """Of an environment with both checkers, and with NumPy as it is here."""
    return programs(tmp_path_factory.mktemp("checkers"), *CHECKERS) / "python"


def check(python, checker, folder, *files):
    """What a type checker says of files, at its strictest."""
    command = [python, "-m", checker, *(["--strict", *files] if checker == "mypy" else [])]
    (folder / "pyrightconfig.json").write_text(json.dumps({"include": files, "typeCheckingMode": "strict", "pythonVersion": "3.11"}))
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, env=ENVIRONMENT)


@pytest.mark.parametrize("checker", ["mypy", "pyright"])
def test_type_checkers_accept_the_stubs_and_the_examples(checker, python, checked):
    stubs = [f"splinecore/{path.name}" for path in STUBS.glob("*.pyi")]
    done = check(python, checker, checked, *stubs, "use.py", *(path.name for path in EXAMPLES))
    assert done.returncode == 0, done.stdout[-3000:] + done.stderr[-1000:]


@pytest.mark.parametrize("checker", ["mypy", "pyright"])
def test_type_checkers_see_what_is_wrong(checker, python, checked):
    (checked / "wrong.py").write_text(WRONG)
    done = check(python, checker, checked, "wrong.py")
    assert done.returncode == 1 and "middle" in done.stdout and "domain" in done.stdout, done.stdout + done.stderr


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_examples_run(path, tmp_path):
    environment = os.environ | {"PYTHONPATH": str(Path(sc.__file__).parents[1])}
    done = subprocess.run([sys.executable, "-W", "error", path, tmp_path / "out.stl"], capture_output=True, text=True, cwd=tmp_path,
                          env=environment)
    assert done.returncode == 0 and done.stdout and not done.stderr, done.stderr
