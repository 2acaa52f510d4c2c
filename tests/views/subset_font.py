"""Makes the mathematics font of the page: a part of STIX Two Math, as a WOFF file.

A developer's step, needed only when the page gets a new sign (a test says so):

    pip install fonttools
    python -m tests.views.subset_font STIXTwoMath-Regular.otf verify/data/mathematics.woff

The font is that of Debian's texlive-fonts-extra, or of the STIX project.
"""

from __future__ import annotations

import sys

#: Signs that formulas of the page have, or may have.
SIGNS = "′¯−≤≥<>=≠±×⋅·∞√∑∏∈…⁡⁢|()[]{},.;:+-/*!_^ "
LETTERS = (*range(0x30, 0x3A), *range(0x41, 0x5B), *range(0x61, 0x7B))
GREEK = tuple(range(0x391, 0x3CA))
#: The slanted letters that browsers take for a letter that stands alone.
SLANTED = (0x210E, 0x1D6E4, *range(0x1D434, 0x1D468), *range(0x1D6E2, 0x1D71C))


def main(source: str, target: str) -> None:
    """Write the part of a font that the page uses."""
    from fontTools import subset

    options = subset.Options(
        flavor="woff", layout_features=[], name_IDs=[0, 1, 2, 3, 4, 5, 6, 13, 14],
        hinting=False, desubroutinize=False, drop_tables=["GPOS", "DSIG", "GDEF"],
    )  # fmt: skip
    font = subset.load_font(source, options)
    part = subset.Subsetter(options)
    part.populate(unicodes=[*map(ord, SIGNS), *LETTERS, *GREEK, *SLANTED])
    part.subset(font)
    for record in font["name"].names:
        if record.nameID in (1, 3, 4, 6):
            font["name"].setName("VerifyMath", record.nameID, 3, 1, 0x409)
    subset.save_font(font, target, options)


if __name__ == "__main__":
    main(*sys.argv[1:])
