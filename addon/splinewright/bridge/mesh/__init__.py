"""Meshes that are written from patches, and what of a mesh the user owns."""
