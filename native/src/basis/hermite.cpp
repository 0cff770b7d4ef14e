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
  require_increasing(parameters, argument);
  return parameters;
}

KnotVector hermite_knots(const std::vector<double>& parameters) {
  std::vector<double> knots{parameters.front()};
  for (const double u : parameters) knots.insert(knots.end(), 3, u);
  knots.push_back(parameters.back());
  return KnotVector::make(3, std::move(knots));
}

}  // namespace splinecore
