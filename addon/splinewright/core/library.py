"""The one place that knows where the native library lies."""

import importlib
import json
import sys
from importlib.machinery import EXTENSION_SUFFIXES
from pathlib import Path

from .. import __version__

_FOLDER = Path(__file__).parent.parent / "splinecore"


def _damage():
    """What is wrong with the compiled module's file, or "".

    A file cut short must not be loaded: the system ends the whole process for that.
    """
    sizes = json.loads((_FOLDER / "modules.json").read_text())
    name = next((n for n in (f"_splinecore{suffix}" for suffix in EXTENSION_SUFFIXES) if n in sizes), None)
    if name is None:
        return "was not made for it"
    path = _FOLDER / name
    if not path.exists():
        return "is missing"
    return "" if path.stat().st_size == sizes[name] else "is damaged"


def _load():
    """The library and "", or None and one sentence."""
    python = f"{sys.version_info.major}.{sys.version_info.minor}"
    cure = "Install the Splinewright zip made for this Blender again, then restart Blender"
    try:
        damage = _damage()
        if damage:
            return None, f"Splinewright's native module for Python {python} {damage}. {cure}"
        library = importlib.import_module("..splinecore", __package__)
    except (ImportError, OSError, ValueError) as error:
        return None, f"Splinewright's native module for Python {python} does not load ({error}). {cure}"
    if library.__version__ != __version__:
        return None, f"Splinewright {__version__} found a native module of version {library.__version__}. {cure}"
    return library, ""


#: The library, and why it cannot be used, as one sentence.
sc, problem = _load()
