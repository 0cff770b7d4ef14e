#include "approximation.hpp"
#include "arrays.hpp"
#include "classes.hpp"
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
      conics, "ImplicitConic", py::module_local(),
      "ImplicitConic(coefficients, origin=(0, 0, 0), x_axis=(1, 0, 0), y_axis=(0, 1, 0))\n\n"
      "a x² + b xy + c y² + d x + e y + f = 0, coefficients (6,) = a … f, in the coordinates of a plane with\n"
      "orthonormal axes. Multiplying the coefficients changes nothing else. Lecture row S1.");
  seal(cls);
  cls.def(py::init(&make_conic), py::arg("coefficients"), py::arg("origin") = py::make_tuple(0.0, 0.0, 0.0),
          py::arg("x_axis") = py::make_tuple(1.0, 0.0, 0.0), py::arg("y_axis") = py::make_tuple(0.0, 1.0, 0.0));
  cls.def_property_readonly("coefficients", [](const py::object& self) {
    return view_of_numbers(std::span<const double>(py::cast<const ImplicitConic&>(self).coefficients()), self);
  }, "(6,) float64, as given, read-only.");
  cls.def_property_readonly("origin", [](const ImplicitConic& self) { return array_of(self.plane().origin); }, "(3,)");
  cls.def_property_readonly("x_axis", [](const ImplicitConic& self) { return array_of(self.plane().x_axis); }, "(3,)");
  cls.def_property_readonly("y_axis", [](const ImplicitConic& self) { return array_of(self.plane().y_axis); }, "(3,)");
  cls.def_property_readonly("type", [](const ImplicitConic& self) { return name_of(self.type()); },
                            "'circle', 'ellipse', 'parabola', 'hyperbola', 'crossing_lines', 'parallel_lines', 'line',\n"
                            "'point' or 'empty'.");
  cls.def_property_readonly("center", [](const ImplicitConic& self) -> py::object {
    const auto point = splinecore::center(self);
    return point ? py::object(array_of(*point)) : py::object(py::none());
  }, "(3,): the center, a parabola's vertex, a point of a line; None where the conic is empty.");
  cls.def_property_readonly("half_lengths", [](const ImplicitConic& self) {
    return py::make_tuple(self.shape().first, self.shape().second);
  }, "(along, across) of the axes; (focal length, 0) of a parabola; (0, half the distance) of parallel lines.");
  cls.def_property_readonly("axes", [](const ImplicitConic& self) {
    const auto axes = splinecore::axis_directions(self);
    return py::make_tuple(array_of(axes[0]), array_of(axes[1]));
  }, "Unit vectors: along the major or transverse axis, or to a parabola's focus, or along a line; and across.");
  cls.def_property_readonly("foci", [](const ImplicitConic& self) {
    py::list points;
    for (const auto& point : splinecore::foci(self)) points.append(array_of(point));
    return points;
  }, "[(3,), …]: two, one of a circle or a parabola, none where the conic is degenerate.");
  cls.def_property_readonly("eccentricity", [](const ImplicitConic& self) { return splinecore::eccentricity(self); },
                            "0 of a circle, 1 of a parabola; None where the conic is degenerate.");
  cls.def("arc", [](const ImplicitConic& self, const py::object& start, const py::object& end) {
            return splinecore::arc_between(self, real(start, "start"), real(end, "end"));
          }, py::arg("start"), py::arg("end"),
          "The part between two parameters, a NurbsCurve: angles from the axis; of a parabola distances from its\n"
          "axis; of a hyperbola t of (along cosh t, across sinh t).");
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
             }, py::arg("start"), py::arg("through"), py::arg("end"),
             "The arc of a circle from a point (3,) through another one to a third one, a NurbsCurve. InvalidShape if two\n"
             "are one or all are on a line. Lecture row S10.");
  conics.def("arc_from_tangent", [](const py::object& start, const py::object& tangent, const py::object& end) {
               return splinecore::arc_from_tangent(vector_of(start, "start"), vector_of(tangent, "tangent"), vector_of(end, "end"));
             }, py::arg("start"), py::arg("tangent"), py::arg("end"),
             "The arc of a circle from a point (3,) in a direction (3,) to another point (3,), a NurbsCurve. InvalidShape if\n"
             "the points are one, or the direction is zero or along the line of both. Lecture row S10.");
  conics.def("arc_about", [](const py::object& center, const py::object& start, const py::object& end, const py::object& normal) {
               return splinecore::arc_about(vector_of(center, "center"), vector_of(start, "start"), vector_of(end, "end"),
                                            vector_of(normal, "normal"));
             }, py::arg("center"), py::arg("start"), py::arg("end"), py::arg("normal") = up,
             "The arc about a center (3,) from a point (3,), counterclockwise seen against the normal (3,), to the direction of\n"
             "another one (3,), a NurbsCurve; a whole circle where that is the same. InvalidShape if a point is the center, or\n"
             "the normal is zero or along the radius. Lecture row S10.");
  conics.def("circle", [](const py::object& center, const py::object& radius, const py::object& normal, const py::object& form) {
               return splinecore::circle(vector_of(center, "center"), real(radius, "radius"), vector_of(normal, "normal"),
                                         form_of(form));
             }, py::arg("center"), py::arg("radius"), py::arg("normal") = up, py::arg("form") = "square",
             "The whole circle as a NurbsCurve: four quarters on a 'square', three thirds on a 'triangle', two 'halves'\n"
             "with directions in the middle, or a 'single' span of degree 5 (Chou 1995). Lecture row S10.");
  conics.def("ellipse", [](const py::object& center, const py::object& axis_a, const py::object& axis_b, const py::object& form) {
               return splinecore::ellipse(vector_of(center, "center"), vector_of(axis_a, "axis_a"),
                                          vector_of(axis_b, "axis_b"), form_of(form));
             }, py::arg("center"), py::arg("axis_a"), py::arg("axis_b"), py::arg("form") = "square",
             "The ellipse center + cos a axis_a + sin a axis_b as a NurbsCurve, in the forms of circle(). Any two\n"
             "conjugate half axes. Lecture row S10.");
  conics.def("hyperbola", [](const py::object& center, const py::object& axis_a, const py::object& axis_b) {
               return splinecore::hyperbola(vector_of(center, "center"), vector_of(axis_a, "axis_a"),
                                            vector_of(axis_b, "axis_b"));
             }, py::arg("center"), py::arg("axis_a"), py::arg("axis_b"),
             "[NurbsCurve, NurbsCurve]: both branches of center +- cosh t axis_a + sinh t axis_b, each from one asymptote's\n"
             "direction to the other's with its vertex between. Any two conjugate half axes. Lecture row S10.");
  conics.def("arc", [](const py::object& center, const py::object& axis_a, const py::object& axis_b, const py::object& start,
                       const py::object& sweep, const py::object& spans) {
               return splinecore::ellipse_arc(vector_of(center, "center"), vector_of(axis_a, "axis_a"),
                                              vector_of(axis_b, "axis_b"), real(start, "start"), real(sweep, "sweep"),
                                              integer(spans, "span_count"));
             }, py::arg("center"), py::arg("axis_a"), py::arg("axis_b"), py::arg("start"), py::arg("sweep"),
             py::arg("span_count") = 0,
             "A part of an ellipse, angles in radians, in span_count spans; 0 for as few as keep each within a\n"
             "quarter turn. A span of half a turn has a direction in its middle, a longer one a negative weight.");
  conics.def("by_foci", [](const py::object& focus_1, const py::object& focus_2, const py::object& distance,
                           const py::object& normal) {
               return splinecore::conic_by_foci(vector_of(focus_1, "focus_1"), vector_of(focus_2, "focus_2"),
                                                real(distance, "distance"), vector_of(normal, "normal"));
             }, py::arg("focus_1"), py::arg("focus_2"), py::arg("distance"), py::arg("normal") = up,
             "The ImplicitConic with two foci: the ellipse with that sum of distances where it is more than the foci's\n"
             "own, otherwise the hyperbola with that difference. Lecture row S10.");
  conics.def("parabola", [](const py::object& focus, const py::object& directrix_point, const py::object& directrix_direction) {
               return splinecore::parabola(vector_of(focus, "focus"), vector_of(directrix_point, "directrix_point"),
                                           vector_of(directrix_direction, "directrix_direction"));
             }, py::arg("focus"), py::arg("directrix_point"), py::arg("directrix_direction"),
             "The ImplicitConic of the points as far from the focus as from a line.\n\n"
             "InvalidShape if the focus lies on the line. Lecture row S10.");
  conics.def("through_points", &through_points, py::arg("points"), py::arg("tolerance") = py::none(),
             "The ImplicitConic through points (5, 2 or 3) of a plane. InvalidShape if two coincide, four lie on a\n"
             "line or one lies off the plane by more than tolerance (None: 1e-9 of their extent). Lecture row S10.");
}

void bind_forms(py::module_& conics) {
  conics.def("conic_arc", [](const py::object& p0, const py::object& p1, const py::object& p2, const py::object& w1) {
               return splinecore::conic_arc(vector_of(p0, "p0"), vector_of(p1, "p1"), vector_of(p2, "p2"), real(w1, "w1"));
             }, py::arg("p0"), py::arg("p1"), py::arg("p2"), py::arg("w1"),
             "The BezierCurve of three points with weights 1, w1, 1. With w1 = 0 it is the segment from p0 to p2.\n"
             "Lecture row S10.");
  conics.def("class_of", [](const py::object& curve) { return name_of(splinecore::conic_class(single_arc(curve))); },
             py::arg("curve"),
             "What a rational quadratic curve of one span is: 'shorter_ellipse_arc', 'half_ellipse',\n"
             "'longer_ellipse_arc', 'parabola_arc', 'two_parabola_arcs', 'hyperbola_arc', 'two_hyperbola_arcs',\n"
             "'three_hyperbola_arcs', 'segment', 'line_through_infinity' or 'point'. Lecture row S10.");
  conics.def("implicit", [](const py::object& curve) { return splinecore::implicit_conic(single_arc(curve)); },
             py::arg("curve"),
             "The ImplicitConic on which a rational quadratic curve of one span lies: in the xy plane where every z is\n"
             "0, otherwise in its own. InvalidShape if its points lie on one line. Lecture row S1.");
  conics.def("from_implicit", [](const py::object& conic) { return splinecore::curves_of(conic_of(conic)); },
             py::arg("conic"),
             "[NurbsCurve, …] that cover the real points of a conic, each once. Curves that are not closed begin and\n"
             "end at infinity: finite_arcs() clips them. Nothing for a point or an empty conic. Lecture row S1.");
  conics.def("as_hermite", &as_hermite, py::arg("curve"), py::arg("tolerance"),
             "Approximation(HermiteCurve, error) of a finite curve of degree 2: cubics that leave it nowhere by more\n"
             "than the error, a length. ToleranceNotReached where only rounding is left. Lecture row S10.");
}

}  // namespace

void bind_conics(py::module_& module) {
  py::module_ conics = module.def_submodule("conics", "Conics: rational quadratic curves and their equations.");
  bind_implicit_conic(conics);
  bind_makers(conics);
  bind_forms(conics);
}

}  // namespace bindings
