"""Numbers only: definitions, starting shapes, file formats. Nothing here knows Blender."""
