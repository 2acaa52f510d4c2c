"""Run the commands of all screens, and show what differs, or write it with ``--accept``."""

from __future__ import annotations

import sys
from difflib import unified_diff

from tests.golden import PROMPT, files, screen, sessions


def main() -> int:
    """Return 1 if something differs and is not accepted."""
    differing = 0
    for path in files():
        before = path.read_text(encoding="utf-8")
        shown = [f"{PROMPT}{command}\n{screen(command)}\n" for command in sessions(path)]
        after = "\n".join(shown)
        differing += after != before
        lines = (text.splitlines(keepends=True) for text in (before, after))
        sys.stdout.writelines(unified_diff(*lines, path.name, path.name))
        if "--accept" in sys.argv[1:]:
            path.write_text(after, encoding="utf-8")
    return int(bool(differing) and "--accept" not in sys.argv[1:])


if __name__ == "__main__":
    sys.exit(main())
