"""What is said: terms, claims, contexts, statements, arguments; nothing is proved here.

It uses the standard library only. Begin with `terms.py`, then `statement.py`.
"""
