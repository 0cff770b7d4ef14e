"""What is drawn by clicks: contours, guides, and places to snap to."""
