#include <limits>

#include "mesh_faces.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"

namespace splinecore {

namespace {

constexpr std::size_t kStepsOfTriangle = 100, kHeader = 80, kRecord = 50;

}  // namespace

std::string to_stl(std::span<const MeshArrays> arrays) {
  const std::vector<MeshFaces> meshes = faces_of(arrays);
  std::size_t count = 0;
  for (const MeshFaces& mesh : meshes) count += mesh.triangle_count();
  if (count > std::numeric_limits<std::uint32_t>::max()) {
    throw InvalidShape("an STL file has room for 2^32 - 1 triangles, not for " + std::to_string(count));
  }
  std::string out = "splinecore";
  out.reserve(kHeader + 4 + kRecord * count);
  out.resize(kHeader, ' ');
  append(out, static_cast<std::uint32_t>(count));
  for (const MeshFaces& mesh : meshes) {
    for (std::size_t i = 0; i < mesh.face_count(); ++i) {
      mesh.for_triangles(i, [&](std::size_t a, std::size_t b, std::size_t c) {
        breathe(kStepsOfTriangle);
        const glm::vec3 corners[] = {single_of(mesh.corner_position(a)), single_of(mesh.corner_position(b)),
                                     single_of(mesh.corner_position(c))};
        append(out, glm::vec3(normal_of(corners[0], corners[1], corners[2])));
        for (const glm::vec3& corner : corners) append(out, corner);
        out.append(2, '\0');
      });
    }
  }
  return out;
}

}  // namespace splinecore
