#include <optional>
#include <string>
#include <vector>

#include "approximation.hpp"
#include "arguments.hpp"
#include "arrays.hpp"
#include "classes.hpp"
#include "every_kind.hpp"
#include "long_calls.hpp"
#include "neighbors.hpp"
#include "pairs.hpp"
#include "point_arguments.hpp"
#include "result_pickles.hpp"
#include "rooms.hpp"
#include "splinecore/surface/loft.hpp"
#include "values.hpp"

namespace bindings {

using splinecore::Closing;
using splinecore::InvalidShape;
using splinecore::LoftCorners;
using splinecore::LoftEnd;
using splinecore::LoftNeighbor;
using splinecore::LoftOptions;
using splinecore::LoftSection;
using splinecore::LoftStyle;
using splinecore::LoftSurface;
using splinecore::SectionWeights;

namespace {

/// Curves of any kinds, and points.
std::vector<LoftSection> sections_of(const py::object& value) {
  const bool is_list = py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value);
  if (!is_list) throw py::type_error("sections must be a list of curves and points, not " + type_name(value));
  std::vector<LoftSection> sections;
  for (const py::handle& item : value) {
    const std::string name = "sections" + splinecore::index_text(sections.size());
    const auto section = py::reinterpret_borrow<py::object>(item);
    const bool is_point = py::isinstance<py::array>(section) || py::isinstance<py::list>(section) ||
                          py::isinstance<py::tuple>(section);
    if (is_point) {
      sections.emplace_back(vector_of(section, name.c_str()));
    } else {
      sections.emplace_back(any_curve(section, name.c_str()));
    }
  }
  return sections;
}

std::vector<bool> turned_of(const py::object& value) {
  std::vector<bool> turned;
  if (value.is_none()) return turned;
  if (!py::isinstance<py::list>(value) && !py::isinstance<py::tuple>(value)) {
    throw py::type_error("turned must be a list of bool, not " + type_name(value));
  }
  for (const py::handle& item : value) turned.push_back(boolean(py::reinterpret_borrow<py::object>(item), "turned"));
  return turned;
}

std::optional<glm::dvec3> optional_vector(const py::object& value, const char* name) {
  if (value.is_none()) return {};
  return vector_of(value, name);
}

LoftStyle style_of(const py::object& word) {
  return chosen<LoftStyle>(word, "style", {{"normal", LoftStyle::normal}, {"tight", LoftStyle::tight},
                                           {"uniform", LoftStyle::uniform}, {"loose", LoftStyle::loose},
                                           {"straight", LoftStyle::straight}});
}

/// The normal in a pole, and how fast the loft leaves it: (3,), or a pair of that and a number.
void set_flat(LoftEnd& end, const py::object& value, const char* name) {
  const bool is_pair = (py::isinstance<py::tuple>(value) || py::isinstance<py::list>(value)) && py::len(value) == 2;
  if (!is_pair) {
    end.flat = optional_vector(value, name);
    return;
  }
  const auto pair = py::reinterpret_borrow<py::sequence>(value);
  end.flat = vector_of(pair[0], name);
  end.flat_speed = real(pair[1], name);
}

LoftCorners corners_of(const py::object& word) {
  return chosen<LoftCorners>(word, "corners", {{"free", LoftCorners::free}, {"matched", LoftCorners::matched}});
}

void bind_corner_counts(py::module_& build) {
  build.def("corner_counts", [](const py::object& sections, const py::object& align) {
              const std::vector<LoftSection> through = sections_of(sections);
              LoftOptions options;
              options.is_aligned = boolean(align, "align");
              return unlocked([&] { return splinecore::corner_counts(through, options); });
            }, py::arg("sections"), py::kw_only(), py::arg("align") = true);
}

void bind_loft(py::module_& build) {
  build.def("loft", [](const py::object& sections, const py::object& style, const py::object& closed,
                       const py::object& degree, const py::object& align, const py::object& turned,
                       const py::object& corners, const py::object& weights, const py::object& tolerance, const py::object& knot_distance, const py::object& parameters,
                       const py::object& knots, const py::object& start_tangent, const py::object& end_tangent,
                       const py::object& start_flat, const py::object& end_flat, const py::object& start_neighbor,
                       const py::object& end_neighbor, const py::object& calm, const py::object& cancel) {
              const std::vector<LoftSection> through = sections_of(sections);
              LoftOptions options;
              options.style = style_of(style);
              options.closing = boolean(closed, "closed") ? Closing::closed : Closing::open;
              options.degree = integer(degree, "degree");
              options.is_aligned = boolean(align, "align");
              options.turned = turned_of(turned);
              options.corners = corners_of(corners);
              options.weights = chosen<SectionWeights>(
                  weights, "weights", {{"scaled", SectionWeights::scaled}, {"kept", SectionWeights::kept}});
              options.tolerance = tolerance_of(tolerance);
              options.knot_distance = real(knot_distance, "knot_distance");
              options.parameters = optional_numbers(parameters, "parameters");
              options.knots = optional_numbers(knots, "knots");
              options.start.tangent = optional_vector(start_tangent, "start_tangent");
              options.start.neighbor = neighbor_of(start_neighbor, "start_neighbor");
              set_flat(options.start, start_flat, "start_flat");
              options.end.tangent = optional_vector(end_tangent, "end_tangent");
              options.end.neighbor = neighbor_of(end_neighbor, "end_neighbor");
              set_flat(options.end, end_flat, "end_flat");
              options.is_calm = boolean(calm, "calm");
              return unlocked([&] { return splinecore::loft(through, options); }, cancel);
            }, py::arg("sections"), py::kw_only(), py::arg("style") = "normal", py::arg("closed") = false,
            py::arg("degree") = 3, py::arg("align") = true, py::arg("turned") = py::none(),
            py::arg("corners") = "free", py::arg("weights") = "scaled", py::arg("tolerance") = py::none(),
            py::arg("knot_distance") = 0.0, py::arg("parameters") = py::none(), py::arg("knots") = py::none(),
            py::arg("start_tangent") = py::none(), py::arg("end_tangent") = py::none(), py::arg("start_flat") = py::none(),
            py::arg("end_flat") = py::none(), py::arg("start_neighbor") = py::none(),
            py::arg("end_neighbor") = py::none(), py::arg("calm") = true, py::arg("cancel") = py::none());
}

void bind_patch_blend(py::module_& build) {
  build.def("blend_patches", [](const py::object& a, const py::object& side_a, const py::object& b, const py::object& side_b,
                                const py::object& continuity, const py::object& strengths, const py::object& align,
                                const py::object& calm) {
              const auto [on_a, on_b] = both(continuity, "continuity", "one for each patch");
              const auto [of_a, of_b] = both(strengths, "strengths", "one for each patch");
              LoftNeighbor from{any_patch(a, "a"), border_of(side_a, "side_a"), continuity_of(on_a, "continuity"), real(of_a, "strengths")};
              LoftNeighbor to{any_patch(b, "b"), border_of(side_b, "side_b"), continuity_of(on_b, "continuity"), real(of_b, "strengths")};
              const bool is_aligned = boolean(align, "align");
              const bool is_calm = boolean(calm, "calm");
              return unlocked([&] { return splinecore::blend(from, to, is_aligned, is_calm); });
            }, py::arg("a"), py::arg("side_a"), py::arg("b"), py::arg("side_b"), py::arg("continuity") = "G2",
            py::arg("strengths") = 1.0, py::kw_only(), py::arg("align") = true, py::arg("calm") = true);
}

void bind_loft_surface(py::module_& module) {
  Class<LoftSurface> cls(module, "LoftSurface", py::module_local());
  seal(cls);
  pickle_members(cls, &LoftSurface::value, &LoftSurface::error, &LoftSurface::followed);
  cls.def_readonly("value", &LoftSurface::value);
  cls.def_readonly("error", &LoftSurface::error);
  cls.def_readonly("followed", &LoftSurface::followed);
  bind_pair(cls);
  cls.def("__repr__", [](const LoftSurface& self) {
    return "LoftSurface(error=" + splinecore::text_of(self.error) + ", followed=" + splinecore::text_of(self.followed) + ")";
  });
}

}  // namespace

void bind_lofts(py::module_& module) {
  bind_loft_surface(module);
  py::module_ build = module.attr("build");
  bind_loft(build);
  bind_corner_counts(build);
  bind_patch_blend(build);
}

}  // namespace bindings
