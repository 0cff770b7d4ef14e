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
    if "sc.plot." in code:
        pytest.importorskip("matplotlib")
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(path for path in sys.path if path), "MPLBACKEND": "agg"}
    done = subprocess.run([sys.executable, "-W", "error", "-c", code], capture_output=True, text=True, cwd=tmp_path, env=environment)
    assert done.returncode == 0, done.stderr


def test_every_page_has_samples_where_it_should():
    found = {param.id.rsplit("-", 1)[0] for param in samples()}
    assert {"command", "cookbook", "formats", "gallery", "index", "mathematics", "README"} <= found


@pytest.mark.parametrize("page", ["cookbook", "gallery", "index"])
def test_pictures_are_made_by_the_samples_of_their_page(page):
    text = (PROJECT / f"docs/{page}.md").read_text()
    written = re.findall(r'(?:savefig|Path)\("([^"]+)"\)', text)
    shown = re.findall(r"\]\(figures/([^)]+)\)", text)
    assert sorted(written) == sorted(shown) and len(set(shown)) == len(shown)
    assert f'"{page}"' in re.search(r"^PAGES = .*$", (PROJECT / "docs/extensions/figures.py").read_text(), re.M)[0]


def test_every_picture_of_the_gallery_has_its_code():
    blocks = (PROJECT / "docs/gallery.md").read_text().split("\n\n")
    pictures = [i for i, block in enumerate(blocks) if block.startswith("![")]
    assert len(pictures) >= 14
    for i in pictures:
        assert "](figures/" in blocks[i] or "{download}" in blocks[i + 1], blocks[i]


@pytest.mark.parametrize("page", ["cookbook", "gallery", "index"])
def test_lines_of_code_fit_the_column_of_the_site(page):
    for code in re.findall(r"^```python\n(.*?)^```", (PROJECT / f"docs/{page}.md").read_text(), re.S | re.M):
        assert max(map(len, code.splitlines())) <= 88, max(code.splitlines(), key=len)


def test_the_cookbook_has_a_program_for_each_recipe():
    recipes = re.split(r"^## ", (PROJECT / "docs/cookbook.md").read_text(), flags=re.M)[1:]
    assert len(recipes) >= 7
    for recipe in recipes:
        assert recipe.count("```python\n") == 1, recipe.splitlines()[0]


@pytest.mark.parametrize("page", sorted((PROJECT / "docs").glob("*.md")), ids=lambda page: page.stem)
def test_pages_link_what_is_there(page):
    made = {"guide", "python", "cpp", "figures"}      # by docs/extensions/pages.py
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


def test_the_reference_has_no_private_members(monkeypatch):
    monkeypatch.syspath_prepend(PROJECT / "docs/extensions")
    from headers import without_private
    shown = '<sectiondef kind="public-func"><memberdef prot="public">a</memberdef></sectiondef>'
    hidden = """
      <innerclass refid="b" prot="private">C::B</innerclass>
      <sectiondef kind="private-func"><memberdef prot="private">b</memberdef></sectiondef>
      <sectiondef kind="private-attrib">\n<memberdef prot="private">c</memberdef>\n</sectiondef>"""
    assert without_private(f"<x>{hidden}{shown}{hidden}</x>") == f"<x>{shown}</x>"
