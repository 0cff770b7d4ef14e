"""Curves that are written from curves, and what of their splines the user owns."""
