#include "splinecore/build/part.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "splinecore/base/errors.hpp"
#include "splinecore/curve/ends.hpp"
#include "splinecore/curve/join.hpp"
#include "splinecore/measure/arc_length.hpp"
#include "splinecore/meet/intersections.hpp"

namespace splinecore {

namespace {

/// Parameters so near, as a part of the domain, are one.
constexpr double kSame = 0x1p-40;

void require_in_domain(const Interval& domain, double u) {
  if (u >= domain.start && u <= domain.end) return;
  throw InvalidShape("the parameter " + text_of(u) + " is outside of " + text_of(domain.start) + " to " +
                     text_of(domain.end));
}

/// Of a plain curve, within its domain.
NurbsCurve inner_part(const NurbsCurve& curve, double start, double end) {
  NurbsCurve found = curve;
  if (end < found.domain().end) found = split(found, end).first;
  if (start > found.domain().start) found = split(found, start).second;
  return found;
}

/// By halves: to cut off one part after the other would copy the rest each time.
void cut(const NurbsCurve& curve, std::span<const double> at, std::vector<NurbsCurve>& found) {
  if (at.empty()) {
    found.push_back(curve);
    return;
  }
  const std::size_t middle = at.size() / 2;
  const auto [before, behind] = split(curve, at[middle]);
  cut(before, at.first(middle), found);
  cut(behind, at.subspan(middle + 1), found);
}

}  // namespace

NurbsCurve part(const NurbsCurve& curve, double start, double end) {
  const Interval domain = curve.domain();
  require_in_domain(domain, start);
  if (!(start < end)) throw InvalidShape("the part ends at " + text_of(end) + ", where it starts or before");
  if (end <= domain.end && !curve.periodic()) return inner_part(curve, start, end);
  const double turn = domain.length();
  if (!is_closed(curve)) require_in_domain(domain, end);
  if (end - start > turn * (1.0 + kSame)) throw InvalidShape("the part is longer than a turn of the curve");
  if (curve.periodic()) return inner_part(opened(curve, start), start, end);
  if (start == domain.start) return curve;
  if (start == domain.end) return with_domain(inner_part(curve, domain.start, end - turn), {start, end});
  const NurbsCurve before = inner_part(curve, start, domain.end);
  const NurbsCurve behind = inner_part(curve, domain.start, end - turn);
  return joined(before, with_domain(behind, {domain.end, end}), Smoothness::c0).value;
}

std::vector<NurbsCurve> parts(const NurbsCurve& curve, std::vector<double> parameters) {
  const Interval domain = curve.domain();
  for (const double u : parameters) require_in_domain(domain, u);
  const bool goes_round = is_closed(curve);
  const double same = kSame * domain.length();
  std::ranges::sort(parameters);
  std::vector<double> cuts;
  for (const double u : parameters) {
    const bool is_at_end = u - domain.start <= same || domain.end - u <= same;
    if (goes_round ? !cuts.empty() && u - cuts.front() >= domain.length() - same : is_at_end) continue;
    if (cuts.empty() || u - cuts.back() > same) cuts.push_back(u);
  }
  if (cuts.empty()) return {curve};
  if (goes_round) {
    cuts.push_back(cuts.front() + domain.length());
  } else {
    cuts.insert(cuts.begin(), domain.start);
    cuts.push_back(domain.end);
  }
  std::vector<NurbsCurve> found;
  cut(part(curve, cuts.front(), cuts.back()), std::span(cuts).subspan(1, cuts.size() - 2), found);
  return found;
}

std::vector<double> meeting_parameters(const NurbsCurve& curve, std::span<const NurbsCurve> others) {
  std::vector<double> found;
  for (const NurbsCurve& other : others) {
    const CurveIntersections both = intersections(curve, other);
    for (const CurveIntersection& place : both.places) found.push_back(place.a);
    for (const CurveOverlap& overlap : both.overlaps) found.insert(found.end(), {overlap.a.start, overlap.a.end});
  }
  std::ranges::sort(found);
  return found;
}

std::vector<NurbsCurve> trimmed(const NurbsCurve& curve, std::span<const NurbsCurve> others, double at) {
  const Interval domain = curve.domain();
  require_in_domain(domain, at);
  const bool goes_round = is_closed(curve);
  const double same = kSame * domain.length();
  std::vector<double> cuts = meeting_parameters(curve, others);
  std::erase_if(cuts, [&](double u) {
    return !goes_round && (u - domain.start <= same || domain.end - u <= same);
  });
  const auto is_one = [&](double a, double b) { return b - a <= same; };
  cuts.erase(std::unique(cuts.begin(), cuts.end(), is_one), cuts.end());
  if (cuts.empty()) throw InvalidShape("nothing meets the curve between its ends: there is nothing to trim it at");
  const auto next = std::ranges::upper_bound(cuts, at);
  if (goes_round) {
    if (cuts.size() == 1) throw InvalidShape("a closed curve is trimmed between two intersections: here is only one");
    const double turn = domain.length();
    const double start = next == cuts.end() ? cuts.front() : *next;
    const double end = next == cuts.begin() ? cuts.back() : *(next - 1);
    return {part(curve, start, end > start ? end : end + turn)};
  }
  std::vector<NurbsCurve> left;
  if (next != cuts.begin()) left.push_back(part(curve, domain.start, *(next - 1)));
  if (next != cuts.end()) left.push_back(part(curve, *next, domain.end));
  return left;
}

}  // namespace splinecore
