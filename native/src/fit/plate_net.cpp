#include "plate_net.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "basis/banded_cholesky.hpp"
#include "plate_energy.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"

namespace splinecore {

namespace {

/// So many numbers a row of the system has, if its rows are those of a direction.
std::size_t width_of(const PlateAxis& outer, const PlateAxis& inner) {
  const auto free = [](const PlateAxis& axis) {
    return static_cast<std::size_t>(axis.knots.count()) - axis.held.start - axis.held.end;
  };
  const auto reach = [&](const PlateAxis& axis, int times) {
    const std::size_t most = std::max<std::size_t>(free(axis), 1) - 1;
    return std::min(static_cast<std::size_t>(axis.knots.degree() * times), most);
  };
  const std::size_t along = inner.knots.periodic() ? free(inner) - 1 : reach(inner, 1);
  return reach(outer, outer.knots.periodic() ? 2 : 1) * free(inner) + along + 1;
}

std::vector<glm::dvec3> exchanged(std::span<const glm::dvec3> net, std::size_t rows) {
  const std::size_t columns = net.size() / rows;
  std::vector<glm::dvec3> out(net.size());
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < columns; ++j) out[j * rows + i] = net[i * columns + j];
  }
  return out;
}

}  // namespace

PlateNet::PlateNet(const PlateAxis& u, const PlateAxis& v, std::vector<glm::dvec3> net)
    : is_swapped_(width_of(v, u) < width_of(u, v)), outer_(is_swapped_ ? v : u, true),
      inner_(is_swapped_ ? u : v, false) {
  if (!is_free()) return;
  constexpr double kMost = 0x1p27;
  width_ = is_swapped_ ? width_of(v, u) : width_of(u, v);
  if (static_cast<double>(outer_.free() * inner_.free()) * static_cast<double>(width_) > kMost) {
    throw InvalidShape("a net of " + std::to_string(u.knots.count()) + " x " + std::to_string(v.knots.count()) +
                       " control points is too large to be faired");
  }
  pull_ = plate_bending(outer_, inner_, is_swapped_ ? exchanged(net, inner_.count) : std::move(net));
}

/// Of the control points that may move, in rows of the upper triangle.
std::vector<double> PlateNet::system(double factor) const {
  std::vector<double> rows(outer_.free() * inner_.free() * width_, 0.0);
  for (std::size_t i = 0; i < outer_.count; ++i) {
    if (outer_.is_held(i)) continue;
    for (std::size_t k = 0; k < outer_.bands[0].width; ++k) {
      if (!outer_.has(i, k) || outer_.is_held(outer_.partner(i, k))) continue;
      const std::size_t a = outer_.partner(i, k);
      const double plain = outer_.bands[0].at(i, k);
      const double once = 2.0 * factor * outer_.bands[1].at(i, k);
      const double twice = factor * outer_.bands[2].at(i, k);
      breathe(8 * inner_.bands[0].width * inner_.count);
      for (std::size_t j = 0; j < inner_.count; ++j) {
        if (inner_.is_held(j)) continue;
        const std::size_t row = place(i, j);
        for (std::size_t l = 0; l < inner_.bands[0].width; ++l) {
          if (!inner_.has(j, l) || inner_.is_held(inner_.partner(j, l))) continue;
          const std::size_t column = place(a, inner_.partner(j, l));
          if (column < row) continue;
          rows[row * width_ + column - row] += (plain + twice) * inner_.bands[0].at(j, l) +
                                               once * inner_.bands[1].at(j, l) +
                                               factor * plain * inner_.bands[2].at(j, l);
        }
      }
    }
  }
  return rows;
}

std::optional<std::vector<glm::dvec3>> PlateNet::moves(double factor) const {
  constexpr int kRounds = 3;
  const BandedCholesky cholesky(system(factor), width_);
  if (cholesky.dependent_row()) return {};
  std::vector<glm::dvec3> moves(pull_.size(), glm::dvec3(0.0));
  std::vector<glm::dvec3> right(outer_.free() * inner_.free());
  const auto for_free = [&](auto&& done) {
    for (std::size_t i = outer_.held.start; i < outer_.count - outer_.held.end; ++i) {
      for (std::size_t j = inner_.held.start; j < inner_.count - inner_.held.end; ++j) {
        done(i * inner_.count + j, place(i, j));
      }
    }
  };
  for (int round = 0; round < kRounds; ++round) {
    const std::vector<glm::dvec3> bent = plate_bending(outer_, inner_, moves);
    const std::vector<glm::dvec3> moved = plate_product(outer_, inner_, {0, 0}, moves);
    for_free([&](std::size_t at, std::size_t row) { right[row] = -factor * (pull_[at] + bent[at]) - moved[at]; });
    cholesky.solve({&right.front().x, 3 * right.size()}, 3);
    for_free([&](std::size_t at, std::size_t row) { moves[at] += right[row]; });
  }
  return is_swapped_ ? exchanged(moves, outer_.count) : std::move(moves);
}

}  // namespace splinecore
