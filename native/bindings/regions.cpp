#include "arrays.hpp"
#include "classes.hpp"
#include "every_kind.hpp"
#include "long_calls.hpp"
#include "point_arguments.hpp"
#include "rooms.hpp"
#include "splinecore/measure/plane_moments.hpp"
#include "splinecore/region/offset_region.hpp"
#include "splinecore/region/region.hpp"
#include "values.hpp"

namespace bindings {

using splinecore::FillRule;
using splinecore::NurbsCurve;
using splinecore::OffsetCorner;
using splinecore::Region;
using splinecore::RegionOperation;

namespace {

std::optional<glm::dvec3> optional_vector(const py::object& value, const char* name) {
  if (value.is_none()) return {};
  return vector_of(value, name);
}

Region region_of(const py::object& curves, const py::object& normal, const py::object& rule, const py::object& tolerance, const py::object& cancel) {
  const std::vector<NurbsCurve> outlines = any_curves(curves, "curves");
  const auto across = optional_vector(normal, "normal");
  const FillRule filled = chosen<FillRule>(rule, "rule", {{"even-odd", FillRule::even_odd}, {"nonzero", FillRule::nonzero}});
  const auto near = optional_real(tolerance, "tolerance");
  return unlocked([&] { return Region::of(outlines, across, filled, near); }, cancel);
}

py::tuple outlines_of(const Region& self) { return py::tuple(py::cast(self.outlines())); }

template <RegionOperation kOperation>
Region combined(const Region& self, const Region& other, const py::object& tolerance, const py::object& cancel) {
  const auto near = optional_real(tolerance, "tolerance");
  return unlocked([&] { return splinecore::combined(self, other, kOperation, near); }, cancel);
}

template <RegionOperation kOperation>
Region combined_as_they_are(const Region& self, const Region& other) {
  return unlocked([&] { return splinecore::combined(self, other, kOperation); });
}

template <RegionOperation kOperation>
void bind_operation(Class<Region>& cls, const char* name, const char* sign) {
  cls.def(name, &combined<kOperation>, py::arg("other"), py::arg("tolerance") = py::none(), py::kw_only(), py::arg("cancel") = py::none());
  cls.def(sign, &combined_as_they_are<kOperation>, py::arg("other"), py::is_operator());
}

py::object contains(const Region& self, const py::object& points) {
  const Doubles given = real_array(points, "points");
  const std::vector<glm::dvec3> at = vectors(given, "points", static_cast<int>(given.ndim()) - 1);
  const std::vector<bool> found = unlocked([&] { return splinecore::contains(self, at); });
  py::array_t<bool> out(Shape(given.shape(), given.shape() + given.ndim() - 1));
  std::ranges::copy(found, out.mutable_data());
  return out;
}

double area(const Region& self, const py::object& tolerance) {
  const double most = real(tolerance, "tolerance");
  return unlocked([&] { return splinecore::enclosed_area(self.outlines(), self.normal(), most).value; });
}

py::array_t<double> centroid(const Region& self, const py::object& tolerance) {
  const double most = real(tolerance, "tolerance");
  const glm::dvec3 found = unlocked([&] { return splinecore::plane_centroid(self.outlines(), self.normal(), most).value; });
  return new_numbers(std::span<const double>(&found.x, 3));
}

py::array_t<double> second_moments(const Region& self, const py::object& about, const py::object& tolerance) {
  const auto point = optional_vector(about, "about");
  const double most = real(tolerance, "tolerance");
  const auto found = unlocked([&] { return splinecore::plane_second_moments(self.outlines(), self.normal(), point, most).value; });
  py::array_t<double> out({3, 3});
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) out.mutable_at(i, j) = found[i][j];
  }
  return out;
}

Region offset(const Region& self, const py::object& distance, const py::object& tolerance, const py::object& corner, const py::object& cancel) {
  const double by = real(distance, "distance");
  const OffsetCorner turned = chosen<OffsetCorner>(corner, "corner", {{"round", OffsetCorner::round}, {"sharp", OffsetCorner::sharp}});
  const auto near = optional_real(tolerance, "tolerance");
  return unlocked([&] { return splinecore::offset(self, by, turned, near); }, cancel);
}

}  // namespace

void bind_regions(py::module_& module) {
  Class<Region> cls(module, "Region", py::module_local());
  bind_value(cls);
  cls.def_static("of", &region_of, py::arg("curves"), py::arg("normal") = py::none(), py::kw_only(), py::arg("rule") = "even-odd",
                 py::arg("tolerance") = py::none(), py::arg("cancel") = py::none());
  cls.def_property_readonly("outlines", &outlines_of);
  cls.def_property_readonly("normal", [](const Region& self) { return new_numbers(std::span<const double>(&self.normal().x, 3)); });
  bind_operation<RegionOperation::united>(cls, "union", "__or__");
  bind_operation<RegionOperation::common>(cls, "intersection", "__and__");
  bind_operation<RegionOperation::without>(cls, "difference", "__sub__");
  bind_operation<RegionOperation::in_one>(cls, "symmetric_difference", "__xor__");
  cls.def("contains", &contains, py::arg("points"));
  cls.def("area", &area, py::kw_only(), py::arg("tolerance") = splinecore::kPlaneAreaTolerance);
  cls.def("centroid", &centroid, py::kw_only(), py::arg("tolerance") = splinecore::kPlaneAreaTolerance);
  cls.def("second_moments", &second_moments, py::arg("about") = py::none(), py::kw_only(), py::arg("tolerance") = splinecore::kPlaneAreaTolerance);
  cls.def("offset", &offset, py::arg("distance"), py::arg("tolerance") = py::none(), py::kw_only(), py::arg("corner") = "round",
          py::arg("cancel") = py::none());
  cls.def("__bool__", [](const Region& self) { return !self.is_empty(); });
  cls.def("__repr__", [](const Region& self) { return "Region(outlines=" + std::to_string(self.outlines().size()) + ")"; });
}

}  // namespace bindings
