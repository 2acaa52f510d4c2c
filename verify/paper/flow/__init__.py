"""The flow of three inelastic hard spheres, one collision at a time, in inner products."""
