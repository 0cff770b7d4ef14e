"""What there is to see of a shape beside its faces: lines and points of float64, of definitions alone."""
