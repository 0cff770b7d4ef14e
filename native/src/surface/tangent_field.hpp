#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "splinecore/basis/knot_vector.hpp"
#include "splinecore/curve/nurbs_curve.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Unit vectors in the tangent plane of a neighbor at a place of a border: away from the neighbor, and along the border.
struct PlaneFrame {
  glm::dvec3 out;
  glm::dvec3 along;
};

/// Vectors along a border that lie in the tangent planes of the patch beyond it: a(s) out + b(s) along.
class TangentField {
 public:
  /// @param border     run through over its domain, along v_start of the neighbor or a part of that
  /// @param at         where curves cross the border, as a family has it of its others
  /// @param across     their derivatives there, into the network
  /// @param name       of the neighbor, and `crossing` of a curve without its index, for what is refused
  /// @throws InvalidShape if there is no tangent plane, or a curve turns back
  TangentField(NurbsCurve border, NurbsPatch neighbor, std::vector<double> at, std::span<const glm::dvec3> across,
               std::string name, const std::string& crossing);

  std::vector<glm::dvec3> vectors(std::span<const double> at) const;

  std::vector<PlaneFrame> frames(std::span<const double> at) const;
  PlaneFrame frame(double at) const { return frames({&at, 1}).front(); }

  /// Adds to the derivatives of a and b at an end of the domain; where curves cross they stay.
  void bend(bool is_end, const glm::dvec2& slopes);

  const NurbsCurve& border() const { return border_; }
  const std::string& name() const { return name_; }

 private:
  NurbsCurve through_crossed() const;

  NurbsCurve border_;
  NurbsPatch neighbor_;
  NurbsCurve side_;
  std::string name_;
  std::vector<double> at_;
  std::vector<glm::dvec2> crossed_;                    ///< a and b where curves cross
  std::array<std::optional<glm::dvec2>, 2> slopes_{};  ///< theirs at the ends, where they are set
  NurbsCurve parts_;                                   ///< a and b as coordinates
};

}  // namespace splinecore
#pragma GCC visibility pop
