"""Plots of certified enclosures: every band and box is drawn from balls over a whole cell."""
