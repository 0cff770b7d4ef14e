#pragma once

#include <optional>
#include <vector>

#include "curve_bundles.hpp"
#include "curve_part.hpp"
#include "curve_pieces.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// The parts of a curve, in their order along it, and the bundles of them.
class BundledParts {
 public:
  explicit BundledParts(const CurvePieces& curve);

  const std::vector<CurvePart>& parts() const noexcept { return parts_; }
  const CurveBundles& bundles() const noexcept { return *bundles_; }

  /// Halves each part so many times.
  void halve(const std::vector<int>& times);

 private:
  std::vector<CurvePart> parts_;
  std::optional<CurveBundles> bundles_;
};

/// Halves parts that bend and whose boxes so are near those of many others, as turns of a spiral beside each other are,
/// until they are near but a few: of one curve by itself, and of two by each other.
void halve_crowded(BundledParts& parts, double distance);
void halve_crowded(BundledParts& a, BundledParts& b, double distance);

}  // namespace splinecore
#pragma GCC visibility pop
