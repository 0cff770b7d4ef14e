"""The public headers read by doxygen, as breathe wants them."""

import re
import subprocess
import sys
from pathlib import Path

DOCS = Path(__file__).resolve().parents[1]


def read(folder):
    """Doxygen's XML of the headers in a folder, made anew."""
    folder.mkdir(parents=True, exist_ok=True)
    settings = (DOCS / "Doxyfile").read_text() + f"OUTPUT_DIRECTORY = {folder}\n"
    try:
        subprocess.run(["doxygen", "-"], input=settings, text=True, check=True, cwd=DOCS)
    except FileNotFoundError:
        sys.exit("doxygen is not installed")
    name_by_path(folder / "xml")
    for path in (folder / "xml").glob("*.xml"):
        text = path.read_text()
        if 'prot="private"' in text:
            path.write_text(without_private(text))
    return folder / "xml"


def without_private(text):
    """The XML of a class or a file without private members and classes, which breathe shows, too."""
    text = re.sub(r'\s*<sectiondef kind="private-[^"]*">.*?</sectiondef>', "", text, flags=re.S)
    return re.sub(r'\s*<innerclass [^>]*prot="private"[^>]*>[^<]*</innerclass>', "", text)


def name_by_path(xml):
    """Headers of one name lie in several rooms; breathe tells files by their names alone."""
    index = (xml / "index.xml").read_text()

    def path_of(found):
        place = re.findall(r'<location file="([^"]*)"/>', (xml / f"{found[1]}.xml").read_text())[-1]
        return f'<compound refid="{found[1]}" kind="file"><name>{place}</name>'

    index = re.sub(r'<compound refid="([^"]*)" kind="file"><name>[^<]*</name>', path_of, index)
    (xml / "index.xml").write_text(index)


def setup(app):
    app.setup_extension("breathe")
    xml = read(Path(app.outdir).parent / "doxygen")
    app.connect("config-inited", lambda app, config: config.breathe_projects.update(splinecore=str(xml)))
    return {"parallel_read_safe": True}
