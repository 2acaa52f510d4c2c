"""The set as printed, with > in the hypothesis: from each of its states the particles collapse.

Only the argument of the paper needs a change, not its constants: the sharper theorem applies to
every state of the set. `numbers` has what it is applied to, `printed_set` the set itself.
"""
