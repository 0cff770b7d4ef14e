#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "kernels/kernels.hpp"
#include "splinecore/base/interval.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Finds the span of a parameter among many: the domain is cut into equal parts, of which each knows its first span.
/// They are counted when they are first asked for: many knots are made that only lead to others.
class SpanFinder {
 public:
  /// @param knots   that whoever has the finder keeps
  /// @param starts  of the spans among them, which meet; kept as well
  SpanFinder(std::span<const double> knots, std::span<const int> starts) : knots_(knots), starts_(starts) {}
  ~SpanFinder() { delete parts_.load(); }
  SpanFinder(const SpanFinder&) = delete;
  SpanFinder& operator=(const SpanFinder&) = delete;

  /// Where the spans start, and the end of the last one.
  const double* bounds() const { return parts().bounds.data(); }

  /// Of each span: a parameter above it is nearer to the end.
  const double* middles() const { return parts().middles.data(); }

  /// The last span that starts before u; Side::right: or at u. Of a u before them all the first.
  /// @param u  a number in the domain
  int find(double u, Side side) const {
    std::int32_t span = 0;
    find_all(&u, 1, side, &span);
    return span;
  }

  /// The same of many.
  void find_all(const double* u, std::size_t count, Side side, std::int32_t* spans) const {
    kernels().find_spans(for_kernels(), side == Side::right, u, count, spans);
  }

  SpanParts for_kernels() const {
    const Parts& found = parts();
    return {found.bounds.data(), static_cast<std::int32_t>(starts_.size()), found.scale, found.first.data(),
            found.is_crowded};
  }

 private:
  struct Parts {
    std::vector<double> bounds;  ///< and infinity behind them
    std::vector<double> middles;
    double scale = 0.0;
    bool is_crowded = false;
    std::vector<std::int32_t> first;  ///< of each part: how many spans start in those before it
  };

  /// Of two that count them at once the first to be done is taken.
  const Parts& parts() const {
    const Parts* known = parts_.load(std::memory_order_acquire);
    if (known != nullptr) return *known;
    std::unique_ptr<const Parts> made = counted();
    if (parts_.compare_exchange_strong(known, made.get(), std::memory_order_acq_rel)) known = made.release();
    return *known;
  }

  std::unique_ptr<const Parts> counted() const {
    auto made = std::make_unique<Parts>();
    const std::size_t count = starts_.size();
    std::vector<double>& bounds = made->bounds;
    bounds.reserve(count + 2);
    for (const int k : starts_) bounds.push_back(knots_[k]);
    bounds.push_back(starts_.empty() ? 0.0 : knots_[starts_.back() + 1]);
    bounds.push_back(std::numeric_limits<double>::infinity());
    made->middles.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      const double middle = Interval{bounds[i], bounds[i + 1]}.middle();
      made->middles.push_back(middle < bounds[i + 1] ? middle : bounds[i]);
    }
    constexpr std::size_t kMostParts = std::size_t{1} << 20;
    constexpr double kLargest = 1e300;
    const std::size_t number = count > 1 ? std::min(kMostParts, 8 * count) : 1;
    const double scale = static_cast<double>(number) / (bounds[count] - bounds.front());
    made->scale = count > 1 && scale > 0.0 && scale < kLargest ? scale : 0.0;
    std::vector<std::int32_t>& first = made->first;
    first.assign(number + 2, 0);
    // The part grows with u, so that spans that start in other parts need not be looked at.
    for (std::size_t i = 0; i < count; ++i) {
      ++first[static_cast<std::size_t>((bounds[i] - bounds.front()) * made->scale) + 1];
    }
    constexpr std::int32_t kFew = 4;
    made->is_crowded = std::ranges::any_of(first, [](std::int32_t starts) { return starts > kFew; });
    for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
    return made;
  }

  std::span<const double> knots_;
  std::span<const int> starts_;
  mutable std::atomic<const Parts*> parts_{nullptr};
};

}  // namespace splinecore
#pragma GCC visibility pop
