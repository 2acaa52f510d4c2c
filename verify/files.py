"""Writing results: files, all of them or none, and documents."""

from __future__ import annotations

import os
from collections.abc import Mapping
from errno import EISDIR
from typing import Any

from verify.inputs import InputError


def write_all(option: str, directory: str, contents: Mapping[str, bytes]) -> None:
    """Write files into a directory, created if needed; each appears whole or not at all.

    Raises:
        InputError: if the directory or a file cannot be written, naming the option.
    """
    import tempfile  # slow to load, and most runs write nothing

    temporary: dict[str, str] = {}
    try:
        os.makedirs(directory, exist_ok=True)
        for name, content in contents.items():
            handle, path = tempfile.mkstemp(prefix=f".{name}.", dir=directory)
            temporary[path] = os.path.join(directory, name)
            with os.fdopen(handle, "wb") as file:
                file.write(content)
            os.chmod(path, 0o644)
        for target in temporary.values():
            if os.path.isdir(target):
                raise IsADirectoryError(EISDIR, os.strerror(EISDIR), target)
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


def read_bytes(option: str, path: str) -> bytes:
    """The content of a file.

    Raises:
        InputError: if it cannot be read, naming the option.
    """
    try:
        with open(path, "rb") as file:
            return file.read()
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise InputError(f"{option}: {path!r} cannot be read ({reason}); name a file") from error


def print_document(document: Mapping[str, Any]) -> None:
    """Print one JSON document on stdout."""
    import json  # loaded only where it is used

    print(json.dumps(document, ensure_ascii=False, indent=1))
