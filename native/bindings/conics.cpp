#include "approximation.hpp"
#include "arrays.hpp"
#include "classes.hpp"
#include "every_kind.hpp"
#include "long_calls.hpp"
#include "rooms.hpp"
#include "splinecore/conic/arcs.hpp"
#include "splinecore/conic/conic_arc.hpp"
#include "splinecore/conic/ellipse.hpp"
#include "splinecore/conic/hermite_conic.hpp"
#include "splinecore/conic/implicit_form.hpp"
#include "splinecore/conic/make_conic.hpp"
#include "splinecore/convert/to_bezier.hpp"
#include "values.hpp"
#include "views.hpp"

namespace bindings {

using splinecore::BezierCurve;
using splinecore::ConicArcClass;
using splinecore::ConicType;
using splinecore::EllipseForm;
using splinecore::ImplicitConic;
using splinecore::InvalidShape;
using splinecore::NurbsCurve;

namespace {

py::array array_of(const glm::dvec3& v) {
  return new_numbers(std::span(&v.x, 3));
}

EllipseForm form_of(const py::object& value) {
  if (py::isinstance<py::str>(value)) {
    const std::string text = py::str(value);
    if (text == "square") return EllipseForm::square;
    if (text == "triangle") return EllipseForm::triangle;
    if (text == "halves") return EllipseForm::halves;
    if (text == "single") return EllipseForm::single;
  }
  throw InvalidShape("form = " + std::string(py::repr(value)) + " is none of 'square', 'triangle', 'halves', 'single'");
}

const char* name_of(ConicArcClass kind) {
  switch (kind) {
    case ConicArcClass::shorter_ellipse_arc: return "shorter_ellipse_arc";
    case ConicArcClass::half_ellipse: return "half_ellipse";
    case ConicArcClass::longer_ellipse_arc: return "longer_ellipse_arc";
    case ConicArcClass::parabola_arc: return "parabola_arc";
    case ConicArcClass::two_parabola_arcs: return "two_parabola_arcs";
    case ConicArcClass::hyperbola_arc: return "hyperbola_arc";
    case ConicArcClass::two_hyperbola_arcs: return "two_hyperbola_arcs";
    case ConicArcClass::three_hyperbola_arcs: return "three_hyperbola_arcs";
    case ConicArcClass::segment: return "segment";
    case ConicArcClass::line_through_infinity: return "line_through_infinity";
    case ConicArcClass::point: break;
  }
  return "point";
}

const char* name_of(ConicType type) {
  switch (type) {
    case ConicType::circle: return "circle";
    case ConicType::ellipse: return "ellipse";
    case ConicType::parabola: return "parabola";
    case ConicType::hyperbola: return "hyperbola";
    case ConicType::crossing_lines: return "crossing_lines";
    case ConicType::parallel_lines: return "parallel_lines";
    case ConicType::line: return "line";
    case ConicType::point: return "point";
    case ConicType::empty: break;
  }
  return "empty";
}

/// The one arc of a curve of degree 2, whichever kind it is.
BezierCurve single_arc(const py::object& curve) {
  if (py::isinstance<BezierCurve>(curve)) return py::cast<const BezierCurve&>(curve);
  if (!py::isinstance<NurbsCurve>(curve)) {
    throw py::type_error("curve must be a BezierCurve or a NurbsCurve, not " + type_name(curve));
  }
  const auto& nurbs = py::cast<const NurbsCurve&>(curve);
  const auto spans = nurbs.knot_vector().spans().size();
  if (spans == 1) return splinecore::to_bezier(nurbs).front();
  throw InvalidShape("curve has " + std::to_string(spans) + " spans: take one of to_bezier()");
}

AnyApproximation as_hermite(const py::object& curve, const py::object& tolerance) {
  const double most = real(tolerance, "tolerance");
  if (py::isinstance<BezierCurve>(curve)) {
    const NurbsCurve& form = py::cast<const BezierCurve&>(curve).nurbs();
    return wrap(unlocked([&] { return splinecore::conic_as_hermite(form, most); }));
  }
  if (!py::isinstance<NurbsCurve>(curve)) {
    throw py::type_error("curve must be a BezierCurve or a NurbsCurve, not " + type_name(curve));
  }
  const auto& nurbs = py::cast<const NurbsCurve&>(curve);
  return wrap(unlocked([&] { return splinecore::conic_as_hermite(nurbs, most); }));
}

ImplicitConic through_points(const py::object& points, const py::object& tolerance) {
  const std::vector<glm::dvec3> given = vectors(real_array(points, "points"), "points", 1);
  if (tolerance.is_none()) return splinecore::conic_through(given);
  return splinecore::conic_through(given, real(tolerance, "tolerance"));
}

const ImplicitConic& conic_of(const py::object& value) {
  if (py::isinstance<ImplicitConic>(value)) return py::cast<const ImplicitConic&>(value);
  throw py::type_error("conic must be an ImplicitConic, not " + type_name(value));
}

ImplicitConic make_conic(const py::object& coefficients, const py::object& origin, const py::object& x_axis,
                         const py::object& y_axis) {
  const std::vector<double> given = numbers(coefficients, "coefficients");
  if (given.size() != 6) {
    throw InvalidShape("coefficients has " + std::to_string(given.size()) + " values, a conic has 6");
  }
  std::array<double, 6> six;
  std::ranges::copy(given, six.begin());
  return ImplicitConic::make(six, splinecore::plane_along(vector_of(origin, "origin"), vector_of(x_axis, "x_axis"),
                                                          vector_of(y_axis, "y_axis")));
}

/// What makes a conic again: its four arguments.
py::tuple state_of(const ImplicitConic& conic) {
  const auto tuple = [](const glm::dvec3& v) { return py::make_tuple(v.x, v.y, v.z); };
  const auto& plane = conic.plane();
  return py::make_tuple(py::tuple(py::cast(conic.coefficients())), tuple(plane.origin), tuple(plane.x_axis),
                        tuple(plane.y_axis));
}

void bind_implicit_conic(py::module_& conics) {
  Class<ImplicitConic> cls(
      conics, "ImplicitConic", py::module_local());
  seal(cls);
  cls.def(py::init(&make_conic), py::arg("coefficients"), py::arg("origin") = py::make_tuple(0.0, 0.0, 0.0),
          py::arg("x_axis") = py::make_tuple(1.0, 0.0, 0.0), py::arg("y_axis") = py::make_tuple(0.0, 1.0, 0.0));
  cls.def_property_readonly("coefficients", [](const py::object& self) {
    return view_of_numbers(std::span<const double>(py::cast<const ImplicitConic&>(self).coefficients()), self);
  });
  cls.def_property_readonly("origin", [](const ImplicitConic& self) { return array_of(self.plane().origin); }, "(3,)");
  cls.def_property_readonly("x_axis", [](const ImplicitConic& self) { return array_of(self.plane().x_axis); }, "(3,)");
  cls.def_property_readonly("y_axis", [](const ImplicitConic& self) { return array_of(self.plane().y_axis); }, "(3,)");
  cls.def_property_readonly("type", [](const ImplicitConic& self) { return name_of(self.type()); });
  cls.def_property_readonly("center", [](const ImplicitConic& self) -> py::object {
    const auto point = splinecore::center(self);
    return point ? py::object(array_of(*point)) : py::object(py::none());
  });
  cls.def_property_readonly("half_lengths", [](const ImplicitConic& self) {
    return py::make_tuple(self.shape().first, self.shape().second);
  });
  cls.def_property_readonly("axes", [](const ImplicitConic& self) {
    const auto axes = splinecore::axis_directions(self);
    return py::make_tuple(array_of(axes[0]), array_of(axes[1]));
  });
  cls.def_property_readonly("foci", [](const ImplicitConic& self) {
    py::list points;
    for (const auto& point : splinecore::foci(self)) points.append(array_of(point));
    return points;
  });
  cls.def_property_readonly("eccentricity", [](const ImplicitConic& self) { return splinecore::eccentricity(self); });
  cls.def("arc", [](const ImplicitConic& self, const py::object& start, const py::object& end) {
            return splinecore::arc_between(self, real(start, "start"), real(end, "end"));
          }, py::arg("start"), py::arg("end"));
  cls.def("__eq__", [](const ImplicitConic& self, const ImplicitConic& other) { return self == other; }, py::is_operator());
  cls.def("__hash__", [](const ImplicitConic& self) { return py::hash(state_of(self)); });
  cls.def(py::pickle([](const ImplicitConic& self) -> py::object { return state_of(self); },
                     [](const py::object& state) {
    const py::tuple parts = state_of_size(state, 4);
    return make_conic(parts[0], parts[1], parts[2], parts[3]);
  }));
  cls.def("__repr__", [](const ImplicitConic& self) { return "ImplicitConic(" + std::string(name_of(self.type())) + ")"; });
}

void bind_makers(py::module_& conics) {
  const auto up = py::make_tuple(0.0, 0.0, 1.0);
  conics.def("arc_through", [](const py::object& start, const py::object& through, const py::object& end) {
               return splinecore::arc_through(vector_of(start, "start"), vector_of(through, "through"), vector_of(end, "end"));
             }, py::arg("start"), py::arg("through"), py::arg("end"));
  conics.def("arc_from_tangent", [](const py::object& start, const py::object& tangent, const py::object& end) {
               return splinecore::arc_from_tangent(vector_of(start, "start"), vector_of(tangent, "tangent"), vector_of(end, "end"));
             }, py::arg("start"), py::arg("tangent"), py::arg("end"));
  conics.def("arc_about", [](const py::object& center, const py::object& start, const py::object& end, const py::object& normal) {
               return splinecore::arc_about(vector_of(center, "center"), vector_of(start, "start"), vector_of(end, "end"),
                                            vector_of(normal, "normal"));
             }, py::arg("center"), py::arg("start"), py::arg("end"), py::arg("normal") = up);
  conics.def("circle", [](const py::object& center, const py::object& radius, const py::object& normal, const py::object& form) {
               return splinecore::circle(vector_of(center, "center"), real(radius, "radius"), vector_of(normal, "normal"),
                                         form_of(form));
             }, py::arg("center"), py::arg("radius"), py::arg("normal") = up, py::arg("form") = "square");
  conics.def("ellipse", [](const py::object& center, const py::object& axis_a, const py::object& axis_b, const py::object& form) {
               return splinecore::ellipse(vector_of(center, "center"), vector_of(axis_a, "axis_a"),
                                          vector_of(axis_b, "axis_b"), form_of(form));
             }, py::arg("center"), py::arg("axis_a"), py::arg("axis_b"), py::arg("form") = "square");
  conics.def("hyperbola", [](const py::object& center, const py::object& axis_a, const py::object& axis_b) {
               return splinecore::hyperbola(vector_of(center, "center"), vector_of(axis_a, "axis_a"),
                                            vector_of(axis_b, "axis_b"));
             }, py::arg("center"), py::arg("axis_a"), py::arg("axis_b"));
  conics.def("arc", [](const py::object& center, const py::object& axis_a, const py::object& axis_b, const py::object& start,
                       const py::object& sweep, const py::object& spans) {
               return splinecore::ellipse_arc(vector_of(center, "center"), vector_of(axis_a, "axis_a"),
                                              vector_of(axis_b, "axis_b"), real(start, "start"), real(sweep, "sweep"),
                                              integer(spans, "span_count"));
             }, py::arg("center"), py::arg("axis_a"), py::arg("axis_b"), py::arg("start"), py::arg("sweep"),
             py::arg("span_count") = 0);
  conics.def("by_foci", [](const py::object& focus_1, const py::object& focus_2, const py::object& distance,
                           const py::object& normal) {
               return splinecore::conic_by_foci(vector_of(focus_1, "focus_1"), vector_of(focus_2, "focus_2"),
                                                real(distance, "distance"), vector_of(normal, "normal"));
             }, py::arg("focus_1"), py::arg("focus_2"), py::arg("distance"), py::arg("normal") = up);
  conics.def("parabola", [](const py::object& focus, const py::object& directrix_point, const py::object& directrix_direction) {
               return splinecore::parabola(vector_of(focus, "focus"), vector_of(directrix_point, "directrix_point"),
                                           vector_of(directrix_direction, "directrix_direction"));
             }, py::arg("focus"), py::arg("directrix_point"), py::arg("directrix_direction"));
  conics.def("through_points", &through_points, py::arg("points"), py::arg("tolerance") = py::none());
}

void bind_forms(py::module_& conics) {
  conics.def("conic_arc", [](const py::object& p0, const py::object& p1, const py::object& p2, const py::object& w1) {
               return splinecore::conic_arc(vector_of(p0, "p0"), vector_of(p1, "p1"), vector_of(p2, "p2"), real(w1, "w1"));
             }, py::arg("p0"), py::arg("p1"), py::arg("p2"), py::arg("w1"));
  conics.def("class_of", [](const py::object& curve) { return name_of(splinecore::conic_class(single_arc(curve))); },
             py::arg("curve"));
  conics.def("implicit", [](const py::object& curve) {
               const NurbsCurve& form = any_curve(curve, "curve");
               return unlocked([&] { return splinecore::implicit_conic(form); });
             }, py::arg("curve"));
  conics.def("from_implicit", [](const py::object& conic) { return splinecore::curves_of(conic_of(conic)); },
             py::arg("conic"));
  conics.def("as_hermite", &as_hermite, py::arg("curve"), py::arg("tolerance"));
}

}  // namespace

void bind_conics(py::module_& module) {
  py::module_ conics = module.def_submodule("conics", "Conics: rational quadratic curves and their equations.");
  bind_implicit_conic(conics);
  bind_makers(conics);
  bind_forms(conics);
}

}  // namespace bindings
