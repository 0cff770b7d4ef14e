#include "splinecore/basis/hermite.hpp"

#include <numeric>

#include "base/require.hpp"
#include "splinecore/base/errors.hpp"

namespace splinecore {

std::vector<double> hermite_parameters(std::vector<double> parameters, std::size_t count,
                                       const std::string& argument) {
  if (parameters.empty()) {
    parameters.resize(count);
    std::iota(parameters.begin(), parameters.end(), 0.0);
  }
  if (parameters.size() != count) {
    throw InvalidShape(argument + " has " + std::to_string(parameters.size()) + " values for " +
                       std::to_string(count) + " points");
  }
  require_finite(parameters, argument);
  for (std::size_t i = 1; i < count; ++i) {
    if (parameters[i] > parameters[i - 1]) continue;
    throw InvalidShape(argument + index_text(i) + " = " + text_of(parameters[i]) +
                       " does not increase from " + text_of(parameters[i - 1]));
  }
  return parameters;
}

KnotVector hermite_knots(const std::vector<double>& parameters) {
  std::vector<double> knots{parameters.front()};
  for (const double u : parameters) knots.insert(knots.end(), 3, u);
  knots.push_back(parameters.back());
  return KnotVector::make(3, std::move(knots));
}

}  // namespace splinecore
