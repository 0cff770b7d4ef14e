"""The library and its module, installed: a wheel, a CMake package, two copies in one process."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
import textwrap

import numpy as np
import pytest

import splinecore as sc

NATIVE = pathlib.Path(__file__).resolve().parents[2] / "native"
EXAMPLES = NATIVE.parent / "examples"
#: Of what is compiled into the module.
TEXTS = ("Eigen.txt", "GLM.txt", "nlohmann-json.txt", "pybind11.txt")
PACKAGE = pathlib.Path(sc.__file__).resolve().parent


def run(*command, **more):
    environment = {key: value for key, value in os.environ.items() if key != "PYTHONPATH"} | more.pop("env", {})
    done = subprocess.run([*map(str, command)], capture_output=True, text=True, env=environment, timeout=1500, **more)
    return done.returncode, done.stdout + done.stderr


def must(*command, **more):
    code, output = run(*command, **more)
    assert code == 0, output
    return output


def version_of_cmake():
    return re.search(r"project\(splinecore VERSION ([0-9.]+)", (NATIVE / "CMakeLists.txt").read_text())[1]


def test_the_version_is_the_one_of_cmake():
    assert sc.__version__ == version_of_cmake()


def test_the_module_exports_nothing_but_its_entry():
    if not shutil.which("nm"):
        pytest.skip("nm is not installed")
    (library,) = PACKAGE.glob("_splinecore*.so")
    symbols = must("nm", "-D", "--defined-only", "--extern-only", library).split("\n")
    assert [line.split()[-1] for line in symbols if line] == ["PyInit__splinecore"]


WHEEL_USE = """
import importlib.metadata, pathlib, pickle, sys
import splinecore as sc
arc = sc.BezierCurve([(1, 0), (1, 1), (0, 1)], [1, 0.5**0.5, 1])
assert abs((arc.evaluate(0.3) ** 2).sum() - 1) < 1e-15
assert pickle.loads(pickle.dumps(arc)) == sc.loads(arc.dumps()) == arc
folder = pathlib.Path(sc.__file__).parent
assert str(folder).startswith(sys.prefix), folder
assert {"__init__.pyi", "basis.pyi", "build.pyi", "py.typed"} <= {path.name for path in folder.iterdir()}
meta = importlib.metadata.metadata("splinecore")
assert sc.__version__ == meta["Version"], meta["Version"]
assert "GPL-3.0-or-later" in (meta["License-Expression"], meta["License"])
texts = {path.name for path in importlib.metadata.files("splinecore") if "licenses" in path.parts}
assert texts >= {"LICENSE", "Eigen.txt", "GLM.txt", "nlohmann-json.txt", "pybind11.txt"}, texts
print(sc.__version__)
"""


def as_the_build():
    """Settings with which what the build has compiled is taken from ccache, where there is one: with its pybind11, too.
    With the one of PyPI, in an isolated build, `./run release` installs the source distribution."""
    if not shutil.which("ccache"):
        return {}
    return {"CMAKE_CXX_COMPILER_LAUNCHER": "ccache", "CMAKE_ARGS": "-DSPLINECORE_STRICT=ON -DSPLINECORE_PRECOMPILED=OFF -DSPLINECORE_UNITY=OFF", "CXX": "/usr/bin/c++",
            "PATH": f"/usr/bin:{os.environ['PATH']}", "CCACHE_DEPEND": "1"}


def test_pip_install_gives_a_package_that_works_in_a_plain_python(tmp_path):
    code, output = run(sys.executable, "-m", "venv", tmp_path / "venv")
    if code:
        pytest.skip(f"venv does not work here: {output[-200:]}")
    python = tmp_path / "venv/bin/python"
    code, output = run(python, "-m", "pip", "--retries", "1", "--timeout", "15", "install", "-q", "scikit-build-core", "numpy")
    if code:
        pytest.skip(f"PyPI cannot be reached, so there is no scikit-build-core: {output[-200:]}")
    # Beside the build: ccache keeps paths as seen from where it compiles.
    with tempfile.TemporaryDirectory(prefix="build-", dir=NATIVE.parent) as objects:
        must(python, "-m", "pip", "install", "-q", "--no-build-isolation", f"--config-settings=build-dir={objects}", NATIVE,
             env=as_the_build())
    assert must(python, "-c", WHEEL_USE, cwd=tmp_path).strip() == version_of_cmake()


@pytest.mark.skipif("SPLINECORE_TESTS_FEWER" in os.environ, reason="it compiles the library once more, with precompiled headers")
def test_pip_makes_a_wheel_of_the_source_archive_that_works_in_a_plain_python(tmp_path):
    """What `./run wheel` does. What it compiles is kept beside the build that the module came from, if it did."""
    kept = PACKAGE.parents[1]
    build = kept / "wheel" if (kept / "native/cmake_install.cmake").exists() else tmp_path / "wheel"
    environment = {"CMAKE_ARGS": "-DSPLINECORE_STRICT=ON", "CCACHE_DEPEND": "1", "CCACHE_SLOPPINESS": "pch_defines,time_macros"}
    code, output = run(sys.executable, NATIVE / "release/here.py", build, tmp_path / "dist", env=environment)
    if code == 3:
        pytest.skip(output)
    assert code == 0, output[-4000:]
    assert "works in an empty environment" in output and "GLIBC" in output
    assert re.search(r"SPLINECORE_PRECOMPILED:\w+=ON", (build / "objects/CMakeCache.txt").read_text())
    assert must(build / "empty/bin/python", "-c", WHEEL_USE, cwd=tmp_path).strip() == version_of_cmake()
    with tarfile.open(*(tmp_path / "dist").glob("splinecore-*.tar.gz")) as archive:
        names = archive.getnames()
    assert {"LICENSE", *(f"licenses/{text}" for text in TEXTS)} <= {name.partition("/")[2] for name in names}
    assert not [name for name in names if "/release/" in name or "/build/" in name]


@pytest.mark.parametrize("missing, words", [
    (["Eigen3"], ["libeigen3-dev (Debian), eigen (Homebrew), eigen3 (vcpkg)"]),
    (["glm", "nlohmann_json"], ["libglm-dev (Debian), glm (Homebrew), glm (vcpkg)",
                                "3.11 or later: nlohmann-json3-dev (Debian), nlohmann-json (Homebrew), nlohmann-json (vcpkg)"]),
    (["pybind11"], ["2.10 or later: pybind11-dev (Debian), pybind11 (Homebrew), pybind11 (vcpkg)"]),
    (["Python"], ["3.11 or later: python3-dev (Debian), python (Homebrew), python3 (vcpkg)"])], ids="-".join)
def test_what_is_missing_for_a_build_is_said_at_once_by_the_names_of_packages(missing, words, tmp_path):
    if not shutil.which("cmake"):
        pytest.skip("cmake is not installed")
    code, said = run("cmake", "-S", NATIVE, "-B", tmp_path, *(f"-DCMAKE_DISABLE_FIND_PACKAGE_{name}=ON" for name in missing))
    assert code != 0 and "is not installed here" in said
    for line in words:
        assert line in said, said
    assert said.count("(Debian)") == len(missing)


def installed(prefix, scratch):
    """The library, from the build that the module came from or else from one of its own."""
    build = PACKAGE.parents[1]
    if (build / "native/cmake_install.cmake").exists():
        must("cmake", "--build", build, "--target", "splinecore")
        build = build / "native"
    else:
        build = scratch
        must("cmake", "-S", NATIVE, "-B", build, "-DSPLINECORE_PYTHON=OFF", "-DCMAKE_BUILD_TYPE=Debug")
        must("cmake", "--build", build, "--parallel", os.cpu_count() or 1)
    must("cmake", "--install", build, "--prefix", prefix)


needs_cmake = pytest.mark.skipif(not shutil.which("cmake"), reason="cmake is not installed")


@pytest.fixture(scope="module")
def prefix(tmp_path_factory):
    """Where the library is installed."""
    there = tmp_path_factory.mktemp("prefix")
    installed(there, tmp_path_factory.mktemp("library"))
    return there


def require_bottle(program, path):
    """What examples/cpp makes is closed but for its two ends."""
    said = must(program, path)
    data = path.read_bytes()
    triangles = np.frombuffer(data, np.dtype([("normal", "<f4", 3), ("points", "<f4", (3, 3)), ("rest", "<u2")]), offset=84)["points"]
    assert "area" in said and len(triangles) == int.from_bytes(data[80:84], "little") > 500
    _, corners = np.unique(triangles.reshape(-1, 3), axis=0, return_inverse=True)
    edges = np.sort(corners.reshape(-1, 3)[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    _, counts = np.unique(edges, axis=0, return_counts=True)
    open_points = triangles.reshape(-1, 3)[:, 2]
    assert set(counts) == {1, 2} and open_points.min() == 0.0 and open_points.max() == 12.5


@needs_cmake
def test_the_cpp_example_is_built_with_the_installed_library(prefix, tmp_path):
    must("cmake", "-S", EXAMPLES / "cpp", "-B", tmp_path / "build", f"-DCMAKE_PREFIX_PATH={prefix}")
    must("cmake", "--build", tmp_path / "build")
    require_bottle(tmp_path / "build/bottle", tmp_path / "bottle.stl")


@needs_cmake
def test_pkg_config_tells_a_compiler_what_it_needs(prefix, tmp_path):
    if not shutil.which("pkg-config"):
        pytest.skip("pkg-config is not installed")
    (described,) = prefix.glob("**/splinecore.pc")
    flags = must("pkg-config", "--cflags", "--libs", "splinecore", env={"PKG_CONFIG_PATH": str(described.parent)}).split()
    assert must("pkg-config", "--modversion", "splinecore", env={"PKG_CONFIG_PATH": str(described.parent)}).strip() == version_of_cmake()
    must("c++", "-std=c++20", EXAMPLES / "cpp/bottle.cpp", "-o", tmp_path / "bottle", *flags,
         f"-Wl,-rpath,{described.parents[1]}")
    require_bottle(tmp_path / "bottle", tmp_path / "bottle.stl")


AROUND = """
cmake_minimum_required(VERSION 3.22)
project(around LANGUAGES CXX)
include(FetchContent)
FetchContent_Declare(splinecore SOURCE_DIR {native})
FetchContent_MakeAvailable(splinecore)
add_executable(bottle {example})
target_link_libraries(bottle PRIVATE splinecore::splinecore)
get_target_property(kind splinecore TYPE)
message(STATUS "splinecore is a ${{kind}}")
"""


@needs_cmake
@pytest.mark.parametrize("more, kind", [([], "SHARED_LIBRARY"), (["-DBUILD_SHARED_LIBS=OFF"], "STATIC_LIBRARY")])
def test_as_a_part_of_another_project_it_is_the_library_alone(more, kind, tmp_path):
    (tmp_path / "CMakeLists.txt").write_text(AROUND.format(native=NATIVE, example=EXAMPLES / "cpp/bottle.cpp"))
    said = must("cmake", "-S", tmp_path, "-B", tmp_path / "build", *more)
    cache = (tmp_path / "build/CMakeCache.txt").read_text()
    assert f"splinecore is a {kind}" in said and "pybind11_DIR" not in cache and "Python_EXECUTABLE" not in cache
    must("cmake", "--install", tmp_path / "build", "--prefix", tmp_path / "prefix")
    assert not list((tmp_path / "prefix").glob("**/*.hpp")), "nothing of it is installed with the project"


@needs_cmake
def test_the_library_is_configured_without_python(tmp_path):
    must("cmake", "-S", NATIVE, "-B", tmp_path, "-DSPLINECORE_PYTHON=OFF")
    cache = (tmp_path / "CMakeCache.txt").read_text()
    assert "pybind11_DIR" not in cache and "Python_EXECUTABLE" not in cache


TWO_COPIES = """
import pickle, threading
import numpy as np
import splinecore as one
from someaddon import splinecore as other

assert one._splinecore.__file__ != other._splinecore.__file__
assert other.NurbsCurve.__module__ == "someaddon.splinecore"
assert other.basis.KnotVector.__module__ == "someaddon.splinecore.basis"
for name in one.__all__:
    assert getattr(one, name) is not getattr(other, name), name

points = np.random.default_rng(0).random((4, 4, 3))
pair = [copy.BezierPatch(points) for copy in (one, other)]
u = np.linspace(0, 1, 200)
assert np.array_equal(*(patch.evaluate_grid(u, u) for patch in pair))
assert pair[0] != pair[1] and pair[0].dumps() == pair[1].dumps()

for copy, stranger, value, foreign in [(one, other, *pair), (other, one, *pair[::-1])]:
    assert isinstance(value, copy.BezierPatch) and not isinstance(value, stranger.BezierPatch)
    again = pickle.loads(pickle.dumps(value))
    assert again == value and type(again) is copy.BezierPatch
    assert copy.loads(foreign.dumps()) == value
    for call in (lambda: copy.dumps(foreign), lambda: copy.PatchSet.from_patches([foreign]),
                 lambda: copy.BezierPatch.evaluate(foreign, 0, 0),
                 lambda: copy.basis.Samples(foreign.to_nurbs().knot_vectors[0], [0])):
        try:
            call()
        except TypeError:
            pass
        else:
            raise AssertionError("a value of the other copy was taken")
    cases = [("InvalidShape", lambda: value.evaluate(7, 7)),
             ("PointAtInfinity", lambda: copy.BezierCurve([(0, 0), (1, 1)], [1, -1]).evaluate(0.5)),
             ("Cancelled", lambda: value.evaluate(u, u, cancel=lambda: True))]
    for name, call in cases:
        try:
            call()
        except getattr(stranger, name):
            raise AssertionError(name + " is the other copy's")
        except getattr(copy, name):
            pass

wrong = []
def work(patch):
    expected = patch.evaluate_grid(u, u)
    wrong.extend(i for i in range(20) if not np.array_equal(patch.evaluate_grid(u, u), expected))
threads = [threading.Thread(target=work, args=(patch,)) for patch in pair * 2]
[thread.start() for thread in threads], [thread.join() for thread in threads]
assert not wrong
print("both live")
"""


def test_two_copies_live_in_one_process(tmp_path):
    addon = tmp_path / "someaddon"
    shutil.copytree(PACKAGE, addon / "splinecore")
    (addon / "__init__.py").write_text("")
    script = tmp_path / "two_copies.py"
    script.write_text(textwrap.dedent(TWO_COPIES))
    path = os.pathsep.join([str(PACKAGE.parent), str(tmp_path)])
    assert must(sys.executable, script, env={"PYTHONPATH": path}).strip() == "both live"
    swapped = script.read_text().replace("import splinecore as one\nfrom someaddon import splinecore as other",
                                         "from someaddon import splinecore as other\nimport splinecore as one")
    script.write_text(swapped)
    assert must(sys.executable, script, env={"PYTHONPATH": path}).strip() == "both live"
