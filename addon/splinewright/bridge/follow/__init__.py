"""Shapes that are made from other objects follow them."""
