"""Pack the add-on: sources, the module's Python files and every compiled module, with one version."""

import argparse
import json
import re
import zipfile
from pathlib import Path

ADDON = Path(__file__).parent / "splinewright"
LICENSE = Path(__file__).parent.parent / "LICENSE"
# The same input gives the same file, byte for byte.
FIXED_DATE = (2026, 1, 1, 0, 0, 0)


def with_version(name, text, version):
    if name == "__init__.py":
        numbers = ", ".join(version.split("."))
        text = re.sub(r'"version": \(0, 0, 0\)', f'"version": ({numbers})', text)
        return re.sub(r'__version__ = "0\.0\.0"', f'__version__ = "{version}"', text)
    return re.sub(r'^version = "0\.0\.0"', f'version = "{version}"', text, flags=re.M)


def content(version, modules, bindings):
    """Pairs of a path inside the zip and its bytes."""
    for path in sorted(ADDON.rglob("*")):
        if path.is_dir() or "__pycache__" in path.parts:
            continue
        data = path.read_bytes()
        if path.parent == ADDON and path.name in ("__init__.py", "blender_manifest.toml"):
            data = with_version(path.name, data.decode(), version).encode()
        yield Path("splinewright") / path.relative_to(ADDON), data
    compiled = sorted(modules.glob("_splinecore.*.so"))
    for path in [*sorted(bindings.glob("*.py")), *compiled]:
        yield Path("splinewright/splinecore") / path.name, path.read_bytes()
    sizes = {path.name: path.stat().st_size for path in compiled}
    yield Path("splinewright/splinecore/modules.json"), json.dumps(sizes, indent=1).encode()
    yield Path("splinewright/LICENSE"), LICENSE.read_bytes()


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--version", required=True)
    parser.add_argument("--modules", type=Path, required=True, help="folder of compiled modules")
    parser.add_argument("--bindings", type=Path, required=True, help="the module's Python files")
    parser.add_argument("--output", type=Path, required=True)
    args = parser.parse_args()
    with zipfile.ZipFile(args.output, "w", zipfile.ZIP_DEFLATED) as archive:
        for path, data in content(args.version, args.modules, args.bindings):
            info = zipfile.ZipInfo(path.as_posix(), FIXED_DATE)
            info.compress_type = zipfile.ZIP_DEFLATED
            info.external_attr = 0o644 << 16
            archive.writestr(info, data)


if __name__ == "__main__":
    main()
