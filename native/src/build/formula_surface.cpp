#include <algorithm>
#include <cmath>

#include "patch_fit.hpp"

namespace splinecore {

namespace {

using Expansion = std::array<double, 5>;

/// c_kl of u^k v^l for k, l <= 2 from expansions along (1, 0), (0, 1), (1, 1), (1, -1): the last two hold
/// the sums of c_kl over k + l = n, with alternating signs in the second.
std::array<double, 9> mixed_coefficients(const Expansion& u, const Expansion& v, const Expansion& sum,
                                         const Expansion& alternating) {
  const auto even = [&](int n) { return 0.5 * (sum[n] + alternating[n]); };
  const auto odd = [&](int n) { return 0.5 * (sum[n] - alternating[n]); };
  return {u[0], v[1],           v[2],                  //
          u[1], odd(2),         even(3) - u[3],        //
          u[2], odd(3) - v[3],  even(4) - u[4] - v[4]};
}

}  // namespace

FormulaSurface::FormulaSurface(std::span<const Formula> coordinates, const std::array<Interval, 2>& domains)
    : coordinates_(coordinates), scale_(domains[0].length(), domains[1].length()) {
  for (const Formula& formula : coordinates) expansions_.emplace_back(formula, 4);
}

void FormulaSurface::evaluate(std::span<const double> u, std::span<const double> v, std::span<glm::dvec3> out) {
  const std::span<const double> places[]{u, v};
  values_.resize(u.size());
  for (std::size_t axis = 0; axis < coordinates_.size(); ++axis) {
    splinecore::evaluate(coordinates_[axis], places, values_);
    for (std::size_t i = 0; i < values_.size(); ++i) out[i][static_cast<int>(axis)] = values_[i];
  }
}

const CornerJet& FormulaSurface::jet(double u, double v) {
  const auto [entry, is_new] = known_.try_emplace({u, v});
  CornerJet& jet = entry->second;
  if (!is_new) return jet;
  evaluate({&u, 1}, {&v, 1}, {jet.data(), 1});
  const double origin[]{u, v};
  for (std::size_t axis = 0; axis < coordinates_.size(); ++axis) {
    const auto along = [&](double x, double y) {
      const double direction[]{x * scale_.x, y * scale_.y};
      Expansion coefficients;
      std::ranges::copy(expansions_[axis].along(origin, direction), coefficients.begin());
      return coefficients;
    };
    const auto mixed = mixed_coefficients(along(1.0, 0.0), along(0.0, 1.0), along(1.0, 1.0), along(1.0, -1.0));
    for (int k = 0; k <= 2; ++k) {
      for (int l = k == 0 ? 1 : 0; l <= 2; ++l) {
        // 2! is the only factorial that is not 1.
        const double factor = (k == 2 ? 2.0 : 1.0) * (l == 2 ? 2.0 : 1.0);
        const double value = factor * mixed[3 * k + l] / std::pow(scale_.x, k) / std::pow(scale_.y, l);
        jet[3 * k + l][static_cast<int>(axis)] = std::isfinite(value) ? value : 0.0;
      }
    }
  }
  return jet;
}

}  // namespace splinecore
