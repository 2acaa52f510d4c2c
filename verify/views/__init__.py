"""What people see of a statement and its outcome; decides nothing.

A view reads a statement with its outcome, or records of `findings.py`, which commands fill. What it
says of the paper stands in the `Publication` that it is given. It uses the language and the prover.

Begin with `screen.py` for the terminal, `document.py` for JSON, `page/build.py` for the page.
"""
