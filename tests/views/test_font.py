"""The font of the page has every sign of its formulas."""

from __future__ import annotations

import re
import struct
import unicodedata
import zlib
from collections.abc import Iterator
from html import unescape
from pathlib import Path

from verify.views.style import font_bytes


def tables(font: bytes) -> dict[str, bytes]:
    """The tables of a WOFF file, unpacked."""
    assert font[:4] == b"wOFF"
    (count,) = struct.unpack(">H", font[12:14])
    found = {}
    for number in range(count):
        tag, start, size, whole, _ = struct.unpack_from(">4sIIII", font, 44 + 20 * number)
        data = font[start : start + size]
        found[tag.decode()] = zlib.decompress(data) if size < whole else data
    return found


def signs_of(cmap: bytes) -> Iterator[int]:
    """The characters that the table of characters has, by its subtables in format 12 and 4."""
    (count,) = struct.unpack_from(">H", cmap, 2)
    for number in range(count):
        (start,) = struct.unpack_from(">I", cmap, 4 + 8 * number + 4)
        (kind,) = struct.unpack_from(">H", cmap, start)
        if kind == 12:
            (groups,) = struct.unpack_from(">I", cmap, start + 12)
            for group in range(groups):
                low, high, _ = struct.unpack_from(">III", cmap, start + 16 + 12 * group)
                yield from range(low, high + 1)
        elif kind == 4:
            (twice,) = struct.unpack_from(">H", cmap, start + 6)
            ends = struct.unpack_from(f">{twice // 2}H", cmap, start + 14)
            starts = struct.unpack_from(f">{twice // 2}H", cmap, start + 16 + twice)
            for low, high in zip(starts, ends, strict=True):
                yield from range(low, high + 1)


def slanted(letter: str) -> str:
    """What a browser draws for a letter that stands alone."""
    if letter == "h":
        return "ℎ"
    name = unicodedata.name(letter).split()
    size = {"CAPITAL": "CAPITAL", "SMALL": "SMALL"}[name[1]]
    return unicodedata.lookup(f"MATHEMATICAL ITALIC {size} {name[-1]}")


def signs_of_formulas(page: str) -> set[str]:
    """All characters of formulas, as they are drawn."""
    formulas = "".join(re.findall(r"<math>.*?</math>", page, re.DOTALL))
    alone = set(map(unescape, re.findall(r"<mi>([^<&]|&[^;]*;)</mi>", formulas)))
    signs = {slanted(letter) for letter in alone if letter.isalpha()}
    return signs | (set(unescape(re.sub("<[^>]*>", "", formulas))) - alone)


def test_the_font_has_every_sign_of_the_page(made: Path, page: str) -> None:
    known = set(map(chr, signs_of(tables(font_bytes())["cmap"])))
    needed = signs_of_formulas(page)
    assert {"𝛼", "𝛿", "√"} - known == set()
    assert len(needed) > 50
    assert needed - known == set()
    assert "font/woff" in (made / "pages/style.css").read_text(encoding="utf-8")


def test_the_font_can_stretch_and_is_small() -> None:
    assert "MATH" in tables(font_bytes())
    assert len(font_bytes()) < 80_000
