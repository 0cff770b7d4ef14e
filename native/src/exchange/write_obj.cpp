#include <array>
#include <charconv>

#include "mesh_faces.hpp"
#include "splinecore/base/pause.hpp"

namespace splinecore {

namespace {

constexpr std::size_t kStepsOfLine = 500;
constexpr int kDigits = 9, kDigitsOfNormal = 6;

void write_row(std::string& out, const char* word, const glm::dvec3& row, int digits) {
  breathe(kStepsOfLine);
  out += word;
  std::array<char, 32> text;
  for (int k = 0; k < 3; ++k) {
    out += ' ';
    const auto end = std::to_chars(text.data(), text.data() + text.size(), row[k], std::chars_format::general, digits).ptr;
    out.append(text.data(), end);
  }
  out += '\n';
}

void write_number(std::string& out, std::size_t number) {
  std::array<char, 24> text;
  out.append(text.data(), std::to_chars(text.data(), text.data() + text.size(), number).ptr);
}

/// Vertices and normals of all meshes are counted from 1.
void write_face(std::string& out, const MeshFaces& mesh, std::size_t face, std::size_t vertices_before, std::size_t normals_before) {
  out += 'f';
  for (std::size_t c = mesh.begin(face); c < mesh.end(face); ++c) {
    out += ' ';
    write_number(out, vertices_before + mesh.vertex(c) + 1);
    if (!mesh.has_normals()) continue;
    out += "//";
    write_number(out, normals_before + c + 1);
  }
  out += '\n';
}

void write_line(std::string& out, const Polyline& line, std::size_t vertices_before) {
  for (std::size_t i = 0; i < point_count(line); ++i) write_row(out, "v", point_of(line, i), kDigits);
  out += 'l';
  for (std::size_t i = 0; i < point_count(line) + (line.closed ? 1 : 0); ++i) {
    out += ' ';
    write_number(out, vertices_before + i % point_count(line) + 1);
  }
  out += '\n';
}

}  // namespace

std::string to_obj(std::span<const MeshArrays> meshes, std::span<const Polyline> lines) {
  require_lines(lines);
  std::string out;
  std::size_t vertices = 0, normals = 0;
  for (const MeshFaces& mesh : faces_of(meshes)) {
    for (std::size_t i = 0; i < mesh.vertex_count(); ++i) write_row(out, "v", mesh.position(i), kDigits);
    for (std::size_t c = 0; mesh.has_normals() && c < mesh.corner_count(); ++c) write_row(out, "vn", mesh.normal(c), kDigitsOfNormal);
    for (std::size_t i = 0; i < mesh.face_count(); ++i) write_face(out, mesh, i, vertices, normals);
    vertices += mesh.vertex_count();
    if (mesh.has_normals()) normals += mesh.corner_count();
  }
  for (const Polyline& line : lines) {
    write_line(out, line, vertices);
    vertices += point_count(line);
  }
  return out;
}

}  // namespace splinecore
