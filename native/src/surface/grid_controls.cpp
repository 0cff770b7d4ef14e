#include "grid_controls.hpp"

#include <cstddef>

#include "fit/row_spline.hpp"
#include "greville.hpp"

namespace splinecore {

std::vector<double> grid_controls(const KnotVector& knots, const std::vector<double>& values) {
  const std::vector<double> at = greville_places(knots);
  const std::size_t width = at.size();
  const std::vector<double> all(knots.knots().begin(), knots.knots().end());
  std::vector<double> found = values;
  for (int direction = 0; direction < 2; ++direction) {
    RowConditions given{at, {}, {}, {}};
    for (std::size_t i = 0; i < width; ++i) given.rows.emplace_back(found.begin() + i * width, found.begin() + (i + 1) * width);
    const std::vector<double> controls = spline_through(given, knots.degree(), Closing::open, all).controls;
    for (std::size_t i = 0; i < width; ++i) {
      for (std::size_t j = 0; j < width; ++j) found[j * width + i] = controls[i * width + j];
    }
  }
  return found;
}

}  // namespace splinecore
