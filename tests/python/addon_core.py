"""The add-on's core on the module under test; it needs no Blender."""

import importlib
import sys
import types
from pathlib import Path

import splinecore as sc

ADDON = Path(__file__).resolve().parents[2] / "addon" / "splinewright"


def core(name):
    """A module of the core: core("definition")."""
    if "splinewright" not in sys.modules:
        package, library = types.ModuleType("splinewright"), types.ModuleType("splinewright.core.base.library")
        package.__path__, library.sc, library.problem = [str(ADDON)], sc, ""
        sys.modules.update({package.__name__: package, library.__name__: library})
    return importlib.import_module(f"splinewright.core.{name}")
