#include "crossing_part.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "base/rounding.hpp"

namespace splinecore {

namespace {

constexpr double kMargin = 1.25;

/// The sine of the least angle between tangents and the planes at right angles to normals, with the sign of the products;
/// 0 where they have both.
double least_sine(const VectorCone& normals, const VectorCone& tangents) {
  const double sine = glm::dot(normals.along, tangents.along);
  const double angle = std::atan2(std::abs(sine), glm::length(glm::cross(normals.along, tangents.along)));
  const double least = angle - kMargin * (normals.spread + tangents.spread);
  return least > 0.0 ? std::copysign(std::sin(least), sine) : 0.0;
}

/// How surely each parameter goes on along the cross product of both normals, and which way (Cramer's rule).
FourParameters leads(const PatchPart& a, const PatchPart& b) {
  return {-least_sine(b.normals(), a.tangents(Axis::v)), least_sine(b.normals(), a.tangents(Axis::u)),
          least_sine(a.normals(), b.tangents(Axis::v)), -least_sine(a.normals(), b.tangents(Axis::u))};
}

CrossingPart made(PatchPart a, PatchPart b, const FourParameters& leads) {
  // Of a much larger part the curve has but a small range.
  constexpr double kSmaller = 0.25;
  constexpr double kTie = 0x1p-20;  // what functions of different systems may differ by decides nothing
  const bool is_a_small = a.largest_size() < kSmaller * b.largest_size();
  const bool is_b_small = b.largest_size() < kSmaller * a.largest_size();
  std::array<int, 4> signs{};
  std::size_t lead = 0;
  double most = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    signs[i] = (leads[i] > 0.0 ? 1 : 0) - (leads[i] < 0.0 ? 1 : 0);
    const bool is_of_large = i < 2 ? is_b_small : is_a_small;
    const double sure = std::abs(leads[i]) * (is_of_large ? 0x1p-3 : 1.0);
    if (!(sure > (1.0 + kTie) * most)) continue;
    lead = i;
    most = sure;
  }
  return {std::move(a), std::move(b), signs, lead};
}

}  // namespace

bool CrossingPart::holds(const FourParameters& at) const noexcept {
  for (std::size_t i = 0; i < 4; ++i) {
    if (!(at[i] >= range(i).start - kRoundingOfPlace && at[i] <= range(i).end + kRoundingOfPlace)) return false;
  }
  return true;
}

std::optional<CrossingPart> crossing_part(PatchPart a, PatchPart b, double rounding) {
  if (!do_normals_differ(a, b, rounding)) return {};
  const FourParameters sure = leads(a, b);
  if (std::ranges::all_of(sure, [](double lead) { return lead == 0.0; })) return {};
  return made(std::move(a), std::move(b), sure);
}

std::optional<CrossingPart> crossing_part(PatchPart a, PatchPart b, const HeightDifference& difference) {
  if (!(difference.least_slope > 0.0)) return {};
  if (std::ranges::all_of(difference.leads, [](double lead) { return lead == 0.0; })) return {};
  return made(std::move(a), std::move(b), difference.leads);
}

CrossingPart within(const CrossingPart& part, std::size_t parameter, const Interval& kept) {
  const Axis axis = parameter % 2 == 0 ? Axis::u : Axis::v;
  PatchPart a = parameter < 2 ? part.a.within(axis, kept) : part.a;
  PatchPart b = parameter < 2 ? part.b : part.b.within(axis, kept);
  const FourParameters sure = leads(a, b);
  CrossingPart found = made(std::move(a), std::move(b), sure);
  // What rounding hides in a small part is known of the larger one.
  for (std::size_t i = 0; i < 4; ++i) {
    if (part.signs[i] != 0) found.signs[i] = part.signs[i];
  }
  if (found.signs[found.lead] == 0) found.lead = part.lead;
  return found;
}

std::pair<CrossingPart, CrossingPart> halves(const CrossingPart& part) {
  const bool is_a = part.a.largest_size() >= part.b.largest_size();
  const PatchPart& larger = is_a ? part.a : part.b;
  const std::size_t k = larger.size[0] >= larger.size[1] ? 0 : 1;
  const Interval whole = larger.range[k];
  const std::size_t parameter = is_a ? k : 2 + k;
  return {within(part, parameter, {whole.start, whole.middle()}), within(part, parameter, {whole.middle(), whole.end})};
}

}  // namespace splinecore
