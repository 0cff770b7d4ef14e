#include <algorithm>
#include <cctype>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <limits>
#include <system_error>
#include <type_traits>

#include "splinecore/base/errors.hpp"
#include "splinecore/exchange/meshes.hpp"
#include "splinecore/tessellate/tessellation.hpp"

namespace splinecore {

namespace {

constexpr int kFaces = 8, kPieces = 32;

/// What becomes of shapes in a file.
class Shown {
 public:
  explicit Shown(const MeshFineness& fineness) : fineness_(fineness) {
    if (fineness.resolution && (fineness.tolerance || fineness.angle)) {
      throw InvalidShape("resolution counts faces, tolerance and angle measure them: give one or the others");
    }
  }

  void add(const Value& value) {
    std::visit([this](const auto& shape) { add_shape(shape); }, value);
  }

  bool has_lines() const noexcept { return !lines_.empty(); }

  std::string text(const std::string& ending) const {
    std::vector<MeshArrays> meshes;
    for (const Made& made : meshes_) {
      meshes.push_back({made.positions, made.normals, made.mesh.face_starts(), made.mesh.corner_vertices()});
    }
    if (ending == ".obj") return to_obj(meshes, lines_);
    if (ending == ".ply") return to_ply(meshes, lines_);
    return ending == ".stl" ? to_stl(meshes) : to_glb(meshes, lines_);
  }

 private:
  struct Made {
    Tessellation mesh;
    std::vector<float> positions, normals;
  };

  Tessellation mesh_of(const PatchSet& set) const {
    const int faces = fineness_.resolution.value_or(kFaces);
    if (!fineness_.tolerance && !fineness_.angle) return Tessellation::make(set, faces, faces);
    constexpr double kAny = std::numeric_limits<double>::infinity();
    return Tessellation::adaptive(set, {fineness_.tolerance.value_or(kAny), fineness_.angle.value_or(kAny)});
  }

  void add_shape(const PatchSet& set) {
    Made made{mesh_of(set), {}, {}};
    made.positions.resize(3 * made.mesh.vertex_count());
    made.normals.resize(3 * made.mesh.corner_vertices().size());
    made.mesh.evaluate(set, made.positions, made.normals);
    meshes_.push_back(std::move(made));
  }

  void add_shape(const Region& region) {
    for (const NurbsCurve& outline : region.outlines()) add_shape(outline);
  }

  template <class Shape>
  void add_shape(const Shape& shape) {
    if constexpr (std::is_constructible_v<AnyPatch, Shape>) {
      const AnyPatch patch(shape);
      add_shape(PatchSet::of(std::span(&patch, 1), true));
    } else if constexpr (std::is_same_v<Shape, NurbsCurve>) {
      std::ranges::move(polylines(shape, fineness_.resolution.value_or(kPieces)), std::back_inserter(lines_));
    } else {
      add_shape(shape.nurbs());
    }
  }

  MeshFineness fineness_;
  std::vector<Made> meshes_;
  std::vector<Polyline> lines_;
};

std::string ending_of(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  for (const char* known : {".obj", ".ply", ".stl", ".glb"}) {
    if (ending == known) return ending;
  }
  throw InvalidShape(path.filename().string() + ": .obj, .ply, .stl, .glb can be written");
}

void write_whole(const std::filesystem::path& path, const std::string& text) {
  std::filesystem::path part = path;
  part += ".part";
  errno = 0;
  {
    std::ofstream file(part, std::ios::binary);
    file.write(text.data(), static_cast<std::streamsize>(text.size()));
    file.close();
    if (!file) {
      const std::error_code code(errno != 0 ? errno : EIO, std::generic_category());
      std::error_code ignored;
      std::filesystem::remove(part, ignored);
      throw std::filesystem::filesystem_error("a mesh cannot be written", path, code);
    }
  }
  try {
    std::filesystem::rename(part, path);
  } catch (const std::filesystem::filesystem_error&) {
    std::error_code ignored;
    std::filesystem::remove(part, ignored);
    throw;
  }
}

}  // namespace

void save_meshes(const std::filesystem::path& path, const Document& shapes, const MeshFineness& fineness) {
  const std::string ending = ending_of(path);
  Shown shown(fineness);
  if (const auto* only = std::get_if<Value>(&shapes)) {
    shown.add(*only);
  } else {
    for (const Value& one : std::get<std::vector<Value>>(shapes)) shown.add(one);
  }
  if (ending == ".stl" && shown.has_lines()) throw InvalidShape("STL holds triangles alone, no curves");
  write_whole(path, shown.text(ending));
}

}  // namespace splinecore
