"""How Sphinx builds these pages: ``python -m sphinx -W -b html docs build/docs``."""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent)]

import generated  # noqa: E402

import verify  # noqa: E402

project = "verify-collapse"
author = "The founders of verify-collapse"
version = release = verify.__version__
project_copyright = author

extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.napoleon", "generated"]
myst_enable_extensions = ["colon_fence", "substitution"]
myst_heading_anchors = 3
myst_substitutions = generated.figures()
smartquotes = False  # --r is an option
autodoc_member_order = "bysource"
autodoc_typehints = "description"

html_theme = "furo"
html_title = "verify-collapse"
html_copy_source = False
html_show_sphinx = False
templates_path: list[str] = []
exclude_patterns = ["_build"]
