#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "arrays.hpp"
#include "every_kind.hpp"
#include "long_calls.hpp"
#include "rooms.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/measure/plane_curve.hpp"

namespace bindings {

using splinecore::InvalidShape;
using splinecore::NurbsCurve;

namespace {

double signed_area(const NurbsCurve& curve, const py::object& normal, const py::object& tolerance) {
  const glm::dvec3 across = vector_of(normal, "normal");
  const double most = real(tolerance, "tolerance");
  return unlocked([&] { return splinecore::signed_area(curve, across, most).value; });
}

/// Around the points of an array of any shape.
py::object winding_numbers(const NurbsCurve& curve, const Doubles& given, const glm::dvec3& across) {
  constexpr const char* name = "point";
  const std::vector<glm::dvec3> points = vectors(given, name, static_cast<int>(given.ndim()) - 1);
  py::array_t<std::int64_t> out(Shape(given.shape(), given.shape() + given.ndim() - 1));
  std::int64_t* to = out.mutable_data();
  for (py::ssize_t k = 0; k < given.size(); ++k) {
    if (std::isfinite(given.data()[k])) continue;
    throw InvalidShape(std::string(name) + place_text(given, k) + " = " + splinecore::text_of(given.data()[k]) + " is not finite");
  }
  std::size_t i = 0;
  try {
    unlocked([&] {
      for (; i < points.size(); ++i) to[i] = splinecore::winding_number(curve, points[i], across);
    });
  } catch (const InvalidShape& error) {
    const std::string text = error.what();
    if (!text.starts_with("point ")) throw;
    throw InvalidShape("point" + place_text(out, static_cast<py::ssize_t>(i)) + text.substr(5));
  }
  return out;
}

py::object winding_number(const NurbsCurve& curve, const py::object& point, const py::object& normal) {
  const Doubles given = real_array(point, "point");
  if (given.ndim() > 1) return winding_numbers(curve, given, vector_of(normal, "normal"));
  const glm::dvec3 around = vector_of(point, "point");
  const glm::dvec3 across = vector_of(normal, "normal");
  return py::int_(unlocked([&] { return splinecore::winding_number(curve, around, across); }));
}

void bind_plane_measures(const CurveClasses& cls) {
  cls.def("signed_area", [](const AnyCurve& self, const py::object& normal, const py::object& tolerance) {
            return signed_area(form(self), normal, tolerance);
          },
          py::arg("normal") = py::make_tuple(0.0, 0.0, 1.0), py::kw_only(),
          py::arg("tolerance") = splinecore::kPlaneAreaTolerance);
  cls.def("winding_number", [](const AnyCurve& self, const py::object& point, const py::object& normal) {
            return winding_number(form(self), point, normal);
          },
          py::arg("point"), py::arg("normal") = py::make_tuple(0.0, 0.0, 1.0));
}

}  // namespace

void bind_plane_curves(py::module_& module) {
  bind_plane_measures(CurveClasses(module));
}

}  // namespace bindings
