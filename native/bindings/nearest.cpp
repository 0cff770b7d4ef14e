#include "nearest.hpp"

#include <cmath>
#include <cstdint>
#include <span>
#include <string>

#include "arrays.hpp"
#include "classes.hpp"
#include "every_kind.hpp"
#include "long_calls.hpp"
#include "result_pickles.hpp"
#include "rooms.hpp"
#include "splinecore/meet/nearest_among.hpp"
#include "values.hpp"

namespace bindings {

using splinecore::InvalidShape;
using splinecore::NurbsCurve;
using splinecore::NurbsPatch;

namespace {

/// Points (..., 2 or 3).
struct GivenPoints {
  std::vector<glm::dvec3> points;
  Shape shape;  ///< without the last dimension

  explicit GivenPoints(const py::object& value) {
    const Doubles given = real_array(value, "points");
    const py::ssize_t columns = given.ndim() == 0 ? 0 : given.shape(given.ndim() - 1);
    if (columns != 2 && columns != 3) {
      throw InvalidShape("points has shape " + shape_text(given) + ", (..., 2) or (..., 3) is expected");
    }
    shape.assign(given.shape(), given.shape() + given.ndim() - 1);
    points.reserve(static_cast<std::size_t>(given.size() / columns));
    for (py::ssize_t i = 0; i < given.size(); ++i) {
      if (std::isfinite(given.data()[i])) continue;
      throw InvalidShape("points" + place_text(given, i) + " = " + splinecore::text_of(given.data()[i]) +
                         " is not finite");
    }
    for (const double* row = given.data(); row != given.data() + given.size(); row += columns) {
      points.emplace_back(row[0], row[1], columns == 3 ? row[2] : 0.0);
    }
  }
};

Shape with_column(Shape shape, py::ssize_t count) {
  shape.push_back(count);
  return shape;
}

Nearest nearest(const NurbsCurve& curve, const py::object& points, const py::object& threads,
                const py::object& cancel) {
  const GivenPoints places(points);
  const int most = threads_of(threads);
  std::vector<splinecore::NearestOnCurve> found(places.points.size());
  unlocked([&] { splinecore::nearest(curve, places.points, found, most); }, cancel);
  Nearest out = arrays_for(places.shape, places.shape);
  write_places(found, out);
  return out;
}

Nearest nearest(const NurbsPatch& patch, const py::object& points, const py::object& threads,
                const py::object& cancel) {
  const GivenPoints places(points);
  const int most = threads_of(threads);
  std::vector<splinecore::NearestOnPatch> found(places.points.size());
  unlocked([&] { splinecore::nearest(patch, places.points, found, most); }, cancel);
  Nearest out = arrays_for(places.shape, with_column(places.shape, 2));
  write_places(found, out);
  return out;
}

/// What Python sees of the nearest points of several shapes to many.
struct NearestAmong {
  py::array_t<std::int64_t> shapes;
  Nearest places;
};

template <class Found, class Shape>
NearestAmong nearest_among(const std::vector<const Shape*>& shapes, const GivenPoints& places, const bindings::Shape& parameters,
                           const py::object& threads, const py::object& cancel) {
  const int most = threads_of(threads);
  std::vector<splinecore::NearestAmong<Found>> found(places.points.size());
  unlocked([&] { splinecore::nearest_among(std::span<const Shape* const>(shapes), places.points, found, most); }, cancel);
  NearestAmong out{py::array_t<std::int64_t>(places.shape), arrays_for(places.shape, parameters)};
  std::vector<Found> own;
  own.reserve(found.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    out.shapes.mutable_data()[i] = static_cast<std::int64_t>(found[i].shape);
    own.push_back(found[i].place);
  }
  write_places(own, out.places);
  return out;
}

bool is_patch(const py::handle& value) {
  return py::isinstance<NurbsPatch>(value) || py::isinstance<splinecore::BezierPatch>(value) ||
         py::isinstance<splinecore::HermitePatch>(value);
}

/// Of curves, or of patches: the first one says which. What it is made of stays as long as this tuple.
NearestAmong nearest_among(const py::tuple& shapes, const py::object& points, const py::object& threads,
                           const py::object& cancel) {
  const GivenPoints places(points);
  std::vector<const NurbsCurve*> curves;
  std::vector<const NurbsPatch*> patches;
  const bool are_patches = !shapes.empty() && is_patch(shapes[0]);
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const py::object shape = shapes[i];
    const std::string name = "shapes" + splinecore::index_text(i);
    if (are_patches) patches.push_back(&any_patch(shape, name.c_str()));
    else curves.push_back(&any_curve(shape, name.c_str()));
  }
  using splinecore::NearestOnCurve;
  using splinecore::NearestOnPatch;
  if (are_patches) return nearest_among<NearestOnPatch>(patches, places, with_column(places.shape, 2), threads, cancel);
  return nearest_among<NearestOnCurve>(curves, places, places.shape, threads, cancel);
}

void bind_near_curve(const CurveClasses& cls) {
  cls.def("nearest", [](const AnyCurve& self, const py::object& points, const py::object& threads,
                        const py::object& cancel) {
            return nearest(form(self), points, threads, cancel);
          },
          py::arg("points"), py::kw_only(), py::arg("threads") = 0, py::arg("cancel") = py::none());
}

void bind_near_patch(const PatchClasses& cls) {
  cls.def("nearest", [](const AnyPatch& self, const py::object& points, const py::object& threads,
                        const py::object& cancel) {
            return nearest(patch_form(self), points, threads, cancel);
          },
          py::arg("points"), py::kw_only(), py::arg("threads") = 0, py::arg("cancel") = py::none());
}

void bind_nearest_result(py::module_& module) {
  Class<Nearest> cls(module, "Nearest", py::module_local());
  seal(cls);
  pickle_members(cls, &Nearest::parameters, &Nearest::points, &Nearest::distances);
  cls.def_readonly("parameters", &Nearest::parameters);
  cls.def_readonly("points", &Nearest::points);
  cls.def_readonly("distances", &Nearest::distances);
  cls.def("__repr__", [](const Nearest& self) { return "Nearest(shape=" + shape_text(self.distances) + ")"; });
}

void bind_among(py::module_& module) {
  Class<NearestAmong> cls(module, "NearestAmong", py::module_local());
  seal(cls);
  pickle_members(cls, &NearestAmong::shapes, &NearestAmong::places);
  cls.def_readonly("shapes", &NearestAmong::shapes);
  cls.def_property_readonly("parameters", [](const NearestAmong& self) { return self.places.parameters; });
  cls.def_property_readonly("points", [](const NearestAmong& self) { return self.places.points; });
  cls.def_property_readonly("distances", [](const NearestAmong& self) { return self.places.distances; });
  cls.def("__repr__", [](const NearestAmong& self) {
    return "NearestAmong(shape=" + shape_text(self.places.distances) + ")";
  });
  module.def("nearest", [](const py::object& shapes, const py::object& points, const py::object& threads,
                           const py::object& cancel) {
               const bool is_list = py::isinstance<py::list>(shapes) || py::isinstance<py::tuple>(shapes);
               if (!is_list) throw py::type_error("shapes must be a list of curves or of patches, not " + type_name(shapes));
               return nearest_among(py::tuple(shapes), points, threads, cancel);
             }, py::arg("shapes"), py::arg("points"), py::kw_only(), py::arg("threads") = 0, py::arg("cancel") = py::none());
}

}  // namespace

Nearest arrays_for(const Shape& shape, const Shape& parameters) {
  return {py::array_t<double>(parameters), py::array_t<double>(with_column(shape, 3)), py::array_t<double>(shape)};
}

void bind_nearest(py::module_& module) {
  bind_nearest_result(module);
  bind_among(module);
  bind_near_curve(CurveClasses(module));
  bind_near_patch(PatchClasses(module));
}

}  // namespace bindings
