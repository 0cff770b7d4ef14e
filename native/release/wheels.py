"""Wheels of compiled modules, as `pip install` and Blender's manifest take them."""

import re
import shutil
import sys
import tomllib

from tools import HERE, run

NATIVE = HERE.parent
BINDINGS = NATIVE / "bindings/splinecore"
#: What is loaded from the web.
LARGEST = 4 << 20


def version():
    """Of everything, as native/CMakeLists.txt has it."""
    return re.search(r"project\(splinecore VERSION ([0-9.]+)", (NATIVE / "CMakeLists.txt").read_text())[1]


def project(field):
    """A value of pyproject.toml's [project]."""
    return tomllib.loads((NATIVE / "pyproject.toml").read_text())["project"][field]


def licenses():
    """The texts that a wheel has: of the library, and of what is compiled into it."""
    return [NATIVE.parent / "LICENSE", *sorted((NATIVE / "licenses").iterdir())]


def metadata():
    """The text of METADATA, from pyproject.toml."""
    lines = ["Metadata-Version: 2.4", "Name: splinecore", f"Version: {version()}", f"Summary: {project('description')}",
             f"License-Expression: {project('license')}", *[f"License-File: {text.name}" for text in licenses()],
             f"Requires-Python: {project('requires-python')}",
             *[f"Requires-Dist: {needed}" for needed in project("dependencies")],
             *[f"Classifier: {entry}" for entry in project("classifiers")]]
    return "\n".join(lines) + "\n"


def write(tools, target, python, module, dist):
    """The wheel's path in dist, written.

    @raises SystemExit if it is too large to be given away.
    """
    tag = f"cp{python.replace('.', '')}"
    folder = module.parent / "wheel"
    shutil.rmtree(folder, ignore_errors=True)
    package, info = folder / "splinecore", folder / f"splinecore-{version()}.dist-info"
    package.mkdir(parents=True)
    (info / "licenses").mkdir(parents=True)
    for file in (*sorted(BINDINGS.glob("*.py*")), BINDINGS / "py.typed", module):
        shutil.copy(file, package)
    for text in licenses():
        shutil.copy(text, info / "licenses")
    (info / "METADATA").write_text(metadata())
    (info / "WHEEL").write_text(f"Wheel-Version: 1.0\nGenerator: splinecore {version()}\nRoot-Is-Purelib: false\n"
                                f"Tag: {tag}-{tag}-{target.wheel}\n")
    run(tools.python, "-m", "wheel", "pack", folder, "--dest-dir", dist, capture_output=True)
    wheel = dist / f"splinecore-{version()}-{tag}-{tag}-{target.wheel}.whl"
    if wheel.stat().st_size > LARGEST:
        sys.exit(f"{wheel}: {wheel.stat().st_size} bytes are more than {LARGEST}")
    return wheel
