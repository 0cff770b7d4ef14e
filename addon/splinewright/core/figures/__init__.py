"""Figures: what a view shows as exact paths on a page, and the files that hold them."""
