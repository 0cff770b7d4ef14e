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
          py::arg("points"), py::kw_only(), py::arg("threads") = 0, py::arg("cancel") = py::none(),
          "The nearest point of all the curve to each of points (..., 2 or 3), as a Nearest: ends, corners and\n"
          "gaps included, never a minimum that is only local. Distances are right to a few roundings of the\n"
          "size of the curve and of themselves.\n\n"
          "Branch and bound on the boxes of Bernstein pieces (Johnson and Cohen 1998), with Newton's method. Of\n"
          "places at one distance, up to rounding, it is the one with the smallest parameter, to 1e-6 of the\n"
          "domain; of a periodic curve it lies in [start, end). Where the curve passes through infinity its\n"
          "finite part counts; at a gap the point is that of the nearer side. A point has the same result in\n"
          "any batch, on any number of threads. cancel is a callable that ends a long call by returning True.\n"
          "InvalidShape names a point that is not finite.");
}

void bind_patch(const PatchClasses& cls) {
  cls.def("nearest", [](const AnyPatch& self, const py::object& points, const py::object& threads,
                        const py::object& cancel) {
            return nearest(patch_form(self), points, threads, cancel);
          },
          py::arg("points"), py::kw_only(), py::arg("threads") = 0, py::arg("cancel") = py::none(),
          "The nearest point of all the patch to each of points (..., 2 or 3), as a Nearest: borders, corners\n"
          "and poles included, never a minimum that is only local. Distances are right to a few roundings of\n"
          "the size of the patch and of themselves.\n\n"
          "Branch and bound on the boxes of Bernstein pieces (Johnson and Cohen 1998), with Newton's method. Of\n"
          "places at one distance, up to rounding, it is the one with the smallest u, then v, to 1e-6 of the\n"
          "domain; where periodic in [start, end). Where the patch passes through infinity its finite part\n"
          "counts. Where more than 2^14 parts may hold the point, as where a whole curve of places is as near\n"
          "that is none of constant u or v, any of them is taken, and the distance is right to 1e-7 of the size\n"
          "of the patch and of itself; after 2^18 parts it is refused. A point has the same result in any batch,\n"
          "on any number of threads. cancel is a callable that ends a long call by returning True. InvalidShape\n"
          "names a point that is not finite.");
}

void bind_result(py::module_& module) {
  Class<Nearest> cls(module, "Nearest", py::module_local(),
                          "The nearest points of a shape to points (..., 3).\n\n"
                          "parameters is (...,) on a curve and (..., 2), u and v, on a patch; points is (..., 3),\n"
                          "distances (...,).");
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
