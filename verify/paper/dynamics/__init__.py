"""One collision to the next, exactly: what every theorem on the recursion starts from."""
