#include "mesh_files.hpp"

#include <deque>
#include <string>
#include <utility>
#include <vector>

#include "arrays.hpp"
#include "long_calls.hpp"
#include "splinecore/exchange/meshes.hpp"

namespace bindings {

using splinecore::InvalidShape;
using splinecore::MeshArrays;
using splinecore::Polyline;

namespace {

/// The parts of a tuple or list.
std::vector<py::object> parts_of(const py::handle& value, std::size_t count, const std::string& name) {
  if (!py::isinstance<py::sequence>(value) || py::isinstance<py::str>(value)) {
    throw py::type_error(name + " must be a tuple of " + std::to_string(count) + ", not " + type_name(value));
  }
  std::vector<py::object> parts;
  for (const py::handle& part : py::cast<py::sequence>(value)) parts.push_back(py::reinterpret_borrow<py::object>(part));
  if (parts.size() == count) return parts;
  throw InvalidShape(name + " has " + std::to_string(parts.size()) + " parts, not " + std::to_string(count));
}

void require_three_columns(const py::array& rows, const char* name) {
  if (rows.ndim() == 2 && rows.shape(1) == 3) return;
  throw InvalidShape(std::string(name) + " has shape " + shape_text(rows) + ", (n, 3) is expected");
}

/// Meshes, and the arrays that they are views of.
class GivenMeshes {
 public:
  explicit GivenMeshes(const py::object& meshes) {
    for (const py::handle& mesh : py::iter(meshes)) {
      const auto parts = parts_of(mesh, 4, "meshes" + splinecore::index_text(meshes_.size()));
      MeshArrays own;
      own.positions = coordinates(parts[0], "positions");
      if (!parts[1].is_none()) own.corner_normals = coordinates(parts[1], "normals");
      own.face_starts = integers(parts[2], "face starts");
      own.corner_vertices = integers(parts[3], "vertices");
      meshes_.push_back(own);
    }
  }

  std::span<const MeshArrays> meshes() const noexcept { return meshes_; }

 private:
  splinecore::Coordinates coordinates(const py::object& value, const char* name) {
    py::array given = array_of(value, name);
    if (py::isinstance<py::array_t<float>>(given)) {
      const py::array_t<float, py::array::c_style | py::array::forcecast> rows(given);
      require_three_columns(rows, name);
      kept_.push_back(rows);
      return std::span(rows.data(), static_cast<std::size_t>(rows.size()));
    }
    const Doubles rows = real_array(value, name);
    require_three_columns(rows, name);
    kept_.push_back(rows);
    return std::span(rows.data(), static_cast<std::size_t>(rows.size()));
  }

  std::span<const std::int32_t> integers(const py::object& value, const char* name) {
    const py::array given = array_of(value, name);
    const bool is_empty = given.size() == 0;
    if (given.ndim() != 1) throw InvalidShape(std::string(name) + " has shape " + shape_text(given) + ", (n,) is expected");
    if (!is_empty && given.dtype().kind() != 'i' && given.dtype().kind() != 'u') {
      throw py::type_error(std::string(name) + " must be integers, not " + std::string(py::str(given.dtype())));
    }
    const py::array_t<std::int64_t, py::array::c_style | py::array::forcecast> wide(given);
    std::vector<std::int32_t>& own = integers_.emplace_back();
    own.reserve(static_cast<std::size_t>(wide.size()));
    for (py::ssize_t i = 0; i < wide.size(); ++i) {
      const std::int64_t number = wide.data()[i];
      if (!std::in_range<std::int32_t>(number)) {
        throw InvalidShape(std::string(name) + splinecore::index_text(static_cast<std::size_t>(i)) + " = " +
                           std::to_string(number) + " is too large");
      }
      own.push_back(static_cast<std::int32_t>(number));
    }
    return own;
  }

  std::vector<MeshArrays> meshes_;
  std::vector<py::array> kept_;
  std::deque<std::vector<std::int32_t>> integers_;
};

std::vector<Polyline> lines_of(const py::object& lines) {
  std::vector<Polyline> found;
  for (const py::handle& line : py::iter(lines)) {
    const auto parts = parts_of(line, 2, "lines" + splinecore::index_text(found.size()));
    const Doubles points = real_array(parts[0], "points of a line");
    require_three_columns(points, "points of a line");
    found.push_back({{points.data(), points.data() + points.size()}, boolean(parts[1], "closed")});
  }
  return found;
}

std::string file_of(const std::string& ending, std::span<const MeshArrays> meshes, std::span<const Polyline> lines) {
  if (ending == ".obj") return splinecore::to_obj(meshes, lines);
  if (ending == ".ply") return splinecore::to_ply(meshes, lines);
  if (ending == ".stl") return splinecore::to_stl(meshes);
  return splinecore::to_glb(meshes, lines);
}

}  // namespace

void bind_mesh_files(py::module_& module) {
  module.def("_mesh_file", [](const std::string& ending, const py::object& meshes, const py::object& lines) {
    const GivenMeshes given(meshes);
    const std::vector<Polyline> given_lines = lines_of(lines);
    return py::bytes(unlocked([&] { return file_of(ending, given.meshes(), given_lines); }));
  }, py::arg("ending"), py::arg("meshes"), py::arg("lines"));
}

}  // namespace bindings
