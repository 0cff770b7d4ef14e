"""Lessons in separate scenes: their shapes, where a learner is, and what was answered."""
