"""Measurements: `bench` and `stress`. It may use every other room but the command line."""
