"""The file for Coq: definitions of the data, and the theorem that follows from them."""

from __future__ import annotations

from collections.abc import Callable, Collection

from verify import check
from verify.wire.coq.proofs import Proofs
from verify.wire.coq.readable import Readable, readable
from verify.wire.coq.reading import NotAcceptedError, Reading, label, read
from verify.wire.coq.statement import listed

ASSUMPTIONS = "\nPrint Assumptions proved.\n"


#: What a file ends in, instead of the theorem that the statement is true.
Ending = Callable[[Reading], list[str]]


def export(
    folder: check.Folder,
    *,
    ordinary: bool = False,
    rows: Callable[[Reading], Collection[str] | None] = lambda _: None,
    ending: Ending | None = None,
) -> str:
    """A Coq file that proves the statement from the certificate; also in ordinary notation.

    There it has the ``rows`` of the statement, or all of them. With ``ending`` the
    file ends in what that says of the statement.

    Raises:
        NotAcceptedError: for what is no certificate that proves its statement.
    """
    reading = read(folder)
    if reading.complaints:
        raise NotAcceptedError("; ".join(reading.complaints))
    if ending is not None:
        more = ending(reading)
    else:
        form = Readable(reading)
        more = [*(readable(reading, form, rows(reading)) if ordinary else ()), ASSUMPTIONS]
    return "\n".join((head(reading), *data(reading), *theorem(reading), *more))


def head(reading: Reading) -> str:
    """What it is about, and the libraries."""
    lines = [
        f"(* {printable(reading.theorem)}: data for the checker in Coq, written from a",
        f"   statement.json with the SHA-256 {reading.digest}, which Coq",
        "   does not compute. *)",
        "From Coq Require Import ZArith QArith List.",
        "From Verify Require Import Meaning Clearing Kernel Checker Accepted.",
        "Import ListNotations.",
        "Open Scope positive_scope.",
        "",
    ]
    return "\n".join(lines)


def printable(text: str) -> str:
    """A text that cannot end a comment, nor begin a string in one."""
    return "".join(letter if letter.isalnum() or letter in " .,-_/" else "?" for letter in text)


def data(reading: Reading) -> list[str]:
    """The definitions, with the names of things beside them."""
    found, kernel, statement = Proofs(reading), reading.kernel, reading.statement
    steps = reading.certificate["steps"]
    proofs = [found.step(step) for step in steps]  # before the rest: it takes numbers for facts
    names = {term: name for name, term in kernel.names.items()}
    nodes = [(found.node(i), f"{i + 1} {names.get(i, '')}") for i in range(len(kernel.nodes))]
    contexts = [(found.context(context), name) for name, context in kernel.contexts.items()]
    rows = [(found.row(row), row.name) for row in statement.rows.values()]
    cited = [(found.fact(name, fact), name) for name, fact in reading.cited.items()]
    labels = [label(step) for step in steps]
    own = listed(f"{i}%nat" for name, i in found.contexts.items() if ":" not in name)
    constants = listed(found.term(kernel.names[name]) for name in reading.reader.own)
    values = listed(map(found.term, reading.cited_constants))
    whole = f"the_nodes the_contexts\n  {own}\n  {constants}\n  the_rows the_citations\n  {values}"
    return [
        defined("the_nodes : list node", nodes),
        defined("the_contexts : list context", contexts),
        defined("the_rows : list row", rows),
        defined("the_citations : list (positive * (nat * claim))", cited),
        f"Definition the_statement : statement := Statement {whole}.\n",
        defined("the_steps : list step", list(zip(proofs, labels, strict=True))),
        defined("the_enclosures : list ends", [(text, "") for text in found.enclosures()]),
        "Definition the_certificate : certificate :=",
        f"  Certificate {listed(found.shared())} the_steps the_enclosures.\n",
    ]


def defined(name: str, items: list[tuple[str, str]]) -> str:
    """The definition of a list, each item on a line, with a comment."""
    lines = [
        f"  {text}{'' if i == len(items) else ';'}{f'  (* {note.strip()} *)' if note else ''}"
        for i, (text, note) in enumerate(items, 1)
    ]
    return "\n".join((f"Definition {name} := [", *lines, "].\n"))


def theorem(reading: Reading) -> list[str]:
    """What Coq proves: the statement is true, if what it cites is, and so are the enclosures."""
    citing = "citations_true the_statement -> " if reading.cites else ""
    closing = "" if reading.cites else "\n  apply no_citations; vm_compute; reflexivity."
    return [
        "Theorem accepted : accepts the_statement the_certificate = true.",
        "Proof. vm_cast_no_check (eq_refl true). Qed.",
        f"Theorem proved : {citing}true_statement the_statement.",
        f"Proof.\n  apply (accepts_sound _ _ accepted).{closing}\nQed.",
        "Definition enclosed_values := enclosures_sound _ _ accepted.",
    ]
