"""Run the hard cases: the precision each needs, the digits it loses, and whether it is right."""

from __future__ import annotations

from typing import Any

from verify.cli import columns
from verify.cli.files import test_folder
from verify.cli.options import Options, Usage
from verify.cli.steps import Steps
from verify.language.record import TYPE_CHECKING

if TYPE_CHECKING:
    from verify.measure.stress import Finding


USAGE = Usage({**columns.OPTIONS, "--out DIR": "write stress.json there"})


def run(options: Options) -> int:
    """Run the cases; return 0 if every answer is right, else 1."""
    from verify.measure import stress  # loads mpmath

    test_folder("--out", options.out, "stress.json")
    cases = stress.cases(options.quick)
    findings, progress = [], Steps(len(cases))
    for case in cases:
        progress(case.name)
        findings.append(stress.run_case(case))
    columns.publish("stress", {"cases": findings_table(findings)}, options, ("why",))
    return 0 if all(finding.right for finding in findings) else 1


def findings_table(findings: list[Finding]) -> dict[str, Any]:
    """One row for each case."""
    return {
        "title": "Hard cases",
        "columns": ["case", "answer", "bits", "digits lost", "textbook φ⁻ loses", "right", "why"],
        "rows": [
            [
                finding.case.name,
                finding.answer,
                finding.bits,
                f"{finding.lost:.1f}",
                "" if finding.textbook is None else f"{finding.textbook:.1f}",
                "yes" if finding.right else "NO",
                finding.case.why,
            ]
            for finding in findings
        ],
    }
