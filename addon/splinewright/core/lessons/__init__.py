"""Lessons: what their files say, what is measured of the shapes of a step, and whether an answer is right."""
