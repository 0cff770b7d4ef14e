"""The add-on's core on the module under test, packed as in the zip; it needs no Blender."""

import functools
import importlib
import importlib.util
import sys
import tempfile
from pathlib import Path

import splinecore as sc

ADDON = Path(__file__).resolve().parents[2] / "addon"


def _make_zip():
    spec = importlib.util.spec_from_file_location("make_zip", ADDON / "make_zip.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@functools.cache
def _unpacked():
    """A folder that is removed when Python ends; kept in the cache as long as it is used.

    Its library is the one that the tests have imported: values of a second copy would be of other types.
    """
    folder = tempfile.TemporaryDirectory(prefix="splinewright-")
    package = Path(sc.__file__).resolve().parent
    for path, data in _make_zip().content(sc.__version__, package, package):
        target = Path(folder.name) / path
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_bytes(data)
    sys.path.insert(0, folder.name)
    importlib.import_module("splinewright")
    sys.modules["splinewright.splinecore"] = sc
    return folder


def core(name):
    """A module of the core: core("definition")."""
    _unpacked()
    return importlib.import_module(f"splinewright.core.{name}")
