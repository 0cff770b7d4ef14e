#include "straight.hpp"

namespace splinecore {

std::vector<double> straight_controls(const KnotVector& knots) {
  const auto degree = static_cast<std::size_t>(knots.degree());
  const auto chain = knots.knots();
  const Interval domain = knots.domain();
  std::vector<double> controls(static_cast<std::size_t>(knots.count()));
  for (std::size_t i = 0; i < controls.size(); ++i) {
    for (std::size_t k = 1; k <= degree; ++k) controls[i] += (chain[i + k] - domain.start) / domain.length();
    controls[i] /= static_cast<double>(degree);
  }
  return controls;
}

}  // namespace splinecore
