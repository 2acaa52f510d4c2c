"""Bring the certificates that come with the program up to date: python -m tests.package.

They are made again, checked, copied from `certificates` to `verify/data`, and their digests are
written into `verify/wire/packaged.py`; again and again, since some cite others, until nothing
changes.
"""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from hashlib import sha256
from pathlib import Path

ROOT = Path(__file__).parents[1]
MODULE = ROOT / "verify" / "wire" / "packaged.py"
ROUNDS = 6


def names() -> list[str]:
    """The folders, as they stand in the source."""
    return sorted(path.name for path in (ROOT / "verify" / "data").iterdir() if path.is_dir())


def copied() -> bool:
    """Copy the files and write their digests; whether anything was new."""
    new = False
    source = MODULE.read_text(encoding="utf-8")
    for name in names():
        for file in ("statement.json", "certificate.json"):
            origin, copy = (ROOT / place / name / file for place in ("certificates", "verify/data"))
            old, digest = (sha256(path.read_bytes()).hexdigest() for path in (copy, origin))
            if old != digest:
                shutil.copy(origin, copy)
                assert source.count(old) == 1, f"{name}/{file}: {old} is not in {MODULE}"
                source, new = re.sub(old, digest, source), True
    MODULE.write_text(source, encoding="utf-8")
    return new


def main() -> None:
    """Repeat until what is made is what comes with the program."""
    for _ in range(ROUNDS):
        subprocess.run([sys.executable, "-m", "verify", "certify"], cwd=ROOT, check=True)
        if not copied():
            return
    raise SystemExit(f"still changing after {ROUNDS} rounds")


if __name__ == "__main__":
    main()
