"""The spectral claims of the paper: Section 5 with its appendix, and Section 4.1-4.2.

One file per step, in the paper's order. `printed` has the displayed objects that everything else
is built from, `spectrum` assembles the rows. Nothing in this package proves anything.
"""
