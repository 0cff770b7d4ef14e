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
  });
  cls.def_property("domain", [](const AnyPatch& self) {
    return py::make_tuple(pair_of(patch_form(self).knot_vector(Axis::u).domain()),
                          pair_of(patch_form(self).knot_vector(Axis::v).domain()));
  });
  cls.def_property("is_rational", [](const AnyPatch& self) { return patch_form(self).rational(); });
  cls.def("evaluate", [](const AnyPatch& self, const py::object& u, const py::object& v, const py::object& side,
                         const py::object& at_infinity, const py::object& dtype, const py::object& out,
                         const py::object& threads, const py::object& cancel) {
            return evaluate(patch_form(self), u, v, side, at_infinity, dtype, out, threads, cancel);
          },
          py::arg("u"), py::arg("v"), py::kw_only(), py::arg("side") = "right", py::arg("at_infinity") = "raise",
          py::arg("dtype") = py::none(), py::arg("out") = py::none(), py::arg("threads") = 0,
          py::arg("cancel") = py::none());
  cls.def("evaluate_grid", [](const AnyPatch& self, const py::object& u, const py::object& v, const py::object& side,
                              const py::object& at_infinity, const py::object& dtype, const py::object& out,
                              const py::object& threads, const py::object& cancel) {
            return evaluate_grid(patch_form(self), u, v, side, at_infinity, dtype, out, threads, cancel);
          },
          py::arg("u"), py::arg("v"), py::kw_only(), py::arg("side") = "right", py::arg("at_infinity") = "raise",
          py::arg("dtype") = py::none(), py::arg("out") = py::none(), py::arg("threads") = 0,
          py::arg("cancel") = py::none());
  cls.def("evaluate_grid_with_normals",
          [](const AnyPatch& self, const py::object& u, const py::object& v, const py::object& side,
             const py::object& at_infinity, const py::object& dtype, const py::object& out, const py::object& threads,
             const py::object& cancel) {
            return evaluate_grid_with_normals(patch_form(self), u, v, side, at_infinity, dtype, out, threads, cancel);
          },
          py::arg("u"), py::arg("v"), py::kw_only(), py::arg("side") = "right", py::arg("at_infinity") = "raise",
          py::arg("dtype") = py::none(), py::arg("out") = py::none(), py::arg("threads") = 0,
          py::arg("cancel") = py::none());
  cls.def("derivatives", [](const AnyPatch& self, const py::object& u, const py::object& v, const py::object& order,
                            const py::object& side, const py::object& at_infinity, const py::object& out,
                            const py::object& threads, const py::object& cancel) {
            return derivatives(patch_form(self), u, v, order, side, at_infinity, out, threads, cancel);
          },
          py::arg("u"), py::arg("v"), py::arg("order"), py::kw_only(), py::arg("side") = "right",
          py::arg("at_infinity") = "raise", py::arg("out") = py::none(), py::arg("threads") = 0,
          py::arg("cancel") = py::none());
  cls.def("first_derivatives", [](const AnyPatch& self, const py::object& u, const py::object& v, const py::object& side,
                                  const py::object& at_infinity, const py::object& out, const py::object& threads,
                                  const py::object& cancel) {
            return first_derivatives(patch_form(self), u, v, side, at_infinity, out, threads, cancel);
          },
          py::arg("u"), py::arg("v"), py::kw_only(), py::arg("side") = "right", py::arg("at_infinity") = "raise",
          py::arg("out") = py::none(), py::arg("threads") = 0, py::arg("cancel") = py::none());
  cls.def("to_bezier", [](const AnyPatch& self) { return bezier_rows(patch_form(self)); });
  cls.def("to_hermite", [](const AnyPatch& self) { return unlocked([&] { return splinecore::to_hermite(patch_form(self)); }); });
}

}  // namespace bindings
