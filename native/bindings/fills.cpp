#include <string>
#include <vector>

#include "arguments.hpp"
#include "arrays.hpp"
#include "classes.hpp"
#include "every_kind.hpp"
#include "long_calls.hpp"
#include "neighbours.hpp"
#include "rooms.hpp"
#include "splinecore/surface/fill.hpp"
#include "values.hpp"

namespace bindings {

using splinecore::FillOptions;
using splinecore::FillSide;
using splinecore::Filling;

namespace {

/// Curves of any kinds, and neighbours.
std::vector<FillSide> sides_of(const py::object& value) {
  const bool is_list = py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value);
  if (!is_list) throw py::type_error("sides must be a list of curves and neighbours, not " + type_name(value));
  std::vector<FillSide> sides;
  for (const py::handle& item : value) {
    const std::string name = "sides" + splinecore::index_text(sides.size());
    const auto side = py::reinterpret_borrow<py::object>(item);
    if (py::isinstance<py::tuple>(side)) {
      sides.emplace_back(*neighbour_of(side, name.c_str()));
    } else {
      sides.emplace_back(any_curve(side, name.c_str()));
    }
  }
  return sides;
}

void bind_filling(py::module_& module) {
  Class<Filling> cls(module, "Filling", py::module_local(),
                          "What fills a hole: patches, a tuple of NurbsPatch, and how well it goes on (lecture row S21).\n\n"
                          "gap, a length, is the largest distance from a side; angle, in radians, the largest between tangent planes along\n"
                          "neighbours with 'G1' and 'G2'; curvature_difference, in 1 / length, that of normal curvatures across those with\n"
                          "'G2'; inner_angle the largest between tangent planes of patches of the filling.");
  seal(cls);
  cls.def_property_readonly("patches", [](const Filling& self) { return py::tuple(py::cast(self.patches)); },
                            "A tuple of NurbsPatch.");
  cls.def_readonly("gap", &Filling::gap);
  cls.def_readonly("angle", &Filling::angle);
  cls.def_readonly("curvature_difference", &Filling::curvature_difference);
  cls.def_readonly("inner_angle", &Filling::inner_angle);
  cls.def("__repr__", [](const Filling& self) {
    const auto text = [](double value) { return splinecore::text_of(value); };
    return "Filling(" + std::to_string(self.patches.size()) + " patches, gap=" + text(self.gap) + ", angle=" + text(self.angle) +
           ", curvature_difference=" + text(self.curvature_difference) + ", inner_angle=" + text(self.inner_angle) + ")";
  });
}

}  // namespace

void bind_fills(py::module_& module) {
  bind_filling(module);
  py::module_ build = module.attr("build");
  build.def("fill", [](const py::object& sides, const py::object& tolerance, const py::object& angle, const py::object& cancel) {
              const std::vector<FillSide> around = sides_of(sides);
              const FillOptions options{tolerance_of(tolerance), real(angle, "angle")};
              return unlocked([&] { return splinecore::fill(around, options); }, cancel);
            }, py::arg("sides"), py::kw_only(), py::arg("tolerance") = py::none(), py::arg("angle") = 1e-4,
            py::arg("cancel") = py::none(),
            "The Filling of a hole of three to eight sides, which are curves of any kinds or neighbours (patch, side, 'G0' to\n"
            "'G2'), one after the other in any directions: the surface that goes on from these (lecture row S21), with as few\n"
            "control points as come within the tolerance, a length, by default 2^-20 of the size of the sides, and the angle, in\n"
            "radians; the Filling says what was reached.\n\n"
            "A hole with four corners is one patch: from 'G1' the bicubic Coons patch, whose borders are the sides, weights and all, of\n"
            "degree 3 to 7. Otherwise, and where that does not do, patches are of degree 5, or 7 for 'G2', with at most eight spans\n"
            "unless sides need more, by least third derivatives (Sarraga 1987, Greiner 1994) of what lies between them and what\n"
            "neighbours let expect; other numbers of sides are split from the middle of each to a point. Where all sides go on into\n"
            "each other without a corner, patches run from each, as it is, to a point in which all end; where some do, from\n"
            "neighbours, they are one side of the hole.\n\n"
            "Where neighbours do not share their tangent plane at a corner, nothing can go on from both.\n"
            "In wide and deep holes patches go by lines that run from all sides to a point as circles would, where that bends more evenly.\n"
            "InvalidShape unless there are 3 to 8 sides that go round, or where what fills the hole would fold, as it may where weights or\n"
            "paces along sides differ much or curvatures are to go on far; or if one with a neighbour turns back over it, or runs on\n"
            "without a corner into one from no neighbour, or one or two corners are left, or a round hole is not seen whole from its\n"
            "middle;\n"
            "ToleranceNotReached says how far ends of sides lie apart, or how far the filling is from its sides.");
}

}  // namespace bindings
