#include <cmath>
#include <string>
#include <vector>

#include "arrays.hpp"
#include "classes.hpp"
#include "long_calls.hpp"
#include "point_arguments.hpp"
#include "result_pickles.hpp"
#include "rooms.hpp"
#include "splinecore/surface/catmull_clark.hpp"
#include "values.hpp"

namespace bindings {

using splinecore::ControlMesh;
using splinecore::InvalidShape;
using splinecore::SubdivisionPatches;

namespace {

std::vector<std::vector<int>> faces_of(const py::object& value) {
  const bool is_sequence = py::isinstance<py::sequence>(value) && !py::isinstance<py::str>(value);
  if (!is_sequence && !py::isinstance<py::array>(value)) {
    throw py::type_error("faces must be a list of lists of point numbers, not " + type_name(value));
  }
  std::vector<std::vector<int>> faces;
  for (const py::handle& item : value) {
    const std::string name = "faces" + splinecore::index_text(faces.size());
    std::vector<int> face;
    for (const py::handle& corner : item) face.push_back(integer(corner, name.c_str()));
    faces.push_back(std::move(face));
  }
  return faces;
}

ControlMesh mesh_of(const py::object& points, const py::object& faces) {
  const Doubles rows = real_array(points, "points");
  if (rows.ndim() != 2 || rows.shape(1) != 3) throw InvalidShape("points must have the shape (n, 3), not " + shape_text(rows));
  ControlMesh mesh;
  for (py::ssize_t i = 0; i < rows.shape(0); ++i) {
    const double* const p = rows.data() + 3 * i;
    mesh.points.emplace_back(p[0], p[1], p[2]);
  }
  mesh.faces = faces_of(faces);
  return mesh;
}

void bind_patches_of_subdivision(py::module_& module) {
  Class<SubdivisionPatches> cls(module, "SubdivisionPatches", py::module_local());
  seal(cls);
  pickle_members(cls, &SubdivisionPatches::patches, &SubdivisionPatches::rounds, &SubdivisionPatches::irregular,
                  &SubdivisionPatches::angle);
  cls.def_property_readonly("patches", [](const SubdivisionPatches& self) { return py::tuple(py::cast(self.patches)); });
  cls.def_readonly("rounds", &SubdivisionPatches::rounds);
  cls.def_readonly("irregular", &SubdivisionPatches::irregular);
  cls.def_readonly("angle", &SubdivisionPatches::angle);
  cls.def("__repr__", [](const SubdivisionPatches& self) {
    return "SubdivisionPatches(" + std::to_string(self.patches.size()) + " patches, rounds=" + std::to_string(self.rounds) +
           ", irregular=" + std::to_string(self.irregular) + ", angle=" + splinecore::text_of(self.angle) + ")";
  });
}

}  // namespace

void bind_subdivisions(py::module_& module) {
  bind_patches_of_subdivision(module);
  py::module_ build = module.attr("build");
  build.def("catmull_clark", [](const py::object& points, const py::object& faces, const py::object& cancel) {
              const ControlMesh mesh = mesh_of(points, faces);
              return unlocked([&] { return splinecore::catmull_clark(mesh); }, cancel);
            }, py::arg("points"), py::arg("faces"), py::kw_only(), py::arg("cancel") = py::none());
}

}  // namespace bindings
