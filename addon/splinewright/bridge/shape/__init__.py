"""A shape as a whole: made, read, written, told when others changed it."""
