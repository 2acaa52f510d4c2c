"""One scene: what it is, what decides it, and what is told of it."""
