"""A road through measured points with noise: fitted, divided, and with its edges.

    python track.py
"""

import numpy as np
from numpy.typing import NDArray

import splinecore as sc


def measured(count: int = 400, noise: float = 0.05) -> NDArray[np.float64]:
    """Points of a bend, in meters, as a receiver gives them."""
    t = np.linspace(0.0, 1.0, count)
    places: NDArray[np.float64] = np.stack([100.0 * t, 30.0 * np.sin(np.pi * t) ** 2], axis=1)
    places += np.random.default_rng(1).normal(0.0, noise, places.shape)
    return places


def fitted(points: NDArray[np.float64], tolerance: float) -> sc.NurbsCurve:
    """The axis of the road; with noise the ends are free."""
    axis, error = sc.fit.approximate(points, tolerance=tolerance, fixed_ends=False)
    print(f"{len(axis.points)} control points, at most {error:.3f} m from {len(points)} measured ones")
    return axis


def main() -> None:
    axis = fitted(measured(), tolerance=0.3)
    stations = axis.divide_by_length(20.0)
    for u, place, bend in zip(stations, axis.evaluate(stations), axis.signed_curvature(stations)):
        print(f"u = {u:.3f}: x = {place[0]:6.2f}, y = {place[1]:5.2f}, curvature {bend:+.4f} / m")
    edges: list[sc.NurbsCurve] = [edge for side in (3.5, -3.5) for edge in axis.offset(side, tolerance=0.01)]
    print(f"{axis.length():.2f} m long, edges {' and '.join(f'{edge.length():.2f}' for edge in edges)} m")


if __name__ == "__main__":
    main()
