"""Shapes as formulas, and as steps of the algorithms that evaluate them."""
