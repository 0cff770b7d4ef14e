#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "splinecore/base/interval.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Finds the span of a parameter among many: the domain is cut into equal parts, of which each knows its first span.
class SpanFinder {
 public:
  /// @param starts  of the spans, growing
  SpanFinder(std::vector<double> starts, double end)
      : count_(static_cast<std::int32_t>(starts.size())), bounds_(std::move(starts)) {
    bounds_.push_back(end);
    bounds_.push_back(std::numeric_limits<double>::infinity());
    add_middles();
    add_parts();
  }

  /// Where the spans start, and the end of the last one.
  const double* bounds() const noexcept { return bounds_.data(); }

  /// Of each span: a parameter above it is nearer to the end.
  const double* middles() const noexcept { return middles_.data(); }

  /// The last span that starts before u; Side::right: or at u. Of a u before them all the first.
  /// @param u  a number in the domain
  int find(double u, Side side) const noexcept {
    std::int32_t span = 0;
    find_all(&u, 1, side, &span);
    return span;
  }

  /// The same of many.
  void find_all(const double* u, std::size_t count, Side side, std::int32_t* spans) const noexcept {
    if (side == Side::right) {
      find_each(u, count, spans, [](double bound, double at) { return bound <= at; });
    } else {
      find_each(u, count, spans, [](double bound, double at) { return bound < at; });
    }
  }

 private:
  void add_middles() {
    middles_.reserve(static_cast<std::size_t>(count_));
    for (std::int32_t i = 0; i < count_; ++i) {
      const double middle = Interval{bounds_[i], bounds_[i + 1]}.middle();
      middles_.push_back(middle < bounds_[i + 1] ? middle : bounds_[i]);
    }
  }

  void add_parts() {
    constexpr std::size_t kMostParts = std::size_t{1} << 20;
    constexpr double kLargest = 1e300;
    const std::size_t parts = count_ > 1 ? std::min(kMostParts, 8 * static_cast<std::size_t>(count_)) : 1;
    const double scale = static_cast<double>(parts) / (bounds_[count_] - bounds_.front());
    scale_ = count_ > 1 && scale > 0.0 && scale < kLargest ? scale : 0.0;
    first_.assign(parts + 2, 0);
    for (std::int32_t i = 0; i < count_; ++i) ++first_[part_of(bounds_[i]) + 1];
    constexpr std::int32_t kFew = 4;
    is_crowded_ = std::ranges::any_of(first_, [](std::int32_t starts) { return starts > kFew; });
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  }

  /// Grows with u, so that spans that start in other parts need not be looked at.
  std::size_t part_of(double u) const noexcept { return static_cast<std::size_t>((u - bounds_.front()) * scale_); }

  template <class Begins>
  void find_each(const double* u, std::size_t count, std::int32_t* spans, Begins begins) const noexcept {
    const double* const bounds = bounds_.data();
    const std::int32_t* const first = first_.data();
    const double start = bounds[0];
    const double scale = scale_;
    const std::int32_t last = count_ - 1;
    const bool is_crowded = is_crowded_;
    for (std::size_t i = 0; i < count; ++i) {
      const double at = u[i];
      const auto part = static_cast<std::size_t>(static_cast<std::int64_t>((at - start) * scale));
      std::int32_t next = first[part];
      if (is_crowded) next = searched(at, next, first[part + 1], begins);
      while (begins(bounds[next], at)) ++next;
      spans[i] = std::clamp(next - 1, 0, last);
    }
  }

  template <class Begins>
  std::int32_t searched(double u, std::int32_t low, std::int32_t high, Begins begins) const noexcept {
    const double* const from = bounds_.data() + low;
    const double* const to = bounds_.data() + high;
    const auto next = std::partition_point(from, to, [&](double bound) { return begins(bound, u); });
    return static_cast<std::int32_t>(next - bounds_.data());
  }

  std::int32_t count_;
  std::vector<double> bounds_;  ///< and infinity behind them
  std::vector<double> middles_;
  double scale_ = 0.0;
  bool is_crowded_ = false;
  std::vector<std::int32_t> first_;  ///< of each part: how many spans start in those before it
};

}  // namespace splinecore
#pragma GCC visibility pop
