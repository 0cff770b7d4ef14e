"""Joints of curves and seams of patches: how continuous they are, and what holds them."""
