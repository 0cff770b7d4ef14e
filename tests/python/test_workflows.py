"""What runs on GitHub: on proposed changes, too, and nothing that somebody else can exchange."""

import re
import subprocess
from pathlib import Path

import pytest

from from_pypi import ENVIRONMENT, programs

PROJECT = Path(__file__).resolve().parents[2]
FOLDER = PROJECT / ".github/workflows"
TEXTS = {path.name: path.read_text() for path in sorted(FOLDER.glob("*.yml"))}


def test_proposed_changes_are_tested():
    assert re.search(r"^  pull_request:", TEXTS["tests.yml"], re.M) and "./run test\n" in TEXTS["tests.yml"]


@pytest.mark.parametrize("name", TEXTS)
def test_actions_are_pinned_by_hash_with_their_version(name):
    used = re.findall(r"uses: (.+)", TEXTS[name])
    assert used
    for action in used:
        if action.startswith("./"):
            assert (PROJECT / action).is_file(), action
        else:
            assert re.fullmatch(r"[\w./-]+@[0-9a-f]{40} # v\d+\.\d+\.\d+", action), action


def test_one_action_has_one_hash():
    pins = {}
    for text in TEXTS.values():
        for action, pin in re.findall(r"uses: ([\w./-]+)@(.+)", text):
            assert pins.setdefault(action, pin) == pin, action


def test_what_is_run_is_there():
    for text in TEXTS.values():
        for word in re.findall(r"(?:\{project\}/|/usr/bin/python3 )([\w/.]+)", text):
            assert (PROJECT / word).exists(), word
        for command in re.findall(r"\./run ([\w-]+)", text):
            assert re.search(rf"^  {command}\)", (PROJECT / "run").read_text(), re.M), command


def test_zizmor_finds_no_risk(tmp_path):
    zizmor = programs(tmp_path / "venv", "zizmor==1.32.0") / "zizmor"
    done = subprocess.run([zizmor, "--offline", "--no-progress", "--min-severity", "medium", FOLDER],
                          capture_output=True, text=True, env=ENVIRONMENT)
    assert done.returncode == 0, done.stdout[-3000:] + done.stderr[-1000:]
