"""The files of a report: read once, and an error where one cannot be used."""

from __future__ import annotations


class CertificateError(Exception):
    """Something that no report may show; ``code`` is the exit code that says why."""

    def __init__(self, message: str, code: int) -> None:
        super().__init__(message)
        self.code = code


def unusable(message: str) -> CertificateError:
    """The error for files that cannot be used."""
    return CertificateError(f"--directory: {message}", 2)


def read_file(path: str) -> bytes:
    """The bytes of a file.

    Raises:
        CertificateError: if it cannot be read.
    """
    try:
        with open(path, "rb") as file:
            return file.read()
    except OSError as error:
        raise unusable(f"{path!r} cannot be read ({error.strerror}); name a file") from error
