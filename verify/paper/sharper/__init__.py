"""A sharper theorem than the paper's: any state near enough to a collapse collapses."""
