"""The paper, in the paper's order: letters are its letters, labels are its labels.

Source: T. Dolmaire and J. J. L. Velázquez, "Collapse of inelastic hard spheres in dimension
d >= 2". Nothing in this package proves anything.
"""
