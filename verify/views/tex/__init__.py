"""Statements as LaTeX: words, formulas that break, and the document."""
