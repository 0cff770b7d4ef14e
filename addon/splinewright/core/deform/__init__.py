"""What moves shapes other than point by point: pulls, turns, mirrors, deformations."""
