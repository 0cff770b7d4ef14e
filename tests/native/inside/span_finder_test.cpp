#include "basis/span_finder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "support.hpp"

namespace splinecore {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Where spans start, and the end of the last one: even, uneven, crowded, as short as numbers allow, tiny and huge.
std::vector<std::vector<double>> all_bounds() {
  std::vector<std::vector<double>> found{{0, 1}, {-3, 2, 7}};
  std::vector<double> even(65);
  std::iota(even.begin(), even.end(), 0.0);
  found.push_back(even);
  std::vector<double> crowded{0.0};
  for (int i = 1; i < 20; ++i) crowded.push_back(i * 1e-12);
  crowded.push_back(1.0);
  found.push_back(crowded);
  found.push_back({0.0, 1.0, std::nextafter(1.0, 2.0), std::nextafter(std::nextafter(1.0, 2.0), 2.0), 3.0});
  found.push_back({0.0, 5e-324, 1e-323, 3e-323});
  found.push_back({1e7, 1e7 + 0.5, 1e7 + 1});
  for (const double size : {1e-300, 1e300}) found.push_back({-size, 0.1 * size, 0.2 * size, size});
  testing::Random random(3);
  std::vector<double> scattered{0.0};
  for (int i = 0; i < 300; ++i) scattered.push_back(scattered.back() + std::exp(-std::ldexp(double(random() >> 40), -19)));
  found.push_back(scattered);
  return found;
}

/// All bounds, the middles between, and their neighbors.
std::vector<double> places_of(const std::vector<double>& bounds) {
  std::vector<double> places = bounds;
  for (std::size_t i = 0; i + 1 < bounds.size(); ++i) places.push_back(Interval{bounds[i], bounds[i + 1]}.middle());
  for (const double place : std::vector<double>(places)) {
    places.push_back(std::nextafter(place, kInfinity));
    places.push_back(std::nextafter(place, -kInfinity));
  }
  std::erase_if(places, [&](double place) { return place < bounds.front() || place > bounds.back(); });
  return places;
}

std::vector<int> starts_of(const std::vector<double>& bounds) {
  std::vector<int> starts(bounds.size() - 1);
  std::iota(starts.begin(), starts.end(), 0);
  return starts;
}

int expected_span(const std::vector<double>& bounds, double u, Side side) {
  const auto next = side == Side::right ? std::upper_bound(bounds.begin(), bounds.end(), u)
                                        : std::lower_bound(bounds.begin(), bounds.end(), u);
  return std::clamp(static_cast<int>(next - bounds.begin()) - 1, 0, static_cast<int>(bounds.size()) - 2);
}

TEST(SpanFinder, FindsTheSpansThatASearchFinds) {
  for (const std::vector<double>& bounds : all_bounds()) {
    const std::vector<int> starts = starts_of(bounds);
    const SpanFinder finder(bounds, starts);
    const std::vector<double> places = places_of(bounds);
    for (const Side side : {Side::left, Side::right}) {
      std::vector<std::int32_t> spans(places.size());
      finder.find_all(places.data(), places.size(), side, spans.data());
      for (std::size_t i = 0; i < places.size(); ++i) {
        EXPECT_EQ(spans[i], expected_span(bounds, places[i], side)) << places[i];
        EXPECT_EQ(spans[i], finder.find(places[i], side));
      }
    }
  }
}

TEST(SpanFinder, FindsTheHalfInWhichAParameterIsNearerToItsEnd) {
  for (const std::vector<double>& bounds : all_bounds()) {
    const std::vector<int> starts = starts_of(bounds);
    const SpanFinder finder(bounds, starts);
    const std::vector<double> places = places_of(bounds);
    for (const Side side : {Side::left, Side::right}) {
      const SpanHalves& halves = finder.halves(side);
      std::vector<std::int32_t> found(places.size());
      halves.find_all(places.data(), places.size(), found.data());
      for (std::size_t i = 0; i < places.size(); ++i) {
        const int span = expected_span(bounds, places[i], side);
        const Interval whole{bounds[span], bounds[span + 1]};
        const double middle = whole.middle() < whole.end ? whole.middle() : whole.start;
        EXPECT_EQ(found[i], 2 * span + (places[i] > middle ? 1 : 0)) << places[i];
        const double* const ends = halves.ends() + 2 * found[i];
        EXPECT_EQ(ends[found[i] & 1], whole.start);
        EXPECT_EQ(ends[1 - (found[i] & 1)], whole.end);
        const Interval range = halves.range(found[i]);
        EXPECT_TRUE(range.start <= places[i] && places[i] <= range.end);
      }
    }
  }
}

}  // namespace
}  // namespace splinecore
