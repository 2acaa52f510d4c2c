"""The numbers of the paper's labels, from a source and what LaTeX says of it."""

from __future__ import annotations

import pytest

from verify.paper.commands.numbering import kinds, numbers

SOURCE = r"""
\section{One}
\label{SECT}
\label{}
% \label{hidden}
\begin{theor} \label{THEOR}
\begin{align} x \label{EQUAT} \end{align}
\end{theor}
\begin{align}
\begin{array}{c} x \end{array} \label{SYSTEM}
\end{align}
\begin{appendices} \section{More} \label{APPEN} \end{appendices}
"""
AUXILIARY = r"""
\newlabel{SECT}{{1}{1}}
\newlabel{THEOR}{{2}{1}}
\newlabel{EQUAT}{{1.1}{1}}
\newlabel{SYSTEM}{{1.2}{1}}
\newlabel{APPEN}{{A}{2}}
"""


def test_each_label_is_called_as_in_print() -> None:
    assert numbers(SOURCE, AUXILIARY) == {
        "SECT": "Section 1",
        "THEOR": "Theorem 2",
        "EQUAT": "(1.1)",
        "SYSTEM": "(1.2)",
        "APPEN": "Appendix A",
    }


def test_a_label_without_a_number_is_an_error() -> None:
    with pytest.raises(KeyError, match="EQUAT"):
        numbers(SOURCE, AUXILIARY.replace("EQUAT", "OTHER"))


def test_a_label_outside_of_all_is_that_of_a_section() -> None:
    assert dict(kinds(r"\begin{center} \label{X} \end{center}")) == {"X": "Section"}
