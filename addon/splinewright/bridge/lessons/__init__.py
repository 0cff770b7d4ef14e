"""Lessons in scenes of their own: their shapes, where a learner is, and what was answered."""
