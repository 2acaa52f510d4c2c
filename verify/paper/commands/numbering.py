r"""The numbers that the paper prints, from its source: each ``\label`` with its number and kind.

``python -m verify.paper.commands.numbering collapse.tex`` compiles the source with LaTeX, reads
the numbers back and writes the table that `verify.paper.numbering` shows. The source itself is not
kept; the table has its digest.
"""

from __future__ import annotations

import hashlib
import json
import re
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

#: What a label in such an environment is the number of; outside of all, it is that of a section.
KINDS = {
    "theor": "Theorem",
    "propo": "Proposition",
    "lemma": "Lemma",
    "defin": "Definition",
    "remar": "Remark",
    "align": "equation",
    "equation": "equation",
    "appendices": "Appendix",
}
TABLE = Path(__file__).parents[2] / "data" / "numbers.json"
_NUMBER = re.compile(r"\\newlabel\{([^}]+)\}\{\{([^}]*)\}")
_STEP = re.compile(r"\\(begin|end|label)\{([^}]*)\}")
_COMMENT = re.compile(r"(?<!\\)%.*")


def numbers(source: str, auxiliary: str) -> dict[str, str]:
    r"""Each label as the paper calls it: ``(4.25)``, ``Theorem 1``, ``Section 4.1``.

    Args:
        source: the text of the paper.
        auxiliary: the ``.aux`` file that LaTeX wrote for it.

    Raises:
        KeyError: if a label of the source has no number.
    """
    found = dict(_NUMBER.findall(auxiliary))
    return {label: _called(kind, found[label]) for label, kind in kinds(source)}


def kinds(source: str) -> Iterator[tuple[str, str]]:
    """Each label of a source with the kind of what it is the number of."""
    inside: list[str] = []
    for step, name in _STEP.findall(_COMMENT.sub("", source)):
        if step == "begin":
            inside.append(name)
        elif step == "end":
            inside.pop()
        elif name:
            numbered = [KINDS[environment] for environment in inside if environment in KINDS]
            yield name, numbered[-1] if numbered else "Section"


def _called(kind: str, number: str) -> str:
    return f"({number})" if kind == "equation" else f"{kind} {number}"


def compiled(path: Path) -> str:
    """The ``.aux`` file of a source, after LaTeX has run on it in a folder of its own.

    Raises:
        FileNotFoundError: if there is no LaTeX, or it wrote no such file.
    """
    with tempfile.TemporaryDirectory() as folder:
        command = ["pdflatex", "-interaction=nonstopmode", f"-output-directory={folder}", str(path)]
        subprocess.run(command, capture_output=True, check=False)
        return (Path(folder) / path.with_suffix(".aux").name).read_text(encoding="utf-8")


def main(path: Path) -> None:
    """Write the table for this source."""
    source = path.read_bytes()
    table = {
        "source_sha256": hashlib.sha256(source).hexdigest(),
        "numbers": numbers(source.decode("utf-8"), compiled(path)),
    }
    text = json.dumps(table, indent=1, ensure_ascii=False) + "\n"
    TABLE.write_text(text, encoding="utf-8", newline="\n")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
