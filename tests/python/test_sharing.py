"""Two processes share test files: each is run once, and the last line and the exit code tell of all of them."""

import os
import re
import subprocess
import sys
from pathlib import Path

SHARING = Path(__file__).resolve().parents[1] / "sharing"
GOOD = "def test_a():\n    pass\n\n\ndef test_b():\n    pass\n"
SKIPPED = "import pytest\n\n\ndef test_a():\n    pytest.skip('not here')\n"
WRONG = "def test_a():\n    assert 1 == 2, 'one is not two'\n"
CRASH = "import os\n\n\ndef test_a():\n    os.abort()\n"
BROKEN = "import nowhere\n"


def shared(tmp_path, without="", **files):
    """The exit code and what was printed."""
    folder = tmp_path / "tests"
    folder.mkdir()
    for name, text in files.items():
        (folder / f"test_{name}.py").write_text(text)
    script = (f'set -euo pipefail; source "{SHARING}/share.sh"; PYTHONPATH="{SHARING}" share "{tmp_path}/logs" '
              f'"{sys.executable}" -m pytest -q -p no:cacheprovider -p sharing --rootdir "{folder}" "{folder}"')
    done = subprocess.run(["bash", "-c", script], capture_output=True, text=True, timeout=120,
                          env={**os.environ, 'SHARED_WITHOUT': without})
    return done.returncode, done.stdout


def last_line(said):
    return re.sub(r' in \d+ s$', '', said.splitlines()[-1])


def test_all_is_well(tmp_path):
    code, said = shared(tmp_path, one=GOOD, two=GOOD, three=GOOD, four=SKIPPED)
    assert code == 0 and last_line(said) == "6 passed, 0 failed, 1 skipped"
    assert sorted(re.findall(r'test_\w+\.py', said)) == ["test_four.py", "test_one.py", "test_three.py", "test_two.py"]


def test_a_failure_is_shown_and_counted(tmp_path):
    code, said = shared(tmp_path, one=GOOD, two=WRONG, three=GOOD)
    assert code == 1 and last_line(said) == "4 passed, 1 failed" and "one is not two" in said


def test_a_crash_is_named_and_the_other_process_does_the_rest(tmp_path):
    code, said = shared(tmp_path, one=CRASH, three=GOOD, two=GOOD)
    assert code == 1 and last_line(said) == "4 passed, 1 failed"
    assert "test_one.py was begun and not ended" in said


def test_a_file_that_cannot_be_read_is_a_failure(tmp_path):
    code, said = shared(tmp_path, one=GOOD, two=BROKEN)
    assert code == 1 and "nowhere" in said


def test_a_file_is_left_out(tmp_path):
    code, said = shared(tmp_path, without="test_two.py test_four.py", one=GOOD, two=WRONG, three=GOOD)
    assert code == 0 and last_line(said) == "4 passed, 0 failed" and "test_two" not in said


def test_nothing_run_is_a_failure(tmp_path):
    code, said = shared(tmp_path)
    assert code == 1 and last_line(said) == "0 passed, 0 failed"


def test_all_closing_lines_are_added_up():
    lines = ["100% tests passed, 0 tests failed out of 712", "  test_a.py   3 passed   0.1 s", "2403 passed, 3 failed, 1 skipped in 30 s",
             "99% tests passed, 2 tests failed out of 10", "5 passed, 0 failed in 3 s"]
    total = subprocess.run(["awk", "-f", str(SHARING.parents[1] / ".ci" / "total.awk")], input='\n'.join(lines),
                           capture_output=True, text=True, check=True)
    assert total.stdout.splitlines()[-1] == "3128 passed, 5 failed, 1 skipped"
