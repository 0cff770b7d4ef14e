#include "arrays.hpp"
#include "long_calls.hpp"
#include "rational.hpp"
#include "rooms.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/base/quotient.hpp"
#include "splinecore/convert/to_bezier.hpp"
#include "splinecore/convert/to_hermite.hpp"
#include "splinecore/curve/bezier_curve.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "splinecore/curve/hermite_curve.hpp"
#include "splinecore/curve/nurbs_curve.hpp"
#include "splinecore/tessellate/polyline.hpp"
#include "values.hpp"

namespace bindings {

using splinecore::BezierCurve;
using splinecore::EvaluateOptions;
using splinecore::HermiteCurve;
using splinecore::InvalidShape;
using splinecore::KnotVector;
using splinecore::NurbsCurve;

namespace {

constexpr std::size_t kPart = 1 << 16;

const NurbsCurve& form(const NurbsCurve& curve) { return curve; }
const NurbsCurve& form(const BezierCurve& curve) { return curve.nurbs(); }
const NurbsCurve& form(const HermiteCurve& curve) { return curve.nurbs(); }

EvaluateOptions options_of(const py::object& side, const py::object& at_infinity) {
  return {side_of(side, "side"), at_infinity_of(at_infinity)};
}

/// in_parts() over parameters; one that is refused is named by its place among all of them.
template <class Work>
void in_parts_of(const Doubles& parameters, const NurbsCurve& curve, const EvaluateOptions& options,
                 const py::object& cancel, Work work) {
  try {
    in_parts(parameters.size(), kPart, cancel, work);
  } catch (const InvalidShape&) {
    require_inside(curve.knot_vector(), parameters, options.side, "u");
    throw;
  }
}

py::array evaluate(const NurbsCurve& curve, const py::object& u, const py::object& side,
                   const py::object& at_infinity, const py::object& dtype, const py::object& out,
                   const py::object& cancel) {
  const Doubles at = apart_from(real_array(u, "u"), out);
  Shape shape(at.shape(), at.shape() + at.ndim());
  shape.push_back(3);
  const Output output(shape, out, dtype);
  const EvaluateOptions options = options_of(side, at_infinity);
  in_parts_of(at, curve, options, cancel, [&](std::size_t begin, std::size_t end) {
    const std::span parameters(at.data() + begin, end - begin);
    if (output.single()) {
      splinecore::evaluate(curve, parameters, output.floats(3 * begin, 3 * (end - begin)), options);
    } else {
      splinecore::evaluate(curve, parameters, output.doubles(3 * begin, 3 * (end - begin)), options);
    }
  });
  return output.array();
}

py::array derivatives(const NurbsCurve& curve, const py::object& u, const py::object& order,
                      const py::object& side, const py::object& at_infinity, const py::object& cancel) {
  const Doubles at = real_array(u, "u");
  const int highest = integer(order, "order");
  splinecore::require_order(highest);
  Shape shape(at.shape(), at.shape() + at.ndim());
  shape.push_back(highest + 1);
  shape.push_back(3);
  const Output output(shape, py::none(), py::none());
  const EvaluateOptions options = options_of(side, at_infinity);
  const std::size_t row = 3 * (highest + 1);
  in_parts_of(at, curve, options, cancel, [&](std::size_t begin, std::size_t end) {
    splinecore::derivatives(curve, {at.data() + begin, end - begin}, highest,
                            output.doubles(row * begin, row * (end - begin)), options);
  });
  return output.array();
}

py::list polylines(const NurbsCurve& curve, const py::object& resolution) {
  py::list lines;
  const int steps = integer(resolution, "resolution");
  for (const auto& line : unlocked([&] { return splinecore::polylines(curve, steps); })) {
    py::array_t<double> points({static_cast<py::ssize_t>(line.points.size() / 3), py::ssize_t{3}});
    std::ranges::copy(line.points, points.mutable_data());
    lines.append(py::make_tuple(points, line.closed));
  }
  return lines;
}

py::list finite_pieces(const NurbsCurve& curve) {
  py::list intervals;
  for (const auto& piece : splinecore::pieces(curve)) intervals.append(pair_of(piece));
  return intervals;
}

/// What every kind of curve can do through its NURBS form.
template <class Curve>
void bind_common(py::class_<Curve>& cls) {
  cls.def_property_readonly("degree", [](const Curve& self) { return form(self).degree(); });
  cls.def_property_readonly("domain", [](const Curve& self) { return pair_of(form(self).domain()); },
                            "(start, end) of the parameter.");
  cls.def_property_readonly("is_rational", [](const Curve& self) { return form(self).rational(); },
                            "True unless every weight is 1.");
  cls.def("evaluate", [](const Curve& self, const py::object& u, const py::object& side, const py::object& at_infinity,
                         const py::object& dtype, const py::object& out, const py::object& cancel) {
            return evaluate(form(self), u, side, at_infinity, dtype, out, cancel);
          },
          py::arg("u"), py::kw_only(), py::arg("side") = "right", py::arg("at_infinity") = "raise",
          py::arg("dtype") = py::none(), py::arg("out") = py::none(), py::arg("cancel") = py::none(),
          "Points at parameters: (...,) -> (..., 3), float64 or, with dtype or out, float32.\n\n"
          "A parameter outside the domain by more than 4 ulp raises InvalidShape. At a knot the right-hand\n"
          "value is taken unless side='left'. Where the weight is zero PointAtInfinity is raised, or\n"
          "at_infinity='nan' marks the point. out is a C-contiguous array of the result's shape; cancel\n"
          "is a callable that ends a long call by returning True. Rows S6, S9, S15.");
  cls.def("derivatives", [](const Curve& self, const py::object& u, const py::object& order, const py::object& side,
                            const py::object& at_infinity, const py::object& cancel) {
            return derivatives(form(self), u, order, side, at_infinity, cancel);
          },
          py::arg("u"), py::arg("order"), py::kw_only(), py::arg("side") = "right",
          py::arg("at_infinity") = "raise", py::arg("cancel") = py::none(),
          "The point and its derivatives up to order: (...,) -> (..., order + 1, 3). The NURBS Book, A4.2.");
  cls.def("pieces", [](const Curve& self) { return finite_pieces(form(self)); },
          "Intervals [(start, end), …] on which the curve is finite and in one piece: it is cut where the\n"
          "weight is zero and at knots of multiplicity degree + 1.");
  cls.def("polylines", [](const Curve& self, const py::object& resolution) { return polylines(form(self), resolution); },
          py::arg("resolution"),
          "[(points (m, 3), closed), …]: one polyline for each of pieces(), resolution steps a span.");
  cls.def("to_bezier", [](const Curve& self) { return unlocked([&] { return splinecore::to_bezier(form(self)); }); },
          "One BezierCurve for each span, in order. The NURBS Book, A5.6.");
  cls.def("to_hermite", [](const Curve& self) { return splinecore::to_hermite(form(self)); },
          "The same curve as a HermiteCurve; InvalidShape if it is rational, has a gap or degree above 3.");
}

/// Control points with weights, as Bezier and NURBS curves have them.
template <class Curve>
void bind_points(py::class_<Curve>& cls) {
  const auto count = [](const Curve& curve) { return Shape{static_cast<py::ssize_t>(curve.points().size())}; };
  cls.def_property_readonly("points", [count](const py::object& self) {
    const auto& curve = py::cast<const Curve&>(self);
    return view_of_points(curve.points(), count(curve), self);
  }, "(n, 3) float64, as given, read-only.");
  cls.def_property_readonly("weights", [count](const py::object& self) {
    const auto& curve = py::cast<const Curve&>(self);
    return view_of_weights(curve.points(), count(curve), self);
  }, "(n,) float64, read-only. A point of weight 0 is a direction: a point at infinity.");
  cls.def_property_readonly("homogeneous_points", [count](const Curve& self) {
    return homogeneous_array(self.points(), count(self));
  }, "(n, 4): wx, wy, wz, w; a direction keeps its coordinates.");
  cls.def("with_points", [](const Curve& self, const py::object& points) {
            const Doubles given = real_array(points, "points");
            std::vector<glm::dvec4> rows = weighted_points(given, py::none(), 1);
            require_net(given, "points", {static_cast<py::ssize_t>(self.points().size())});
            for (std::size_t i = 0; i < rows.size(); ++i) rows[i].w = self.points()[i].w;
            return self.with_points(std::move(rows));
          }, py::arg("points"), "The curve with other points (n, 2 or 3) and the same weights and knots.");
  cls.def("with_weights", [](const Curve& self, const py::object& weights) {
            const std::vector<double> given = numbers(weights, "weights");
            std::vector<glm::dvec4> rows(self.points().begin(), self.points().end());
            if (given.size() != rows.size()) {
              throw InvalidShape("weights has " + std::to_string(given.size()) + " values for " +
                                 std::to_string(rows.size()) + " points");
            }
            for (std::size_t i = 0; i < rows.size(); ++i) rows[i].w = given[i];
            return self.with_points(std::move(rows));
          }, py::arg("weights"), "The curve with other weights (n,) and the same points and knots.");
}

/// Tangents (n, 3), or (n, 2, 3) incoming and outgoing.
std::vector<splinecore::Tangents> tangents_of(const py::object& value) {
  const Doubles array = real_array(value, "tangents");
  std::vector<splinecore::Tangents> tangents;
  if (array.ndim() == 3) {
    if (array.shape(1) != 2) {
      throw InvalidShape("tangents has shape " + shape_text(array) + ", (n, 3) or (n, 2, 3) is expected");
    }
    const std::vector<glm::dvec3> rows = vectors(array, "tangents", 2);
    for (std::size_t i = 0; i < rows.size(); i += 2) tangents.push_back({rows[i], rows[i + 1]});
    return tangents;
  }
  for (const glm::dvec3& tangent : vectors(array, "tangents", 1)) tangents.push_back({tangent, tangent});
  return tangents;
}

std::string text_of(const NurbsCurve& curve) {
  return "NurbsCurve(degree=" + std::to_string(curve.degree()) + ", points=" + std::to_string(curve.points().size()) +
         (curve.rational() ? ", rational" : "") + (curve.periodic() ? ", periodic)" : ")");
}

void bind_nurbs(py::module_& module) {
  py::class_<NurbsCurve> cls(
      module, "NurbsCurve", py::module_local(),
      "NurbsCurve(degree, knots, points, weights=None, periodic=False)\n\n"
      "n control points (n, 2 or 3) with weights (n,) on n + degree + 1 knots; periodic on n + 1, one period.\n"
      "A weight of 0 makes a point a direction, negative weights are allowed. Raises InvalidShape (a\n"
      "ValueError) or TypeError naming the argument, index and value. Lecture rows S11, S15.");
  cls.def(py::init([](const py::object& degree, const py::object& knots, const py::object& points,
                      const py::object& weights, const py::object& periodic) {
            return NurbsCurve::make(integer(degree, "degree"), numbers(knots, "knots"),
                                    weighted_points(real_array(points, "points"), weights, 1),
                                    boolean(periodic, "periodic"));
          }),
          py::arg("degree"), py::arg("knots"), py::arg("points"), py::arg("weights") = py::none(),
          py::arg("periodic") = false);
  cls.def_static("from_homogeneous", [](const py::object& degree, const py::object& knots, const py::object& points,
                                        const py::object& periodic) {
                   const auto rows = rows_of_four(real_array(points, "points"), "points", 1);
                   splinecore::require_points(rows);
                   return NurbsCurve::from_homogeneous(
                       KnotVector::make(integer(degree, "degree"), numbers(knots, "knots"), boolean(periodic, "periodic")),
                       rows);
                 },
                 py::arg("degree"), py::arg("knots"), py::arg("points"), py::arg("periodic") = false,
                 "From points (n, 4): wx, wy, wz, w; w = 0 makes a direction.");
  bind_common(cls);
  bind_points(cls);
  bind_rational_verbs(cls);
  bind_value(cls);
  cls.def_property_readonly("periodic", &NurbsCurve::periodic);
  cls.def_property_readonly("knots", [](const py::object& self) {
    return view_of_numbers(py::cast<const NurbsCurve&>(self).knot_vector().knots(), self);
  }, "The knots as given: a read-only float64 array.");
  cls.def_property_readonly("knot_vector", [](const NurbsCurve& self) { return self.knot_vector(); },
                            "The basis.KnotVector, shared.");
  cls.def("insert_knot", [](const NurbsCurve& self, const py::object& u, const py::object& times) {
            return splinecore::insert_knot(self, parameter(u, self.knot_vector()), integer(times, "times"));
          }, py::arg("u"), py::arg("times") = 1,
          "The same curve with u added to the knots. Untouched points keep every digit (Boehm 1980).");
  cls.def("refine", [](const NurbsCurve& self, const py::object& knots) {
            const std::vector<double> inserted = numbers(knots, "knots");
            return unlocked([&] { return splinecore::refine(self, inserted); });
          }, py::arg("knots"), "The same curve with all these parameters added to the knots.");
  cls.def("split", [](const NurbsCurve& self, const py::object& u) -> py::tuple {
            const double at = real(u, "u");
            if (self.periodic()) return py::make_tuple(splinecore::opened(self, at));
            auto [before, after] = splinecore::split(self, at);
            return py::make_tuple(std::move(before), std::move(after));
          }, py::arg("u"),
          "(before, after), each on its part of the domain; of a periodic curve (opened,), one plain curve from u\n"
          "once around.");
  cls.def("unrolled", [](const NurbsCurve& self) { return splinecore::unrolled(self); },
          "The same curve as a plain one: knots and points of a periodic curve repeated.");
  cls.def("reversed", [](const NurbsCurve& self) { return splinecore::reversed(self); },
          "The same points in the opposite direction, over the same domain.");
  cls.def("to_nurbs", [](const NurbsCurve& self) { return self; }, "The curve itself.");
  cls.def("__repr__", &text_of);
}

void bind_bezier(py::module_& module) {
  py::class_<BezierCurve> cls(
      module, "BezierCurve", py::module_local(),
      "BezierCurve(points, weights=None)\n\n"
      "degree + 1 control points (n, 2 or 3) with weights (n,), over [0, 1]. Lecture rows S6, S9, S11.");
  cls.def(py::init([](const py::object& points, const py::object& weights) {
            return BezierCurve::make(weighted_points(real_array(points, "points"), weights, 1));
          }), py::arg("points"), py::arg("weights") = py::none());
  cls.def_static("from_homogeneous", [](const py::object& points) {
    const auto rows = rows_of_four(real_array(points, "points"), "points", 1);
    splinecore::require_points(rows);
    return BezierCurve::from_homogeneous(rows);
  }, py::arg("points"), "From points (n, 4): wx, wy, wz, w; w = 0 makes a direction.");
  bind_common(cls);
  bind_points(cls);
  bind_rational_verbs(cls);
  bind_value(cls);
  cls.def("split", [](const BezierCurve& self, const py::object& u) { return splinecore::split(self, real(u, "u")); },
          py::arg("u"), "(before, after), each over [0, 1] (de Casteljau).");
  cls.def("reversed", [](const BezierCurve& self) { return splinecore::reversed(self); },
          "The same points in the opposite direction.");
  cls.def("to_nurbs", [](const BezierCurve& self) { return self.nurbs(); }, "The same curve as a NurbsCurve.");
  cls.def("__repr__", [](const BezierCurve& self) {
    return "BezierCurve(degree=" + std::to_string(self.degree()) + (self.nurbs().rational() ? ", rational)" : ")");
  });
}

void bind_hermite(py::module_& module) {
  py::class_<HermiteCurve> cls(
      module, "HermiteCurve", py::module_local(),
      "HermiteCurve(points, tangents, parameters=None)\n\n"
      "A chain of cubics through points (n, 2 or 3) with derivatives (n, 3), or (n, 2, 3): incoming and\n"
      "outgoing. Parameters (n,) increase; 0, 1, 2, … if none are given. Lecture row S4.");
  cls.def(py::init([](const py::object& points, const py::object& tangents, const py::object& parameters) {
            return HermiteCurve::make(vectors(real_array(points, "points"), "points", 1), tangents_of(tangents),
                                      optional_numbers(parameters, "parameters"));
          }), py::arg("points"), py::arg("tangents"), py::arg("parameters") = py::none());
  bind_common(cls);
  bind_value(cls);
  cls.def_property_readonly("points", [](const py::object& self) {
    const auto points = py::cast<const HermiteCurve&>(self).points();
    return view_of_vectors(points, {static_cast<py::ssize_t>(points.size())}, self);
  }, "(n, 3) float64, read-only.");
  cls.def_property_readonly("tangents", [](const py::object& self) {
    const auto tangents = py::cast<const HermiteCurve&>(self).tangents();
    const auto* rows = reinterpret_cast<const glm::dvec3*>(tangents.data());
    return view_of_vectors({rows, 2 * tangents.size()}, {static_cast<py::ssize_t>(tangents.size()), 2}, self);
  }, "(n, 2, 3) float64, incoming and outgoing, read-only.");
  cls.def_property_readonly("parameters", [](const py::object& self) {
    return view_of_numbers(py::cast<const HermiteCurve&>(self).parameters(), self);
  }, "(n,) float64, read-only.");
  cls.def("split", [](const HermiteCurve& self, const py::object& u) { return splinecore::split(self, real(u, "u")); },
          py::arg("u"), "(before, after), each on its part of the domain.");
  cls.def("reversed", [](const HermiteCurve& self) { return splinecore::reversed(self); },
          "The same points in the opposite direction, over the same domain.");
  cls.def("to_nurbs", [](const HermiteCurve& self) { return self.nurbs(); },
          "The same curve as a cubic NurbsCurve with triple knots.");
  cls.def("__repr__", [](const HermiteCurve& self) {
    return "HermiteCurve(points=" + std::to_string(self.points().size()) + ")";
  });
}

}  // namespace

void bind_curves(py::module_& module) {
  bind_nurbs(module);
  bind_bezier(module);
  bind_hermite(module);
}

}  // namespace bindings
