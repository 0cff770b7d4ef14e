"""What is measured of shapes and shown over them, kept until they change."""
