#include <cmath>
#include <optional>

#include "arrays.hpp"
#include "classes.hpp"
#include "every_kind.hpp"
#include "long_calls.hpp"
#include "result_pickles.hpp"
#include "rooms.hpp"
#include "splinecore/measure/area.hpp"
#include "splinecore/measure/curve_frame.hpp"
#include "splinecore/measure/length.hpp"
#include "splinecore/measure/moments.hpp"
#include "splinecore/measure/patch_curvature.hpp"
#include "values.hpp"

namespace bindings {

using splinecore::Axis;
using splinecore::InvalidShape;
using splinecore::NurbsCurve;
using splinecore::NurbsPatch;
using splinecore::PatchOptions;
using splinecore::PatchSet;
using splinecore::Side;

namespace {

/// What Python sees of the curvatures at many pairs of parameters.
struct Curvatures {
  py::array_t<double> gauss;
  py::array_t<double> mean;
  py::array_t<double> principal;
  py::array_t<double> directions;
};

std::span<double> numbers_in(py::array_t<double>& array) {
  return {array.mutable_data(), static_cast<std::size_t>(array.size())};
}

Shape with_more(Shape shape, std::initializer_list<py::ssize_t> more) {
  shape.insert(shape.end(), more);
  return shape;
}

/// Of a periodic curve, which goes on, one end that was given may lie beyond the other, which was not.
/// @throws InvalidShape naming the one that was given
void require_both_ends(const splinecore::Interval& domain, std::optional<double> start, std::optional<double> end) {
  if (start && !end && std::isfinite(*start) && *start > domain.end) {
    throw InvalidShape("start = " + splinecore::text_of(*start) + " is above " + splinecore::text_of(domain.end) +
                       ", the end of the domain: an end is needed, too");
  }
  if (end && !start && std::isfinite(*end) && *end < domain.start) {
    throw InvalidShape("end = " + splinecore::text_of(*end) + " is below " + splinecore::text_of(domain.start) +
                       ", the start of the domain: a start is needed, too");
  }
}

double length(const NurbsCurve& curve, const py::object& start, const py::object& end, const py::object& tolerance,
              const py::object& cancel) {
  const splinecore::Interval domain = curve.domain();
  const std::optional<double> from = optional_real(start, "start");
  const std::optional<double> to = optional_real(end, "end");
  if (curve.periodic()) require_both_ends(domain, from, to);
  const splinecore::Interval range{from.value_or(domain.start), to.value_or(domain.end)};
  const double most = real(tolerance, "tolerance");
  return unlocked([&] { return splinecore::length(curve, range, most).value; }, cancel);
}

/// One number for each parameter.
using AlongCurve = void (*)(const NurbsCurve&, std::span<const double>, std::span<double>, Side);

py::array_t<double> along(const NurbsCurve& curve, const py::object& u, const py::object& side, AlongCurve measure) {
  const Doubles at = real_array(u, "u");
  const Side from = side_of(side, "side");
  require_inside(curve.knot_vector(), at, from, "u");
  py::array_t<double> out(Shape(at.shape(), at.shape() + at.ndim()));
  const std::span numbers = numbers_in(out);
  unlocked([&] { measure(curve, {at.data(), numbers.size()}, numbers, from); });
  return out;
}

py::array_t<double> frames(const NurbsCurve& curve, const py::object& u, const py::object& side) {
  const Doubles at = real_array(u, "u");
  const Side from = side_of(side, "side");
  require_inside(curve.knot_vector(), at, from, "u");
  py::array_t<double> out(with_more(Shape(at.shape(), at.shape() + at.ndim()), {3, 3}));
  const auto count = static_cast<std::size_t>(at.size());
  static_assert(sizeof(splinecore::MovingFrame) == 9 * sizeof(double));
  auto* first = reinterpret_cast<splinecore::MovingFrame*>(out.mutable_data());
  unlocked([&] { splinecore::frenet_frames(curve, {at.data(), count}, {first, count}, from); });
  return out;
}

void bind_curve(const CurveClasses& cls) {
  cls.def("length", [](const AnyCurve& self, const py::object& start, const py::object& end, const py::object& tolerance,
                       const py::object& cancel) { return length(form(self), start, end, tolerance, cancel); },
          py::arg("start") = py::none(), py::arg("end") = py::none(), py::kw_only(),
          py::arg("tolerance") = splinecore::kLengthTolerance, py::arg("cancel") = py::none());
  cls.def("curvature", [](const AnyCurve& self, const py::object& u, const py::object& side) {
            return along(form(self), u, side, &splinecore::curvature);
          }, py::arg("u"), py::kw_only(), py::arg("side") = "right");
  cls.def("torsion", [](const AnyCurve& self, const py::object& u, const py::object& side) {
            return along(form(self), u, side, &splinecore::torsion);
          }, py::arg("u"), py::kw_only(), py::arg("side") = "right");
  cls.def("frenet_frame", [](const AnyCurve& self, const py::object& u, const py::object& side) {
            return frames(form(self), u, side);
          }, py::arg("u"), py::kw_only(), py::arg("side") = "right");
}

/// u and v broadcast against each other, in the domain of a patch.
struct Places {
  Doubles u;
  Doubles v;
  Shape shape;
  PatchOptions options;

  Places(const NurbsPatch& patch, const py::object& at_u, const py::object& at_v, const py::object& side) {
    const bool is_pair = py::isinstance<py::tuple>(side) && py::len(side) == 2;
    options.side_u = side_of(is_pair ? py::object(side[py::int_(0)]) : side, "side");
    options.side_v = side_of(is_pair ? py::object(side[py::int_(1)]) : side, "side");
    const Doubles given_u = real_array(at_u, "u");
    const Doubles given_v = real_array(at_v, "v");
    require_inside(patch.knot_vector(Axis::u), given_u, options.side_u, "u");
    require_inside(patch.knot_vector(Axis::v), given_v, options.side_v, "v");
    try {
      const py::list both = py::module_::import("numpy").attr("broadcast_arrays")(given_u, given_v);
      u = Doubles(both[0]);
      v = Doubles(both[1]);
    } catch (py::error_already_set& error) {
      if (!error.matches(PyExc_ValueError)) throw;
      throw InvalidShape("u of shape " + shape_text(given_u) + " and v of shape " + shape_text(given_v) +
                         " do not broadcast");
    }
    shape.assign(u.shape(), u.shape() + u.ndim());
  }

  std::size_t count() const { return static_cast<std::size_t>(u.size()); }
};

py::tuple fundamental_forms(const NurbsPatch& patch, const py::object& u, const py::object& v, const py::object& side) {
  const Places at(patch, u, v, side);
  std::vector<splinecore::FundamentalForms> forms(at.count());
  unlocked([&] {
    splinecore::fundamental_forms(patch, {at.u.data(), at.count()}, {at.v.data(), at.count()}, forms, at.options);
  });
  py::array_t<double> first(with_more(at.shape, {2, 2}));
  py::array_t<double> second(with_more(at.shape, {2, 2}));
  double* to_first = first.mutable_data();
  double* to_second = second.mutable_data();
  for (const auto& form : forms) {
    for (const double value : {form.e, form.f, form.f, form.g}) *to_first++ = value;
    for (const double value : {form.l, form.m, form.m, form.n}) *to_second++ = value;
  }
  return py::make_tuple(first, second);
}

Curvatures curvatures(const NurbsPatch& patch, const py::object& u, const py::object& v, const py::object& side) {
  const Places at(patch, u, v, side);
  std::vector<splinecore::SurfaceCurvature> found(at.count());
  unlocked([&] {
    splinecore::curvatures(patch, {at.u.data(), at.count()}, {at.v.data(), at.count()}, found, at.options);
  });
  Curvatures out{py::array_t<double>(at.shape), py::array_t<double>(at.shape),
                 py::array_t<double>(with_more(at.shape, {2})), py::array_t<double>(with_more(at.shape, {2, 3}))};
  for (std::size_t i = 0; i < found.size(); ++i) {
    out.gauss.mutable_data()[i] = found[i].gauss;
    out.mean.mutable_data()[i] = found[i].mean;
    std::ranges::copy(found[i].principal, out.principal.mutable_data() + 2 * i);
    std::copy_n(&found[i].directions[0].x, 6, out.directions.mutable_data() + 6 * i);
  }
  return out;
}

void bind_patch(const PatchClasses& cls) {
  cls.def("fundamental_forms", [](const AnyPatch& self, const py::object& u, const py::object& v, const py::object& side) {
            return fundamental_forms(patch_form(self), u, v, side);
          }, py::arg("u"), py::arg("v"), py::kw_only(), py::arg("side") = "right");
  cls.def("curvatures", [](const AnyPatch& self, const py::object& u, const py::object& v, const py::object& side) {
            return curvatures(patch_form(self), u, v, side);
          }, py::arg("u"), py::arg("v"), py::kw_only(), py::arg("side") = "right");
  cls.def("area", [](const AnyPatch& self, const py::object& tolerance, const py::object& cancel) {
            const double most = real(tolerance, "tolerance");
            return unlocked([&] { return splinecore::area(patch_form(self), most).value; }, cancel);
          }, py::kw_only(), py::arg("tolerance") = splinecore::kAreaTolerance, py::arg("cancel") = py::none());
}

void bind_set(Class<PatchSet> cls) {
  cls.def("area", [](const PatchSet& self, const py::object& tolerance, const py::object& cancel) {
            const double most = real(tolerance, "tolerance");
            return unlocked([&] { return splinecore::area(self, most).value; }, cancel);
          }, py::kw_only(), py::arg("tolerance") = splinecore::kAreaTolerance, py::arg("cancel") = py::none());
  cls.def("volume", [](const PatchSet& self, const py::object& tolerance, const py::object& cancel) {
            const double most = real(tolerance, "tolerance");
            return unlocked([&] { return splinecore::volume(self, most).value; }, cancel);
          }, py::kw_only(), py::arg("tolerance") = splinecore::kAreaTolerance, py::arg("cancel") = py::none());
}

py::array_t<double> second_moments(const PatchSet& set, const py::object& about, const py::object& tolerance,
                                   const py::object& cancel) {
  std::optional<glm::dvec3> point;
  if (!about.is_none()) point = vector_of(about, "about");
  const double most = real(tolerance, "tolerance");
  const auto found = unlocked([&] { return splinecore::second_moments(set, point, most).value; }, cancel);
  py::array_t<double> out(Shape{3, 3});
  std::copy_n(&found[0].x, 9, out.mutable_data());
  return out;
}

void bind_moments(Class<PatchSet> cls) {
  cls.def("centroid", [](const PatchSet& self, const py::object& tolerance, const py::object& cancel) {
            const double most = real(tolerance, "tolerance");
            const glm::dvec3 found = unlocked([&] { return splinecore::centroid(self, most).value; }, cancel);
            py::array_t<double> out(Shape{3});
            std::copy_n(&found.x, 3, out.mutable_data());
            return out;
          }, py::kw_only(), py::arg("tolerance") = splinecore::kAreaTolerance, py::arg("cancel") = py::none());
  cls.def("second_moments", [](const PatchSet& self, const py::object& about, const py::object& tolerance,
                               const py::object& cancel) { return second_moments(self, about, tolerance, cancel); },
          py::arg("about") = py::none(), py::kw_only(), py::arg("tolerance") = splinecore::kAreaTolerance,
          py::arg("cancel") = py::none());
}

void bind_jet(py::module_& module) {
  Class<Curvatures> cls(
      module, "Curvatures", py::module_local());
  seal(cls);
  pickle_members(cls, &Curvatures::gauss, &Curvatures::mean, &Curvatures::principal, &Curvatures::directions);
  cls.def_readonly("gauss", &Curvatures::gauss);
  cls.def_readonly("mean", &Curvatures::mean);
  cls.def_readonly("principal", &Curvatures::principal);
  cls.def_readonly("directions", &Curvatures::directions);
  cls.def("__repr__", [](const Curvatures& self) { return "Curvatures(shape=" + shape_text(self.gauss) + ")"; });
}

}  // namespace

void bind_measure(py::module_& module) {
  bind_jet(module);
  bind_curve(CurveClasses(module));
  bind_patch(PatchClasses(module));
  bind_set(class_of<PatchSet>(module, "PatchSet"));
  bind_moments(class_of<PatchSet>(module, "PatchSet"));
}

}  // namespace bindings
