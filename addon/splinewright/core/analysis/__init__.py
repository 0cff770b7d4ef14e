"""Measures of shapes that are shown over them: combs, frames, distances, polygons."""
