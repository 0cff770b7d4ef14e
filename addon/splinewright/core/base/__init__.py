"""Numbers, units, failures, and the one way to the library."""
