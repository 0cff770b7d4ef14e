"""Measures of shapes that are shown over them, kept until they change."""
