#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

#include "arrangement.hpp"
#include "edge_groups.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// Edges, along which the inside is to the left, put together to loops that go through no vertex twice.
/// @throws InvalidShape where as many do not leave a vertex as come to it, in turn
std::vector<std::vector<GroupedEdge>> traced_loops(const Arrangement& arrangement, const std::vector<GroupedEdge>& edges,
                                                   const glm::dvec3& normal);

/// Edges that follow each other, without a vertex that they go through twice: cut there into loops.
std::vector<std::vector<GroupedEdge>> cut_at_repeated_vertices(const Arrangement& arrangement,
                                                               const std::vector<GroupedEdge>& round);

}  // namespace splinecore
#pragma GCC visibility pop
