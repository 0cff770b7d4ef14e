"""The net of a definition, as numbers."""
