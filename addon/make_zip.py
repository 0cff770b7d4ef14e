"""Pack the add-on: sources, the manual, icons and the library, with one version.

The library comes as compiled modules with its Python files, which every Blender takes, or as wheels, which Blender 4.2 and
later installs: those of all systems in one zip, or of one.
"""

import argparse
import ast
import json
import re
import zipfile
from pathlib import Path

import make_icons
import make_manual

ADDON = Path(__file__).parent / "splinewright"
LICENSE = Path(__file__).parent.parent / "LICENSE"
# Of what is compiled into the library.
LICENSES = Path(__file__).parent.parent / "native/licenses"
# The same input gives the same file, byte for byte.
FIXED_DATE = (2026, 1, 1, 0, 0, 0)


def addresses(text):
    """{name: address} of what a file assigns, without those that are empty."""
    assigned = [node for node in ast.parse(text).body if isinstance(node, ast.Assign)]
    return {node.targets[0].id: value for node in assigned if (value := ast.literal_eval(node.value))}


def completed(name, text, version, known, wheels=()):
    """The text of __init__.py or of the manifest, with the version, the known addresses on the web and the wheels."""
    if name == "__init__.py":
        numbers = ", ".join(version.split("."))
        entries = {"doc_url": known.get("WEBSITE"), "tracker_url": known.get("ISSUES")}
        lines = "".join(f'    "{entry}": {address!r},\n' for entry, address in entries.items() if address)
        text = re.sub(r'    "version": \(0, 0, 0\),\n', lambda _: f'    "version": ({numbers}),\n{lines}', text)
        return re.sub(r'__version__ = "0\.0\.0"', f'__version__ = "{version}"', text)
    website = f'website = "{known["WEBSITE"]}"\n' if "WEBSITE" in known else ""
    text = re.sub(r'^version = "0\.0\.0"\n', lambda _: f'version = "{version}"\n{website}', text, flags=re.M)
    if not wheels:
        return text
    platforms = json.dumps(sorted({platform_of(wheel) for wheel in wheels}))
    listed = "".join(f'  "./wheels/{wheel.name}",\n' for wheel in wheels)
    return re.sub(r'^platforms = .*\n', f"platforms = {platforms}\nwheels = [\n{listed}]\n", text, flags=re.M)


def platform_of(wheel):
    """The system of a wheel, as Blender names it."""
    tag = wheel.stem.rpartition("-")[2]
    system = next(name for start, name in (("manylinux", "linux"), ("win", "windows"), ("macosx", "macos")) if tag.startswith(start))
    return f"{system}-{'arm64' if tag.endswith(('arm64', 'aarch64')) else 'x64'}"


def content(version, modules, bindings, wheels):
    """Pairs of a path inside the zip and its bytes."""
    known = addresses((ADDON / "ui/addresses.py").read_text())
    for path in sorted(ADDON.rglob("*")):
        if path.is_dir() or "__pycache__" in path.parts or path.suffix == ".pot":
            continue
        data = path.read_bytes()
        if path.parent == ADDON and path.name in ("__init__.py", "blender_manifest.toml"):
            data = completed(path.name, data.decode(), version, known, wheels).encode()
        yield Path("splinewright") / path.relative_to(ADDON), data
    for wheel in wheels:
        yield Path("splinewright/wheels") / wheel.name, wheel.read_bytes()
    if modules:
        yield from library(modules, bindings)
    yield Path("splinewright/LICENSE"), LICENSE.read_bytes()
    for path in sorted(LICENSES.iterdir()):
        yield Path("splinewright/licenses") / path.name, path.read_bytes()
    for name, data in make_icons.content():
        yield Path("splinewright/icons") / name, data
    for path, data in make_manual.content():
        yield Path("splinewright/manual") / path, data


def library(modules, bindings):
    """The same of the library that lies inside the add-on."""
    compiled = sorted((*modules.glob("_splinecore.*.so"), *modules.glob("_splinecore.*.pyd")))
    for path in [*sorted(bindings.glob("*.py")), *compiled]:
        yield Path("splinewright/splinecore") / path.name, path.read_bytes()
    sizes = {path.name: path.stat().st_size for path in compiled}
    yield Path("splinewright/splinecore/modules.json"), json.dumps(sizes, indent=1).encode()


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--version", required=True)
    parser.add_argument("--modules", type=Path, help="folder of compiled modules")
    parser.add_argument("--bindings", type=Path, help="the module's Python files")
    parser.add_argument("--wheels", type=Path, nargs="*", default=[], help="wheels, in place of modules")
    parser.add_argument("--legacy", action="store_true", help="no manifest: for Blender before 4.2 alone")
    parser.add_argument("--output", type=Path, required=True)
    args = parser.parse_args()
    if bool(args.modules) != bool(args.bindings) or bool(args.modules) == bool(args.wheels):
        parser.error("either --modules with --bindings, or --wheels")
    with zipfile.ZipFile(args.output, "w", zipfile.ZIP_DEFLATED) as archive:
        for path, data in content(args.version, args.modules, args.bindings, sorted(args.wheels)):
            if args.legacy and path.name == "blender_manifest.toml":
                continue
            info = zipfile.ZipInfo(path.as_posix(), FIXED_DATE)
            info.compress_type = zipfile.ZIP_DEFLATED
            info.external_attr = 0o644 << 16
            archive.writestr(info, data)


if __name__ == "__main__":
    main()
