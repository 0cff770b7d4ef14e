#include <optional>
#include <vector>

#include "approximation.hpp"
#include "arguments.hpp"
#include "arrays.hpp"
#include "classes.hpp"
#include "every_kind.hpp"
#include "long_calls.hpp"
#include "point_arguments.hpp"
#include "rail_numbers.hpp"
#include "result_pickles.hpp"
#include "rooms.hpp"
#include "splinecore/surface/extend_patch.hpp"
#include "splinecore/surface/fillet_chain.hpp"
#include "splinecore/surface/fillet_patches.hpp"
#include "splinecore/surface/match.hpp"
#include "splinecore/surface/offset_patch.hpp"
#include "values.hpp"

namespace bindings {

using splinecore::Extension;
using splinecore::MatchOptions;
using splinecore::RoundedEdge;

namespace {

void bind_offset_patch(py::module_& build) {
  build.def("offset_patch", [](const py::object& patch, const py::object& distance, const py::object& tolerance,
                               const py::object& cancel) {
              const auto given = any_patch(patch, "patch");
              const double by = real(distance, "distance");
              const std::optional<double> within = tolerance_of(tolerance);
              return wrap(unlocked([&] { return splinecore::offset(given, by, within); }, cancel));
            }, py::arg("patch"), py::arg("distance"), py::kw_only(), py::arg("tolerance") = py::none(),
            py::arg("cancel") = py::none());
  build.def("thicken", [](const py::object& patch, const py::object& start, const py::object& end, const py::object& tolerance,
                          const py::object& cancel) {
              const auto given = any_patch(patch, "patch");
              const double from = real(start, "start");
              const double to = real(end, "end");
              const std::optional<double> within = tolerance_of(tolerance);
              return wrap(unlocked([&] { return splinecore::thickened(given, from, to, within); }, cancel));
            }, py::arg("patch"), py::arg("start"), py::arg("end"), py::kw_only(), py::arg("tolerance") = py::none(),
            py::arg("cancel") = py::none());
}

void bind_extend_patch(py::module_& build) {
  build.def("extend_patch", [](const py::object& patch, const py::object& side, const py::object& length, const py::object& how) {
              const auto given = any_patch(patch, "patch");
              const splinecore::Border at = border_of(side, "side");
              const double by = real(length, "length");
              const auto as = chosen<Extension>(how, "how", {{"natural", Extension::natural}, {"straight", Extension::straight}});
              return unlocked([&] { return splinecore::extended(given, at, by, as); });
            }, py::arg("patch"), py::arg("side"), py::arg("length"), py::arg("how") = "natural");
}

void bind_match(py::module_& build) {
  build.def("match_patch", [](const py::object& patch, const py::object& side, const py::object& onto, const py::object& onto_side,
                              const py::object& continuity, const py::object& rows, const py::object& strength,
                              const py::object& reversed, const py::object& cancel) {
              const auto moved = any_patch(patch, "patch");
              const splinecore::Border at = border_of(side, "side");
              const auto other = any_patch(onto, "onto");
              const splinecore::Border at_other = border_of(onto_side, "onto_side");
              MatchOptions options;
              options.continuity = chosen<int>(continuity, "continuity", {{"G0", 0}, {"G1", 1}, {"G2", 2}, {"G3", 3}});
              if (!rows.is_none()) options.rows = integer(rows, "rows");
              options.strength = real(strength, "strength");
              options.is_reversed = optional_boolean(reversed, "reversed");
              return wrap(unlocked([&] { return splinecore::matched(moved, at, other, at_other, options); }, cancel));
            }, py::arg("patch"), py::arg("side"), py::arg("onto"), py::arg("onto_side"), py::arg("continuity") = "G1", py::kw_only(),
            py::arg("rows") = py::none(), py::arg("strength") = 1.0, py::arg("reversed") = py::none(),
            py::arg("cancel") = py::none());
}

void bind_rounded_edge(py::module_& module) {
  Class<RoundedEdge> cls(module, "RoundedEdge", py::module_local());
  seal(cls);
  pickle_members(cls, &RoundedEdge::first, &RoundedEdge::fillet, &RoundedEdge::second, &RoundedEdge::error);
  cls.def_readonly("first", &RoundedEdge::first);
  cls.def_readonly("fillet", &RoundedEdge::fillet);
  cls.def_readonly("second", &RoundedEdge::second);
  cls.def_readonly("error", &RoundedEdge::error);
  cls.def("__repr__", [](const RoundedEdge& self) { return "RoundedEdge(error=" + splinecore::text_of(self.error) + ")"; });
}

void bind_fillet_patches(py::module_& build) {
  build.def("fillet_patches", [](const py::object& first, const py::object& first_side, const py::object& second,
                                 const py::object& second_side, const py::object& radius, const py::object& tolerance,
                                 const py::object& cancel) {
              const auto a = any_patch(first, "first");
              const splinecore::Border on_a = border_of(first_side, "first_side");
              const auto b = any_patch(second, "second");
              const splinecore::Border on_b = border_of(second_side, "second_side");
              const auto along = splinecore::axis_of(on_a) == splinecore::Axis::u ? splinecore::Axis::v : splinecore::Axis::u;
              const auto radii = radii_of(radius, "radius", a.knot_vector(along).domain());
              const std::optional<double> within = tolerance_of(tolerance);
              return unlocked([&] { return splinecore::fillet(a, on_a, b, on_b, radii, within); }, cancel);
            }, py::arg("first"), py::arg("first_side"), py::arg("second"), py::arg("second_side"), py::arg("radius"), py::kw_only(),
            py::arg("tolerance") = py::none(), py::arg("cancel") = py::none());
}

splinecore::PatchEdge edge_of(const py::object& value, std::size_t index) {
  const std::string name = "edges" + splinecore::index_text(index);
  const auto given = py::isinstance<py::sequence>(value) ? py::cast<py::sequence>(value) : py::sequence(py::tuple());
  if (given.size() != 4) throw splinecore::InvalidShape(name + ": a patch and its side, another patch and its side are expected");
  return {any_patch(given[0], name.c_str()), border_of(given[1], name.c_str()), any_patch(given[2], name.c_str()),
          border_of(given[3], name.c_str())};
}

void bind_fillet_chain(py::module_& build) {
  build.def("fillet_chain", [](const py::sequence& edges, const py::object& radius, const py::object& tolerance, const py::object& cancel) {
              std::vector<splinecore::PatchEdge> given;
              for (std::size_t i = 0; i < edges.size(); ++i) given.push_back(edge_of(edges[i], i));
              const auto radii = radii_of(radius, "radius", {0.0, static_cast<double>(given.size())});
              const std::optional<double> within = tolerance_of(tolerance);
              return unlocked([&] { return splinecore::fillet_chain(given, radii, within); }, cancel);
            }, py::arg("edges"), py::arg("radius"), py::kw_only(), py::arg("tolerance") = py::none(), py::arg("cancel") = py::none());
}

}  // namespace

void bind_surface_verbs(py::module_& module) {
  py::module_ build = module.attr("build");
  bind_offset_patch(build);
  bind_extend_patch(build);
  bind_match(build);
  bind_rounded_edge(module);
  bind_fillet_patches(build);
  bind_fillet_chain(build);
}

}  // namespace bindings
