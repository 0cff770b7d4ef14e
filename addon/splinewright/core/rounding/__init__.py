"""Edges of surfaces in whose place a ball rolls (lecture row S21)."""
