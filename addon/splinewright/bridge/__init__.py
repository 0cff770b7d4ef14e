"""Between definitions and Blender's data: store, read and write. Definitions never come from what was written."""
