"""Planes of scenes: boxes decided one by one, the border between them, and the log of both."""
