"""The flow of hard balls: its law, what it conserves, and a scene followed along it."""
