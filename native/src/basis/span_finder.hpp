#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "splinecore/base/interval.hpp"

namespace splinecore {

/// Finds the span of a parameter among many: the domain is cut into equal parts, of which each knows its first span.
class SpanFinder {
 public:
  SpanFinder() = default;

  /// @param starts  of the spans, growing
  SpanFinder(std::vector<double> starts, double end) : starts_(std::move(starts)) {
    constexpr std::size_t kFew = 4;
    constexpr std::size_t kMostParts = std::size_t{1} << 20;
    if (starts_.size() <= kFew) return;
    const std::size_t parts = std::min(kMostParts, 8 * starts_.size());
    scale_ = static_cast<double>(parts) / (end - starts_.front());
    if (!(scale_ > 0.0) || scale_ > 1e300) return;
    first_.assign(parts + 1, 0);
    for (const double start : starts_) ++first_[part_of(start, parts) + 1];
    for (std::size_t i = 1; i <= parts; ++i) first_[i] += first_[i - 1];
  }

  /// The last span that starts before u; Side::right: or at u. Of a u before them all the first.
  int find(double u, Side side) const noexcept {
    auto low = starts_.begin();
    auto high = starts_.end();
    if (!first_.empty()) {
      const std::size_t part = part_of(u, first_.size() - 1);
      low += first_[part];
      high = starts_.begin() + first_[part + 1];
    }
    const auto next = side == Side::right ? std::upper_bound(low, high, u) : std::lower_bound(low, high, u);
    return next == starts_.begin() ? 0 : static_cast<int>(next - starts_.begin()) - 1;
  }

 private:
  /// Grows with u, so that spans that start in other parts need not be looked at.
  std::size_t part_of(double u, std::size_t parts) const noexcept {
    const double place = (u - starts_.front()) * scale_;
    return place > 0.0 ? std::min(static_cast<std::size_t>(place), parts - 1) : 0;
  }

  std::vector<double> starts_;
  double scale_ = 0.0;
  std::vector<int> first_;  ///< of each part: how many spans start in those before it
};

}  // namespace splinecore
