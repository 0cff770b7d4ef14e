#include "arguments.hpp"
#include "arrays.hpp"
#include "classes.hpp"
#include "join_arguments.hpp"
#include "joints.hpp"
#include "long_calls.hpp"
#include "result_pickles.hpp"
#include "rooms.hpp"
#include "splinecore/measure/seam.hpp"
#include "splinecore/patch/join.hpp"
#include "splinecore/patch/patch_set.hpp"
#include "values.hpp"
#include "views.hpp"

namespace bindings {

using splinecore::Axis;
using splinecore::BezierPatch;
using splinecore::Border;
using splinecore::HermitePatch;
using splinecore::InvalidShape;
using splinecore::JoinMoves;
using splinecore::NurbsPatch;
using splinecore::PatchSmoothness;
using splinecore::SeamContinuity;

namespace {

/// splinecore::PatchJoin with patches of any kind.
struct JoinedPatches {
  py::object first;
  py::object second;
  double first_error;
  double second_error;
  bool reversed;
};

splinecore::AnyPatch patch_of(const py::object& value, const char* name) {
  std::optional<splinecore::AnyPatch> patch;
  if (unwrap(value, patch)) return *patch;
  throw py::type_error(std::string(name) + " must be a patch, not " + type_name(value));
}

py::object as_bezier(const NurbsPatch& patch) {
  return py::cast(BezierPatch::make(patch.count(Axis::u), patch.count(Axis::v),
                                    {patch.points().begin(), patch.points().end()}));
}

JoinedPatches join_patches(const py::object& first, const py::object& first_side, const py::object& second,
                           const py::object& second_side, const py::object& continuity, const py::object& moves,
                           const py::object& reversed) {
  const splinecore::AnyPatch a = patch_of(first, "first");
  const Border on_a = border_of(first_side, "first_side");
  const splinecore::AnyPatch b = patch_of(second, "second");
  const Border on_b = border_of(second_side, "second_side");
  const PatchSmoothness smoothness = smoothness_of(continuity);
  const JoinMoves moved = moves_of(moves);
  const std::optional<bool> against = optional_boolean(reversed, "reversed");
  const auto join = unlocked([&] {
    return splinecore::joined_patches(nurbs_of(a), on_a, nurbs_of(b), on_b, smoothness, moved, against);
  });
  // One span on [0, 1] in both directions is what two Bezier patches stay.
  const bool are_bezier = std::holds_alternative<BezierPatch>(a) && std::holds_alternative<BezierPatch>(b);
  return {are_bezier ? as_bezier(join.first) : py::cast(join.first),
          are_bezier ? as_bezier(join.second) : py::cast(join.second), join.first_error, join.second_error,
          join.reversed};
}

SeamContinuity seam_continuity(const splinecore::AnyPatch& a, const py::object& first_side, const py::object& second,
                               const char* second_name, const char* first_side_name, const py::object& second_side,
                               const char* second_side_name, const py::object& tolerance,
                               const py::object& parameters, const py::object& reversed) {
  const Border on_a = border_of(first_side, first_side_name);
  const splinecore::AnyPatch b = patch_of(second, second_name);
  const Border on_b = border_of(second_side, second_side_name);
  const double most = real(tolerance, "tolerance");
  const std::optional<bool> against = optional_boolean(reversed, "reversed");
  std::optional<std::vector<double>> given;
  if (!parameters.is_none()) given = numbers(parameters, "parameters");
  return unlocked([&] {
    std::optional<std::span<const double>> places;
    if (given) places = *given;
    return splinecore::seam_continuity(nurbs_of(a), on_a, nurbs_of(b), on_b, most, places, against);
  });
}

void bind_seam(py::module_& module) {
  Class<SeamContinuity> cls(
      module, "SeamContinuity", py::module_local());
  seal(cls);
  pickle_members(cls, &SeamContinuity::gap, &SeamContinuity::angle, &SeamContinuity::curvature_difference,
                  &SeamContinuity::first_difference, &SeamContinuity::second_difference, &SeamContinuity::c,
                  &SeamContinuity::g, &SeamContinuity::reversed, &SeamContinuity::parameters,
                  &SeamContinuity::points, &SeamContinuity::gaps, &SeamContinuity::angles,
                  &SeamContinuity::curvature_differences);
  cls.def_readonly("gap", &SeamContinuity::gap);
  cls.def_readonly("angle", &SeamContinuity::angle);
  cls.def_readonly("curvature_difference", &SeamContinuity::curvature_difference);
  cls.def_readonly("first_difference", &SeamContinuity::first_difference);
  cls.def_readonly("second_difference", &SeamContinuity::second_difference);
  cls.def_readonly("c", &SeamContinuity::c);
  cls.def_readonly("g", &SeamContinuity::g);
  cls.def_readonly("reversed", &SeamContinuity::reversed);
  const auto add_numbers = [&cls](const char* name, std::vector<double> SeamContinuity::*member) {
    cls.def_property_readonly(name, [member](const py::object& self) {
      return view_of_numbers(std::span<const double>(py::cast<const SeamContinuity&>(self).*member), self);
    });
  };
  add_numbers("parameters", &SeamContinuity::parameters);
  add_numbers("gaps", &SeamContinuity::gaps);
  add_numbers("angles", &SeamContinuity::angles);
  add_numbers("curvature_differences", &SeamContinuity::curvature_differences);
  cls.def_property_readonly("points", [](const py::object& self) {
    const auto& points = py::cast<const SeamContinuity&>(self).points;
    return view_of_vectors(points, {static_cast<py::ssize_t>(points.size())}, self);
  });
  cls.def("__repr__", [](const SeamContinuity& self) {
    const auto text = [](double value) { return splinecore::text_of(value); };
    return "SeamContinuity(gap=" + text(self.gap) + ", angle=" + text(self.angle) + ", curvature_difference=" +
           text(self.curvature_difference) + ", c=" + std::to_string(self.c) + ", g=" + std::to_string(self.g) + ")";
  });
}

void bind_seam_function(py::module_& module) {
  module.def("seam_continuity", [](const py::object& first, const py::object& first_side, const py::object& second,
                                   const py::object& second_side, const py::object& tolerance,
                                   const py::object& parameters, const py::object& reversed) {
               return seam_continuity(patch_of(first, "first"), first_side, second, "second", "first_side",
                                      second_side, "second_side", tolerance, parameters, reversed);
             }, py::arg("first"), py::arg("first_side"), py::arg("second"), py::arg("second_side"), py::kw_only(),
             py::arg("tolerance") = splinecore::kContinuityTolerance, py::arg("parameters") = py::none(),
             py::arg("reversed") = py::none());
}

template <class Patch>
void bind_continuity_to(const py::module_& module, const char* name) {
  auto cls = py::reinterpret_borrow<Class<Patch>>(module.attr(name));
  cls.def("continuity_to", [](const Patch& self, const py::object& side, const py::object& other,
                              const py::object& other_side, const py::object& tolerance,
                              const py::object& reversed) {
            return seam_continuity(splinecore::AnyPatch(self), side, other, "other", "side", other_side, "other_side", tolerance,
                                   py::none(), reversed);
          }, py::arg("side"), py::arg("other"), py::arg("other_side"),
          py::arg("tolerance") = splinecore::kContinuityTolerance, py::arg("reversed") = py::none());
  cls.def("join", [](const py::object& self, const py::object& side, const py::object& other, const py::object& other_side,
                     const py::object& continuity, const py::object& moves, const py::object& reversed) {
            return join_patches(self, side, other, other_side, continuity, moves, reversed);
          }, py::arg("side"), py::arg("other"), py::arg("other_side"), py::arg("continuity") = "G1", py::arg("moves") = "second",
          py::arg("reversed") = py::none());
}

void bind_join(py::module_& module) {
  Class<JoinedPatches> cls(
      module, "JoinedPatches", py::module_local());
  seal(cls);
  pickle_members(cls, &JoinedPatches::first, &JoinedPatches::second, &JoinedPatches::first_error,
                  &JoinedPatches::second_error, &JoinedPatches::reversed);
  cls.def_readonly("first", &JoinedPatches::first);
  cls.def_readonly("second", &JoinedPatches::second);
  cls.def_readonly("first_error", &JoinedPatches::first_error);
  cls.def_readonly("second_error", &JoinedPatches::second_error);
  cls.def_readonly("reversed", &JoinedPatches::reversed);
  cls.def("__repr__", [](const JoinedPatches& self) {
    return "JoinedPatches(first=" + std::string(py::repr(self.first)) + ", second=" +
           std::string(py::repr(self.second)) + ", first_error=" + splinecore::text_of(self.first_error) +
           ", second_error=" + splinecore::text_of(self.second_error) + ")";
  });
  py::module_ build = module.attr("build");
  build.def("join_patches", &join_patches, py::arg("first"), py::arg("first_side"), py::arg("second"),
            py::arg("second_side"), py::arg("continuity") = "G1", py::arg("moves") = "second",
            py::arg("reversed") = py::none());
}

}  // namespace

void bind_patch_joins(py::module_& module) {
  bind_seam(module);
  bind_seam_function(module);
  bind_continuity_to<NurbsPatch>(module, "NurbsPatch");
  bind_continuity_to<BezierPatch>(module, "BezierPatch");
  bind_continuity_to<HermitePatch>(module, "HermitePatch");
  bind_join(module);
  py::module_ build = module.attr("build");
  bind_joints(build);
}

}  // namespace bindings
