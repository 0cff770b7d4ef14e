"""The site: `./run docs`."""

import re
import sys
from pathlib import Path

DOCS = Path(__file__).parent
sys.path.insert(0, str(DOCS / "extensions"))

project = "Splinewright"
author = "The Splinewright developers"
copyright = "2026, The Splinewright developers"
release = re.search(r"project\(splinecore VERSION ([0-9.]+)", (DOCS.parent / "native/CMakeLists.txt").read_text())[1]

extensions = ["figures", "pages", "stubs", "mathml", "myst_parser", "sphinx.ext.autodoc", "sphinx.ext.autosummary", "headers"]
exclude_patterns = ["requirements.txt"]
myst_enable_extensions = ["colon_fence", "dollarmath"]
myst_heading_anchors = 3
breathe_default_project = "splinecore"
html_math_renderer = "mathml"
html_theme = "furo"
html_title = "Splinewright"
html_static_path = ["style"]
html_css_files = ["site.css"]
default_role = "py:obj"
napoleon_google_docstring = False
napoleon_preprocess_types = True
napoleon_use_rtype = False
# Each header shows the namespace that all share.
suppress_warnings = ["duplicate_declaration.cpp"]
