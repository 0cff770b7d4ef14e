#pragma once

#include <array>
#include <optional>
#include <vector>

#include "splinecore/conic/plane.hpp"

namespace splinecore {

/// What the real points of a conic are.
enum class ConicType {
  circle, ellipse, parabola, hyperbola, crossing_lines, parallel_lines, line, point, empty
};

/// A conic in the coordinates of its plane.
///
/// Of an ellipse and a hyperbola `center` is the center, `axis` the unit vector of the major or
/// the transverse axis, `first` and `second` the half lengths along it and across. Of a parabola
/// `center` is the vertex, `axis` points to the focus, `first` is the focal length. Of crossing
/// lines `axis` first ± across second are their directions; of parallel ones `second` is half
/// their distance. Otherwise lengths are 0.
struct ConicShape {
  ConicType type = ConicType::empty;
  glm::dvec2 center{0.0, 0.0};
  glm::dvec2 axis{1.0, 0.0};
  double first = 0.0;
  double second = 0.0;
};

/// a x² + b xy + c y² + d x + e y + f = 0 in the coordinates of a plane (lecture row S1).
class ImplicitConic {
 public:
  /// Multiplying all coefficients by a number changes nothing but the coefficients.
  ///
  /// The type is decided relative to the terms that cancel in each decision: a sum within
  /// 64 ulp of its largest term is zero. So rounded coefficients of a parabola, a circle or a pair
  /// of lines near the plane's origin are recognized.
  /// @throws InvalidShape if a number is not finite, all coefficients are zero, or the shape
  ///         reaches beyond the range of numbers.
  static ImplicitConic make(const std::array<double, 6>& coefficients, const Plane& plane = {});

  const std::array<double, 6>& coefficients() const noexcept { return coefficients_; }
  const Plane& plane() const noexcept { return plane_; }
  ConicType type() const noexcept { return shape_.type; }
  const ConicShape& shape() const noexcept { return shape_; }

  friend bool operator==(const ImplicitConic& a, const ImplicitConic& b) noexcept {
    return a.coefficients_ == b.coefficients_ && a.plane_ == b.plane_;
  }

 private:
  ImplicitConic(const std::array<double, 6>& coefficients, const Plane& plane, const ConicShape& shape)
      : coefficients_(coefficients), plane_(plane), shape_(shape) {}

  std::array<double, 6> coefficients_;
  Plane plane_;
  ConicShape shape_;
};

/// The center, a parabola's vertex, a point of a line; nothing where the conic is empty.
std::optional<glm::dvec3> center(const ImplicitConic& conic);

/// The shape's axis and the direction across it, both unit vectors in space.
std::array<glm::dvec3, 2> axis_directions(const ImplicitConic& conic);

/// Two of an ellipse or a hyperbola, one of a circle or a parabola, none of anything else.
std::vector<glm::dvec3> foci(const ImplicitConic& conic);

/// 0 of a circle, 1 of a parabola; nothing where the conic is degenerate.
std::optional<double> eccentricity(const ImplicitConic& conic);

}  // namespace splinecore
