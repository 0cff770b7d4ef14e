#pragma once

#include <bit>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

#include "splinecore/exchange/meshes.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// A mesh whose arrays fit each other.
class MeshFaces {
 public:
  /// @param name  of the mesh in messages
  /// @throws InvalidShape
  MeshFaces(const MeshArrays& arrays, const std::string& name);

  std::size_t vertex_count() const noexcept { return vertex_count_; }
  std::size_t corner_count() const noexcept { return arrays_.corner_vertices.size(); }
  std::size_t face_count() const noexcept { return starts_.size(); }
  std::size_t triangle_count() const noexcept { return corner_count() - 2 * face_count(); }
  bool has_normals() const noexcept { return has_normals_; }

  glm::dvec3 position(std::size_t vertex) const noexcept;
  glm::dvec3 corner_position(std::size_t corner) const noexcept {
    return position(static_cast<std::size_t>(arrays_.corner_vertices[corner]));
  }
  glm::dvec3 normal(std::size_t corner) const noexcept;
  std::size_t vertex(std::size_t corner) const noexcept { return static_cast<std::size_t>(arrays_.corner_vertices[corner]); }

  /// The first corner of a face, and that behind its last.
  std::size_t begin(std::size_t face) const noexcept { return static_cast<std::size_t>(starts_[face]); }
  std::size_t end(std::size_t face) const noexcept { return face + 1 < face_count() ? begin(face + 1) : corner_count(); }
  std::size_t most_corners() const noexcept;

  /// Calls for the corners of each triangle of a face, a fan about its first.
  void for_triangles(std::size_t face, const auto& call) const {
    for (std::size_t c = begin(face) + 2; c < end(face); ++c) call(begin(face), c - 1, c);
  }

 private:
  void require_faces(const std::string& name) const;
  void require_numbers(const std::string& name) const;

  MeshArrays arrays_;
  std::span<const std::int32_t> starts_;  ///< without their end
  std::size_t vertex_count_ = 0;
  bool has_normals_ = false;
};

std::vector<MeshFaces> faces_of(std::span<const MeshArrays> meshes);

/// @throws InvalidShape naming a line that has less than two points or one that is not finite.
void require_lines(std::span<const Polyline> lines);

std::size_t point_count(const Polyline& line);
glm::dvec3 point_of(const Polyline& line, std::size_t i);

/// Calls for both ends of each piece of a line.
void for_pieces(const Polyline& line, const auto& call) {
  const std::size_t count = point_count(line);
  for (std::size_t i = 1; i < count; ++i) call(i - 1, i);
  if (line.closed) call(count - 1, std::size_t{0});
}

/// The normal of a triangle, of length 1, or zero where it has none.
glm::dvec3 normal_of(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

/// Four bytes, the lowest first.
void append(std::string& out, std::uint32_t number);

/// @throws InvalidShape if a coordinate is too large for single precision
glm::vec3 single_of(const glm::dvec3& point);

void append(std::string& out, const glm::vec3& point);

}  // namespace splinecore
#pragma GCC visibility pop
