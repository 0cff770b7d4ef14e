"""What CONTRIBUTING.md says to run and names must be there."""

import re
import subprocess
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[2]
TEXT = (PROJECT / "CONTRIBUTING.md").read_text()
BLOCKS = re.findall(r"(?:^    .+\n)+", TEXT, re.M)
COMMANDS = [line.partition("#")[0].split() for block in BLOCKS for line in block.splitlines()]


def test_every_command_is_one_of_run_or_a_script():
    script = (PROJECT / "run").read_text()
    assert len(COMMANDS) >= 10
    for command in [*COMMANDS, *(found.split() for found in re.findall(r"`(\./run [^`]+)`", TEXT))]:
        if command[0] == "./run" and command[1] != "help":
            assert re.search(rf"^  {command[1]}\)", script, re.M), command
        elif command[0] != "./run":
            scripts = [word for word in command if re.search(r"\.(sh|py)$", word)]
            assert scripts and all((PROJECT / word).is_file() for word in scripts), command


def test_every_argument_that_is_a_path_is_there():
    for command in COMMANDS:
        for word in command[1:]:
            if word.startswith(("tests/", "addon/")):
                assert (PROJECT / word).exists(), word


def test_every_path_is_there():
    paths = [path for path in re.findall(r"`([\w.]+/[\w./]*)`", TEXT) if not path.startswith("build/")]
    assert len(paths) >= 20
    for path in [*paths, *re.findall(r"\*\*([\w/]+/)\*\*", TEXT)]:
        assert (PROJECT / path).exists(), path


def test_every_name_is_there():
    addon = "".join(path.read_text() for path in (PROJECT / "addon").rglob("*.py"))
    for name in ("Refusal", "Result", "Recipe", "CLASSES", "verb"):
        assert f"`{name}" in TEXT and re.search(rf"\b(class|def) {name}\b|^{name} = ", addon, re.M), name
    assert re.search(r"project\(splinecore VERSION [0-9.]+", (PROJECT / "native/CMakeLists.txt").read_text())


def test_the_manual_can_be_made_as_it_says(tmp_path):
    (command,) = (command for command in COMMANDS if "addon/make_manual.py" in command)
    done = subprocess.run([*command[:-1], tmp_path / "manual"], cwd=PROJECT, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert done.stdout.strip() == (tmp_path / "manual/index.html").resolve().as_uri()


def test_the_readme_leads_to_it():
    assert "(CONTRIBUTING.md)" in (PROJECT / "README.md").read_text()
