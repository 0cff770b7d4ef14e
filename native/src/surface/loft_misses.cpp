#include "loft_misses.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <limits>
#include <vector>

#include "base/length.hpp"
#include "base/rounding.hpp"
#include "splinecore/basis/samples.hpp"
#include "splinecore/curve/distance.hpp"

namespace splinecore {

namespace {

/// The row of a spline at a sample, and how far rounding may take what is summed there.
struct RowAt {
  std::vector<glm::dvec4> row;
  double rounding;
};

RowAt row_at(const RowSpline& spline, const Samples& samples, std::size_t sample, std::size_t width) {
  const auto count = static_cast<std::size_t>(spline.knots.count());
  RowAt made{std::vector<glm::dvec4>(width, glm::dvec4(0.0)), 0.0};
  auto next = static_cast<std::size_t>(samples.first(sample));
  for (const double weight : samples.weights(sample)) {
    const double* const from = &spline.controls[(next++ % count) * 4 * width];
    double largest = 0.0;
    for (std::size_t i = 0; i < width; ++i) {
      const glm::dvec4 control(from[4 * i], from[4 * i + 1], from[4 * i + 2], from[4 * i + 3]);
      made.row[i] += weight * control;
      largest = std::max(largest, length_of(glm::dvec3(control)));
    }
    made.rounding += kRoundingOfStep * std::abs(weight) * largest;
  }
  return made;
}

/// How far curves with these homogeneous points can be from each other, where all weights are positive.
double bound_of(const std::vector<glm::dvec4>& made, const std::vector<glm::dvec4>& wanted) {
  double off = 0.0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < made.size(); ++i) {
    const glm::dvec4 by = made[i] - wanted[i];
    off = std::max({off, length_of(glm::dvec3(by)), std::abs(by.w)});
    least = std::min({least, made[i].w, wanted[i].w});
  }
  return least > 0.0 ? off / least : std::numeric_limits<double>::infinity();
}

}  // namespace

double largest_miss(const LoftSections& sections, const RowSpline& spline, std::span<const double> parameters) {
  const Samples samples = Samples::make(spline.knots, parameters.first(sections.rows.size()));
  double largest = 0.0;
  for (std::size_t j = 0; j < sections.rows.size(); ++j) {
    const std::vector<glm::dvec4>& wanted = sections.rows[j].near;
    const RowAt made = row_at(spline, samples, j, wanted.size());
    if (bound_of(made.row, wanted) + made.rounding <= kRoundingOfPlace) continue;
    const double off = made.rounding + largest_distance(NurbsCurve::from_homogeneous(sections.knots, made.row),
                                                        NurbsCurve::from_homogeneous(sections.knots, wanted));
    if (!(off <= kRoundingOfPlace)) largest = std::max(largest, std::isnan(off) ? std::numeric_limits<double>::infinity() : off);
  }
  return largest;
}

double farthest_control(const RowSpline& spline) {
  double largest = 0.0;
  for (std::size_t i = 0; i + 3 < spline.controls.size(); i += 4) {
    const double w = spline.controls[i + 3];
    for (int axis = 0; axis < 3 && w != 0.0; ++axis) largest = std::max(largest, std::abs(spline.controls[i + axis] / w));
  }
  return largest;
}

}  // namespace splinecore
