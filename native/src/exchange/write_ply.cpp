#include <algorithm>
#include <limits>
#include <utility>

#include "mesh_faces.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"

namespace splinecore {

namespace {

constexpr std::size_t kStepsOfVertex = 50;
/// Counts of corners are one byte where that has room for them.
constexpr std::size_t kMostInByte = 255;

struct Counts {
  std::size_t vertices = 0, faces = 0, edges = 0, most_corners = 0;

  Counts(std::span<const MeshFaces> meshes, std::span<const Polyline> lines) {
    for (const MeshFaces& mesh : meshes) {
      vertices += mesh.vertex_count();
      faces += mesh.face_count();
      most_corners = std::max(most_corners, mesh.most_corners());
    }
    for (const Polyline& line : lines) {
      vertices += point_count(line);
      edges += point_count(line) - (line.closed ? 0 : 1);
    }
    if (std::cmp_less_equal(vertices, std::numeric_limits<std::int32_t>::max())) return;
    throw InvalidShape("a PLY file has room for 2^31 - 1 vertices, not for " + std::to_string(vertices));
  }
};

std::string header_of(const Counts& counts) {
  std::string out = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(counts.vertices) + "\n";
  for (const char axis : {'x', 'y', 'z'}) out += std::string("property float ") + axis + "\n";
  out += "element face " + std::to_string(counts.faces) + "\nproperty list ";
  out += counts.most_corners <= kMostInByte ? "uchar" : "uint";
  out += " int vertex_indices\n";
  if (counts.edges > 0) out += "element edge " + std::to_string(counts.edges) + "\nproperty int vertex1\nproperty int vertex2\n";
  return out + "end_header\n";
}

void write_faces(std::string& out, const MeshFaces& mesh, std::size_t vertices_before, bool is_byte) {
  for (std::size_t i = 0; i < mesh.face_count(); ++i) {
    breathe(kStepsOfVertex);
    const std::size_t count = mesh.end(i) - mesh.begin(i);
    if (is_byte) out += static_cast<char>(count);
    else append(out, static_cast<std::uint32_t>(count));
    for (std::size_t c = mesh.begin(i); c < mesh.end(i); ++c) {
      append(out, static_cast<std::uint32_t>(vertices_before + mesh.vertex(c)));
    }
  }
}

}  // namespace

std::string to_ply(std::span<const MeshArrays> arrays, std::span<const Polyline> lines) {
  require_lines(lines);
  const std::vector<MeshFaces> meshes = faces_of(arrays);
  const Counts counts(meshes, lines);
  std::string out = header_of(counts);
  for (const MeshFaces& mesh : meshes) {
    for (std::size_t i = 0; i < mesh.vertex_count(); ++i) append(out, single_of(mesh.position(i)));
  }
  for (const Polyline& line : lines) {
    for (std::size_t i = 0; i < point_count(line); ++i) append(out, single_of(point_of(line, i)));
  }
  std::size_t before = 0;
  for (const MeshFaces& mesh : meshes) {
    write_faces(out, mesh, before, counts.most_corners <= kMostInByte);
    before += mesh.vertex_count();
  }
  for (const Polyline& line : lines) {
    for_pieces(line, [&](std::size_t a, std::size_t b) {
      append(out, static_cast<std::uint32_t>(before + a));
      append(out, static_cast<std::uint32_t>(before + b));
    });
    before += point_count(line);
  }
  return out;
}

}  // namespace splinecore
