#include "mesh_faces.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "splinecore/base/errors.hpp"

namespace splinecore {

namespace {

std::size_t size_of(const Coordinates& rows) {
  return std::visit([](const auto& numbers) { return numbers.size(); }, rows);
}

glm::dvec3 row_of(const Coordinates& rows, std::size_t i) {
  return std::visit([i](const auto& numbers) { return glm::dvec3(numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]); }, rows);
}

bool is_finite(const glm::dvec3& point) { return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z); }

void require_rows(const Coordinates& rows, const std::string& what) {
  if (size_of(rows) % 3 != 0) throw InvalidShape(what + ": there must be three numbers in each row");
  for (std::size_t i = 0; i < size_of(rows) / 3; ++i) {
    if (!is_finite(row_of(rows, i))) throw InvalidShape(what + index_text(i) + " must be finite");
  }
}

}  // namespace

MeshFaces::MeshFaces(const MeshArrays& arrays, const std::string& name)
    : arrays_(arrays), starts_(arrays.face_starts), vertex_count_(size_of(arrays.positions) / 3),
      has_normals_(size_of(arrays.corner_normals) > 0) {
  if (!starts_.empty() && std::cmp_equal(starts_.back(), corner_count())) starts_ = starts_.first(starts_.size() - 1);
  require_faces(name);
  require_numbers(name);
}

void MeshFaces::require_faces(const std::string& name) const {
  const auto count = static_cast<std::int64_t>(corner_count());
  bool fits = starts_.empty() ? count == 0 : starts_[0] == 0;
  for (std::size_t i = 0; i < starts_.size() && fits; ++i) {
    const std::int64_t next = i + 1 < starts_.size() ? starts_[i + 1] : count;
    fits = next - starts_[i] >= 3;
  }
  if (fits) return;
  throw InvalidShape(name + ": face starts are 0 and grow by at least 3 up to the " + std::to_string(count) + " corners; these " +
                     (starts_.empty() ? "are none" : "end with " + std::to_string(starts_.back())));
}

void MeshFaces::require_numbers(const std::string& name) const {
  for (std::size_t i = 0; i < corner_count(); ++i) {
    const std::int32_t vertex = arrays_.corner_vertices[i];
    if (vertex >= 0 && std::cmp_less(vertex, vertex_count_)) continue;
    throw InvalidShape(name + ": vertex " + std::to_string(vertex) + " of corner " + std::to_string(i) + " is not one of " +
                       std::to_string(vertex_count_));
  }
  if (has_normals_ && size_of(arrays_.corner_normals) != 3 * corner_count()) {
    throw InvalidShape(name + ": there are " + std::to_string(size_of(arrays_.corner_normals) / 3) + " normals for " +
                       std::to_string(corner_count()) + " corners");
  }
  require_rows(arrays_.positions, name + ": positions");
  require_rows(arrays_.corner_normals, name + ": normals");
}

glm::dvec3 MeshFaces::position(std::size_t vertex) const noexcept { return row_of(arrays_.positions, vertex); }

glm::dvec3 MeshFaces::normal(std::size_t corner) const noexcept { return row_of(arrays_.corner_normals, corner); }

std::size_t MeshFaces::most_corners() const noexcept {
  std::size_t most = 0;
  for (std::size_t i = 0; i < face_count(); ++i) most = std::max(most, end(i) - begin(i));
  return most;
}

std::vector<MeshFaces> faces_of(std::span<const MeshArrays> meshes) {
  std::vector<MeshFaces> found;
  found.reserve(meshes.size());
  for (const MeshArrays& mesh : meshes) found.emplace_back(mesh, "meshes" + index_text(found.size()));
  return found;
}

void require_lines(std::span<const Polyline> lines) {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string name = "lines" + index_text(i);
    require_rows(std::span<const double>(lines[i].points), name + ": points");
    if (point_count(lines[i]) < 2) throw InvalidShape(name + " has less than two points");
  }
}

std::size_t point_count(const Polyline& line) { return line.points.size() / 3; }

glm::dvec3 point_of(const Polyline& line, std::size_t i) {
  return {line.points[3 * i], line.points[3 * i + 1], line.points[3 * i + 2]};
}

glm::dvec3 normal_of(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 across = glm::cross(b - a, c - a);
  const double length = std::hypot(across.x, across.y, across.z);
  return length > 0.0 && std::isfinite(length) ? across / length : glm::dvec3(0.0);
}

void append(std::string& out, std::uint32_t number) {
  char bytes[4];
  for (int k = 0; k < 4; ++k) bytes[k] = static_cast<char>(number >> (8 * k) & 0xff);
  out.append(bytes, 4);
}

glm::vec3 single_of(const glm::dvec3& point) {
  const glm::vec3 single(point);
  if (is_finite(single)) return single;
  const double largest = std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)});
  throw InvalidShape("a coordinate of " + text_of(largest) + " is too large for a file in single precision");
}

void append(std::string& out, const glm::vec3& point) {
  for (int k = 0; k < 3; ++k) append(out, std::bit_cast<std::uint32_t>(point[k]));
}

}  // namespace splinecore
