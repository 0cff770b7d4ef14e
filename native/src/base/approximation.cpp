#include "splinecore/base/approximation.hpp"

#include "splinecore/base/errors.hpp"

namespace splinecore {

ToleranceNotReached::ToleranceNotReached(const std::string& what, double tolerance, double error)
    : std::runtime_error(what + " within " + text_of(tolerance) + ": the error would be " + text_of(error)),
      error_(error) {}

}  // namespace splinecore
