"""Blender's own curves and surfaces, in and out."""
