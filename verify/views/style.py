"""The style sheet of the pages, and the font that they bring along."""

from __future__ import annotations

import os
from binascii import b2a_base64

HERE = os.path.dirname(__file__)

_LIGHT = """
ink #1c2128, faint #6f7781, undecided #bcc3cb, paper #ffffff, proved #1d5ca8, refuted #a3470a,
proved-area #2e6bb6, refuted-area #f7bb70, refuted-line #9a4300, series-1 #1d5ca8,
series-2 #d9822b, series-3 #52606d, series-4 #7fb2e5, series-5 #a3470a, series-6 #4b8fa0,
series-7 #77803a"""
_DARK = """
ink #e4e7ea, faint #939ca6, undecided #a4adb7, paper #14181d, proved #8ab8f0, refuted #f2a65a,
proved-area #2c5a99, refuted-area #dfa050, refuted-line #4a2400, series-1 #8ab8f0,
series-2 #f2a65a, series-3 #b5bfca, series-4 #3f74b5, series-5 #d98a3a, series-6 #7cc3d3,
series-7 #b9c36c"""

#: What the variables of the style sheet stand for, in either scheme.
SCHEMES = {
    scheme: dict(pair.split() for pair in text.split(","))
    for scheme, text in (("light", _LIGHT), ("dark", _DARK))
}


def font_bytes() -> bytes:
    """The font file: a part of STIX Two Math."""
    with open(os.path.join(os.path.dirname(HERE), "data", "mathematics.woff"), "rb") as file:
        return file.read()


def style() -> str:
    """System fonts and a font for formulas, both colour schemes, a phone, a screen, paper."""
    light, dark = (
        ";".join(f"--{name}:{colour}" for name, colour in SCHEMES[scheme].items())
        for scheme in ("light", "dark")
    )
    with open(os.path.join(HERE, "templates", "style.css"), encoding="utf-8") as file:
        rules = file.read()
    font = b2a_base64(font_bytes(), newline=False).decode()
    return (
        f'@font-face{{font-family:VerifyMath;src:url("data:font/woff;base64,{font}")}}'
        f":root{{{light}}}@media screen and (prefers-color-scheme:dark){{:root{{{dark}}}}}\n{rules}"
    )
