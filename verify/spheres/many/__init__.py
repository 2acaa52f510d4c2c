"""Many balls followed rigorously: with walls, gravity, or a box that repeats itself.

Begin with `system.py`, then `motion.py` and `queue.py`. What ends a run is decided in `decide.py`:
three balls that collapse with nobody near, or groups of balls that never meet again.
"""
