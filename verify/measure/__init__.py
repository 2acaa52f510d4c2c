"""Measurements: speed against error, and hard cases."""
