"""What may go wrong at a door of Splinewright, and how it is said."""

import numpy as np

#: What a modeller is told of; anything else is a mistake of ours and shows its traceback.
FAILURES = (ValueError, TypeError, ArithmeticError, RuntimeError, OSError, MemoryError, np.linalg.LinAlgError)


def sentence(error):
    """A failure in words."""
    if isinstance(error, MemoryError):
        return "there is not enough memory"
    return getattr(error, 'strerror', None) or str(error)
