"""Writing results: files, all of them or none, documents, and progress."""

from __future__ import annotations

import os
import sys
from collections.abc import Mapping
from errno import EISDIR
from typing import Any

from verify.cli.inputs import InputError, shown


def write_all(option: str, directory: str, contents: Mapping[str, bytes]) -> None:
    """Write files into a directory, created if needed; each appears whole or not at all.

    Raises:
        InputError: if the directory or a file cannot be written, naming the option.
    """
    temporary: dict[str, str] = {}
    made = False
    try:
        made = not os.path.isdir(directory)
        os.makedirs(directory, exist_ok=True)
        for name, content in contents.items():
            path = os.path.join(directory, f".{name}.{os.getpid()}")
            temporary[path] = os.path.join(directory, name)
            with open(path, "xb") as file:
                file.write(content)
        for target in temporary.values():
            if os.path.isdir(target):
                raise IsADirectoryError(EISDIR, os.strerror(EISDIR), target)
        for path, target in temporary.items():
            os.replace(path, target)
        made = False
    except (OSError, ValueError, RecursionError) as error:
        raise InputError(
            f"{option}: {shown(directory)} cannot be written ({_reason(error)}); "
            "name a folder that can"
        ) from error
    finally:
        for path in temporary:
            if os.path.exists(path):
                os.unlink(path)
        if made and os.path.isdir(directory) and not os.listdir(directory):
            os.rmdir(directory)


def _reason(error: Exception) -> str:
    return getattr(error, "strerror", None) or str(error)


def read_bytes(option: str, path: str) -> bytes:
    """The content of a file.

    Raises:
        InputError: if it cannot be read, naming the option.
    """
    try:
        with open(path, "rb") as file:
            return file.read()
    except (OSError, ValueError) as error:
        raise InputError(
            f"{option}: {shown(path)} cannot be read ({_reason(error)}); name a file"
        ) from error


def progress(text: str) -> None:
    """Say on stderr what is being done, if somebody watches."""
    if sys.stderr is not None and sys.stderr.isatty():
        print(f"{text} …", file=sys.stderr)


def print_document(document: Mapping[str, Any]) -> None:
    """Print one JSON document on stdout."""
    import json  # loaded only where it is used

    print(json.dumps(document, ensure_ascii=False, indent=1))
