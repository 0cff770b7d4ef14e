#include "influence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/rounding.hpp"
#include "splinecore/basis/hermite.hpp"
#include "splinecore/basis/samples.hpp"

namespace splinecore {

Influence Influence::at(const KnotVector& knots, double u, const char* name) {
  Stencil at(knots, 2);
  at.move_to(knots.admit(u, Side::right, {}, name), Side::right);
  const auto count = static_cast<std::size_t>(knots.count());
  const std::vector<double> none(count, 0.0);
  Influence found{none, none, none};
  for (std::size_t j = 0; j < at.weights(0).size(); ++j) {
    const std::size_t i = (at.first() + j) % count;
    found.value[i] += at.weights(0)[j];
    found.slope[i] += at.weights(1)[j];
    found.bend[i] += at.weights(2)[j];
  }
  return found;
}

bool make_rational(Influence& plain, std::span<const glm::dvec4> points) {
  double size = 0.0;
  for (const glm::dvec4& point : points) size = std::max(size, std::abs(point.w));
  double weight = 0.0;
  double slope = 0.0;
  double bend = 0.0;
  double terms = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double w = points[i].w / size;
    plain.value[i] *= w;
    weight += plain.value[i];
    terms += std::abs(plain.value[i]);
    if (plain.slope.empty()) continue;
    plain.slope[i] *= w;
    plain.bend[i] *= w;
    slope += plain.slope[i];
    bend += plain.bend[i];
  }
  if (!(std::abs(weight) > kRoundingOfShape * terms)) return false;
  for (double& value : plain.value) value /= weight;
  for (std::size_t i = 0; i < plain.slope.size(); ++i) {
    // What is left where the weights alone change is rounding, and counts nothing.
    const double taken = plain.value[i] * slope;
    const double left = plain.slope[i] - taken;
    plain.slope[i] = std::abs(left) > kRoundingOfShape * (std::abs(plain.slope[i]) + std::abs(taken)) ? left / weight : 0.0;
    plain.bend[i] = (plain.bend[i] - 2.0 * plain.slope[i] * slope - plain.value[i] * bend) / weight;
  }
  return true;
}

HermiteInfluence HermiteInfluence::at(std::span<const double> parameters, double u, const char* name) {
  const std::size_t count = parameters.size();
  const Influence chain = Influence::at(hermite_knots({parameters.begin(), parameters.end()}), u, name);
  HermiteInfluence found;
  for (std::size_t i = 0; i < count; ++i) {
    const double before = i == 0 ? 0.0 : (parameters[i] - parameters[i - 1]) / 3.0;
    const double after = i + 1 == count ? 0.0 : (parameters[i + 1] - parameters[i]) / 3.0;
    found.before.push_back(i == 0 ? after : before);
    found.after.push_back(i + 1 == count ? before : after);
    const auto add = [&](const std::vector<double>& bezier, std::vector<double>& of_point, std::vector<double>& incoming,
                         std::vector<double>& outgoing) {
      const double arriving = i == 0 ? 0.0 : bezier[3 * i - 1];
      const double leaving = i + 1 == count ? 0.0 : bezier[3 * i + 1];
      of_point.push_back(arriving + bezier[3 * i] + leaving);
      incoming.push_back(-before * arriving);
      outgoing.push_back(after * leaving);
    };
    add(chain.value, found.points.value, found.incoming.value, found.outgoing.value);
    add(chain.slope, found.points.slope, found.incoming.slope, found.outgoing.slope);
    add(chain.bend, found.points.bend, found.incoming.bend, found.outgoing.bend);
  }
  return found;
}

}  // namespace splinecore
