"""What goes with a certificate to somebody who has nothing but Python."""

from __future__ import annotations

from collections.abc import Mapping

from verify import check
from verify.paper.source import PAPER
from verify.prover.outcome import Outcome
from verify.views.markdown import report
from verify.views.page.single import single_page


def sent(outcome: Outcome, files: Mapping[str, bytes], *, markdown: bool) -> dict[str, bytes]:
    """The checker as it is here, and the report as a page that needs no other file, or as text too.

    The page has the digests of the checker and of ``files``, which are those of the certificate.
    """
    with open(check.__file__, "rb") as file:
        checker = {"check.py": file.read()}
    page = single_page(outcome, PAPER, {**files, **checker})
    told = {"report.md": report(outcome, PAPER, is_sent=True).encode()} if markdown else {}
    return {**checker, "report.html": page.encode(), **told}
