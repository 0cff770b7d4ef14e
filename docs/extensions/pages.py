"""Pages that are made before the others are read: the user guide of the add-on's manual, a page for each room of the library."""

import re
import shutil
import sys
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[2]
DOCS = PROJECT / "docs"
sys.path.insert(0, str(PROJECT / "addon"))

import manual_pages  # noqa: E402
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
    """The manual's pages in every language that they are there in."""
    folder = fresh("guide")
    translations = [manual_pages.address("index", language) for language in manual_pages.languages_of("index")[1:]]
    for language in manual_pages.LANGUAGES:
        names = [name for name in manual_pages.PAGES if language in manual_pages.languages_of(name)]
        place = (folder / manual_pages.address("index", language)).parent
        place.mkdir(exist_ok=True)
        for name in names:
            (place / f"{name}.md").write_text(guide_page(name, language))
        others = [*names[1:], *(translations if language == manual_pages.ENGLISH else ())]
        with (place / "index.md").open("a") as index:
            index.write("\n```{toctree}\n:hidden:\n\n" + "\n".join(others) + "\n```\n")


def guide_page(name, language):
    """What a page takes of the README is put in, links lead to where files lie from there, and other languages stand below the title."""
    text = manual_pages.text(name, language)
    up = "../" if language == manual_pages.ENGLISH else "../../"
    text = re.sub(r"\]\((?:\.\./\.\./)?(blend_samples[^)]*)\)", r"](../../\1)", text)
    text = re.sub(r"(?<!!)\[([^\]]+)\]\((?:addon/splinewright/)?(CHANGELOG\.md)\)", rf"[\1]({up}changelog.md)", text)
    text = re.sub(r"(?<!!)\[([^\]]+)\]\((LICENSE|CONTRIBUTING\.md|(?:addon|tests|native|examples|\.\./\.\./blend_samples)\b[^)]*)\)",
                  r"\1", text)
    text = re.sub(r"\]\(docs/([\w-]+\.md)\)", rf"]({up}\1)", text)
    text = re.sub(r"<!-- F1: .*? -->\n?", "", text, flags=re.S)
    known = manual_pages.languages_of(name)
    root = "" if language == manual_pages.ENGLISH else "../"
    links = " · ".join(manual_pages.LANGUAGES[other] if other == language else
                       f"[{manual_pages.LANGUAGES[other]}]({root}{manual_pages.address(name, other)}.md)" for other in known)
    title, _, rest = text.partition("\n")
    return f"{title}\n\n{links}\n\n{rest}" if len(known) > 1 else text


def speak(app, page, template, context, doctree):
    """A page of the manual is in the language of its folder."""
    folder = page.removeprefix("guide/").partition("/")[0]
    if page.startswith("guide/") and folder in manual_pages.LANGUAGES:
        context["language"] = folder


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
    app.connect("html-page-context", speak)
    return {"parallel_read_safe": True}
