"""Statement and certificate, written and read; what people type; and the checker as a judge.

It uses the language and the prover's classes of proofs, and calls the checker; the exporter to Coq
also reads what the checker has read. Begin with `write.py`; `judge.py` is where verdicts come from.
"""
