#include <cmath>

#include "approximation.hpp"
#include "arrays.hpp"
#include "classes.hpp"
#include "every_kind.hpp"
#include "long_calls.hpp"
#include "rational.hpp"
#include "rooms.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/convert/to_power.hpp"
#include "splinecore/curve/bezier_curve.hpp"
#include "splinecore/curve/bezier_degree.hpp"
#include "splinecore/curve/flatten.hpp"
#include "splinecore/curve/hermite_curve.hpp"
#include "splinecore/curve/nurbs_curve.hpp"
#include "values.hpp"
#include "verbs.hpp"
#include "views.hpp"

namespace bindings {

using splinecore::BezierCurve;
using splinecore::HermiteCurve;
using splinecore::InvalidShape;
using splinecore::KnotVector;
using splinecore::NurbsCurve;

namespace {

/// Control points with weights, as Bezier and NURBS curves have them.
template <class Curve>
void bind_points(Class<Curve>& cls) {
  const auto count = [](const Curve& curve) { return Shape{static_cast<py::ssize_t>(curve.points().size())}; };
  cls.def_property_readonly("points", [count](const py::object& self) {
    const auto& curve = py::cast<const Curve&>(self);
    return view_of_points(curve.points(), count(curve), self);
  });
  cls.def_property_readonly("weights", [count](const py::object& self) {
    const auto& curve = py::cast<const Curve&>(self);
    return view_of_weights(curve.points(), count(curve), self);
  });
  cls.def_property_readonly("homogeneous_points", [count](const Curve& self) {
    return homogeneous_array(self.points(), count(self));
  });
  cls.def("with_points", [](const Curve& self, const py::object& points) {
            const Doubles given = real_array(points, "points");
            std::vector<glm::dvec4> rows = weighted_points(given, py::none(), 1);
            require_net(given, "points", {static_cast<py::ssize_t>(self.points().size())});
            for (std::size_t i = 0; i < rows.size(); ++i) rows[i].w = self.points()[i].w;
            return self.with_points(std::move(rows));
          }, py::arg("points"));
  cls.def("with_weights", [](const Curve& self, const py::object& weights) {
            const std::vector<double> given = numbers(weights, "weights");
            std::vector<glm::dvec4> rows(self.points().begin(), self.points().end());
            if (given.size() != rows.size()) {
              throw InvalidShape("weights has " + std::to_string(given.size()) + " values for " +
                                 std::to_string(rows.size()) + " points");
            }
            for (std::size_t i = 0; i < rows.size(); ++i) rows[i].w = given[i];
            return self.with_points(std::move(rows));
          }, py::arg("weights"));
}

/// Curves of several spans.
template <class Curve>
void bind_to_power(Class<Curve>& cls) {
  cls.def("to_power", [](const Curve& self) { return unlocked([&] { return splinecore::to_power(form(self)); }); });
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

std::string shown(const NurbsCurve& curve) {
  return "NurbsCurve(degree=" + std::to_string(curve.degree()) + ", points=" + std::to_string(curve.points().size()) +
         (curve.rational() ? ", rational" : "") + (curve.periodic() ? ", periodic)" : ")");
}

void bind_nurbs(py::module_& module) {
  Class<NurbsCurve> cls(
      module, "NurbsCurve", py::module_local());
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
                 py::arg("degree"), py::arg("knots"), py::arg("points"), py::arg("periodic") = false);
  bind_points(cls);
  bind_rational_verbs(cls);
  bind_verbs(cls);
  bind_value(cls);
  cls.def_property_readonly("periodic", &NurbsCurve::periodic);
  cls.def_property_readonly("knots", [](const py::object& self) {
    return view_of_numbers(py::cast<const NurbsCurve&>(self).knot_vector().knots(), self);
  });
  cls.def_property_readonly("knot_vector", [](const NurbsCurve& self) { return self.knot_vector(); });
  cls.def("insert_knot", [](const NurbsCurve& self, const py::object& u, const py::object& times) {
            const double at = parameter(u, self.knot_vector());
            const int count = integer(times, "times");
            return unlocked([&] { return splinecore::insert_knot(self, at, count); });
          }, py::arg("u"), py::arg("times") = 1);
  cls.def("refine", [](const NurbsCurve& self, const py::object& knots) {
            const std::vector<double> inserted = numbers(knots, "knots");
            return unlocked([&] { return splinecore::refine(self, inserted); });
          }, py::arg("knots"));
  cls.def("split", [](const NurbsCurve& self, const py::object& u) -> py::tuple {
            const double at = real(u, "u");
            if (self.periodic()) return py::make_tuple(unlocked([&] { return splinecore::opened(self, at); }));
            auto [before, after] = unlocked([&] { return splinecore::split(self, at); });
            return py::make_tuple(std::move(before), std::move(after));
          }, py::arg("u"));
  cls.def("unrolled", [](const NurbsCurve& self) { return splinecore::unrolled(self); });
  cls.def("reversed", [](const NurbsCurve& self) { return splinecore::reversed(self); });
  cls.def("to_nurbs", [](const NurbsCurve& self) { return self; });
  cls.def("bezier_points", [](const NurbsCurve& self) {
            const auto pieces = static_cast<py::ssize_t>(self.knot_vector().spans().size());
            py::array_t<double> points(Shape{pieces, self.degree() + 1, 4});
            auto* rows = reinterpret_cast<glm::dvec4*>(points.mutable_data());
            const std::span out(rows, static_cast<std::size_t>(pieces) * (self.degree() + 1));
            unlocked([&] {
              splinecore::bezier_points(self, out);
              for (glm::dvec4& row : out) {
                for (int axis = 0; self.weight_exponent() != 0 && axis < 4; ++axis) {
                  row[axis] = std::scalbn(row[axis], self.weight_exponent());
                  if (!std::isfinite(row[axis])) throw InvalidShape("points times weights are too large for numbers");
                }
              }
            });
            return points;
          });
  bind_to_power(cls);
  cls.def("__repr__", &shown);
}

py::tuple flattened(const BezierCurve& curve, const py::object& tolerance) {
  const double allowed = real(tolerance, "tolerance");
  const auto line = unlocked([&] { return splinecore::flattened(curve, allowed); });
  const auto count = static_cast<py::ssize_t>(line.points.size());
  py::array_t<double> points({count, py::ssize_t{3}});
  std::copy_n(&line.points.data()->x, 3 * line.points.size(), points.mutable_data());
  return py::make_tuple(new_numbers(std::span(line.parameters)), points);
}

AnyApproximation reduced(const BezierCurve& curve, const py::object& times, const py::object& tolerance) {
  const int steps = integer(times, "times");
  const std::optional<double> most = optional_real(tolerance, "tolerance");
  return wrap(unlocked(
      [&] { return most ? splinecore::reduced(curve, steps, *most) : splinecore::reduced(curve, steps); }));
}

void bind_degrees(Class<BezierCurve>& cls) {
  cls.def("elevate", [](const BezierCurve& self, const py::object& times) {
            const int count = integer(times, "times");
            return unlocked([&] { return splinecore::elevated(self, count); });
          }, py::arg("times") = 1);
  cls.def("reduce", &reduced, py::arg("times") = 1, py::arg("tolerance") = py::none());
  cls.def("flatten", &flattened, py::arg("tolerance"));
}

void bind_bezier(py::module_& module) {
  Class<BezierCurve> cls(
      module, "BezierCurve", py::module_local());
  cls.def(py::init([](const py::object& points, const py::object& weights) {
            return BezierCurve::make(weighted_points(real_array(points, "points"), weights, 1));
          }), py::arg("points"), py::arg("weights") = py::none());
  cls.def_static("from_homogeneous", [](const py::object& points) {
    const auto rows = rows_of_four(real_array(points, "points"), "points", 1);
    splinecore::require_points(rows);
    return BezierCurve::from_homogeneous(rows);
  }, py::arg("points"));
  bind_points(cls);
  bind_rational_verbs(cls);
  bind_value(cls);
  cls.def("split", [](const BezierCurve& self, const py::object& u) {
            const double at = real(u, "u");
            return unlocked([&] { return splinecore::split(self, at); });
          },
          py::arg("u"));
  bind_degrees(cls);
  cls.def("reversed", [](const BezierCurve& self) { return splinecore::reversed(self); });
  cls.def("to_nurbs", [](const BezierCurve& self) { return self.nurbs(); });
  cls.def("to_power", [](const BezierCurve& self, const py::object& origin) {
            return splinecore::to_power(self, real(origin, "origin"));
          }, py::arg("origin") = 0.0);
  cls.def("__repr__", [](const BezierCurve& self) {
    return "BezierCurve(degree=" + std::to_string(self.degree()) + (self.nurbs().rational() ? ", rational)" : ")");
  });
}

void bind_hermite(py::module_& module) {
  Class<HermiteCurve> cls(
      module, "HermiteCurve", py::module_local());
  cls.def(py::init([](const py::object& points, const py::object& tangents, const py::object& parameters) {
            return HermiteCurve::make(vectors(real_array(points, "points"), "points", 1), tangents_of(tangents),
                                      optional_numbers(parameters, "parameters"));
          }), py::arg("points"), py::arg("tangents"), py::arg("parameters") = py::none());
  bind_value(cls);
  cls.def_property_readonly("points", [](const py::object& self) {
    const auto points = py::cast<const HermiteCurve&>(self).points();
    return view_of_vectors(points, {static_cast<py::ssize_t>(points.size())}, self);
  });
  cls.def_property_readonly("tangents", [](const py::object& self) {
    const auto tangents = py::cast<const HermiteCurve&>(self).tangents();
    const auto* rows = reinterpret_cast<const glm::dvec3*>(tangents.data());
    return view_of_vectors({rows, 2 * tangents.size()}, {static_cast<py::ssize_t>(tangents.size()), 2}, self);
  });
  cls.def_property_readonly("parameters", [](const py::object& self) {
    return view_of_numbers(py::cast<const HermiteCurve&>(self).parameters(), self);
  });
  cls.def("split", [](const HermiteCurve& self, const py::object& u) { return splinecore::split(self, real(u, "u")); },
          py::arg("u"));
  cls.def("reversed", [](const HermiteCurve& self) { return splinecore::reversed(self); });
  cls.def("to_nurbs", [](const HermiteCurve& self) { return self.nurbs(); });
  bind_to_power(cls);
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
