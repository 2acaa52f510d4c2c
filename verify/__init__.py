"""Verified constants and recursion of a theorem on the collapse of inelastic hard spheres."""

__version__ = "0.1.0"
