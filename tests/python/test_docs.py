"""Every sample of code in the site's pages runs, and what they link is there."""

import os
import pathlib
import re
import subprocess
import sys

import pytest

PROJECT = pathlib.Path(__file__).resolve().parents[2]
PAGES = [*sorted((PROJECT / "docs").glob("*.md")), *sorted((PROJECT / "addon/manual").glob("*.md")), PROJECT / "README.md"]


def samples():
    """(page, number, code) of those that need no Blender."""
    for page in PAGES:
        for number, code in enumerate(re.findall(r"^```python\n(.*?)^```", page.read_text(), re.S | re.M), 1):
            if not re.search(r"\bC\.object|\bbpy\b|\bapi\b", code):
                yield pytest.param(code, id=f"{page.stem}-{number}")


@pytest.mark.parametrize("code", samples())
def test_samples_run(code, tmp_path):
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(path for path in sys.path if path)}
    done = subprocess.run([sys.executable, "-W", "error", "-c", code], capture_output=True, text=True, cwd=tmp_path, env=environment)
    assert done.returncode == 0, done.stderr


def test_every_page_has_samples_where_it_should():
    found = {param.id.rsplit("-", 1)[0] for param in samples()}
    assert {"command", "formats", "mathematics", "README"} <= found


@pytest.mark.parametrize("page", sorted((PROJECT / "docs").glob("*.md")), ids=lambda page: page.stem)
def test_pages_link_what_is_there(page):
    made = {"guide", "python", "cpp"}      # by docs/extensions/pages.py
    for target in re.findall(r"\]\(([^)#]+)", page.read_text()):
        if "://" not in target and target.split("/")[0] not in made:
            assert (page.parent / target).exists(), target


def test_the_mathematics_has_every_row():
    text = (PROJECT / "docs/mathematics.md").read_text()
    assert [int(row) for row in re.findall(r"^### S(\d+): ", text, re.M)] == list(range(1, 23))


def test_the_reference_has_every_room_of_the_library():
    text = (PROJECT / "docs/extensions/pages.py").read_text()
    rooms = re.findall(r'"(\w+)": "', text.split("CPP_ROOMS = {")[1].split("}")[0])
    assert sorted(rooms) == sorted(path.name for path in (PROJECT / "native/include/splinecore").iterdir() if path.is_dir())
