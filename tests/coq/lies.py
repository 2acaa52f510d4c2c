"""The program that is extracted from Coq has to refuse every lie, as `verify/check.py` does.

python -m tests.coq.lies READER
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
from pathlib import Path

from tests.check.support import answer
from tests.lies.lies import LIES, honest


def main(reader: str) -> int:
    """Give all of them to the program; 1 if a lie passes, or the honest pair does not."""
    pairs = {"honest": honest().files(), **{name: lie.files() for name, lie in LIES.items()}}
    with tempfile.TemporaryDirectory() as path:
        for name, (first, second) in pairs.items():
            folder = Path(path, name)
            folder.mkdir()
            (folder / "statement.json").write_bytes(first)
            (folder / "certificate.json").write_bytes(second)
        done = subprocess.run([reader, *pairs], cwd=path, capture_output=True, text=True)
    found = dict(line.split(": ", 1) for line in done.stdout.splitlines())
    other, wrong = 0, [name for name in pairs if name not in found]
    for name, said in found.items():
        code, _ = answer(pairs[name])
        wanted = {0: "PROVED", 1: "REFUSED", 4: "MALFORMED"}[code]
        if (said == "PROVED") != (code == 0):
            wrong.append(name)
        other += not said.startswith(wanted)
        if not said.startswith(wanted):
            print(f"{name}: {said}, where the checker says {wanted}")
    for name in wrong:
        print(f"WRONG {name}: {found.get(name, done.stderr[-200:])}")
    print(f"{len(pairs)} pairs, {len(wrong)} wrong, {other} refused in another way")
    return bool(wrong)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
