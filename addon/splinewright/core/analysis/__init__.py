"""What is measured of shapes and shown over them: combs, frames, distances, polygons."""
