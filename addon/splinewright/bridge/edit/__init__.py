"""Shapes are joined, split, moved, baked, and given other pieces."""
