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
            }, py::arg("degree"),
            "(degree + 1, degree + 1): [t^degree … t 1] @ matrix @ points is a B-spline segment with knots one\n"
            "apart, t from 0 to 1. Every number is right in its last digit; degrees 0 to 18. Lecture row S13.");
  basis.def("uniform_to_bezier", [](const py::object& degree) {
              return square(splinecore::uniform_to_bezier(integer(degree, "degree")));
            }, py::arg("degree"),
            "(degree + 1, degree + 1): matrix @ points are the Bezier points of such a segment. Lecture row S13.");
  basis.def("bezier_matrix", [](const py::object& degree) {
              return square(splinecore::bezier_matrix(integer(degree, "degree")));
            }, py::arg("degree"),
            "(degree + 1, degree + 1): [t^degree … t 1] @ matrix @ points is the Bezier curve. Integers; degrees\n"
            "0 to 33, above which doubles do not hold them. Lecture row S6.");
  basis.def("hermite_matrix", [] { return square(splinecore::hermite_matrix()); },
            "(4, 4): [t³ t² t 1] @ matrix @ (P1, R1, P4, R4) is Hermite's cubic. Lecture row S4.");
}

}  // namespace bindings
