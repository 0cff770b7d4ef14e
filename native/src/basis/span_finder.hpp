#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "kernels/kernels.hpp"
#include "splinecore/base/interval.hpp"
#include "splinecore/base/lazy.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Finds the interval that a parameter lies in, among intervals of which each begins where the one before ends.
class IntervalFinder {
 public:
  /// @param starts  of the intervals, which ascend, and the end of the last one
  /// @param parts  for each interval: the domain is cut into so many equal ones, of which each knows its first interval
  IntervalFinder(std::vector<double> starts, std::size_t parts);

  /// The last interval that starts before each parameter; Side::right: or at it. All lie in the domain.
  void find_all(const double* u, std::size_t count, Side side, std::int32_t* intervals) const {
    kernels().find_intervals({starts_.data(), first_.data(), begin_, scale_}, side == Side::right, u, count, intervals);
  }

 private:
  std::vector<double> starts_;  ///< minus infinity for the first, and infinity behind the last
  double begin_;
  double scale_ = 0.0;
  std::vector<std::int32_t> first_;
};

/// The halves of spans: the half of a parameter is twice its span, and 1 more where it is nearer to the end.
class SpanHalves {
 public:
  /// @param bounds  of the spans @param side  from which parameters are approached
  SpanHalves(std::span<const double> bounds, Side side);

  void find_all(const double* u, std::size_t count, std::int32_t* halves) const {
    finder_.find_all(u, count, side_, halves);
  }

  /// Of each half the nearer end of its span and the other one.
  const double* ends() const noexcept { return ends_.data(); }

  /// Parameters strictly between these are of the half.
  Interval range(int half) const noexcept {
    const double* const ends = ends_.data() + 2 * half;
    const double middle = middles_[static_cast<std::size_t>(half >> 1)];
    return (half & 1) == 0 ? Interval{ends[0], middle} : Interval{middle, ends[0]};
  }

 private:
  Side side_;
  std::vector<double> middles_;
  std::vector<double> ends_;
  IntervalFinder finder_;
};

/// Finds the spans of parameters. What it takes is made when it is first asked for: many knots are made that only lead to
/// others.
class SpanFinder {
 public:
  /// @param knots   that whoever has the finder keeps
  /// @param starts  of the spans among them, which meet; kept as well
  SpanFinder(std::span<const double> knots, std::span<const int> starts) : knots_(knots), starts_(starts) {}

  /// Where the spans start, and the end of the last one.
  const double* bounds() const { return spans().bounds.data(); }

  /// The last span that starts before u; Side::right: or at u.
  /// @param u  a number in the domain
  int find(double u, Side side) const {
    std::int32_t span = 0;
    find_all(&u, 1, side, &span);
    return span;
  }

  /// The same of many.
  void find_all(const double* u, std::size_t count, Side side, std::int32_t* found) const {
    spans().finder.find_all(u, count, side, found);
  }

  /// The halves of parameters that are approached from a side.
  const SpanHalves& halves(Side side) const {
    Lazy<SpanHalves>& known = side == Side::right ? right_halves_ : left_halves_;
    return known.get([&] { return std::make_unique<const SpanHalves>(spans().bounds, side); });
  }

 private:
  struct Spans {
    std::vector<double> bounds;
    IntervalFinder finder;
  };

  const Spans& spans() const;

  std::span<const double> knots_;
  std::span<const int> starts_;
  mutable Lazy<Spans> spans_;
  mutable Lazy<SpanHalves> right_halves_;
  mutable Lazy<SpanHalves> left_halves_;
};

}  // namespace splinecore
#pragma GCC visibility pop
