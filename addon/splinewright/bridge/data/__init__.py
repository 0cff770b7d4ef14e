"""Data-blocks and settings: where definitions are stored, and what is remembered of the open file."""
