"""The files of a report: read once, and an error where one cannot be used."""

from __future__ import annotations

from verify.wire import inputs

#: Of a file that a report is made from or compared with: more bytes than any of them has.
MAX_BYTES = 1 << 26


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
        return inputs.regular_file(path, MAX_BYTES)
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or error
        raise unusable(f"{path!r} cannot be read ({reason}); name a file") from error
