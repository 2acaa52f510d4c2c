"""The full dynamics lies below a map of two numbers: while that one goes on, so do collisions."""
