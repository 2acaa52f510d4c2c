"""Planes of scenes: each point of a rectangle is a scene, and boxes of them are decided."""
