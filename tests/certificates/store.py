"""Some lies as files, for who writes another checker: python -m tests.certificates.store.

Those in ``correct`` are PROVED (0), those in ``incorrect`` REFUSED (1), and those in ``malformed``
MALFORMED (4).
"""

from pathlib import Path

from tests.lies.lies import INCORRECT, LIES, honest

HERE = Path(__file__).parent

STORED = (
    "a-weak-bound-made-strict",
    "a-witness-on-the-boundary",
    "an-inequality-used-as-an-equation",
    "a-refuted-row-called-proved",
    "a-bound-moved-by-its-last-digit",
    "a-case-missing",
    "a-given-that-is-not-carried",
    "an-instance-outside-the-givens",
    "a-side-that-misses-the-last-digit",
    "a-context-that-never-opens",
    "a-row-proved-by-itself",
    "names-of-two-siblings-in-a-term",
    "a-digest-in-capitals",
    "a-second-document",
    "bits-as-a-float",
)


def stored() -> dict[Path, tuple[bytes, bytes]]:
    """The statement and the certificate of each folder."""
    found = {HERE / "correct" / "honest": honest().files()}
    for name in STORED:
        lie = LIES[name]
        kind = "incorrect" if lie.code == INCORRECT else "malformed"
        found[HERE / kind / name] = lie.files()
    return found


if __name__ == "__main__":
    for folder, files in stored().items():
        folder.mkdir(parents=True, exist_ok=True)
        for file, content in zip(("statement.json", "certificate.json"), files, strict=True):
            (folder / file).write_bytes(content)
