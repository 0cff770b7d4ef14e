"""Programs of PyPI for a test, in an environment of its own."""

import os
import subprocess
import sys

import pytest

#: Without the module under test.
ENVIRONMENT = {key: value for key, value in os.environ.items() if key != "PYTHONPATH"}


def programs(folder, *packages):
    """The folder of the programs of packages, in an environment that has this system's packages, too; skips where there is none."""
    if subprocess.run([sys.executable, "-m", "venv", "--system-site-packages", folder], capture_output=True, env=ENVIRONMENT).returncode:
        pytest.skip("venv does not work here")
    done = subprocess.run([folder / "bin/python", "-m", "pip", "--retries", "1", "--timeout", "20", "install", "-q", *packages],
                          capture_output=True, text=True, env=ENVIRONMENT)
    if done.returncode:
        pytest.skip(f"PyPI cannot be reached, so there is no {', '.join(packages)}: {done.stderr[-200:]}")
    return folder / "bin"
