#include "newton.hpp"

#include <cmath>

namespace splinecore {

namespace {

/// Leja's order: each place is the one farthest from those before it, by the product of all distances,
/// each as often as derivatives are given there.
std::vector<const Osculation*> leja_order(std::span<const Osculation> data) {
  std::vector<const Osculation*> order{&data.front()};
  std::vector<double> distance(data.size(), 0.0);
  while (order.size() < data.size()) {
    const Osculation& last = *order.back();
    std::size_t farthest = 0;
    for (std::size_t i = 0; i < data.size(); ++i) {
      const double apart = std::abs(data[i].parameter - last.parameter);
      distance[i] += static_cast<double>(last.derivatives.size()) * std::log(apart);
      if (distance[i] > distance[farthest]) farthest = i;
    }
    order.push_back(&data[farthest]);
  }
  return order;
}

std::array<DoubleDouble, 3> wide(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

glm::dvec3 rounded(const std::array<DoubleDouble, 3>& v) {
  return {v[0].rounded(), v[1].rounded(), v[2].rounded()};
}

}  // namespace

NewtonForm::NewtonForm(std::span<const Osculation> data)
    : domain_{data.front().parameter, data.back().parameter} {
  std::vector<const Osculation*> places;
  for (const Osculation* place : leja_order(data)) {
    places.insert(places.end(), place->derivatives.size(), place);
    nodes_.insert(nodes_.end(), place->derivatives.size(), moved(place->parameter));
  }
  take_differences(places);
}

void NewtonForm::take_differences(std::span<const Osculation* const> places) {
  for (const Osculation* place : places) coefficients_.push_back(wide(place->derivatives[0]));
  const DoubleDouble quarter = exact_sum(domain_.end, -domain_.start) * 0.25;
  DoubleDouble factor = 1.0;  // quarter^k / k!
  for (std::size_t k = 1; k < places.size(); ++k) {
    factor = factor * quarter / static_cast<double>(k);
    for (std::size_t i = places.size(); i-- > k;) {
      const bool repeated = places[i] == places[i - k];
      const DoubleDouble apart = nodes_[i] - nodes_[i - k];
      for (int axis = 0; axis < 3; ++axis) {
        coefficients_[i][axis] = repeated ? DoubleDouble(places[i]->derivatives[k][axis]) * factor
                                          : (coefficients_[i][axis] - coefficients_[i - 1][axis]) / apart;
      }
    }
  }
}

DoubleDouble NewtonForm::moved(double u) const {
  const DoubleDouble length = exact_sum(domain_.end, -domain_.start);
  return exact_sum(u, -domain_.start) * 4.0 / length - 2.0;
}

glm::dvec3 NewtonForm::value(double u) const {
  const DoubleDouble x = moved(u);
  Vector sum = coefficients_.back();
  for (std::size_t k = coefficients_.size() - 1; k-- > 0;) {
    for (int axis = 0; axis < 3; ++axis) sum[axis] = sum[axis] * (x - nodes_[k]) + coefficients_[k][axis];
  }
  return rounded(sum);
}

std::vector<glm::dvec3> NewtonForm::bernstein(Interval range) const {
  const DoubleDouble start = moved(range.start);
  const DoubleDouble end = moved(range.end);
  std::vector<Vector> points{coefficients_.back()};
  for (std::size_t k = coefficients_.size() - 1; k-- > 0;) {
    // Times x - z_k, whose own Bernstein coefficients are its values at both ends, plus a_k.
    const auto degree = static_cast<double>(points.size());
    const DoubleDouble at_start = start - nodes_[k];
    const DoubleDouble at_end = end - nodes_[k];
    points.push_back({});
    for (std::size_t i = points.size(); i-- > 0;) {
      const DoubleDouble share = DoubleDouble(static_cast<double>(i)) / degree;
      for (int axis = 0; axis < 3; ++axis) {
        const DoubleDouble kept = points[i][axis] * at_start * (DoubleDouble(1.0) - share);
        const DoubleDouble risen = i > 0 ? points[i - 1][axis] * at_end * share : DoubleDouble();
        points[i][axis] = kept + risen + coefficients_[k][axis];
      }
    }
  }
  std::vector<glm::dvec3> result;
  for (const Vector& point : points) result.push_back(rounded(point));
  return result;
}

}  // namespace splinecore
