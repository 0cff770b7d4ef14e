#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "mesh_faces.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"

namespace splinecore {

namespace {

using OrderedJson = nlohmann::ordered_json;
constexpr std::size_t kStepsOfRow = 100;
/// Numbers of the format.
constexpr int kFloat = 5126, kUnsigned = 5125, kOfVertices = 34962, kOfIndices = 34963, kLines = 1, kTriangles = 4;

OrderedJson row_of(const glm::vec3& point) { return OrderedJson::array({point.x, point.y, point.z}); }

/// A list of one object that has one entry.
OrderedJson list_of(const char* key, OrderedJson value) {
  OrderedJson object = OrderedJson::object();
  object[key] = std::move(value);
  OrderedJson list = OrderedJson::array();
  list.push_back(std::move(object));
  return list;
}

/// Of length 1, as the format wants them: of a corner without a normal it is that of the face.
glm::vec3 normal_at(const MeshFaces& mesh, std::size_t face, std::size_t corner) {
  const glm::dvec3 given = mesh.normal(corner);
  const double length = std::hypot(given.x, given.y, given.z);
  constexpr double kNear = 1e-6;
  if (std::abs(length - 1.0) < kNear) return given;
  if (length > 0.0 && std::isfinite(length)) return given / length;
  glm::dvec3 sum(0.0);
  mesh.for_triangles(face, [&](std::size_t a, std::size_t b, std::size_t c) {
    sum += glm::cross(mesh.corner_position(b) - mesh.corner_position(a), mesh.corner_position(c) - mesh.corner_position(a));
  });
  const double size = std::hypot(sum.x, sum.y, sum.z);
  return size > 0.0 && std::isfinite(size) ? sum / size : glm::dvec3(0.0, 0.0, 1.0);
}

/// Collects accessors, one for each array, on one buffer.
class Gltf {
 public:
  int points(std::size_t count, const auto& point) {
    glm::vec3 lowest(std::numeric_limits<float>::infinity()), highest(-std::numeric_limits<float>::infinity());
    begin(count, kFloat, "VEC3", kOfVertices);
    for (std::size_t i = 0; i < count; ++i) {
      breathe(kStepsOfRow);
      const glm::vec3 own = point(i);
      lowest = glm::min(lowest, own);
      highest = glm::max(highest, own);
      append(data_, own);
    }
    accessors_.back()["min"] = row_of(lowest);
    accessors_.back()["max"] = row_of(highest);
    return end();
  }

  int normals(const MeshFaces& mesh) {
    begin(mesh.corner_count(), kFloat, "VEC3", kOfVertices);
    for (std::size_t face = 0; face < mesh.face_count(); ++face) {
      breathe(kStepsOfRow);
      for (std::size_t c = mesh.begin(face); c < mesh.end(face); ++c) append(data_, normal_at(mesh, face, c));
    }
    return end();
  }

  /// @param write  calls its argument with each index
  int indices(std::size_t count, const auto& write) {
    begin(count, kUnsigned, "SCALAR", kOfIndices);
    write([&](std::size_t index) { append(data_, static_cast<std::uint32_t>(index)); });
    return end();
  }

  void add(const OrderedJson& attributes, int indices, int mode) {
    primitives_.push_back({{"attributes", attributes}, {"indices", indices}, {"mode", mode}});
  }

  std::string file() const {
    OrderedJson top = OrderedJson::object();
    top["asset"]["version"] = "2.0";
    top["asset"]["generator"] = "splinecore";
    if (!primitives_.empty()) {
      top["scene"] = 0;
      top["scenes"] = list_of("nodes", OrderedJson::array({0}));
      top["nodes"] = list_of("mesh", 0);
      top["meshes"] = list_of("primitives", primitives_);
      top["accessors"] = accessors_;
      top["bufferViews"] = views_;
      top["buffers"] = list_of("byteLength", data_.size());
    }
    std::string text = top.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    constexpr std::size_t kHeader = 12, kChunk = 8;
    const std::size_t whole = kHeader + kChunk + text.size() + (primitives_.empty() ? 0 : kChunk + data_.size());
    if (whole > std::numeric_limits<std::uint32_t>::max()) {
      throw InvalidShape("a GLB file has room for 2^32 - 1 bytes, not for " + std::to_string(whole));
    }
    std::string out = "glTF";
    out.reserve(whole);
    for (const std::size_t number : {std::size_t{2}, whole}) append(out, static_cast<std::uint32_t>(number));
    append_chunk(out, {"JSON", 4}, text);
    if (!primitives_.empty()) append_chunk(out, {"BIN\0", 4}, data_);
    return out;
  }

 private:
  static void append_chunk(std::string& out, std::string_view kind, const std::string& data) {
    append(out, static_cast<std::uint32_t>(data.size()));
    (out += kind) += data;
  }

  void begin(std::size_t count, int component, const char* type, int target) {
    views_.push_back({{"buffer", 0}, {"byteOffset", data_.size()}, {"byteLength", 0}, {"target", target}});
    accessors_.push_back({{"bufferView", views_.size() - 1}, {"componentType", component}, {"count", count}, {"type", type}});
  }

  int end() {
    views_.back()["byteLength"] = data_.size() - views_.back()["byteOffset"].get<std::size_t>();
    return static_cast<int>(accessors_.size()) - 1;
  }

  std::string data_;
  OrderedJson views_ = OrderedJson::array(), accessors_ = OrderedJson::array(), primitives_ = OrderedJson::array();
};

void add_mesh(Gltf& gltf, const MeshFaces& mesh) {
  if (mesh.face_count() == 0) return;
  const bool has_normals = mesh.has_normals();
  OrderedJson attributes = OrderedJson::object();
  attributes["POSITION"] = gltf.points(has_normals ? mesh.corner_count() : mesh.vertex_count(), [&](std::size_t i) {
    return single_of(has_normals ? mesh.corner_position(i) : mesh.position(i));
  });
  if (has_normals) attributes["NORMAL"] = gltf.normals(mesh);
  const int indices = gltf.indices(3 * mesh.triangle_count(), [&](const auto& write) {
    for (std::size_t face = 0; face < mesh.face_count(); ++face) {
      breathe(kStepsOfRow);
      mesh.for_triangles(face, [&](std::size_t a, std::size_t b, std::size_t c) {
        for (const std::size_t corner : {a, b, c}) write(has_normals ? corner : mesh.vertex(corner));
      });
    }
  });
  gltf.add(attributes, indices, kTriangles);
}

void add_line(Gltf& gltf, const Polyline& line) {
  const int points = gltf.points(point_count(line), [&](std::size_t i) { return single_of(point_of(line, i)); });
  const std::size_t pieces = point_count(line) - (line.closed ? 0 : 1);
  const int indices = gltf.indices(2 * pieces, [&](const auto& write) {
    for_pieces(line, [&](std::size_t a, std::size_t b) {
      write(a);
      write(b);
    });
  });
  OrderedJson attributes = OrderedJson::object();
  attributes["POSITION"] = points;
  gltf.add(attributes, indices, kLines);
}

}  // namespace

std::string to_glb(std::span<const MeshArrays> meshes, std::span<const Polyline> lines) {
  require_lines(lines);
  Gltf gltf;
  for (const MeshFaces& mesh : faces_of(meshes)) add_mesh(gltf, mesh);
  for (const Polyline& line : lines) add_line(gltf, line);
  return gltf.file();
}

}  // namespace splinecore
