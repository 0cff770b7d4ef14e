#pragma once

#include "arrays.hpp"
#include "every_kind.hpp"
#include "long_calls.hpp"
#include "splinecore/convert/to_bezier.hpp"
#include "splinecore/convert/to_hermite.hpp"
#include "splinecore/curve/nurbs_curve.hpp"

namespace bindings {

py::array evaluate(const splinecore::NurbsCurve& curve, const py::object& u, const py::object& side,
                   const py::object& at_infinity, const py::object& dtype, const py::object& out,
                   const py::object& threads, const py::object& cancel);

py::array derivatives(const splinecore::NurbsCurve& curve, const py::object& u, const py::object& order,
                      const py::object& side, const py::object& at_infinity, const py::object& out,
                      const py::object& threads, const py::object& cancel);

py::list polylines(const splinecore::NurbsCurve& curve, const py::object& resolution, const py::object& reach,
                   const py::object& around);

py::list finite_pieces(const splinecore::NurbsCurve& curve);

/// What every kind of curve can do through its NURBS form.
template <class Curve>
void bind_common(py::class_<Curve>& cls) {
  cls.def_property_readonly("degree", [](const Curve& self) { return form(self).degree(); });
  cls.def_property_readonly("domain", [](const Curve& self) { return pair_of(form(self).domain()); },
                            "(start, end) of the parameter.");
  cls.def_property_readonly("is_rational", [](const Curve& self) { return form(self).rational(); },
                            "True unless every weight is 1.");
  cls.def("evaluate", [](const Curve& self, const py::object& u, const py::object& side, const py::object& at_infinity,
                         const py::object& dtype, const py::object& out, const py::object& threads,
                         const py::object& cancel) {
            return evaluate(form(self), u, side, at_infinity, dtype, out, threads, cancel);
          },
          py::arg("u"), py::kw_only(), py::arg("side") = "right", py::arg("at_infinity") = "raise",
          py::arg("dtype") = py::none(), py::arg("out") = py::none(), py::arg("threads") = 0,
          py::arg("cancel") = py::none(),
          "Points at parameters: (...,) -> (..., 3), float64 or, with dtype or out, float32, where a coordinate\n"
          "above 3.4e38 is inf.\n\n"
          "A parameter outside the domain by more than 4 ulp raises InvalidShape; a periodic curve takes any, modulo\n"
          "its period. At a knot the right-hand value is taken unless side='left'. Where the weight is zero\n"
          "PointAtInfinity is raised, or at_infinity='nan' marks the point. out is a C-contiguous array of the\n"
          "result's shape; cancel is a callable that ends a long call by returning True. A long batch runs on all\n"
          "cores; threads says on how many. A parameter has the same bits in any batch, in any order and on any\n"
          "number of threads. Rows S6, S9, S15.");
  cls.def("derivatives", [](const Curve& self, const py::object& u, const py::object& order, const py::object& side,
                            const py::object& at_infinity, const py::object& out, const py::object& threads,
                            const py::object& cancel) {
            return derivatives(form(self), u, order, side, at_infinity, out, threads, cancel);
          },
          py::arg("u"), py::arg("order"), py::kw_only(), py::arg("side") = "right",
          py::arg("at_infinity") = "raise", py::arg("out") = py::none(), py::arg("threads") = 0,
          py::arg("cancel") = py::none(),
          "The point and its derivatives up to order: (...,) -> (..., order + 1, 3) float64. The NURBS Book, A4.2.\n\n"
          "[..., 0, :] is what evaluate() gives, bit for bit. A derivative that is too large for a number raises\n"
          "InvalidShape, or is NaN with at_infinity='nan'.");
  cls.def("pieces", [](const Curve& self) { return finite_pieces(form(self)); },
          "Intervals [(start, end), …] on which the curve is finite and in one piece: it is cut where the\n"
          "weight is zero and at knots of multiplicity degree + 1.");
  cls.def("polylines", [](const Curve& self, const py::object& resolution, const py::object& reach,
                          const py::object& around) {
            return polylines(form(self), resolution, reach, around);
          }, py::arg("resolution"), py::arg("reach") = py::none(), py::arg("around") = py::none(),
          "[(points (m, 3), closed), …]: one polyline for each of pieces(), resolution steps a span.\n\n"
          "With a reach, a length, a curve whose weights have not one sign ends where it leaves the box of its\n"
          "finite control points by so much in a coordinate; without one at its last sample before infinity.\n"
          "With points (n, 3) to be around, their box stands for it, and any curve ends there.");
  cls.def("to_bezier", [](const Curve& self) { return unlocked([&] { return splinecore::to_bezier(form(self)); }); },
          "One BezierCurve for each span, in order. The NURBS Book, A5.6.");
  cls.def("to_hermite", [](const Curve& self) { return unlocked([&] { return splinecore::to_hermite(form(self)); }); },
          "The same curve as a HermiteCurve; InvalidShape if it is rational, has a gap or degree above 3.");
}

}  // namespace bindings
