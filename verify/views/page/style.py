"""The style sheet of the pages, and the font that they bring along."""

from __future__ import annotations

import os
from base64 import b64encode
from importlib.resources import files as package_files

from verify.views.html import TEMPLATES
from verify.views.plots.drawing import SCHEMES


def font_bytes() -> bytes:
    """The font file: a part of STIX Two Math."""
    return package_files("verify").joinpath("data/mathematics.woff").read_bytes()


def style() -> str:
    """System fonts and a font for formulas, both colour schemes, a phone, a screen, paper."""
    light, dark = (
        ";".join(f"--{name}:{colour}" for name, colour in SCHEMES[scheme].items())
        for scheme in ("light", "dark")
    )
    with open(os.path.join(TEMPLATES, "style.css"), encoding="utf-8") as file:
        rules = file.read()
    font = b64encode(font_bytes()).decode()
    return (
        f'@font-face{{font-family:VerifyMath;src:url("data:font/woff;base64,{font}")}}'
        f":root{{{light}}}@media screen and (prefers-color-scheme:dark){{:root{{{dark}}}}}\n{rules}"
    )
