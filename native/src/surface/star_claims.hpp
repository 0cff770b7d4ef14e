#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "star.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Points of a star that its sides decide: those of the row nearest to a side count, and of as near ones the mean.
class StarClaims {
 public:
  explicit StarClaims(const Star& star);

  /// @param rank  of the row, 0 along the side
  void add(std::size_t patch, std::size_t i, std::size_t j, const glm::dvec3& point, int rank);

  /// None for those that no side decides.
  std::vector<std::optional<glm::dvec3>> points() const;

 private:
  struct Claim {
    glm::dvec3 sum{0.0};
    int rank = 0;
    int count = 0;
  };

  const Star& star_;
  std::vector<Claim> claims_;
};

}  // namespace splinecore
#pragma GCC visibility pop
