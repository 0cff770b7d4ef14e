#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "splinecore/base/interval.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Finds the span of a parameter among many: the domain is cut into equal parts, of which each knows its first span.
class SpanFinder {
 public:
  /// @param starts  of the spans, growing
  SpanFinder(std::vector<double> starts, double end) : count_(starts.size()), bounds_(std::move(starts)) {
    bounds_.push_back(end);
    constexpr std::size_t kMostParts = std::size_t{1} << 20;
    const std::size_t parts = std::clamp<std::size_t>(8 * count_, 1, kMostParts);
    const double scale = static_cast<double>(parts) / (end - bounds_.front());
    first_.assign(count_ > 1 && scale > 0.0 && scale < kLargest ? parts + 1 : 2, 0);
    if (first_.size() > 2) scale_ = scale;
    for (std::size_t i = 0; i < count_; ++i) ++first_[part_of(bounds_[i], bounds_.front(), scale_, last_part()) + 1];
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  }

  /// Where the spans start, and the end of the last one.
  const double* bounds() const noexcept { return bounds_.data(); }

  /// The last span that starts before u; Side::right: or at u. Of a u before them all the first.
  int find(double u, Side side) const noexcept {
    std::int32_t span = 0;
    find_all(&u, 1, side, &span);
    return span;
  }

  /// The same of many.
  void find_all(const double* u, std::size_t count, Side side, std::int32_t* spans) const noexcept {
    const double* const bounds = bounds_.data();
    const std::int32_t* const first = first_.data();
    const double start = bounds[0];
    const double scale = scale_;
    const std::int64_t last = last_part();
    for (std::size_t i = 0; i < count; ++i) {
      const std::int64_t part = part_of(u[i], start, scale, last);
      std::int32_t next = first[part];
      const std::int32_t end = first[part + 1];
      if (end - next > kFew) {
        next = searched(u[i], next, end, side);
      } else if (side == Side::right) {
        while (next < end && bounds[next] <= u[i]) ++next;
      } else {
        while (next < end && bounds[next] < u[i]) ++next;
      }
      spans[i] = next > 0 ? next - 1 : 0;
    }
  }

 private:
  static constexpr double kLargest = 1e300;
  static constexpr double kLargestPart = 1e9;

  static constexpr std::int32_t kFew = 4;

  std::int64_t last_part() const noexcept { return static_cast<std::int64_t>(first_.size()) - 2; }

  /// Grows with u, so that spans that start in other parts need not be looked at.
  static std::int64_t part_of(double u, double start, double scale, std::int64_t last) noexcept {
    const double place = std::min((u - start) * scale, kLargestPart);
    return place > 0.0 ? std::min(static_cast<std::int64_t>(place), last) : 0;
  }

  std::int32_t searched(double u, std::int32_t low, std::int32_t high, Side side) const noexcept {
    const double* const from = bounds_.data() + low;
    const double* const to = bounds_.data() + high;
    const double* const next = side == Side::right ? std::upper_bound(from, to, u) : std::lower_bound(from, to, u);
    return static_cast<std::int32_t>(next - bounds_.data());
  }

  std::size_t count_;
  std::vector<double> bounds_;
  double scale_ = 0.0;
  std::vector<std::int32_t> first_;  ///< of each part: how many spans start in those before it
};

}  // namespace splinecore
#pragma GCC visibility pop
