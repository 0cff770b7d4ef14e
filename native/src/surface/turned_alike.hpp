#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>

#include "base/length.hpp"
#include "least_parts.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Lets derivatives across the end of a side, or of a piece of one, and the start of the next one change at the same rate, by
/// the way along them: of both what is changed least.
template <class Side>
void turn_alike(Side& side, Side& next) {
  const double pace = length_of(side.place(1.0).along) / length_of(next.place(0.0).along);
  const std::array<glm::dvec3, 2> here = side.directions(true);
  const std::array<glm::dvec3, 2> there = next.directions(false);
  const std::array<double, 4> lengths{length_of(here[0]), length_of(here[1]), length_of(there[0]), length_of(there[1])};
  const auto parts = [&](const glm::dvec3& wanted) {
    std::array<double, 4> found = least_parts(wanted, {here[0] / lengths[0], here[1] / lengths[1]},
                                              {there[0] * (-pace / lengths[2]), there[1] * (-pace / lengths[3])});
    for (std::size_t i = 0; i < found.size(); ++i) found[i] /= lengths[i];
    return found;
  };
  const auto first = parts(pace * next.jet(false).first[1] - side.jet(true).first[1]);
  side.bend_first(true, first[0], first[1]);
  next.bend_first(false, first[2], first[3]);
  if (side.continuity() < 2 || next.continuity() < 2) return;
  const auto second = parts(pace * next.jet(false).second[1] - side.jet(true).second[1]);
  side.bend_second(true, 1, second[0], second[1]);
  next.bend_second(false, 1, second[2], second[3]);
}

}  // namespace splinecore
#pragma GCC visibility pop
