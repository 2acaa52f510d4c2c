"""What is made from the program and comes with it: copies of certificates, what is compiled of the
page of Theorem 1, and the index of places.

Of each page of the paper it records the text that makes the certificate, by its digest.

``python -m tests.bring``, after a change to a row or to a certificate, writes `verify/data` and the
digests in `verify/data/packaged.txt`. Some certificates cite others: after it wrote something, run
``verify certify`` again, and then this, until nothing is written. With ``--compare`` it writes
nothing, and fails if anything would change.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from hashlib import sha256
from pathlib import Path

from verify import check
from verify.paper.commands import index
from verify.paper.commands.kept import kept
from verify.paper.commands.pages import decide, whole
from verify.paper.commands.places import places
from verify.paper.parameters import AS_PRINTED
from verify.paper.theorem1 import COMPILED, PAGE, as_read
from verify.wire.compiled import compiled
from verify.wire.packaged import (
    DIGESTS,
    PACKAGED,
    PACKAGED_FILES,
    PAGES,
    cited_digests,
    packaged_statements,
)
from verify.wire.write import write

ROOT = Path(__file__).parents[1]
SCENES = ROOT / "certificates/scenes"


def files() -> Iterator[tuple[Path, bytes]]:
    """Each file with the bytes that it should have."""
    code = Path(DIGESTS).read_text(encoding="utf-8")
    for name, old in PACKAGED_FILES.items():
        made = write(decide("printed_rows")) if name == AS_PRINTED else {}
        contents = {f: made.get(f) or (ROOT / "certificates" / name / f).read_bytes() for f in old}
        line = " ".join(sha256(content).hexdigest() for content in contents.values())
        work = work_of(*contents.values())
        code = re.sub(f"(?m)^certificate {name} .*$", f"certificate {name} {line} {work}", code)
        yield from ((Path(PACKAGED, name, file), content) for file, content in contents.items())
    for page, (name, old) in PAGES.items():
        made = write(decide(page))
        here = ROOT / "certificates" / name
        if here.exists() and any(made[f] != (here / f).read_bytes() for f in PACKAGED_FILES[name]):
            raise SystemExit(f"verify/paper/{page}.toml has changed: run `verify certify` first")
        code = code.replace(old, sha256(whole(page)).hexdigest())
    for path in (*(ROOT / "certificates/examples").glob("*.toml"), *SCENES.glob("*.toml")):
        yield Path(PACKAGED, "examples", path.name), path.read_bytes()
    page_of_theorem = Path(PAGE).read_bytes()
    text = compiled(as_read(page_of_theorem)._replace(kept=kept()), page_of_theorem).encode()
    yield Path(COMPILED), text
    compiled_line = f"compiled theorem1.txt {sha256(text).hexdigest()}"
    yield Path(DIGESTS), re.sub("(?m)^compiled theorem1.txt .*$", compiled_line, code).encode()
    yield Path(index.INDEX), index.text(places()).encode()


def work_of(statement: bytes, certificate: bytes) -> int:
    """What the checker counts."""
    cited = packaged_statements(cited_digests(statement))
    return check.check(statement, certificate, cited).work


def main() -> int:
    """Write or compare; return 1 if something compared differs."""
    differing = [(path, new) for path, new in files() if not _has(path, new)]
    for path, new in differing:
        print(f"{'differs' if '--compare' in sys.argv else 'written'}  {path.relative_to(ROOT)}")
        if "--compare" not in sys.argv:
            path.parent.mkdir(exist_ok=True)
            path.write_bytes(new)
    if differing and "--compare" not in sys.argv:
        print("Some certificates cite others: run `verify certify` again, and then this.")
    return 1 if differing and "--compare" in sys.argv else 0


def _has(path: Path, content: bytes) -> bool:
    return path.exists() and path.read_bytes() == content


if __name__ == "__main__":
    raise SystemExit(main())
