"""The mathematics font that the page brings along."""

from __future__ import annotations

from base64 import b64encode
from importlib.resources import files

NAME = "VerifyMath"
FILE = "mathematics.woff"


def font_bytes() -> bytes:
    """The font file: a part of STIX Two Math."""
    return files("verify").joinpath("data", FILE).read_bytes()


def font_face() -> str:
    """The rule of a style sheet that makes the font known."""
    data = b64encode(font_bytes()).decode()
    return f'@font-face{{font-family:{NAME};src:url("data:font/woff;base64,{data}")}}'
