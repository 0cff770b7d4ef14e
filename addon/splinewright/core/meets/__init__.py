"""Where curves and surfaces meet, touch, or are projected."""
