#include "going_on.hpp"

#include <cmath>
#include <cstddef>
#include <utility>

#include "base/length.hpp"

namespace splinecore {

std::vector<glm::dvec4> scaled(double factor, std::vector<glm::dvec4> row) {
  for (glm::dvec4& p : row) p *= factor;
  return row;
}

double speed_of(std::span<const glm::dvec4> row, std::span<const glm::dvec4> derivative) {
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const double w = row[i].w;
    if (w == 0.0) continue;
    sum += length_of((glm::dvec3(derivative[i]) - derivative[i].w / w * glm::dvec3(row[i])) / w);
    count += 1.0;
  }
  return count == 0.0 ? 0.0 : sum / count;
}

LeavingRows going_on(std::span<const glm::dvec4> edge, const LeavingRows& out, double k) {
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < edge.size(); ++i) {
    if (edge[i].w == 0.0) continue;
    sum += out[0][i].w / edge[i].w;
    count += 1.0;
  }
  const double level = -k * sum / count;
  LeavingRows found;
  for (std::size_t order = 1; order <= out.size(); ++order) {
    std::vector<glm::dvec4> row = scaled(std::pow(level, order), {edge.begin(), edge.end()});
    double choose = 1.0;
    for (std::size_t m = 1; m <= order; ++m) {
      choose *= static_cast<double>(order - m + 1) / static_cast<double>(m);
      const double factor = choose * std::pow(level, order - m) * std::pow(k, m);
      for (std::size_t i = 0; i < row.size(); ++i) row[i] += factor * out[m - 1][i];
    }
    found.push_back(std::move(row));
  }
  return found;
}

}  // namespace splinecore
