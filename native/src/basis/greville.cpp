#include "splinecore/basis/greville.hpp"

#include <cstddef>

namespace splinecore {

std::vector<double> greville_abscissae(const KnotVector& knots) {
  const auto all = knots.unrolled();
  const auto degree = static_cast<std::size_t>(knots.degree());
  std::vector<double> abscissae;
  for (std::size_t i = 0; i < static_cast<std::size_t>(knots.count()); ++i) {
    if (degree == 0) {
      abscissae.push_back(0.5 * all[i] + 0.5 * all[i + 1]);
      continue;
    }
    const auto own = all.subspan(i + 1, degree);
    double sum = 0.0;
    for (const double knot : own) sum += knot / static_cast<double>(degree);
    abscissae.push_back(own.front() == own.back() ? own.front() : sum);
  }
  return abscissae;
}

}  // namespace splinecore
