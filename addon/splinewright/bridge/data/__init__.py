"""Data-blocks and settings: where definitions are stored, and the state of the open file."""
