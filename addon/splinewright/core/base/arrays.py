"""What numpy does slowly with small arrays."""


def are_equal(a, b):
    """As np.array_equal() of two arrays."""
    return a.shape == b.shape and bool((a == b).all())
