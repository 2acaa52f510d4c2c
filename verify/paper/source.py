"""Which paper it is."""

from __future__ import annotations

AUTHORS = "Théophile Dolmaire and Juan J. L. Velázquez"
TITLE = "Collapse of inelastic hard spheres in dimension d ≥ 2"
PAPER = f"{AUTHORS}, *{TITLE}*"

#: The paper of the same authors that it builds on.
COMPANION = "arXiv:2403.16905"
