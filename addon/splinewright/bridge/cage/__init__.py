"""The objects in which control points are edited: a mesh for patches, a curve for curves."""
