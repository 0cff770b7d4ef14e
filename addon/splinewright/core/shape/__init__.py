"""A definition: the exact pieces of a shape on one pool of points, its parameters and places."""
