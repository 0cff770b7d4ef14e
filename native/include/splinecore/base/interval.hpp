#pragma once

namespace splinecore {

/// The parameters from start to end, both included.
struct Interval {
  double start = 0.0;
  double end = 1.0;

  double length() const noexcept { return end - start; }
  double middle() const noexcept { return start + 0.5 * (end - start); }

  /// The parameter at t in [0, 1]: exactly the ends at 0 and 1, and never outside.
  double at(double t) const noexcept {
    if (t == 0.0) return start;
    if (t == 1.0) return end;
    const double u = (1.0 - t) * start + t * end;
    return u < start ? start : u > end ? end : u;
  }

  friend bool operator==(const Interval&, const Interval&) = default;
};

/// Which limit is taken where a value jumps: at a knot a curve may have two.
enum class Side { right, left };

/// What evaluation does at a point at infinity: refuse it, or mark it with NaN.
enum class AtInfinity { raise, nan };

}  // namespace splinecore
