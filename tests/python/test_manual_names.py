"""What the pages of the manual set in italics or bold is there under that name, and names of before lead to those of now."""

import re
import sys
from pathlib import Path

import pytest

pofile = pytest.importorskip("babel.messages.pofile")       # ./run installs it
PROJECT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(PROJECT / "addon"))
import manual_pages                                         # noqa: E402
from markdown_it import MarkdownIt                          # noqa: E402

ADDON = PROJECT / "addon" / "splinewright"
#: Steps of lectures have names of their pictures, too.
PAGES = sorted(set(manual_pages.PAGES) - {"lectures"})
KEY = re.compile(r"(?:(?:(?:Ctrl|Shift|Alt)(?:\+|$))*(?:[A-Z]\d?|F\d|Tab|Enter|Esc|Delete|[Nn]umpad \d|-?[\d.]+|wheel|[Dd]rag|(?:double |right )?click|$)(?: |$))+")
#: Blender's menus, commands, panels and tools.
BLENDERS = {
    "Add-ons", "Align: View", "Apply", "Bevel", "Dissolve", "Dissolve Edges", "Edge Loops", "Edit", "Export", "Face", "File", "Follow Path",
    "Import", "Insert Single Keyframe", "Inset Faces", "Interface", "Knife", "Lock Interface", "Loop Cut and Slide", "Modifiers", "Object Mode",
    "Objects", "Overlays", "Preferences", "Render", "Set Origin", "Spin", "Subdivide", "Toggle Cyclic", "Transform", "Translation", "Units",
    "Vertex"}
#: Words that are stressed, or begin a paragraph; parts of labels; what is drawn or typed; a package.
OTHERS = {
    "Edit the inputs first, then add what follows", "Hide what you do not edit", "Show fewer faces", "Use a tolerance that you need",
    "Numbers of recipes", "hold", "was", "at End", "Placement", "Strengths", "Tools Trim", "Tools Split", "NURBS", "G2", "×2 C1", "1, 4-6",
    "reportlab", "Insert a knot", "Pull", "Lock G2"}
#: Operators that curves and patches had for themselves, or that had another name.
BEFORE = {
    "split_curve", "reparametrise", "to_bezier_chain", "patch_swap", *(f"patch_{name}" for name in (
        "insert_knot", "remove_knot", "remove_knots", "raise_degree", "lower_degree", "rebuild", "fair", "split", "reverse", "reparametrise",
        "clamp", "unclamp", "make_periodic", "to_bezier", "to_hermite", "to_nurbs"))}


def text(page):
    return re.sub(r"<!-- .*? -->", "", manual_pages.text(page, manual_pages.ENGLISH), flags=re.S)


def names(page):
    """What a page sets in italics or bold, menus one by one."""
    for token in MarkdownIt('commonmark').enable('table').parse(text(page)):
        children = token.children or ()
        for i, child in enumerate(children):
            if child.type in ('em_open', 'strong_open'):
                end = next(j for j in range(i, len(children)) if children[j].type == child.type.replace("open", "close"))
                said = "".join(" " if one.type == 'softbreak' else one.content for one in children[i + 1:end])
                yield from (part.strip().rstrip(".:,") for part in said.split(" > "))


def labels():
    """All texts of the interface; in menus to add without what Undo History shows."""
    found = set()
    for message in pofile.read_po((ADDON / "languages" / "splinewright.pot").open("rb")):
        texts = message.id if isinstance(message.id, tuple) else (message.id,)
        found |= {text.lower().removeprefix(prefix) for text in texts for prefix in ("", "add ")}
    return found


@pytest.mark.parametrize('page', PAGES)
def test_what_a_page_names_is_there_under_that_name(page):
    known = labels()
    missing = {name for name in names(page) if name.lower() not in known and not KEY.fullmatch(name)}
    assert missing - BLENDERS - OTHERS == set()


def test_names_of_before_lead_to_those_of_now():
    now = set(re.findall(r"'(\w+)'", (ADDON / "ui" / "menu_table.py").read_text()))
    section = text("modify").split("## Names in scripts\n")[1].split("\n## ")[0]
    rows = [[re.findall(r"`(\w+)`", cell) for cell in row.strip("|").split("|")] for row in section.splitlines() if row.startswith("| `")]
    assert {name for before, _ in rows for name in before} == BEFORE and not BEFORE & now
    assert {name for _, after in rows for name in after} <= now
