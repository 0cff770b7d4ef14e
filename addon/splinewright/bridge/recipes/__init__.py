"""Recipes as data-blocks store them, what they follow, and when they are late."""
