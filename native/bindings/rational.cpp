#include "rational.hpp"

#include "arrays.hpp"
#include "classes.hpp"
#include "long_calls.hpp"
#include "splinecore/curve/casteljau.hpp"
#include "splinecore/curve/finite_arcs.hpp"
#include "splinecore/curve/moebius.hpp"
#include "splinecore/curve/multiply.hpp"

namespace bindings {

using splinecore::BezierCurve;
using splinecore::NurbsCurve;

namespace {

py::list arrays_of(const splinecore::Triangle& rows) {
  py::list arrays;
  for (const auto& row : rows) {
    py::array_t<double> array({row.size(), std::size_t{4}});
    for (std::size_t i = 0; i < row.size(); ++i) {
      for (int k = 0; k < 4; ++k) array.mutable_at(i, k) = row[i][k];
    }
    arrays.append(array);
  }
  return arrays;
}

py::tuple rational_rows(const BezierCurve& curve, const py::object& u) {
  const auto triangle = splinecore::rational_casteljau_triangle(curve, real(u, "u"));
  py::object breakdown = py::none();
  if (triangle.breakdown) {
    breakdown = py::make_tuple(triangle.breakdown->row, triangle.breakdown->index, triangle.breakdown->reason);
  }
  return py::make_tuple(arrays_of(triangle.rows), breakdown);
}

const NurbsCurve& form(const NurbsCurve& curve) { return curve; }
const NurbsCurve& form(const BezierCurve& curve) { return curve.nurbs(); }

template <class Curve>
void bind_common(Class<Curve>& cls) {
  cls.def("finite_arcs", [](const Curve& self, const py::object& length) {
            const double most = real(length, "length");
            return unlocked([&] { return splinecore::finite_arcs(form(self), most); });
          }, py::arg("length"));
  cls.def("moebius", [](const Curve& self, const py::object& rho) {
            const double ratio = real(rho, "rho");
            return unlocked([&] { return splinecore::moebius(self, ratio); });
          }, py::arg("rho"));
  cls.def("multiplied", [](const Curve& self, const py::object& start, const py::object& end) {
            const double first = real(start, "start");
            const double last = real(end, "end");
            return unlocked([&] { return splinecore::multiplied(self, first, last); });
          }, py::arg("start"), py::arg("end"));
  cls.def("standard_form", [](const Curve& self) { return splinecore::standard_form(self); });
}

}  // namespace

void bind_rational_verbs(Class<NurbsCurve>& cls) { bind_common(cls); }

void bind_rational_verbs(Class<BezierCurve>& cls) {
  bind_common(cls);
  cls.def("casteljau_triangle", [](const BezierCurve& self, const py::object& u) {
            return arrays_of(splinecore::casteljau_triangle(self, real(u, "u")));
          }, py::arg("u"));
  cls.def("rational_casteljau_triangle", &rational_rows, py::arg("u"));
}

}  // namespace bindings
