#include "splinecore/base/approximation.hpp"

#include <array>
#include <cstdio>

#include "splinecore/base/errors.hpp"

namespace splinecore {

namespace {

/// As many digits as tell how large an error is.
std::string length_text(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4g", value);
  return text.data();
}

}  // namespace

ToleranceNotReached::ToleranceNotReached(const std::string& what, double tolerance, double error)
    : std::runtime_error(what + " within " + text_of(tolerance) + ": the error would be " + length_text(error)),
      what_(what), tolerance_(tolerance), error_(error) {}

}  // namespace splinecore
