#include "arguments.hpp"
#include "arrays.hpp"
#include "classes.hpp"
#include "every_kind.hpp"
#include "long_calls.hpp"
#include "patch_verbs.hpp"
#include "rooms.hpp"
#include "splinecore/base/points.hpp"
#include "splinecore/patch/bezier_patch.hpp"
#include "splinecore/patch/hermite_patch.hpp"
#include "splinecore/patch/nurbs_patch.hpp"
#include "values.hpp"
#include "views.hpp"

namespace bindings {

using splinecore::Axis;
using splinecore::BezierPatch;
using splinecore::HermitePatch;
using splinecore::InvalidShape;
using splinecore::KnotVector;
using splinecore::NurbsPatch;

namespace {

Shape net_shape(const NurbsPatch& patch) { return {patch.count(Axis::u), patch.count(Axis::v)}; }

/// Parts and other parameterizations of any kind of patch, which are of that kind.
template <class Patch>
void bind_parts(Class<Patch>& cls) {
  cls.def("split", [](const Patch& self, const py::object& axis, const py::object& u) -> py::tuple {
            const Axis direction = axis_of(axis);
            const double at = real(u, "u");
            if constexpr (std::is_same_v<Patch, NurbsPatch>) {
              if (self.knot_vector(direction).periodic()) {
                return py::make_tuple(unlocked([&] { return splinecore::opened(self, direction, at); }));
              }
            }
            auto [before, after] = unlocked([&] { return splinecore::split(self, direction, at); });
            return py::make_tuple(std::move(before), std::move(after));
          }, py::arg("axis"), py::arg("u"));
  cls.def("reversed", [](const Patch& self, const py::object& axis) { return splinecore::reversed(self, axis_of(axis)); },
          py::arg("axis"));
  cls.def("swapped", [](const Patch& self) { return splinecore::swapped(self); });
}

template <class Patch>
void bind_points(Class<Patch>& cls) {
  cls.def_property_readonly("points", [](const py::object& self) {
    const auto& patch = patch_form(py::cast<const Patch&>(self));
    return view_of_points(patch.points(), net_shape(patch), self);
  });
  cls.def_property_readonly("weights", [](const py::object& self) {
    const auto& patch = patch_form(py::cast<const Patch&>(self));
    return view_of_weights(patch.points(), net_shape(patch), self);
  });
  cls.def_property_readonly("homogeneous_points", [](const Patch& self) {
    return homogeneous_array(patch_form(self).points(), net_shape(patch_form(self)));
  });
}

/// Other points with the weights of the patch.
std::vector<glm::dvec4> with_new_points(const NurbsPatch& patch, const py::object& points) {
  const Doubles given = real_array(points, "points");
  std::vector<glm::dvec4> rows = weighted_points(given, py::none(), 2);
  require_net(given, "points", net_shape(patch));
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i].w = patch.points()[i].w;
  return rows;
}

std::vector<glm::dvec4> with_new_weights(std::span<const glm::dvec4> points, const py::object& weights, const Shape& shape) {
  const Doubles given = real_array(weights, "weights");
  if (!std::equal(shape.begin(), shape.end(), given.shape(), given.shape() + given.ndim())) {
    throw InvalidShape("weights has shape " + shape_text(given) + ", (" + std::to_string(shape[0]) + ", " +
                       std::to_string(shape[1]) + ") is expected");
  }
  std::vector<glm::dvec4> rows(points.begin(), points.end());
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i].w = given.data()[i];
  return rows;
}

KnotVector knots_of(const py::object& degree, const py::object& knots, const py::object& periodic, Axis axis) {
  const auto part = [&](const py::object& value, const char* name) {
    const auto pair = pair_argument(value, name);
    return axis == Axis::u ? pair.first : pair.second;
  };
  const std::string direction = axis == Axis::u ? "in u: " : "in v: ";
  const int number = integer(part(degree, "degree"), "degree");
  std::vector<double> values = numbers(part(knots, "knots"), "knots");
  const bool closed = boolean(part(periodic, "periodic"), "periodic");
  try {
    return KnotVector::make(number, std::move(values), closed);
  } catch (const InvalidShape& error) {
    throw InvalidShape(direction + error.what());
  }
}

/// @throws InvalidShape unless the net has as many rows and columns as the knots want.
void require_counts(const Doubles& net, const KnotVector& u, const KnotVector& v) {
  if (net.shape(0) == u.count() && net.shape(1) == v.count()) return;
  throw InvalidShape("points has shape " + shape_text(net) + ", but the knots belong to " + std::to_string(u.count()) +
                     " x " + std::to_string(v.count()) + " points");
}

void bind_nurbs(py::module_& module) {
  Class<NurbsPatch> cls(
      module, "NurbsPatch", py::module_local());
  cls.def(py::init([](const py::object& degree, const py::object& knots, const py::object& points,
                      const py::object& weights, const py::object& periodic) {
            const Doubles net = real_array(points, "points");
            auto rows = weighted_points(net, weights, 2);
            KnotVector u = knots_of(degree, knots, periodic, Axis::u);
            KnotVector v = knots_of(degree, knots, periodic, Axis::v);
            require_counts(net, u, v);
            return NurbsPatch::make(std::move(u), std::move(v), std::move(rows));
          }),
          py::arg("degree"), py::arg("knots"), py::arg("points"), py::arg("weights") = py::none(),
          py::arg("periodic") = py::make_tuple(false, false));
  cls.def_static("from_homogeneous", [](const py::object& degree, const py::object& knots, const py::object& points,
                                        const py::object& periodic) {
                   const Doubles net = real_array(points, "points");
                   const auto rows = rows_of_four(net, "points", 2);
                   KnotVector u = knots_of(degree, knots, periodic, Axis::u);
                   KnotVector v = knots_of(degree, knots, periodic, Axis::v);
                   require_counts(net, u, v);
                   splinecore::require_points(rows, net.shape(1));
                   return NurbsPatch::from_homogeneous(std::move(u), std::move(v), rows);
                 },
                 py::arg("degree"), py::arg("knots"), py::arg("points"), py::arg("periodic") = py::make_tuple(false, false));
  bind_parts(cls);
  bind_points(cls);
  bind_value(cls);
  cls.def_property_readonly("periodic", [](const NurbsPatch& self) {
    return py::make_tuple(self.knot_vector(Axis::u).periodic(), self.knot_vector(Axis::v).periodic());
  });
  cls.def_property_readonly("knots", [](const py::object& self) {
    const auto& patch = py::cast<const NurbsPatch&>(self);
    return py::make_tuple(view_of_numbers(patch.knot_vector(Axis::u).knots(), self),
                          view_of_numbers(patch.knot_vector(Axis::v).knots(), self));
  });
  cls.def_property_readonly("knot_vectors", [](const NurbsPatch& self) {
    return py::make_tuple(self.knot_vector(Axis::u), self.knot_vector(Axis::v));
  });
  cls.def("with_points", [](const NurbsPatch& self, const py::object& points) {
    return self.with_points(with_new_points(self, points));
  }, py::arg("points"));
  cls.def("with_weights", [](const NurbsPatch& self, const py::object& weights) {
    return self.with_points(with_new_weights(self.points(), weights, net_shape(self)));
  }, py::arg("weights"));
  cls.def("insert_knot", [](const NurbsPatch& self, const py::object& axis, const py::object& u, const py::object& times) {
            const Axis direction = axis_of(axis);
            const double at = parameter(u, self.knot_vector(direction));
            const int count = integer(times, "times");
            return unlocked([&] { return splinecore::insert_knot(self, direction, at, count); });
          }, py::arg("axis"), py::arg("u"), py::arg("times") = 1);
  cls.def("refine", [](const NurbsPatch& self, const py::object& axis, const py::object& knots) {
            const Axis direction = axis_of(axis);
            const std::vector<double> inserted = numbers(knots, "knots");
            return unlocked([&] { return splinecore::refine(self, direction, inserted); });
          }, py::arg("axis"), py::arg("knots"));
  bind_patch_verbs(cls);
  cls.def("unrolled", [](const NurbsPatch& self) { return splinecore::unrolled(self); });
  cls.def("to_nurbs", [](const NurbsPatch& self) { return self; });
  cls.def("__repr__", [](const NurbsPatch& self) {
    return "NurbsPatch(degree=(" + std::to_string(self.knot_vector(Axis::u).degree()) + ", " +
           std::to_string(self.knot_vector(Axis::v).degree()) + "), points=(" + std::to_string(self.count(Axis::u)) +
           ", " + std::to_string(self.count(Axis::v)) + (self.rational() ? "), rational)" : "))");
  });
}

void bind_bezier(py::module_& module) {
  Class<BezierPatch> cls(
      module, "BezierPatch", py::module_local());
  cls.def(py::init([](const py::object& points, const py::object& weights) {
            const Doubles net = real_array(points, "points");
            auto rows = weighted_points(net, weights, 2);
            const auto limited = [](py::ssize_t n) { return static_cast<int>(std::min<py::ssize_t>(n, 1 << 30)); };
            return BezierPatch::make(limited(net.shape(0)), limited(net.shape(1)), std::move(rows));
          }), py::arg("points"), py::arg("weights") = py::none());
  bind_parts(cls);
  bind_points(cls);
  bind_value(cls);
  cls.def("with_points", [](const BezierPatch& self, const py::object& points) {
    return BezierPatch::make(self.count(Axis::u), self.count(Axis::v), with_new_points(self.nurbs(), points));
  }, py::arg("points"));
  cls.def("with_weights", [](const BezierPatch& self, const py::object& weights) {
    return BezierPatch::make(self.count(Axis::u), self.count(Axis::v),
                             with_new_weights(self.points(), weights, net_shape(self.nurbs())));
  }, py::arg("weights"));
  bind_patch_verbs(cls);
  cls.def("to_nurbs", [](const BezierPatch& self) { return self.nurbs(); });
  cls.def("__repr__", [](const BezierPatch& self) {
    return "BezierPatch(degree=(" + std::to_string(self.degree(Axis::u)) + ", " + std::to_string(self.degree(Axis::v)) +
           (self.nurbs().rational() ? "), rational)" : "))");
  });
}

/// Vectors that belong to the points of a net, one each.
std::vector<glm::dvec3> vectors_of_net(const py::object& value, const char* name, const Doubles& net) {
  const Doubles array = real_array(value, name);
  std::vector<glm::dvec3> rows = vectors(array, name, 2);
  require_net(array, name, {net.shape(0), net.shape(1)});
  return rows;
}

void bind_hermite(py::module_& module) {
  Class<HermitePatch> cls(
      module, "HermitePatch", py::module_local());
  cls.def(py::init([](const py::object& points, const py::object& tangents_u, const py::object& tangents_v,
                      const py::object& twists, const py::object& parameters) {
            const Doubles net = real_array(points, "points");
            splinecore::HermiteNet all{vectors(net, "points", 2), vectors_of_net(tangents_u, "tangents_u", net),
                                       vectors_of_net(tangents_v, "tangents_v", net), {}};
            if (!twists.is_none()) all.twists = vectors_of_net(twists, "twists", net);
            std::pair<py::object, py::object> at{py::none(), py::none()};
            if (!parameters.is_none()) at = pair_argument(parameters, "parameters");
            return HermitePatch::make(static_cast<int>(net.shape(0)), static_cast<int>(net.shape(1)), std::move(all),
                                      optional_numbers(at.first, "parameters_u"),
                                      optional_numbers(at.second, "parameters_v"));
          }),
          py::arg("points"), py::arg("tangents_u"), py::arg("tangents_v"), py::arg("twists") = py::none(),
          py::arg("parameters") = py::none());
  bind_parts(cls);
  bind_value(cls);
  const auto add_net = [&cls](const char* name, std::vector<glm::dvec3> splinecore::HermiteNet::*member) {
    cls.def_property_readonly(name, [member](const py::object& self) {
      const auto& patch = py::cast<const HermitePatch&>(self);
      return view_of_vectors(patch.net().*member, {patch.count(Axis::u), patch.count(Axis::v)}, self);
    });
  };
  add_net("points", &splinecore::HermiteNet::points);
  add_net("tangents_u", &splinecore::HermiteNet::tangents_u);
  add_net("tangents_v", &splinecore::HermiteNet::tangents_v);
  add_net("twists", &splinecore::HermiteNet::twists);
  cls.def_property_readonly("parameters", [](const py::object& self) {
    const auto& patch = py::cast<const HermitePatch&>(self);
    return py::make_tuple(view_of_numbers(patch.parameters(Axis::u), self), view_of_numbers(patch.parameters(Axis::v), self));
  });
  bind_patch_verbs(cls);
  cls.def("to_nurbs", [](const HermitePatch& self) { return self.nurbs(); });
  cls.def("__repr__", [](const HermitePatch& self) {
    return "HermitePatch(points=(" + std::to_string(self.count(Axis::u)) + ", " + std::to_string(self.count(Axis::v)) + "))";
  });
}

}  // namespace

void bind_patches(py::module_& module) {
  bind_nurbs(module);
  bind_bezier(module);
  bind_hermite(module);
}

}  // namespace bindings
