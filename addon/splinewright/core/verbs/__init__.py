"""What changes curves and patches piece by piece: knots, degrees, splits, forms."""
