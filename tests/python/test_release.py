"""What makes releases, as far as it needs no compiler: names, sums, what is refused to be given away, zips with wheels."""

import importlib
import pathlib
import re
import subprocess
import sys
import sysconfig
import tomllib
import zipfile

import pytest

PROJECT = pathlib.Path(__file__).resolve().parents[2]
RELEASE = PROJECT / "native" / "release"


def room(name):
    """A module of native/release."""
    if str(RELEASE) not in sys.path:
        sys.path.insert(0, str(RELEASE))
    return importlib.import_module(name)


targets = room("targets")


def facts(**other):
    return {"libraries": ["libc.so.6"], "machine": "x86_64", "version": (2, 16), "exports": ["PyInit__splinecore"],
            "asks": "glibc 2.16"} | other


@pytest.mark.parametrize("other, words", [
    ({}, None), ({"libraries": ["libc.so.6", "libm.so.6", "ld-linux-x86-64.so.2"]}, None),
    ({"libraries": ["libstdc++.so.6"]}, "imports libstdc++"), ({"version": (2, 29)}, "newer than 2.28"),
    ({"exports": ["PyInit__splinecore", "_ZN1a"]}, "exports"), ({"machine": "aarch64"}, "is for aarch64")])
def test_a_module_for_linux_is_refused_for_what_it_asks(other, words):
    found = list(room("check_module").faults(targets.TARGETS["linux-x64"], "3.11", facts(**other)))
    assert found == [] if words is None else len(found) == 1 and words in found[0]


@pytest.mark.parametrize("library, python, is_fine", [
    ("python311.dll", "3.11", True), ("python313.dll", "3.11", False), ("KERNEL32.dll", "3.13", True),
    ("api-ms-win-crt-math-l1-1-0.dll", "3.11", True), ("libstdc++-6.dll", "3.11", False)])
def test_a_module_for_windows_imports_its_python_and_the_system(library, python, is_fine):
    found = list(room("check_module").faults(targets.TARGETS["windows-x64"], python, facts(libraries=[library])))
    assert (found == []) is is_fine


@pytest.mark.parametrize("other, words", [
    ({}, None), ({"version": (12, 0)}, "not 11.0"), ({"signature": "absent"}, "signature"),
    ({"libraries": ["/usr/lib/libc++.1.dylib"]}, "imports")])
def test_a_module_for_macs_is_refused_for_what_it_asks(other, words):
    known = facts(libraries=["/usr/lib/libSystem.B.dylib"], machine="aarch64", version=(11, 0), signature="valid",
                  exports=["_PyInit__splinecore"], asks="macOS") | other
    found = list(room("check_module").faults(targets.TARGETS["macos-arm64"], "3.11", known))
    assert found == [] if words is None else len(found) == 1 and words in found[0]


def test_the_import_library_names_what_the_headers_declare():
    text = room("import_library").definition(pathlib.Path(sysconfig.get_paths()["include"]), "python.dll")
    lines = text.split("\n")
    assert lines[0] == "LIBRARY python.dll" and len(lines) > 1000
    for name in ("PyLong_AsLongLongAndOverflow", "PyErr_SetString", "PyModule_Create2", "PyGILState_Ensure"):
        assert f"    {name}" in lines
    for name in ("PyExc_ValueError", "PyType_Type", "_Py_NoneStruct"):
        assert f"    {name} DATA" in lines


def results(path, **sections):
    path.write_text("".join(f"{name.replace('_', ' ')}\n" + "".join(f"{bits:016x}\n" for bits in numbers)
                            for name, numbers in sections.items()))
    return str(path)


ONE = 0x3FF0000000000000


@pytest.mark.parametrize("a, b, code, words", [
    ({"curve": [ONE]}, {"curve": [ONE]}, 0, "1 of 1 sections the same"),
    ({"curve": [ONE]}, {"curve": [ONE + 1]}, 1, "WRONG curve: 1 of 1 differ, by 1 ulp"),
    ({"curve": [ONE]}, {"curve": [ONE, ONE]}, 1, "WRONG curve: 1 numbers and 2"),
    ({"curve": [ONE]}, {}, 1, "WRONG curve is missing"),
    ({"libm_sin(t)": [ONE]}, {"libm_sin(t)": [ONE + 4]}, 0, "1 within what libm"),
    ({"libm_sin(t)": [ONE]}, {"libm_sin(t)": [ONE + 5]}, 1, "WRONG libm sin(t)"),
    ({"libm_sphere": [ONE, 0]}, {"libm_sphere": [ONE, 0x3C9CD2B297D889BC]}, 0, "1 within"),
    ({"libm_sphere": [ONE]}, {"libm_sphere": [ONE + 3]}, 1, "WRONG libm sphere")])
def test_results_that_differ_are_named(tmp_path, capsys, a, b, code, words):
    assert room("compare").main([results(tmp_path / "a", **a), results(tmp_path / "b", **b)]) == code
    assert words in capsys.readouterr().out


def wheel(folder, python, tag):
    path = folder / f"splinecore-0.1.0-{python}-{python}-{tag}.whl"
    path.write_bytes(b"wheel " + tag.encode())
    return path


def made(folder, *arguments):
    path = folder / "made.zip"
    done = subprocess.run([sys.executable, PROJECT / "addon/make_zip.py", "--version", "0.1.0", "--output", path,
                           *map(str, arguments)], capture_output=True, text=True)
    return done, path


def test_a_zip_of_wheels_lists_them_with_their_systems(tmp_path):
    wheels = [wheel(tmp_path, python, target.wheel) for target in targets.TARGETS.values() for python in ("cp311", "cp313")]
    done, path = made(tmp_path, "--wheels", *wheels)
    assert done.returncode == 0, done.stderr
    with zipfile.ZipFile(path) as archive:
        names, manifest = archive.namelist(), archive.read("splinewright/blender_manifest.toml").decode()
    assert 'platforms = ["linux-arm64", "linux-x64", "macos-arm64", "macos-x64", "windows-x64"]' in manifest
    for one in wheels:
        assert f"splinewright/wheels/{one.name}" in names and f'  "./wheels/{one.name}",' in manifest
    assert not [name for name in names if name.startswith("splinewright/splinecore/")]
    _, again = made(tmp_path, "--wheels", *wheels[::-1])
    assert again.read_bytes() == path.read_bytes()


def test_a_legacy_zip_has_modules_and_no_manifest(tmp_path):
    modules = tmp_path / "modules"
    modules.mkdir()
    names = {target.module("3.11") for target in targets.TARGETS.values()}
    for name in names:
        (modules / name).write_bytes(b"module")
    done, path = made(tmp_path, "--modules", modules, "--bindings", PROJECT / "native/bindings/splinecore", "--legacy")
    assert done.returncode == 0, done.stderr
    with zipfile.ZipFile(path) as archive:
        found = archive.namelist()
    assert {f"splinewright/splinecore/{name}" for name in names} <= set(found)
    assert "splinewright/blender_manifest.toml" not in found


def test_a_zip_has_what_the_platform_for_extensions_asks_for(tmp_path):
    done, path = made(tmp_path, "--wheels", wheel(tmp_path, "cp311", "manylinux_2_28_x86_64"))
    assert done.returncode == 0, done.stderr
    with zipfile.ZipFile(path) as archive:
        names = set(archive.namelist())
        manifest = tomllib.loads(archive.read("splinewright/blender_manifest.toml").decode())
        texts = {name: archive.read(f"splinewright/licenses/{name}.txt").decode() for name in ("Eigen", "GLM", "nlohmann-json", "pybind11")}
    assert "Mozilla Public License Version 2.0" in texts["Eigen"] and "splinewright/LICENSE" in names
    for name, holder in (("Eigen", "Guennebaud"), ("GLM", "G-Truc"), ("nlohmann-json", "Lohmann"), ("pybind11", "Jakob")):
        assert holder in texts[name] and any(holder in entry for entry in manifest["copyright"]), name
    assert set(manifest["permissions"]) == permissions_used()
    assert not [why for why in manifest["permissions"].values() if why.endswith(".") or len(why) > 64]
    assert not [name for name in names if re.search(r"(^|/)(tests?|\.git|__pycache__)(/|$)", name)]


def permissions_used():
    """What the sources of the add-on use that Blender's manifest has a permission for."""
    text = "".join(path.read_text() for path in (PROJECT / "addon/splinewright").rglob("*.py"))
    signs = {"clipboard": r"\.clipboard\b", "files": "ImportHelper|ExportHelper|\\.write_text",
             "network": r"\b(import|from) (urllib|requests|socket|http)\b", "camera": "opencv|cv2",
             "microphone": "sounddevice|pyaudio"}
    return {name for name, sign in signs.items() if re.search(rf"{sign}", text)}


def test_a_zip_without_a_library_is_refused(tmp_path):
    for arguments in ([], ["--modules", tmp_path], ["--wheels", wheel(tmp_path, "cp311", "win_amd64"), "--modules", tmp_path,
                                                    "--bindings", tmp_path]):
        done, path = made(tmp_path, *arguments)
        assert done.returncode == 2 and "--wheels" in done.stderr and not path.exists()


def test_metadata_is_that_of_the_project():
    text = room("wheels").metadata()
    assert re.search(r"^Version: \d+\.\d+\.\d+$", text, re.M) and "License-Expression: GPL-3.0-or-later\n" in text
    assert "License-File: LICENSE\nLicense-File: Eigen.txt\n" in text
    assert "Requires-Dist: numpy" in text and "Requires-Python: >=3.11\n" in text


def test_the_citation_has_the_version():
    version = re.search(r"project\(splinecore VERSION ([0-9.]+)", (PROJECT / "native/CMakeLists.txt").read_text())[1]
    assert f"\nversion: {version}\n" in (PROJECT / "CITATION.cff").read_text()
