"""A wheel for this system and its Python, made from the source archive, and whether it works in an empty environment.

    here.py BUILD DIST     what is compiled stays in BUILD, and both files lie in DIST

It needs PyPI: where that cannot be reached it says so, and ends with 3.
"""

import os
import re
import shutil
import subprocess
import sys
import tarfile
from pathlib import Path

import sources
from tools import run
from wheels import version

#: What pip makes wheels with. pybind11 is that of the system, as the other libraries are.
TOOLS = ("build", "scikit-build-core")
OFFLINE = 3
PIP = ("-m", "pip", "--disable-pip-version-check", "--retries", "1", "--timeout", "30")
TRIAL = """
import pathlib, sys
import splinecore as sc
assert str(pathlib.Path(sc.__file__)).startswith(sys.prefix), sc.__file__
assert sc.BezierCurve([(0, 0), (1, 2), (2, 0)]).evaluate(0.5)[1] == 1.0
print("splinecore", sc.__version__, "works in an empty environment")
"""


def environment(folder, *packages):
    """The Python of a new environment with packages. @raises SystemExit where PyPI cannot be reached."""
    shutil.rmtree(folder, ignore_errors=True)
    run(sys.executable, "-m", "venv", folder)
    python = folder / "bin/python"
    done = subprocess.run([python, *PIP, "install", "-q", *packages], capture_output=True, text=True)
    if done.returncode:
        print(f"PyPI cannot be reached, so there is no {', '.join(packages)} to make and try a wheel with: {done.stderr[-300:]}")
        raise SystemExit(OFFLINE)
    return python


def unpacked(archive, folder):
    """The sources of an archive, at the same place each time: what is compiled there is found again."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    with tarfile.open(archive) as files:
        files.extractall(folder)
    return folder / f"splinecore-{version()}"


def built(python, source, build, dist):
    """The wheel's path in dist."""
    scratch = build / "made"
    shutil.rmtree(scratch, ignore_errors=True)
    more = {"PATH": f"/usr/bin:{os.environ['PATH']}", "NINJA_STATUS": "[%f of %t, %p, %es] "}
    if shutil.which("ccache"):
        more["CMAKE_CXX_COMPILER_LAUNCHER"] = "ccache"
    run(python, *PIP, "wheel", "-v", "--no-deps", "--no-build-isolation", f"--config-settings=build-dir={build / 'objects'}",
        "-w", scratch, source, env=os.environ | more)
    (made,) = scratch.glob("*.whl")
    dist.mkdir(parents=True, exist_ok=True)
    return Path(shutil.move(made, dist / made.name))


def needed(library):
    """The newest versions of the system's libraries that a compiled module asks for, as {"GLIBC": (2, 35)…}."""
    said = subprocess.run(["objdump", "-T", library], capture_output=True, text=True, check=True).stdout
    newest = {}
    for name, numbers in re.findall(r"\((GLIBC|GLIBCXX)_([\d.]+)\)", said):
        newest[name] = max(newest.get(name, ()), tuple(map(int, numbers.split("."))))
    return newest


def try_out(python, folder, wheel):
    """Installs a wheel in an environment that has NumPy alone, and says what of the system it needs."""
    run(python, *PIP, "install", "-q", "--no-index", "--no-deps", wheel)
    run(python, "-c", TRIAL, cwd=folder)
    (library,) = python.parents[1].glob("lib/python*/site-packages/splinecore/_splinecore*.so")
    if shutil.which("objdump"):
        print("It needs", " and ".join(f"{name} {'.'.join(map(str, number))}" for name, number in needed(library).items()),
              "or later", flush=True)


def main(build, dist):
    build, dist = Path(build).resolve(), Path(dist).resolve()
    print("Getting what wheels are made with, from PyPI", flush=True)
    python = environment(build / "tools", *TOOLS)
    empty = environment(build / "empty", "numpy")
    print("Packing the sources", flush=True)
    archive = sources.write(python, build / "sources", dist)
    print("Compiling them, some minutes the first time", flush=True)
    wheel = built(python, unpacked(archive, build / "unpacked"), build, dist)
    print("Installing the wheel", flush=True)
    try_out(empty, build, wheel)
    print(archive, wheel, sep="\n")


if __name__ == "__main__":
    main(*sys.argv[1:])
