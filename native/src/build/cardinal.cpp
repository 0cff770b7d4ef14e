#include "splinecore/build/cardinal.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "base/require.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/basis/hermite.hpp"

namespace splinecore {

namespace {

/// The way from one point to the next: how long it takes and how fast it is.
struct Chord {
  double length;
  glm::dvec3 slope;
};

std::vector<Chord> chords_of(std::span<const glm::dvec3> points, std::span<const double> parameters) {
  std::vector<Chord> chords;
  for (std::size_t i = 0; i + 1 < parameters.size(); ++i) {
    const double length = parameters[i + 1] - parameters[i];
    chords.push_back({length, (points[(i + 1) % points.size()] - points[i]) / length});
  }
  return chords;
}

Tangents tangents_between(const Chord& before, const Chord& after, const Shaping& shaping) {
  const auto [t, c, b] = shaping;
  const double total = before.length + after.length;
  const glm::dvec3 arriving = (1.0 - t) * (1.0 + b) * (after.length / total) * before.slope;
  const glm::dvec3 leaving = (1.0 - t) * (1.0 - b) * (before.length / total) * after.slope;
  return {(1.0 - c) * arriving + (1.0 + c) * leaving, (1.0 + c) * arriving + (1.0 - c) * leaving};
}

/// At the end of `last`; `next` is the chord beside it and `inner` the tangent where the two meet. Of the
/// start of a chain seen backwards it is the same.
glm::dvec3 end_tangent(const Chord& last, const Chord* next, const glm::dvec3& inner, double tension, EndTangent kind) {
  if (next == nullptr || kind == EndTangent::chord) {
    return kind == EndTangent::natural ? last.slope : (1.0 - tension) * last.slope;
  }
  if (kind == EndTangent::natural) return 0.5 * (3.0 * last.slope - inner);
  const double share = last.length / (last.length + next->length);
  return (1.0 - tension) * (last.slope + share * (last.slope - next->slope));
}

void require_shaping(std::span<const Shaping> shaping, std::size_t count) {
  if (shaping.size() != 1 && shaping.size() != count) {
    throw InvalidShape("shaping has " + std::to_string(shaping.size()) + " rows for " + std::to_string(count) +
                       " points");
  }
  constexpr std::pair<const char*, double Shaping::*> kParts[]{
      {"tension", &Shaping::tension}, {"continuity", &Shaping::continuity}, {"bias", &Shaping::bias}};
  for (std::size_t i = 0; i < shaping.size(); ++i) {
    for (const auto& [name, part] : kParts) {
      if (std::isfinite(shaping[i].*part)) continue;
      throw InvalidShape(name + (shaping.size() == 1 ? "" : index_text(i)) + " = " + text_of(shaping[i].*part) +
                         " is not finite");
    }
  }
}

void require_count(std::size_t count, Closing closing) {
  const std::size_t fewest = closing == Closing::closed ? 3 : 2;
  if (count >= fewest) return;
  throw InvalidShape("points has " + std::to_string(count) + " rows, " + std::to_string(fewest) +
                     " or more are needed");
}

/// Sets the tangents at both ends, those at the points between being known.
void set_ends(std::vector<Tangents>& tangents, const std::vector<Chord>& chords, const Shaping& first,
              const Shaping& last, EndTangent ends) {
  const bool alone = chords.size() == 1;
  const glm::dvec3 start = end_tangent(chords.front(), alone ? nullptr : &chords[1], tangents[1].incoming,
                                       first.tension, ends);
  const glm::dvec3 end = end_tangent(chords.back(), alone ? nullptr : &chords[chords.size() - 2],
                                     tangents[chords.size() - 1].outgoing, last.tension, ends);
  tangents.front() = {start, start};
  tangents.back() = {end, end};
}

}  // namespace

HermiteCurve kochanek_bartels(std::span<const glm::dvec3> points, std::span<const Shaping> shaping,
                              std::vector<double> parameters, Closing closing, EndTangent ends) {
  const bool closed = closing == Closing::closed;
  require_count(points.size(), closing);
  require_finite(points, "points");
  require_shaping(shaping, points.size());
  parameters = hermite_parameters(std::move(parameters), points.size() + (closed ? 1 : 0), "parameters");
  const auto shaping_at = [&](std::size_t i) { return shaping[shaping.size() == 1 ? 0 : i]; };

  const std::vector<Chord> chords = chords_of(points, parameters);
  std::vector<Tangents> tangents(parameters.size());
  for (std::size_t i = 1; i < chords.size(); ++i) tangents[i] = tangents_between(chords[i - 1], chords[i], shaping_at(i));
  std::vector<glm::dvec3> chain(points.begin(), points.end());
  if (closed) {
    chain.push_back(chain.front());
    tangents.front() = tangents.back() = tangents_between(chords.back(), chords.front(), shaping_at(0));
  } else {
    set_ends(tangents, chords, shaping_at(0), shaping_at(points.size() - 1), ends);
  }
  return HermiteCurve::make(std::move(chain), std::move(tangents), std::move(parameters));
}

}  // namespace splinecore
