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
  Class<Filling> cls(module, "Filling", py::module_local(),
                          "What fills a hole: patches, a tuple of NurbsPatch, and how well it goes on (lecture row S21).\n\n"
                          "gap, a length, is the largest distance from a side; angle, in radians, the largest between tangent planes along\n"
                          "neighbors with 'G1' and 'G2'; curvature_difference, in 1 / length, that of normal curvatures across those with\n"
                          "'G2'; inner_angle the largest between tangent planes of patches of the filling.");
  seal(cls);
  pickle_members(cls, &Filling::patches, &Filling::gap, &Filling::angle, &Filling::curvature_difference,
                  &Filling::inner_angle);
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

SideOfPatch side_of(const py::object& value) {
  const py::sequence pair = items_of(value, "a side must be a pair of the number of a patch and its side");
  if (py::len(pair) != 2) throw py::type_error("a side must be a pair of the number of a patch and its side");
  const int patch = integer(pair[0], "patch");
  if (patch < 0) throw splinecore::InvalidShape("there is no patch " + std::to_string(patch));
  return {static_cast<std::size_t>(patch), border_of(pair[1], "side")};
}

std::vector<OpenEnd> ends_of(const py::object& value) {
  std::vector<OpenEnd> ends;
  for (const py::handle& item : items_of(value, "ends must be a list of lists of sides")) {
    OpenEnd& end = ends.emplace_back();
    for (const py::handle& side : items_of(py::reinterpret_borrow<py::object>(item), "an end must be a list of sides")) {
      end.push_back(side_of(py::reinterpret_borrow<py::object>(side)));
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
            }, py::arg("sides"), py::kw_only(), py::arg("cancel") = py::none(),
            "Patches within curves that go round, in any directions, once or several times: (value, error), a list of NurbsPatch and\n"
            "how far the curves are from a plane. What is within a loop is a hole of it, and what is within that is filled again.\n"
            "u runs along a curve, on its control points, v from there by segments to a point that sees all of the rim; one that is\n"
            "seen whole from nowhere, and one with holes, is cut by chords. Those of a plane rim are plane and do not fold. Normals\n"
            "are on the side from which the first curve runs to the left, or of several loops the widest one.\n\n"
            "InvalidShape if the curves do not form a loop, one has a weight that is not positive, or the rim crosses itself or a hole\n"
            "in it, encloses next to nothing, or has too many narrow bends.");
  build.def("open_ends", [](const py::object& patches) {
              const std::vector<NurbsPatch> given = patches_of(patches);
              const std::vector<OpenEnd> found = unlocked([&] { return splinecore::open_ends(given); });
              std::vector<std::vector<std::pair<std::size_t, std::string>>> ends;
              for (const OpenEnd& end : found) {
                auto& sides = ends.emplace_back();
                for (const SideOfPatch& side : end) sides.emplace_back(side.patch, word_of(side.border));
              }
              return ends;
            }, py::arg("patches"),
            "The open ends of patches: for each a list of sides (number of a patch, side) that go round it.\n\n"
            "InvalidShape if a patch is in several pieces, more than two open sides end in one point, or one ends where no other\n"
            "does.");
  build.def("cap", [](const py::object& patches, const py::object& ends, const py::object& cancel) {
              const std::vector<NurbsPatch> given = patches_of(patches);
              if (ends.is_none()) {
                return wrap(unlocked([&] { return splinecore::capped(given, splinecore::open_ends(given)); }, cancel));
              }
              const std::vector<OpenEnd> chosen = ends_of(ends);
              return wrap(unlocked([&] { return splinecore::capped(given, chosen); }, cancel));
            }, py::arg("patches"), py::arg("ends") = py::none(), py::kw_only(), py::arg("cancel") = py::none(),
            "The patches with a fill_rim() of each of these open_ends(), of all of them where none are given: (value, error), a list\n"
            "of NurbsPatch and how far rims are from planes. An end may have sides behind its own that go round holes in it; what goes\n"
            "round these is turned where its normals are on the other side. Caps have the control points of the sides that they close,\n"
            "so that the mesh of all has no open edges there; patches are cut where a rim has to be. Normals of what is closed point\n"
            "outwards.\n\n"
            "InvalidShape as fill_rim(), or if a patch that has to be cut shares the side opposite to the end.");
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
            "The Filling of a hole of three to eight sides, which are curves of any kinds or neighbors (patch, side, 'G0' to\n"
            "'G2'), one after the other in any directions: the surface that goes on from these (lecture row S21), with as few\n"
            "control points as come within the tolerance, a length, by default 2^-20 of the size of the sides, and the angle, in\n"
            "radians; the Filling says what was reached.\n\n"
            "A hole with four corners is one patch: from 'G1' the bicubic Coons patch, whose borders are the sides, weights and all, of\n"
            "degree 3 to 7. Otherwise, and where that does not do, patches are of degree 5, or 7 for 'G2', with at most eight spans\n"
            "unless sides need more, by least third derivatives (Sarraga 1987, Greiner 1994) of what lies between them and what\n"
            "neighbors let expect; other numbers of sides are split from the middle of each to a point. Where all sides go on into\n"
            "each other without a corner, patches run from each, as it is, to a point in which all end; where some do, from\n"
            "neighbors, they are one side of the hole.\n\n"
            "Where neighbors do not share their tangent plane at a corner, the filling cannot continue both.\n"
            "In wide and deep holes patches go by lines that run from all sides to a point as circles would, where that bends more evenly.\n"
            "InvalidShape unless there are 3 to 8 sides that form a loop, or where what fills the hole would fold, as it may where weights or\n"
            "paces along sides differ much or curvatures are to go on far; or if one with a neighbor turns back over it, or runs on\n"
            "without a corner into one from no neighbor, or one or two corners are left, or a round hole is not seen whole from its\n"
            "middle;\n"
            "ToleranceNotReached says how far ends of sides lie apart, or how far the filling is from its sides.");
  bind_rims(build);
}

}  // namespace bindings
