#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "near_curve.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A number or vector, and how much of it may be rounding.
template <class Value>
struct Rounded {
  Value value{0.0};
  double rounding = 0.0;
};

/// Derivatives of a curve near the origin where it is slow: of differences of the points as they were given, from the
/// one that is nearest, so that points that are one leave nothing and near ones lose no digit.
class SlowPlaces {
 public:
  SlowPlaces(const NurbsCurve& curve, const NearCurve& near);

  /// Whether what derivatives() gives of the first one might be rounding for more than a little of it.
  bool is_slow(const glm::dvec3& first, double span) const;

  /// Derivatives 0 to `order`; the first of these is from some point on.
  std::vector<Rounded<glm::dvec3>> jet(double u, Side side, int order) const;

 private:
  NurbsCurve near_;
  std::vector<glm::dvec3> points_;  ///< as given, but for a power of two
  double slow_;
};

}  // namespace splinecore
#pragma GCC visibility pop
