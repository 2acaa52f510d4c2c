"""A scene: three spheres with given centres and velocities, and what becomes of them."""
