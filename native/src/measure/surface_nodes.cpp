#include "surface_nodes.hpp"

#include <algorithm>
#include <span>

#include "kronrod_grid.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/basis/bernstein.hpp"

namespace splinecore {

SurfaceNodes::Functions::Functions(std::size_t count) : values(kGridNodes * count), slopes(values.size()) {
  const int degree = static_cast<int>(count) - 1;
  std::vector<double> less(count - 1);
  for (std::size_t i = 0; i < kGridNodes; ++i) {
    const double at = grid_node(i).at;
    const double rest = i < kKronrod21.size() ? 1.0 - at : kKronrod21[kGridNodes - 1 - i].at;
    bernstein(degree, at, rest, std::span(values).subspan(i * count, count));
    bernstein(degree - 1, at, rest, less);
    for (std::size_t k = 0; k < count; ++k) {
      slopes[i * count + k] = degree * ((k > 0 ? less[k - 1] : 0.0) - (k + 1 < count ? less[k] : 0.0));
    }
  }
}

void SurfaceNodes::start_row(const BernsteinNet<glm::dvec4>& net, std::size_t i) {
  breathe(8 * net.values.size() + kGridNodes * (12 * net.columns + 80));
  std::ranges::fill(points_, glm::dvec4(0.0));
  std::ranges::fill(slopes_, glm::dvec4(0.0));
  for (std::size_t k = 0; k < net.rows; ++k) {
    for (std::size_t j = 0; j < net.columns; ++j) {
      points_[j] += u_.values[i * net.rows + k] * net.at(k, j);
      slopes_[j] += u_.slopes[i * net.rows + k] * net.at(k, j);
    }
  }
}

SurfacePlace SurfaceNodes::at(const BernsteinNet<glm::dvec4>& net, std::size_t i, std::size_t j) {
  if (j == 0) start_row(net, i);
  glm::dvec4 point(0.0);
  glm::dvec4 along_u(0.0);
  glm::dvec4 along_v(0.0);
  for (std::size_t k = 0; k < net.columns; ++k) {
    const double value = v_.values[j * net.columns + k];
    point += value * points_[k];
    along_u += value * slopes_[k];
    along_v += v_.slopes[j * net.columns + k] * points_[k];
  }
  const glm::dvec3 s = glm::dvec3(point) / point.w;
  return {s, (glm::dvec3(along_u) - along_u.w * s) / point.w, (glm::dvec3(along_v) - along_v.w * s) / point.w};
}

std::vector<SurfaceNodes> nodes_of(std::span<const NurbsPatch> patches) {
  std::vector<SurfaceNodes> nodes;
  for (const NurbsPatch& patch : patches) {
    const auto points = [&](Axis axis) { return static_cast<std::size_t>(patch.knot_vector(axis).degree()) + 1; };
    nodes.emplace_back(points(Axis::u), points(Axis::v));
  }
  return nodes;
}

}  // namespace splinecore
