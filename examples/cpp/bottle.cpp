// A bottle: closed sections through points, a loft through them, its area, and a mesh in an STL file.
//
//     bottle FILE.stl

#include <cmath>
#include <cstdint>
#include <fstream>
#include <iostream>
#include <numbers>
#include <splinecore/base/errors.hpp>
#include <splinecore/fit/interpolate.hpp>
#include <splinecore/measure/area.hpp>
#include <splinecore/surface/loft.hpp>
#include <splinecore/tessellate/tessellation.hpp>

namespace sc = splinecore;

namespace {

/// A closed cubic through eight points of an ellipse with flattened sides.
sc::NurbsCurve section(double height, double width, double depth) {
  std::vector<glm::dvec3> points;
  for (int i = 0; i < 8; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 8.0;
    const double flat = i % 2 == 0 ? 1.0 : 1.1;
    points.emplace_back(flat * width * std::cos(angle), flat * depth * std::sin(angle), height);
  }
  return sc::interpolate_calmly(points, {.closing = sc::Closing::closed}).value;
}

void write(std::ofstream& file, const void* data, std::size_t size) { file.write(static_cast<const char*>(data), std::streamsize(size)); }

/// Faces as fans of triangles, in binary.
void write_stl(const std::string& path, const sc::Tessellation& mesh, const std::vector<float>& positions) {
  std::ofstream file(path, std::ios::binary);
  const char header[80] = "splinecore";
  const auto starts = mesh.face_starts();
  const auto corners = mesh.corner_vertices();
  const auto count = static_cast<std::uint32_t>(corners.size() - 2 * starts.size());
  write(file, header, sizeof header);
  write(file, &count, sizeof count);
  for (std::size_t face = 0; face < starts.size(); ++face) {
    const std::size_t end = face + 1 < starts.size() ? static_cast<std::size_t>(starts[face + 1]) : corners.size();
    for (auto i = static_cast<std::size_t>(starts[face]) + 2; i < end; ++i) {
      const float normal[3] = {0.0F, 0.0F, 0.0F};
      const std::uint16_t rest = 0;
      write(file, normal, sizeof normal);
      for (const std::size_t corner : {static_cast<std::size_t>(starts[face]), i - 1, i}) {
        write(file, &positions[3 * static_cast<std::size_t>(corners[corner])], 3 * sizeof(float));
      }
      write(file, &rest, sizeof rest);
    }
  }
}

}  // namespace

int main(int count, char** arguments) try {
  if (count != 2) {
    std::cerr << "bottle FILE.stl\n";
    return 2;
  }
  const std::vector<sc::LoftSection> sections{section(0.0, 3.0, 1.6), section(4.0, 3.4, 2.0), section(9.0, 3.0, 1.8),
                                              section(11.0, 1.2, 1.2), section(12.5, 1.2, 1.2)};
  const sc::NurbsPatch side = sc::loft(sections).value;
  const sc::AnyPatch patches[] = {side};
  const sc::PatchSet bottle = sc::PatchSet::of(patches, true);
  const auto mesh = sc::Tessellation::adaptive(bottle, {.distance = 0.01, .angle = 0.3});
  std::vector<float> positions(3 * mesh.vertex_count());
  mesh.evaluate_positions(bottle, positions);
  write_stl(arguments[1], mesh, positions);
  std::cout << "area " << sc::area(bottle, 1e-6).value << ", " << mesh.vertex_count() << " vertices, " << mesh.face_starts().size() << " faces\n";
  return 0;
} catch (const std::exception& error) {
  std::cerr << "bottle: " << error.what() << "\n";
  return 1;
}
