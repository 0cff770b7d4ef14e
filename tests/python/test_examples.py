"""The examples, on fewer patches: workers give the bits of one process, also when one of them dies."""

import os
import pathlib
import subprocess
import sys

import pytest

EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples"

pytest.importorskip("distributed", reason="Debian's python3-distributed is not installed")


def run(*arguments):
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(path for path in sys.path if path)}
    return subprocess.run([sys.executable, EXAMPLES / "dask_tessellate.py", *map(str, arguments)], capture_output=True,
                          text=True, timeout=300, env=environment)


@pytest.mark.parametrize("kill", [False, True], ids=["alive", "killed"])
def test_workers_give_the_bits_of_one_process(kill):
    done = run("--patches", 900, "--chunk", 50, *["--kill"] * kill)
    assert done.returncode == 0, done.stderr
    assert done.stdout.startswith(f"900 patches, {900 * 13 * 13} vertices: ")
    assert done.stdout.endswith("the same bits\n")
    assert "18 of 18 chunks" in done.stderr and ("killing the worker" in done.stderr) is kill


def test_scaling_is_printed():
    done = run("--patches", 400, "--chunk", 100, "--scaling")
    assert done.returncode == 0, done.stderr
    assert "1 worker: " in done.stdout and "2 workers: " in done.stdout and done.stdout.rstrip().endswith("x")


def test_a_wrong_number_is_refused():
    done = run("--patches", 0)
    assert done.returncode == 2 and "are 1 or more" in done.stderr
