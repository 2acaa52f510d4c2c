"""``python -m verify``."""

import gc

from verify.cli import main

if __name__ == "__main__":
    # A short-lived process that builds trees and drops nothing: collecting would find no garbage.
    gc.disable()
    raise SystemExit(main())
