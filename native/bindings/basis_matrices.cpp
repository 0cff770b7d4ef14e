#include "arrays.hpp"
#include "basis_matrices.hpp"
#include "splinecore/basis/uniform.hpp"

namespace bindings {

namespace {

py::array square(const splinecore::BasisMatrix& matrix) {
  py::array_t<double> out({matrix.degree + 1, matrix.degree + 1});
  std::ranges::copy(matrix.values, out.mutable_data());
  return out;
}

}  // namespace

void bind_matrices(py::module_& basis) {
  basis.def("uniform_matrix", [](const py::object& degree) {
              return square(splinecore::uniform_matrix(integer(degree, "degree")));
            }, py::arg("degree"));
  basis.def("uniform_to_bezier", [](const py::object& degree) {
              return square(splinecore::uniform_to_bezier(integer(degree, "degree")));
            }, py::arg("degree"));
  basis.def("bezier_matrix", [](const py::object& degree) {
              return square(splinecore::bezier_matrix(integer(degree, "degree")));
            }, py::arg("degree"));
  basis.def("hermite_matrix", [] { return square(splinecore::hermite_matrix()); });
}

}  // namespace bindings
