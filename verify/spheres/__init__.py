"""Hard balls followed rigorously: the flow, single scenes, maps of many.

It uses the language, the prover and the wire, and calls the checker of maps. Begin with
`flow/law.py`, then `flow/follow.py`.
"""
