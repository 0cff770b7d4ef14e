#include "raised_knots.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "splinecore/base/errors.hpp"

namespace splinecore {

KnotVector raised_knots(const KnotVector& knots, int degree, int less_smooth) {
  std::vector<double> made(static_cast<std::size_t>(degree) + 1, knots.domain().start);
  for (const double knot : knots.knots()) {
    if (!(knot > knots.domain().start && knot < knots.domain().end)) continue;
    const int times = multiplicity(knots, knot);
    if (times > knots.degree()) throw InvalidShape("a side, or a derivative across it, jumps");
    const int copies = std::min(degree, degree - knots.degree() + times + less_smooth);
    if (made.back() != knot) made.insert(made.end(), static_cast<std::size_t>(copies), knot);
  }
  made.insert(made.end(), static_cast<std::size_t>(degree) + 1, knots.domain().end);
  return KnotVector::make(degree, std::move(made));
}

}  // namespace splinecore
