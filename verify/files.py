"""Writing results: all of them, or none."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Mapping

from verify.inputs import InputError


def write_all(option: str, directory: str, contents: Mapping[str, bytes]) -> None:
    """Write files into a directory, created if needed; each appears whole or not at all.

    Raises:
        InputError: if the directory or a file cannot be written, naming the option.
    """
    temporary: dict[str, str] = {}
    try:
        os.makedirs(directory, exist_ok=True)
        for name, content in contents.items():
            handle, path = tempfile.mkstemp(prefix=f".{name}.", dir=directory)
            temporary[path] = os.path.join(directory, name)
            with os.fdopen(handle, "wb") as file:
                file.write(content)
            os.chmod(path, 0o644)
        for path, target in temporary.items():
            os.replace(path, target)
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise InputError(
            f"{option}: {directory!r} cannot be written ({reason}); name a folder that can"
        ) from error
    finally:
        for path in temporary:
            if os.path.exists(path):
                os.unlink(path)
