"""The matrix of Blenders: which official builds it would take, also where PyPI cannot be reached; paths; the list."""

import os
import re
import subprocess
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[2]
MATRIX = PROJECT / "tests" / "matrix"
#: Nobody listens there.
UNREACHABLE = "http://127.0.0.1:9/simple"


def run(script, *words, index=UNREACHABLE):
    """The exit code and the lines printed."""
    environment = {name: value for name, value in os.environ.items() if not name.startswith('PIP_')}
    environment |= {'PIP_INDEX_URL': index, 'PIP_CONFIG_FILE': os.devnull}
    done = subprocess.run([str(script), *map(str, words)], capture_output=True, text=True, env=environment, timeout=120)
    return done.returncode, done.stdout.splitlines()


def index_of(tmp_path, *files):
    """A package index of these files, in a folder."""
    page = tmp_path / "index" / "bpy"
    page.mkdir(parents=True)
    (page / "index.html").write_text(''.join(f'<a href="{file}">{file}</a>\n' for file in files))
    for file in files:
        (page / file).touch()
    return page.parent.as_uri()


def wheel(version, python):
    return f"bpy-{version}-cp{python}-cp{python}-manylinux_2_28_x86_64.whl"


def kept(folder, text):
    folder.mkdir(parents=True)
    (folder / ".complete").write_text(text + "\n")


def test_without_pypi_every_official_build_is_left_out_and_nothing_fails(tmp_path):
    build = PROJECT / "build" / "nothing"
    code, lines = run(MATRIX / "run.sh", build, tmp_path / "cache", "plan")
    assert code == 0
    assert lines[:5] == [f"Blender {version} is left out: PyPI cannot be reached" for version in ('4.2', '4.5', '5.0', '5.1', '5.2')]


def test_without_pypi_what_is_there_is_used(tmp_path):
    kept(tmp_path / "official" / "4.5", "Blender 4.5.15 with NumPy 1.26.4")
    kept(tmp_path / "trixie" / "opt" / "official" / "5.2", "Blender 5.2.3 with NumPy 2.5.5")
    code, lines = run(MATRIX / "run.sh", PROJECT / "build" / "nothing", tmp_path, "plan")
    assert code == 0
    assert lines[1:3] == ["Blender 4.5.15 with NumPy 1.26.4", "  (PyPI cannot be reached: as it was kept)"]
    assert lines[5:7] == ["Blender 5.2.3 with NumPy 2.5.5", "  (PyPI cannot be reached: as it was kept)"]


def test_the_newest_patch_counts_by_number_and_for_the_right_python(tmp_path):
    index = index_of(tmp_path, wheel("4.2.9", 311), wheel("4.2.23", 311), wheel("4.20.1", 311), wheel("5.1.2", 313))
    assert run(MATRIX / "official.sh", "newest", "4.2", index=index) == (0, ["4.2.23"])
    assert run(MATRIX / "official.sh", "newest", "5.1", index=index) == (0, ["5.1.2"])
    code, lines = run(MATRIX / "official.sh", "make", "4.5", tmp_path / "none", index=index)
    assert (code, lines) == (4, ["Blender 4.5 is left out: PyPI has no Blender 4.5 for Python 3.11"])
    kept(tmp_path / "old", "Blender 4.2.9 with NumPy 1.26.4")
    assert run(MATRIX / "official.sh", "which", "4.2", tmp_path / "old", index=index) == (0, ["Blender 4.2.23, to be installed"])
    kept(tmp_path / "new", "Blender 4.2.23 with NumPy 1.26.4")
    assert run(MATRIX / "official.sh", "make", "4.2", tmp_path / "new", index=index) == (0, ["Blender 4.2.23 with NumPy 1.26.4"])


def test_a_checkout_is_reached_through_a_link(tmp_path):
    link = tmp_path / "link"
    link.symlink_to(PROJECT)
    for project in (PROJECT, link):
        code, lines = run(project / "tests" / "matrix" / "run.sh", project / "build", tmp_path / "cache", "plan")
        assert code == 0 and lines[-1] == f"The build {PROJECT / 'build'} is /project/build in the roots"


def test_a_build_outside_the_checkout_is_refused(tmp_path):
    code, _ = run(MATRIX / "run.sh", tmp_path, tmp_path / "cache", "plan")
    assert code == 2


def test_what_no_version_changes_is_a_test_file_with_a_reason():
    lines = [line for line in (MATRIX / "any_version.txt").read_text().splitlines() if line and not line.startswith('#')]
    names = [line.split()[0] for line in lines]
    assert len(set(names)) == len(names) and all(len(line.split()) > 2 for line in lines)
    for name in names:
        assert re.fullmatch(r'test_\w+\.py', name) and (PROJECT / "tests" / "blender" / name).is_file(), name


def test_blenders_that_share_the_tests_run_each_file_once():
    functions = "/^of_any_version()/p; /^left_by() {/,/^}/p"
    others = ["trixie", "4.2", "4.5", "5.2"]
    script = (f'here={MATRIX} project={PROJECT} how= others=({" ".join(others)}); eval "$(sed -n "{functions}" {MATRIX}/run.sh)"; '
              'for name in "${others[@]}"; do left_by "$name"; echo; done; left_by bookworm; echo; of_any_version')
    *left, first, any_version = [set(line.split()) for line in subprocess.run(
        ["bash", "-c", script], capture_output=True, text=True, check=True).stdout.splitlines()]
    files = {path.name for path in (PROJECT / "tests" / "blender").glob("test_*.py")}
    runs = [name for without in left for name in files - without]
    assert not first and len(left) == len(others) and sorted(runs) == sorted(files - any_version)
