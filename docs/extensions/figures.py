"""The pictures of pages: their samples of code run before the pages are read, and write them into docs/figures."""

import contextlib
import re
import shutil
import sys
import traceback
from pathlib import Path

import matplotlib
from matplotlib import pyplot

DOCS = Path(__file__).resolve().parents[1]
PAGES = ("index", "gallery", "cookbook")
#: Pictures stand on light and on dark pages.
GRAY, PANE = "#808080", (0.5, 0.5, 0.5, 0.1)
STYLE = {
    "savefig.transparent": True, "savefig.bbox": "tight", "savefig.dpi": 150, "svg.hashsalt": "splinecore", "figure.figsize": (6, 4), "text.color": GRAY,
    "axes.edgecolor": GRAY, "axes.labelcolor": GRAY, "xtick.color": GRAY, "ytick.color": GRAY, "grid.color": (0.5, 0.5, 0.5, 0.4),
    "axes3d.xaxis.panecolor": PANE, "axes3d.yaxis.panecolor": PANE, "axes3d.zaxis.panecolor": PANE,
}


def samples(page):
    return re.findall(r"^```python\n(.*?)^```", (DOCS / f"{page}.md").read_text(), re.S | re.M)


def make(folder):
    """Every sample that writes a picture is run in a folder."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    matplotlib.use("agg")
    with contextlib.chdir(folder), contextlib.redirect_stdout(None), matplotlib.rc_context(STYLE):
        for page in PAGES:
            for number, code in enumerate(samples(page), 1):
                try:
                    exec(compile(code, f"{page}.md, sample {number}", "exec"), {})
                except Exception:
                    sys.exit(traceback.format_exc(limit=-1))
                pyplot.close("all")


def setup(app):
    make(DOCS / "figures")
    return {"parallel_read_safe": True}
