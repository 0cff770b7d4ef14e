#include "rational.hpp"

#include "arrays.hpp"
#include "classes.hpp"
#include "long_calls.hpp"
#include "splinecore/curve/casteljau.hpp"
#include "splinecore/curve/finite_arcs.hpp"
#include "splinecore/curve/moebius.hpp"

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
          }, py::arg("length"),
          "[NurbsCurve, …]: what of the curve lies within length of the box of its finite control points, in\n"
          "each coordinate. Every arc is the curve itself on a part of its domain, with positive weights and\n"
          "no control point farther out than twice the length. Lecture rows S10, S11.");
  cls.def("moebius", [](const Curve& self, const py::object& rho) {
            const double ratio = real(rho, "rho");
            return unlocked([&] { return splinecore::moebius(self, ratio); });
          }, py::arg("rho"),
          "The same curve under the parameter t = rho u / ((1 - u) + rho u): Bezier weights are multiplied by\n"
          "rho**i. Of a NURBS curve the domain and the points stay, knots and weights change (Lee and Lucian\n"
          "1991); a periodic one comes out plain. InvalidShape unless rho > 0. Lecture row S12.");
  cls.def("standard_form", [](const Curve& self) { return splinecore::standard_form(self); },
          "The same curve with the weight 1 at both ends; InvalidShape unless both end weights have one sign\n"
          "and the curve is clamped. Lecture row S12.");
}

}  // namespace

void bind_rational_verbs(Class<NurbsCurve>& cls) { bind_common(cls); }

void bind_rational_verbs(Class<BezierCurve>& cls) {
  bind_common(cls);
  cls.def("casteljau_triangle", [](const BezierCurve& self, const py::object& u) {
            return arrays_of(splinecore::casteljau_triangle(self, real(u, "u")));
          }, py::arg("u"),
          "All rows of the homogeneous algorithm at u: degree + 1, degree, … 1 points (k, 4), each wx, wy, wz, w.\n"
          "Defined at any weights and any finite u: outside [0, 1] it extrapolates. InvalidShape if a number would be\n"
          "too large. Lecture row S9.");
  cls.def("rational_casteljau_triangle", &rational_rows, py::arg("u"),
          "(rows, breakdown): all rows of the rational algorithm at u, (k, 4) arrays of x, y, z, w, and None.\n"
          "Where it would divide by zero, or overflow: the rows before, and (row, index, reason). Outside [0, 1] it\n"
          "extrapolates. Farin 1983; row S9.");
}

}  // namespace bindings
