"""Control points that are animated by shape keys."""
