"""What surfaces over curves are made of: sections, rails, rims, caps, holes."""
