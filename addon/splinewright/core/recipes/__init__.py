"""Recipes: shapes that come about from a few numbers and points, which stay what one edits."""
