"""The library where Blender has installed it from a wheel: found, loaded, and what is damaged is not loaded but told of."""

import pathlib
import shutil
import subprocess
import sys

import pytest

import splinecore as sc

ADDON = pathlib.Path(__file__).resolve().parents[2] / "addon" / "splinewright"
PROBE = """
import sys, types
package = types.ModuleType("splinewright")
package.__path__, package.__version__ = [sys.argv[1]], sys.argv[2]
sys.modules["splinewright"] = package
from splinewright.core.base import library
print(library.problem or "loaded " + library.sc.__file__)
"""


@pytest.fixture
def site(tmp_path):
    """A folder of packages with splinecore as an installer leaves it."""
    package, info = tmp_path / "splinecore", tmp_path / f"splinecore-{sc.__version__}.dist-info"
    shutil.copytree(pathlib.Path(sc.__file__).parent, package, ignore=shutil.ignore_patterns("__pycache__"))
    info.mkdir()
    (info / "METADATA").write_text(f"Metadata-Version: 2.1\nName: splinecore\nVersion: {sc.__version__}\n")
    (info / "RECORD").write_text("".join(f"splinecore/{file.name},,{file.stat().st_size}\n" for file in package.iterdir()))
    return tmp_path


def said(site, version=sc.__version__):
    done = subprocess.run([sys.executable, "-c", PROBE, ADDON, version], capture_output=True, text=True, cwd=site,
                          env={"PYTHONPATH": f"{site}", "PATH": ""})
    assert done.returncode == 0, done.stderr
    return done.stdout.strip()


def module_of(site):
    return next((site / "splinecore").glob("_splinecore.*"))


def test_it_is_found_and_loaded(site):
    assert said(site) == f"loaded {site / 'splinecore/__init__.py'}"


@pytest.mark.parametrize("damage, words", [
    (lambda module: module.write_bytes(module.read_bytes()[:1000]), "is damaged"), (lambda module: module.write_bytes(b""), "is damaged"),
    (lambda module: module.unlink(), "is missing"), (lambda module: shutil.rmtree(module.parent), "is missing")],
    ids=["short", "empty", "missing", "all missing"])
def test_damage_is_told_of_and_nothing_is_loaded(site, damage, words):
    damage(module_of(site))
    assert words in said(site) and "Install the Splinewright zip" in said(site)


def test_a_wheel_for_another_python_or_without_a_list_is_told_of(site):
    record = next(site.glob("*.dist-info")) / "RECORD"
    record.write_text(record.read_text().replace("_splinecore.cpython-3", "_splinecore.cpython-2"))
    assert "was not made for it" in said(site)
    record.write_text("")
    assert "does not load (its wheel lists no files)" in said(site)
    shutil.rmtree(record.parent)
    assert "does not load" in said(site)


def test_another_version_is_told_of(site):
    assert f"found a native module of version {sc.__version__}" in said(site, version="9.9.9")


@pytest.mark.parametrize("symbol, words", [
    ("GLIBC_2.35", "it needs glibc 2.35 or later"), ("GLIBCXX_3.4.30", "it needs a libstdc++ with GLIBCXX 3.4.30 or later")])
def test_a_module_of_a_newer_linux_says_what_it_needs(site, symbol, words):
    (site / "splinecore/__init__.py").write_text(
        f"raise ImportError(\"/lib/libc.so.6: version `{symbol}' not found (required by _splinecore.so)\")")
    assert words in said(site) and "does not load" not in said(site)


def test_a_blender_without_numpy_says_what_to_install(site):
    (site / "numpy.py").write_text("raise ModuleNotFoundError(\"No module named 'numpy'\", name='numpy')")
    assert "needs NumPy" in said(site) and "python3-numpy" in said(site) and "does not load" not in said(site)
