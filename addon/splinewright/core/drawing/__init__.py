"""Drawing by clicks: contours, guides, and places to snap to."""
