"""The numbers that results are made of."""

import numpy as np

import splinecore as sc


def numbers_of(result):
    """Every number of a shape, an array, or of a list of them, as float arrays."""
    if isinstance(result, (int, float, np.ndarray, np.generic)):
        return [np.asarray(result, float)]
    if isinstance(result, dict):
        result = list(result.values())
    if isinstance(result, (list, tuple)):
        return [array for item in result for array in numbers_of(item)]
    return [array for name, part in vars(type(result)).items() if isinstance(part, property)
            for array in numbers_of(property_of(result, name))]


def property_of(shape, name):
    try:
        return getattr(shape, name)
    except sc.Error:
        return None


def is_free_of(result, is_bad):
    """Whether no number is as `is_bad`, numpy's isnan or isinf, says."""
    return not any(is_bad(array).any() for array in numbers_of(result))
