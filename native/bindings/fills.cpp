#include <string>
#include <utility>
#include <vector>

#include "approximation.hpp"
#include "arguments.hpp"
#include "arrays.hpp"
#include "classes.hpp"
#include "every_kind.hpp"
#include "long_calls.hpp"
#include "neighbors.hpp"
#include "result_pickles.hpp"
#include "rooms.hpp"
#include "splinecore/surface/cap.hpp"
#include "splinecore/surface/fill.hpp"
#include "values.hpp"

namespace bindings {

using splinecore::Border;
using splinecore::FillOptions;
using splinecore::FillSide;
using splinecore::Filling;
using splinecore::NurbsCurve;
using splinecore::NurbsPatch;
using splinecore::OpenEnd;
using splinecore::SideOfPatch;

namespace {

/// Curves of any kinds, and neighbors.
std::vector<FillSide> sides_of(const py::object& value) {
  const bool is_list = py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value);
  if (!is_list) throw py::type_error("sides must be a list of curves and neighbors, not " + type_name(value));
  std::vector<FillSide> sides;
  for (const py::handle& item : value) {
    const std::string name = "sides" + splinecore::index_text(sides.size());
    const auto side = py::reinterpret_borrow<py::object>(item);
    if (py::isinstance<py::tuple>(side)) {
      sides.emplace_back(*neighbor_of(side, name.c_str()));
    } else {
      sides.emplace_back(any_curve(side, name.c_str()));
    }
  }
  return sides;
}

void bind_filling(py::module_& module) {
  Class<Filling> cls(module, "Filling", py::module_local());
  seal(cls);
  pickle_members(cls, &Filling::patches, &Filling::gap, &Filling::angle, &Filling::curvature_difference,
                  &Filling::inner_angle);
  cls.def_property_readonly("patches", [](const Filling& self) { return py::tuple(py::cast(self.patches)); });
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

/// The items of a list or tuple.
py::sequence items_of(const py::object& value, const char* what) {
  if (!py::isinstance<py::list>(value) && !py::isinstance<py::tuple>(value)) {
    throw py::type_error(std::string(what) + ", not " + type_name(value));
  }
  return py::reinterpret_borrow<py::sequence>(value);
}

std::vector<NurbsPatch> patches_of(const py::object& value) {
  std::vector<NurbsPatch> patches;
  for (const py::handle& item : items_of(value, "patches must be a list of patches")) {
    const std::string name = "patches" + splinecore::index_text(patches.size());
    patches.push_back(any_patch(py::reinterpret_borrow<py::object>(item), name.c_str()));
  }
  return patches;
}

SideOfPatch hole_side(const py::object& value) {
  const py::sequence pair = items_of(value, "a side must be a pair of the number of a patch and its side");
  if (py::len(pair) != 2) throw py::type_error("a side must be a pair of the number of a patch and its side");
  const int patch = integer(pair[0], "patch");
  if (patch < 0) throw splinecore::InvalidShape("there is no patch " + std::to_string(patch));
  return {static_cast<std::size_t>(patch), border_of(pair[1], "side")};
}

std::vector<OpenEnd> open_ends(const py::object& value) {
  std::vector<OpenEnd> ends;
  for (const py::handle& item : items_of(value, "ends must be a list of lists of sides")) {
    OpenEnd& end = ends.emplace_back();
    for (const py::handle& side : items_of(py::reinterpret_borrow<py::object>(item), "an end must be a list of sides")) {
      end.push_back(hole_side(py::reinterpret_borrow<py::object>(side)));
    }
  }
  return ends;
}

const char* word_of(Border border) {
  constexpr const char* kWords[] = {"u_start", "u_end", "v_start", "v_end"};
  return kWords[static_cast<int>(border)];
}

void bind_rims(py::module_& build) {
  build.def("fill_rim", [](const py::object& sides, const py::object& cancel) {
              std::vector<NurbsCurve> rim;
              for (const py::handle& item : items_of(sides, "sides must be a list of curves")) {
                const std::string name = "sides" + splinecore::index_text(rim.size());
                rim.push_back(any_curve(py::reinterpret_borrow<py::object>(item), name.c_str()));
              }
              return wrap(unlocked([&] { return splinecore::rim_filling(rim); }, cancel));
            }, py::arg("sides"), py::kw_only(), py::arg("cancel") = py::none());
  build.def("open_ends", [](const py::object& patches) {
              const std::vector<NurbsPatch> given = patches_of(patches);
              const std::vector<OpenEnd> found = unlocked([&] { return splinecore::open_ends(given); });
              std::vector<std::vector<std::pair<std::size_t, std::string>>> ends;
              for (const OpenEnd& end : found) {
                auto& sides = ends.emplace_back();
                for (const SideOfPatch& side : end) sides.emplace_back(side.patch, word_of(side.border));
              }
              return ends;
            }, py::arg("patches"));
  build.def("cap", [](const py::object& patches, const py::object& ends, const py::object& cancel) {
              const std::vector<NurbsPatch> given = patches_of(patches);
              if (ends.is_none()) {
                return wrap(unlocked([&] { return splinecore::capped(given, splinecore::open_ends(given)); }, cancel));
              }
              const std::vector<OpenEnd> chosen = open_ends(ends);
              return wrap(unlocked([&] { return splinecore::capped(given, chosen); }, cancel));
            }, py::arg("patches"), py::arg("ends") = py::none(), py::kw_only(), py::arg("cancel") = py::none());
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
            py::arg("cancel") = py::none());
  bind_rims(build);
}

}  // namespace bindings
