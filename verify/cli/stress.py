"""Run the hard cases: the precision each needs, the digits it loses, and whether it is right."""

from __future__ import annotations

import json
import sys
from argparse import ArgumentParser, Namespace
from typing import Any

from verify import stress
from verify.files import print_document, write_all
from verify.stress import Finding
from verify.views.columns import print_tables


def add_arguments(parser: ArgumentParser) -> None:
    """The options."""
    parser.add_argument("--quick", action="store_true", help="leave out the longest cases")
    parser.add_argument("--json", action="store_true", help="one JSON document on stdout")
    parser.add_argument("--out", metavar="DIR", help="write stress.json there")


def run(options: Namespace) -> int:
    """Run the cases; return 0 if every answer is right, else 1."""
    findings = []
    for finding in stress.run(options.quick):
        findings.append(finding)
        if sys.stderr.isatty():
            print(f"{finding.case.name} …", file=sys.stderr)
    document = {"command": "stress", "tables": {"cases": table(findings)}}
    if options.out is not None:
        text = json.dumps(document, ensure_ascii=False, indent=1, sort_keys=True) + "\n"
        write_all("--out", options.out, {"stress.json": text.encode()})
    if options.json:
        print_document(document)
    else:
        print_tables(document)
    return 0 if all(finding.right for finding in findings) else 1


def table(findings: list[Finding]) -> dict[str, Any]:
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
