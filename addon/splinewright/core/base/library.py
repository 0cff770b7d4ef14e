"""The one place that knows where the native library lies."""

import importlib
import json
import re
import sys
from importlib.machinery import EXTENSION_SUFFIXES
from importlib.metadata import distribution
from pathlib import Path

from ... import __version__

#: Where the zips for Blender before 4.2 have it; extensions bring it as a wheel, which Blender installs.
_FOLDER = Path(__file__).parents[2] / "splinecore"


def _place():
    """The folder of the library's files, with {name: size} of those that were given away, and the module's name.

    A file cut short must not be loaded: the system ends the whole process for that.
    """
    if _FOLDER.is_dir():
        return _FOLDER, json.loads((_FOLDER / "modules.json").read_text()), "...splinecore"
    files = [file for file in distribution("splinecore").files or () if file.parent.name == "splinecore"]
    if not files:
        raise ImportError("its wheel lists no files")
    return files[0].locate().parent, {file.name: file.size for file in files}, "splinecore"


def _damage(folder, sizes):
    """The problem with the compiled module's file, or ""."""
    name = next((n for n in (f"_splinecore{suffix}" for suffix in EXTENSION_SUFFIXES) if n in sizes), None)
    if name is None:
        return "was not made for it"
    path = folder / name
    if not path.exists():
        return "is missing"
    return "" if path.stat().st_size == sizes[name] else "is damaged"


def _load():
    """The library and "", or None and one sentence."""
    python = f"{sys.version_info.major}.{sys.version_info.minor}"
    cure = "Install the Splinewright zip made for this Blender again, then restart Blender"
    try:
        folder, sizes, name = _place()
        damage = _damage(folder, sizes)
        if damage:
            return None, f"Splinewright's native module for Python {python} {damage}. {cure}"
        library = importlib.import_module(name, __package__)
    except (ImportError, OSError, ValueError) as error:
        if isinstance(error, ImportError) and error.name == "numpy":
            return None, ("Splinewright needs NumPy, which this Blender's Python does not have. Install it, for example by "
                          "sudo apt install python3-numpy on Debian and Ubuntu, then restart Blender")
        newer = re.search(r"version `(GLIBC|GLIBCXX)_([\d.]+)' not found", str(error))
        if newer:
            system = {"GLIBC": "glibc", "GLIBCXX": "a libstdc++ with GLIBCXX"}[newer[1]]
            return None, (f"Splinewright's native module was built on a newer Linux than this one: it needs {system} {newer[2]} "
                          "or later. Build the zip on this system, or install that of a release, which needs glibc 2.28")
        return None, f"Splinewright's native module for Python {python} does not load ({error}). {cure}"
    if library.__version__ != __version__:
        return None, f"Splinewright {__version__} found a native module of version {library.__version__}. {cure}"
    return library, ""


#: The library, and why it cannot be used, as one sentence.
sc, problem = _load()
