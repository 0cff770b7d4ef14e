"""What the README shows must run, and what it and the manual's page on scripting name must be there."""

import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

PROJECT = Path(__file__).resolve().parents[2]
README = (PROJECT / "README.md").read_text()
SCRIPTING = (PROJECT / "addon/manual/python.md").read_text()


def test_the_ten_lines_of_the_module_run():
    blocks = [block for block in re.findall(r"```python\n(.*?)```", README, re.S) if "splinecore as sc" in block]
    assert len(blocks) == 1
    run = subprocess.run([sys.executable, "-c", blocks[0]], capture_output=True, text=True)
    assert run.returncode == 0, run.stderr


def test_it_is_short_and_has_one_picture_and_those_of_the_five_minutes():
    assert len(README.splitlines()) <= 200
    assert README.count("![") == 6


def test_every_picture_and_file_it_links_is_there():
    links = [link for link in re.findall(r"\]\(([^)]+)\)", README) if "://" not in link]
    assert len(links) >= 5
    for link in links:
        assert (PROJECT / link).exists(), link


def test_every_command_it_names_is_one_of_run():
    commands = set(re.findall(r"\./run ([a-z-]+)", README))
    script = (PROJECT / "run").read_text()
    assert {"demo", "test", "zip", "matrix"} <= commands
    for command in commands - {"help"}:
        assert re.search(rf"^  {command}\)", script, re.M), command


def test_the_map_of_rooms_names_every_folder():
    for folder in (PROJECT / "native/src", PROJECT / "addon/splinewright"):
        for room in folder.iterdir():
            if room.is_dir() and not room.name.startswith("_"):
                assert re.search(rf"\b{room.name}\b", README), room.name


def test_every_operator_for_scripts_is_there():
    text = re.search(r"Operators for\s+scripts: (.*?)\n\n", SCRIPTING, re.S).group(1)
    names = re.findall(r"`(?:bpy\.ops\.splinewright\.)?(\w+)`", text)
    source = "".join(path.read_text() for path in (PROJECT / "addon/splinewright/ui/operators").glob("*.py"))
    assert len(names) >= 60
    for name in names:
        row = rf"^    (along|plain)\((\w+, )?'{name}', \""            # of the tables of operators without settings
        assert f'bl_idname = "splinewright.{name}"' in source or re.search(row, source, re.M), name


def test_a_demo_has_a_few_scenes_that_the_readme_counts():
    script = (PROJECT / "run").read_text()
    scenes = re.search(r"^demo_scenes=\((.*)\)$", script, re.M)[1].split()
    assert len(scenes) == 4 and "makes four sample scenes" in README
    for scene in scenes:
        assert (PROJECT / f"blend_samples/make_{scene}.py").is_file(), scene


def test_a_zip_alone_compiles_no_tests():
    script = (PROJECT / "run").read_text()
    alone = re.search(r"^build_zip_alone\(\) \{\n(.*?)^\}", script, re.M | re.S)[1]
    assert "-DSPLINEWRIGHT_TESTS=OFF" in alone and "SPLINECORE_PRECOMPILED=ON" in alone
    assert re.search(r"^do_demo\(\) \{\n  build_zip_alone \"\$\{blender_packages", script, re.M) and "  zip) build_zip_alone" in script


def test_the_packages_of_the_demo_hold_what_the_addon_imports():
    script = (PROJECT / "run").read_text()
    named = " ".join(re.search(rf"^{name}=\((.*?)\)$", script, re.M | re.S)[1] for name in ("zip_packages", "blender_packages"))
    if shutil.which("apt-cache") is None:
        pytest.skip("apt-cache is not here: which packages depend on which is not known")
    closure = subprocess.run(["apt-cache", "depends", "--recurse", "--no-recommends", "--no-suggests", "--no-conflicts", "--no-breaks",
                              "--no-replaces", "--no-enhances", *named.split()], capture_output=True, text=True, check=True).stdout
    assert {"python3-numpy", "blender", "g++"} <= set(re.findall(r"^\S+", closure, re.M))
