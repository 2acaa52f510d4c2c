"""The full dynamics lies above a map of two numbers: where that ends, so do the collisions."""
