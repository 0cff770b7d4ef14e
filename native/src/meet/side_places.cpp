#include "side_places.hpp"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "splinecore/base/pause.hpp"

namespace splinecore {

namespace {

bool is_near(const TwoPatches& patches, const SectionPlace& from, const SectionPlace& to, double tolerance) {
  const SectionStep step(from, to);
  return std::ranges::all_of(std::array{0.15, 0.33, 0.5, 0.67, 0.85}, [&](double s) {
    const PatchSpots at = step.spots(s);
    return glm::length(patches.a.at(at.a, step.point(s)).offset) <= tolerance &&
           glm::length(patches.b.at(at.b, step.point(s)).offset) <= 2.0 * tolerance;
  });
}

}  // namespace

void add_places(SectionTrace& trace, const TwoPatches& patches, const std::function<SectionPlace(double)>& place, double tolerance) {
  constexpr double kShortest = 0x1p-16;
  trace.places.push_back(place(0.0));
  double length = 1.0;
  for (double at = 0.0; at < 1.0;) {
    breathe(2048);
    const double next = at + length < 1.0 ? at + length : 1.0;
    const SectionPlace to = place(next);
    if (next - at > kShortest && !is_near(patches, trace.places.back(), to, tolerance)) {
      length = 0.5 * (next - at);
      continue;
    }
    trace.places.push_back(to);
    at = next;
    length *= 2.0;
  }
}

}  // namespace splinecore
