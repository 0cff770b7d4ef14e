#include "nearest.hpp"

#include <cmath>

#include "arrays.hpp"
#include "classes.hpp"
#include "every_kind.hpp"
#include "long_calls.hpp"
#include "result_pickles.hpp"
#include "rooms.hpp"
#include "values.hpp"

namespace bindings {

using splinecore::InvalidShape;
using splinecore::NurbsCurve;
using splinecore::NurbsPatch;

namespace {

/// Points (..., 2 or 3).
struct Places {
  std::vector<glm::dvec3> points;
  Shape shape;  ///< without the last dimension

  explicit Places(const py::object& value) {
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
  const Places places(points);
  const int most = threads_of(threads);
  std::vector<splinecore::NearestOnCurve> found(places.points.size());
  unlocked([&] { splinecore::nearest(curve, places.points, found, most); }, cancel);
  Nearest out = arrays_for(places.shape, places.shape);
  write_places(found, out);
  return out;
}

Nearest nearest(const NurbsPatch& patch, const py::object& points, const py::object& threads,
                const py::object& cancel) {
  const Places places(points);
  const int most = threads_of(threads);
  std::vector<splinecore::NearestOnPatch> found(places.points.size());
  unlocked([&] { splinecore::nearest(patch, places.points, found, most); }, cancel);
  Nearest out = arrays_for(places.shape, with_column(places.shape, 2));
  write_places(found, out);
  return out;
}

void bind_curve(const CurveClasses& cls) {
  cls.def("nearest", [](const AnyCurve& self, const py::object& points, const py::object& threads,
                        const py::object& cancel) {
            return nearest(form(self), points, threads, cancel);
          },
          py::arg("points"), py::kw_only(), py::arg("threads") = 0, py::arg("cancel") = py::none());
}

void bind_patch(const PatchClasses& cls) {
  cls.def("nearest", [](const AnyPatch& self, const py::object& points, const py::object& threads,
                        const py::object& cancel) {
            return nearest(patch_form(self), points, threads, cancel);
          },
          py::arg("points"), py::kw_only(), py::arg("threads") = 0, py::arg("cancel") = py::none());
}

void bind_result(py::module_& module) {
  Class<Nearest> cls(module, "Nearest", py::module_local());
  seal(cls);
  pickle_members(cls, &Nearest::parameters, &Nearest::points, &Nearest::distances);
  cls.def_readonly("parameters", &Nearest::parameters);
  cls.def_readonly("points", &Nearest::points);
  cls.def_readonly("distances", &Nearest::distances);
  cls.def("__repr__", [](const Nearest& self) { return "Nearest(shape=" + shape_text(self.distances) + ")"; });
}

}  // namespace

Nearest arrays_for(const Shape& shape, const Shape& parameters) {
  return {py::array_t<double>(parameters), py::array_t<double>(with_column(shape, 3)), py::array_t<double>(shape)};
}

void bind_nearest(py::module_& module) {
  bind_result(module);
  bind_curve(CurveClasses(module));
  bind_patch(PatchClasses(module));
}

}  // namespace bindings
