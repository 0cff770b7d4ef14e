#include "arguments.hpp"
#include "arrays.hpp"
#include "every_kind.hpp"
#include "long_calls.hpp"
#include "patch_evaluation.hpp"
#include "rooms.hpp"
#include "splinecore/convert/to_bezier.hpp"
#include "splinecore/convert/to_hermite.hpp"
#include "splinecore/patch/nurbs_patch.hpp"
#include "values.hpp"

namespace bindings {

using splinecore::Axis;
using splinecore::NurbsPatch;

namespace {

py::list bezier_rows(const NurbsPatch& patch) {
  const auto grid = unlocked([&] { return splinecore::to_bezier(patch); });
  py::list rows;
  for (int i = 0; i < grid.count_u; ++i) {
    py::list row;
    for (int j = 0; j < grid.count_v; ++j) row.append(grid.patches[i * grid.count_v + j]);
    rows.append(row);
  }
  return rows;
}

}  // namespace

void bind_patch_methods(py::module_& module) {
  const PatchClasses cls(module);
  cls.def_property("degree", [](const AnyPatch& self) {
    return py::make_tuple(patch_form(self).knot_vector(Axis::u).degree(), patch_form(self).knot_vector(Axis::v).degree());
  }, "(degree in u, degree in v).");
  cls.def_property("domain", [](const AnyPatch& self) {
    return py::make_tuple(pair_of(patch_form(self).knot_vector(Axis::u).domain()),
                          pair_of(patch_form(self).knot_vector(Axis::v).domain()));
  }, "((start, end) of u, (start, end) of v).");
  cls.def_property("is_rational", [](const AnyPatch& self) { return patch_form(self).rational(); },
                            "True unless every weight is 1.");
  cls.def("evaluate", [](const AnyPatch& self, const py::object& u, const py::object& v, const py::object& side,
                         const py::object& at_infinity, const py::object& dtype, const py::object& out,
                         const py::object& threads, const py::object& cancel) {
            return evaluate(patch_form(self), u, v, side, at_infinity, dtype, out, threads, cancel);
          },
          py::arg("u"), py::arg("v"), py::kw_only(), py::arg("side") = "right", py::arg("at_infinity") = "raise",
          py::arg("dtype") = py::none(), py::arg("out") = py::none(), py::arg("threads") = 0,
          py::arg("cancel") = py::none(),
          "Points at pairs of parameters: u and v broadcast, (...,) -> (..., 3). side is 'right', 'left' or a\n"
          "pair for u and v. The rest as for curves, and of a periodic direction as for periodic ones; a pair has the\n"
          "same bits in a grid of any shape. Along u is summed first: where swapped() exchanges u and v, the last bits\n"
          "may differ. Rows S19, S20.");
  cls.def("evaluate_grid", [](const AnyPatch& self, const py::object& u, const py::object& v, const py::object& side,
                              const py::object& at_infinity, const py::object& dtype, const py::object& out,
                              const py::object& threads, const py::object& cancel) {
            return evaluate_grid(patch_form(self), u, v, side, at_infinity, dtype, out, threads, cancel);
          },
          py::arg("u"), py::arg("v"), py::kw_only(), py::arg("side") = "right", py::arg("at_infinity") = "raise",
          py::arg("dtype") = py::none(), py::arg("out") = py::none(), py::arg("threads") = 0,
          py::arg("cancel") = py::none(),
          "Points at every pair of (a,) u and (b,) v: (a, b, 3).");
  cls.def("evaluate_grid_with_normals",
          [](const AnyPatch& self, const py::object& u, const py::object& v, const py::object& side,
             const py::object& at_infinity, const py::object& dtype, const py::object& out, const py::object& threads,
             const py::object& cancel) {
            return evaluate_grid_with_normals(patch_form(self), u, v, side, at_infinity, dtype, out, threads, cancel);
          },
          py::arg("u"), py::arg("v"), py::kw_only(), py::arg("side") = "right", py::arg("at_infinity") = "raise",
          py::arg("dtype") = py::none(), py::arg("out") = py::none(), py::arg("threads") = 0,
          py::arg("cancel") = py::none(),
          "(points, unit normals) of a grid, both (a, b, 3). Normals point along S_u x S_v; at a pole or a\n"
          "collapsed edge they are the limit from inside the domain, and NaN where there is none: where the patch\n"
          "is a curve or a point, or no wider than some roundings of its length. out is a pair of arrays.");
  cls.def("derivatives", [](const AnyPatch& self, const py::object& u, const py::object& v, const py::object& order,
                            const py::object& side, const py::object& at_infinity, const py::object& out,
                            const py::object& threads, const py::object& cancel) {
            return derivatives(patch_form(self), u, v, order, side, at_infinity, out, threads, cancel);
          },
          py::arg("u"), py::arg("v"), py::arg("order"), py::kw_only(), py::arg("side") = "right",
          py::arg("at_infinity") = "raise", py::arg("out") = py::none(), py::arg("threads") = 0,
          py::arg("cancel") = py::none(),
          "Mixed derivatives, k along u and l along v, k, l <= order: (..., order + 1, order + 1, 3) float64.\n"
          "[..., 0, 0, :] is what evaluate() and evaluate_grid() give, bit for bit. One that is too large for a\n"
          "number raises InvalidShape, or is NaN with at_infinity='nan'. The NURBS Book, A4.4.");
  cls.def("first_derivatives", [](const AnyPatch& self, const py::object& u, const py::object& v, const py::object& side,
                                  const py::object& at_infinity, const py::object& out, const py::object& threads,
                                  const py::object& cancel) {
            return first_derivatives(patch_form(self), u, v, side, at_infinity, out, threads, cancel);
          },
          py::arg("u"), py::arg("v"), py::kw_only(), py::arg("side") = "right", py::arg("at_infinity") = "raise",
          py::arg("out") = py::none(), py::arg("threads") = 0, py::arg("cancel") = py::none(),
          "The points and their first derivatives along u and v: (..., 3, 3) float64, S, S_u and S_v, the same bits\n"
          "as of derivatives().");
  cls.def("to_bezier", [](const AnyPatch& self) { return bezier_rows(patch_form(self)); },
          "One BezierPatch for each pair of spans: rows along u of lists along v.");
  cls.def("to_hermite", [](const AnyPatch& self) { return unlocked([&] { return splinecore::to_hermite(patch_form(self)); }); },
          "The same patch as a HermitePatch; InvalidShape if rational, of degree above 3 or not C1 inside.");
}

}  // namespace bindings
