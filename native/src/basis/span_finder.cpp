#include "span_finder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace splinecore {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kMostParts = std::size_t{1} << 20;
constexpr std::size_t kPartsOfSpan = 8;

/// By what a parameter behind the begin is multiplied to number its part.
double scale_of(std::size_t parts, double length) {
  constexpr double kLargest = 1e300;
  const double scale = static_cast<double>(parts) / length;
  return scale > 0.0 && scale < kLargest ? scale : 0.0;
}

/// A parameter above it is nearer to the end.
double middle_of(double start, double end) {
  const double middle = Interval{start, end}.middle();
  return middle < end ? middle : start;
}

/// Where halves start, so that the middles themselves are of the first ones from either side.
std::vector<double> starts_of_halves(std::span<const double> bounds, std::span<const double> middles, Side side) {
  std::vector<double> starts;
  starts.reserve(2 * middles.size() + 1);
  for (std::size_t i = 0; i < middles.size(); ++i) {
    starts.push_back(bounds[i]);
    starts.push_back(side == Side::right ? std::nextafter(middles[i], kInfinity) : middles[i]);
  }
  starts.push_back(bounds.back());
  return starts;
}

std::vector<double> middles_of(std::span<const double> bounds) {
  std::vector<double> middles;
  middles.reserve(bounds.size() - 1);
  for (std::size_t i = 0; i + 1 < bounds.size(); ++i) middles.push_back(middle_of(bounds[i], bounds[i + 1]));
  return middles;
}

}  // namespace

IntervalFinder::IntervalFinder(std::vector<double> starts, std::size_t parts)
    : starts_(std::move(starts)), begin_(starts_.front()) {
  const std::size_t count = starts_.size() - 1;
  const std::size_t number = count > 1 ? std::min(kMostParts, parts * count) : 1;
  if (count > 1) scale_ = scale_of(number, starts_.back() - begin_);
  // The part grows with u, so that intervals that start in other parts need not be looked at.
  first_.assign(number + 2, 0);
  for (std::size_t i = 0; i < count; ++i) ++first_[static_cast<std::size_t>((starts_[i] - begin_) * scale_) + 1];
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  starts_.front() = -kInfinity;
  starts_.back() = kInfinity;
}

SpanHalves::SpanHalves(std::span<const double> bounds, Side side)
    : side_(side), middles_(middles_of(bounds)), finder_(starts_of_halves(bounds, middles_, side), kPartsOfSpan) {
  ends_.reserve(4 * middles_.size());
  for (std::size_t i = 0; i < middles_.size(); ++i) {
    ends_.insert(ends_.end(), {bounds[i], bounds[i + 1], bounds[i + 1], bounds[i]});
  }
}

const SpanFinder::Spans& SpanFinder::spans() const {
  return spans_.get([&] {
    std::vector<double> bounds;
    bounds.reserve(starts_.size() + 1);
    for (const int k : starts_) bounds.push_back(knots_[k]);
    bounds.push_back(starts_.empty() ? 0.0 : knots_[starts_.back() + 1]);
    IntervalFinder finder(bounds, kPartsOfSpan);
    return std::make_unique<const Spans>(Spans{std::move(bounds), std::move(finder)});
  });
}

}  // namespace splinecore
