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
          py::arg("tolerance") = splinecore::kLengthTolerance, py::arg("cancel") = py::none(),
          "The length between two parameters, by default of all: a float, off by at most the tolerance times itself,\n"
          "or by rounding of the coordinates where that is more.\n\n"
          "Adaptive quadrature of Gauss and Kronrod on every span, also through cusps and beside wild weights. Of a\n"
          "periodic curve start and end may be any numbers: it goes on, and turns are counted. InvalidShape unless\n"
          "start <= end in the domain of another, PointAtInfinity if the curve runs to infinity, ToleranceNotReached\n"
          "where that takes too much work: it tells an error that is above the tolerance. cancel: a callable that ends\n"
          "the call by returning true. Row S15.");
  cls.def("curvature", [](const AnyCurve& self, const py::object& u, const py::object& side) {
            return along(form(self), u, side, &splinecore::curvature);
          }, py::arg("u"), py::kw_only(), py::arg("side") = "right",
          "|C' x C''| / |C'|³ at parameters (...,) -> (...,).\n\n"
          "Where C' falls to zero it is the limit, inf at a sharp cusp; nan where the curve stands still.\n"
          "InvalidShape if it is too large for a number. Rows S15, S16.");
  cls.def("torsion", [](const AnyCurve& self, const py::object& u, const py::object& side) {
            return along(form(self), u, side, &splinecore::torsion);
          }, py::arg("u"), py::kw_only(), py::arg("side") = "right",
          "det(C', C'', C''') / |C' x C''|² at parameters (...,) -> (...,), positive for a right-handed screw.\n\n"
          "At an inflection or a cusp it is the limit; nan on a straight line, which has no osculating plane.\n"
          "Row S15.");
  cls.def("frenet_frame", [](const AnyCurve& self, const py::object& u, const py::object& side) {
            return frames(form(self), u, side);
          }, py::arg("u"), py::kw_only(), py::arg("side") = "right",
          "Unit tangent, normal and binormal at parameters: (...,) -> (..., 3, 3), one a row.\n\n"
          "Limits where a derivative falls to zero. Normal and binormal are nan where the curve is straight. Row S15.");
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

constexpr const char* kAreaText =
    "The area, a float: off by at most the tolerance times itself, or by rounding of the coordinates where that is\n"
    "more. Adaptive quadrature of Gauss and Kronrod on every pair of spans.\n\n"
    "PointAtInfinity if a patch runs to infinity; InvalidShape where weights differ too much in size;\n"
    "ToleranceNotReached where it takes too much work, as with many digits of a patch that folds back on itself: it\n"
    "tells an error that is above the tolerance. cancel: a callable that ends the call by returning true. Rows S19, S20.";

void bind_patch(const PatchClasses& cls) {
  cls.def("fundamental_forms", [](const AnyPatch& self, const py::object& u, const py::object& v, const py::object& side) {
            return fundamental_forms(patch_form(self), u, v, side);
          }, py::arg("u"), py::arg("v"), py::kw_only(), py::arg("side") = "right",
          "(first, second) at pairs of parameters: u and v broadcast, (...,) -> two arrays (..., 2, 2).\n\n"
          "[[E, F], [F, G]] and [[L, M], [M, N]], with the unit normal along S_u x S_v. At a pole the normal is its\n"
          "limit; the second form is nan where it has none. InvalidShape if a form is too large for a number.\n"
          "Rows S19, S20.");
  cls.def("curvatures", [](const AnyPatch& self, const py::object& u, const py::object& v, const py::object& side) {
            return curvatures(patch_form(self), u, v, side);
          }, py::arg("u"), py::arg("v"), py::kw_only(), py::arg("side") = "right",
          "Curvatures at pairs of parameters, which broadcast: positive where the patch bends towards its normal.\n\n"
          "At a pole they are those of the one form that all lines through it agree on; nan where they do not, as\n"
          "at the tip of a cone, and where S_u and S_v are parallel. InvalidShape if one is too large for a number.\n"
          "Rows S19, S20.");
  cls.def("area", [](const AnyPatch& self, const py::object& tolerance, const py::object& cancel) {
            const double most = real(tolerance, "tolerance");
            return unlocked([&] { return splinecore::area(patch_form(self), most).value; }, cancel);
          }, py::kw_only(), py::arg("tolerance") = splinecore::kAreaTolerance, py::arg("cancel") = py::none(), kAreaText);
}

void bind_set(Class<PatchSet> cls) {
  cls.def("area", [](const PatchSet& self, const py::object& tolerance, const py::object& cancel) {
            const double most = real(tolerance, "tolerance");
            return unlocked([&] { return splinecore::area(self, most).value; }, cancel);
          }, py::kw_only(), py::arg("tolerance") = splinecore::kAreaTolerance, py::arg("cancel") = py::none(), kAreaText);
  cls.def("volume", [](const PatchSet& self, const py::object& tolerance, const py::object& cancel) {
            const double most = real(tolerance, "tolerance");
            return unlocked([&] { return splinecore::volume(self, most).value; }, cancel);
          }, py::kw_only(), py::arg("tolerance") = splinecore::kAreaTolerance, py::arg("cancel") = py::none(),
          "The volume that the patches enclose, a float right to a relative tolerance; negative if the normals point\n"
          "inwards. By Gauss's theorem and adaptive quadrature. cancel: a callable that ends the call by returning true.\n\n"
          "InvalidShape names a side that meets no other, or beyond which the normals point to the other side. Sides\n"
          "meet on equal points, a side of a pole or across a periodic direction is closed. Rows S19, S20.");
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
          }, py::kw_only(), py::arg("tolerance") = splinecore::kAreaTolerance, py::arg("cancel") = py::none(),
          "The centroid of the solid that the patches enclose, (3,): off by at most the tolerance times half the\n"
          "diagonal of the box of the points, or by rounding where that is more. By Gauss's theorem and adaptive\n"
          "quadrature; normals that point inwards change nothing.\n\n"
          "InvalidShape as volume(), and where the volume is none; PointAtInfinity; ToleranceNotReached. cancel as of\n"
          "volume(). Rows S19, S20.");
  cls.def("second_moments", [](const PatchSet& self, const py::object& about, const py::object& tolerance,
                               const py::object& cancel) { return second_moments(self, about, tolerance, cancel); },
          py::arg("about") = py::none(), py::kw_only(), py::arg("tolerance") = splinecore::kAreaTolerance,
          py::arg("cancel") = py::none(),
          "The integral of d d^T over the solid that the patches enclose, a symmetric (3, 3): d is the way from a\n"
          "point (3,), by default from the centroid. The inertia tensor at density 1 is trace(m) * eye(3) - m.\n\n"
          "Those about the centroid are off by at most the tolerance times their trace, or by rounding where that is\n"
          "more. All are negative if the normals point inwards, as the volume is. InvalidShape as centroid(), and if\n"
          "one is too large for a number; PointAtInfinity; ToleranceNotReached. cancel as of volume(). Rows S19, S20.");
}

void bind_result(py::module_& module) {
  Class<Curvatures> cls(
      module, "Curvatures", py::module_local(),
      "How patches bend at places (...,): positive towards the normal along S_u x S_v.\n\n"
      "gauss and mean are (...,); principal is (..., 2), the larger one first; directions is (..., 2, 3), unit\n"
      "vectors in space at right angles, the second the normal times the first.");
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
  bind_result(module);
  bind_curve(CurveClasses(module));
  bind_patch(PatchClasses(module));
  bind_set(class_of<PatchSet>(module, "PatchSet"));
  bind_moments(class_of<PatchSet>(module, "PatchSet"));
}

}  // namespace bindings
