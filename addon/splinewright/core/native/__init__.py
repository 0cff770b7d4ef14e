"""Blender's own splines, as numbers: their rules, and the ways to and from ours."""
