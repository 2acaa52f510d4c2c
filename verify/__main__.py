"""``python -m verify``."""

import gc
import sys

if __name__ == "__main__":
    # A short-lived process that builds trees and drops nothing: collecting would find no garbage.
    gc.disable()
    try:
        from verify.cli import main
    except KeyboardInterrupt:
        sys.exit(130)
    sys.exit(main())
