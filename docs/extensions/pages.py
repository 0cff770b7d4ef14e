"""Pages that are made before the others are read: the user guide of the add-on's manual, a page for each room of the library."""

import re
import shutil
import sys
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[2]
DOCS = PROJECT / "docs"
sys.path.insert(0, str(PROJECT / "addon"))

import make_manual  # noqa: E402
import python_pages  # noqa: E402

CPP_ROOMS = {
    "base": "Errors, intervals, points, long calls", "basis": "Knot vectors and bases", "curve": "Curves and their verbs",
    "patch": "Patches and their verbs", "convert": "Changes of form", "formula": "Formulas", "measure": "Lengths, areas, curvature",
    "meet": "Where shapes meet", "build": "Shapes from points and formulas", "region": "Plane regions", "fit": "Shapes through points", "conic": "Conics",
    "surface": "Lofts, sweeps, networks, fillings, fillets, subdivision",
    "tessellate": "Meshes", "exchange": "JSON, and meshes in files",
}


def fresh(name):
    """An empty folder of made pages."""
    folder = DOCS / name
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    return folder


def guide():
    """The manual's pages; what they take of the README is put in, and links lead to where files lie from there."""
    folder = fresh("guide")
    readme = (PROJECT / "README.md").read_text()
    for name in make_manual.PAGES:
        text = (make_manual.SOURCE / f"{name}.md").read_text()
        text = re.sub(r"^<!-- README: (.+) -->$", lambda found: make_manual.section(readme, found[1]), text, flags=re.M)
        text = re.sub(r"\]\((?:\.\./\.\./)?(blend_samples[^)]*)\)", r"](../../\1)", text)
        text = re.sub(r"(?<!!)\[([^\]]+)\]\((?:addon/splinewright/)?(CHANGELOG\.md)\)", r"[\1](../changelog.md)", text)
        text = re.sub(r"(?<!!)\[([^\]]+)\]\((LICENSE|CONTRIBUTING\.md|(?:addon|tests|native|examples|\.\./\.\./blend_samples)\b[^)]*)\)",
                      r"\1", text)
        text = re.sub(r"<!-- F1: .*? -->\n?", "", text, flags=re.S)
        (folder / f"{name}.md").write_text(text)
    others = "\n".join(name for name in make_manual.PAGES if name != "index")
    with (folder / "index.md").open("a") as index:
        index.write(f"\n```{{toctree}}\n:hidden:\n\n{others}\n```\n")


def cpp():
    """A page for each room of headers."""
    folder = fresh("cpp")
    rows = []
    for room, title in CPP_ROOMS.items():
        headers = sorted((PROJECT / "native/include/splinecore" / room).glob("*.hpp"))
        parts = [f"{header.name}\n{'-' * len(header.name)}\n\n.. doxygenfile:: splinecore/{room}/{header.name}\n"
                 "   :project: splinecore\n" for header in headers]
        (folder / f"{room}.rst").write_text(f"{room}\n{'=' * len(room)}\n\n{title}.\n\n" + "\n".join(parts))
        rows.append(f"| [{room}]({room}.rst) | {title} |")
    names = "\n".join(CPP_ROOMS)
    (folder / "index.md").write_text(
        "# The C++ library\n\nAfter `cmake --install`: `find_package(splinecore)`, "
        "`target_link_libraries(app splinecore::splinecore)`. Includes run one way: each room uses those above it only.\n\n"
        "| room | contents |\n| --- | --- |\n" + "\n".join(rows) + f"\n\n```{{toctree}}\n:hidden:\n\n{names}\n```\n")


def setup(app):
    guide()
    python_pages.write(fresh("python"))
    cpp()
    return {"parallel_read_safe": True}
