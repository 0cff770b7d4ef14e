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
            }, py::arg("sections"), py::kw_only(), py::arg("align") = true,
            "How many corners each section has as loft() matches them: all breaks of the tangent if all sections have as many of\n"
            "these, else those of more than 0.02 radians; none of a point. Where the numbers differ, none is matched.");
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
            py::arg("end_neighbor") = py::none(), py::arg("calm") = true, py::arg("cancel") = py::none(),
            "The surface through sections, curves of any kinds or as first and last one points (3,), in which it closes:\n"
            "a LoftSurface, (value, error), a NurbsPatch with u along the sections and v from one to the next, and how far\n"
            "sections were moved. Skinning (The NURBS Book, 10.3; lecture row S20).\n\n"
            "style: 'normal' by distances, 'tight' by their roots, 'uniform', 'loose' where sections are rows of control\n"
            "points, 'straight' by segments. degree is that along v. align: directions and seams of sections are those of\n"
            "the section before, closed ones begin where knots are shared; closed sections make the surface periodic. turned (n,): sections that run the other way than\n"
            "that. corners: 'free', or 'matched', where all sections have as many, see corner_counts(): all have the same\n"
            "parameters, the surface has an edge for each, and aligned closed sections begin at one. weights, which each curve may have multiplied by any factor: 'scaled', divided by their mean, or 'kept'. With\n"
            "a tolerance, a length, sections may be moved so far for few knots; knots nearer than knot_distance, a part of the domain, are taken for one. parameters and knots\n"
            "are those along v.\n\n"
            "At each end one of: tangent (3,), of length 1 as fast as elsewhere; flat, the normal (3,) of the tangent plane\n"
            "in a point, or (normal, speed) by that elsewhere; neighbor (patch, side, 'G0' to 'G3'[, strength]), whose side becomes one more section.\n"
            "calm: where with curvatures of neighbors it would shoot out, or weights would not stay positive, it follows them\n"
            "with half of their strengths, a quarter, to a 256th, as `followed` of the result says; else it is refused.\n"
            "InvalidShape if there are fewer than two sections, three where closed, an inner one is a point, or weights would\n"
            "not stay positive between sections; ToleranceNotReached.");
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
            py::arg("strengths") = 1.0, py::kw_only(), py::arg("align") = true, py::arg("calm") = true,
            "The NurbsPatch from a side of one patch to a side of another one that goes on from both: with their points, tangent\n"
            "planes, curvatures and how these change for 'G0' to 'G3', one word for both or a pair. u runs along the sides, v\n"
            "from a to b in one span. strengths say how far it follows each. align: b's side is turned to run as a's does, and closed\n"
            "ones are joined where they lie beside each other. Both keep their beginnings, so that edges stay edges: where these do\n"
            "not lie beside each other, lines across lead from one to the other, over several spans.\n"
            "calm: with less of these strengths where it would shoot out, as loft() has it; else it is refused.\n"
            "Lecture row S21.\n\n"
            "InvalidShape if a side is the seam of a periodic direction or lies at infinity, a patch stands still across its\n"
            "side, both sides are one, or weights would not stay positive; ToleranceNotReached where rounding leaves it off the\n"
            "tangent planes by more than 1e-4 radians, or off the curvatures by more than a thousandth of the largest.");
}

void bind_loft_surface(py::module_& module) {
  Class<LoftSurface> cls(module, "LoftSurface", py::module_local(),
                         "The surface through sections: value, a NurbsPatch, and error, how far it is from them.\n\n"
                         "Unpacks: value, error = build.loft(...). followed is the part of their strengths with which it follows its\n"
                         "neighbors: less than 1 where it would have shot out.");
  seal(cls);
  pickle_members(cls, &LoftSurface::value, &LoftSurface::error, &LoftSurface::followed);
  cls.def_readonly("value", &LoftSurface::value);
  cls.def_readonly("error", &LoftSurface::error);
  cls.def_readonly("followed", &LoftSurface::followed);
  cls.def("__iter__", [](const LoftSurface& self) { return py::iter(py::make_tuple(self.value, self.error)); });
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
