"""Figures of what a view shows: objects, letters, and what hides them."""
