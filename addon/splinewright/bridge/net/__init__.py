"""The net as a Blender object, and the shape that follows it."""
