"""The source archive of the library, which pip takes."""

import shutil
from pathlib import Path

from tools import HERE, PROJECT, run
from wheels import version

NATIVE = HERE.parent


def _not_given(folder, names):
    """What is no source; below `native` itself rooms have such names, too."""
    return {"__pycache__", *(("build", "release") if Path(folder) == NATIVE else ())} & set(names)


def write(python, scratch, dist):
    """The archive's path in dist, with its license. The Python has the package `build`."""
    shutil.rmtree(scratch, ignore_errors=True)
    shutil.copytree(NATIVE, scratch, ignore=_not_given)
    shutil.copy(PROJECT / "LICENSE", scratch)
    run(python, "-m", "build", "--sdist", scratch, "--outdir", dist, capture_output=True)
    return dist / f"splinecore-{version()}.tar.gz"
