"""Lessons: their files, measures of the shapes of a step, and whether an answer is right."""
