#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "splinecore/base/approximation.hpp"
#include "splinecore/base/interval.hpp"
#include "splinecore/formula/taylor.hpp"
#include "splinecore/patch/nurbs_patch.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Mixed derivatives k, l <= 2 at a corner, at [3 * k + l].
using CornerJet = std::array<glm::dvec3, 9>;

/// The surface that formulas describe: points, and jets which are kept.
class FormulaSurface {
 public:
  FormulaSurface(std::span<const Formula> coordinates, const std::array<Interval, 2>& domains);

  /// @throws InvalidShape naming the parameters where a formula is undefined.
  void evaluate(std::span<const double> u, std::span<const double> v, std::span<glm::dvec3> out);

  const CornerJet& jet(double u, double v);

 private:
  std::span<const Formula> coordinates_;
  glm::dvec2 scale_;
  std::vector<Taylor> expansions_;
  std::vector<double> values_;
  std::map<std::pair<double, double>, CornerJet> known_;
};

/// A biquintic C2 patch within the tolerance of the formulas.
/// @throws InvalidShape, ToleranceNotReached as patch_from_formulas() does.
Approximation<NurbsPatch> fitted_patch(std::span<const Formula> coordinates, const std::array<Interval, 2>& domains,
                                       double tolerance);

}  // namespace splinecore
#pragma GCC visibility pop
