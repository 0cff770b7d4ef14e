"""What is given away: zips for Blender, wheels and sources of the library, their sums, and what a repository lists."""

import hashlib
import json
import os
import shutil
import sys
from pathlib import Path

import sources
from targets import PYTHONS, TARGETS
from tools import HERE, PROJECT, run
from wheels import BINDINGS, version

#: Blender's own tool for extensions, in the official builds of PyPI.
EXTENSION_TOOL = "lib/python3.11/site-packages/bpy/*/scripts/addons_core/bl_pkg/cli/blender_ext.py"


def pack(release):
    """All of it in release.dist, from its wheels."""
    wheels = sorted(release.dist.glob("splinecore-*.whl"))
    extensions = [_zip(release, "", "--wheels", *wheels)]
    for target in TARGETS.values():
        own = [wheel for wheel in wheels if wheel.stem.endswith(target.wheel)]
        if own:
            extensions.append(_zip(release, f"-{target.platform}", "--wheels", *own))
    _zip(release, "-legacy", "--modules", _legacy_modules(release), "--bindings", BINDINGS, "--legacy")
    _sources(release)
    tool = _extension_tool(release)
    for extension in extensions:
        run(sys.executable, tool, "validate", extension)
    _repository(release, tool, extensions)
    shutil.copy(HERE / "NOTES.md", release.dist)
    _sums(release)


def _zip(release, suffix, *arguments):
    path = release.dist / f"splinewright-{version()}{suffix}.zip"
    run(sys.executable, PROJECT / "addon/make_zip.py", "--version", version(), "--output", path, *arguments)
    return path


def _lipo():
    """LLVM's tool, which Debian gives no name without its version."""
    return shutil.which("llvm-lipo") or sorted(Path("/usr/lib").glob("llvm-*/bin/llvm-lipo"))[-1]


def _legacy_modules(release):
    """A folder of the modules of all systems, those of both kinds of Macs in one file: they have one name."""
    folder = release.build / "legacy"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    files = {}
    for target in TARGETS.values():
        module = release.module_file(target, PYTHONS[0])
        if module.exists():
            files.setdefault(module.name, []).append(module)
    for name, modules in files.items():
        if len(modules) == 1:
            shutil.copy(modules[0], folder)
        else:
            run(_lipo(), "-create", *modules, "-output", folder / name)
    return folder


def _sources(release):
    """The source archive with its licence, from which pip builds a module that works."""
    trial = release.build / "from-sources"
    shutil.rmtree(trial, ignore_errors=True)
    archive = sources.write(release.tools.python, release.build / "sources", release.dist)
    run(release.tools.python, "-m", "pip", "install", "-q", "--disable-pip-version-check", "--target", trial, archive, "numpy",
        env=os.environ | {"CMAKE_CXX_COMPILER_LAUNCHER": "ccache"})
    run(release.tools.python, "-m", "splinecore", "--version", env=os.environ | {"PYTHONPATH": str(trial)})


def _extension_tool(release):
    """@raises SystemExit where no official build has been installed by tests/matrix."""
    found = sorted((release.cache / "official").glob("*/" + EXTENSION_TOOL))
    if not found:
        run(PROJECT / "tests/matrix/official.sh", "make", "4.5", release.cache / "official/4.5")
        found = sorted((release.cache / "official").glob("*/" + EXTENSION_TOOL))
    return found[-1]


def _repository(release, tool, extensions):
    """A folder that Blender takes for a remote repository: the zips of the systems, and index.json."""
    folder = release.dist / "repository"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    for extension in extensions[1:] or extensions:
        shutil.copy(extension, folder)
    run(sys.executable, tool, "server-generate", "--repo-dir", folder, "--html")
    listed = json.loads((folder / "index.json").read_text())["data"]
    if len(listed) != len(extensions[1:] or extensions):
        sys.exit(f"index.json lists {len(listed)} packages, not {len(extensions) - 1}")


def _sums(release):
    """SHA256SUMS, as `sha256sum --check` reads it."""
    files = [path for path in sorted(release.dist.rglob("*")) if path.is_file() and path.name != "SHA256SUMS"]
    lines = [f"{hashlib.sha256(path.read_bytes()).hexdigest()}  {path.relative_to(release.dist)}\n" for path in files]
    (release.dist / "SHA256SUMS").write_text("".join(lines))
    print(f"{release.dist}: {len(files)} files")
