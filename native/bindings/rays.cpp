#include "splinecore/meet/rays.hpp"

#include <algorithm>
#include <limits>
#include <string>

#include "arguments.hpp"
#include "arrays.hpp"
#include "classes.hpp"
#include "every_kind.hpp"
#include "long_calls.hpp"
#include "result_pickles.hpp"
#include "rooms.hpp"
#include "values.hpp"

namespace bindings {

using splinecore::InvalidShape;
using splinecore::NurbsPatch;
using splinecore::PatchSet;
using splinecore::Ray;
using splinecore::RayHit;

namespace {

/// What Python sees of the places where rays meet a shape.
struct RayHits {
  py::array_t<std::int64_t> rays;
  py::array_t<double> along;
  py::array_t<double> until;
  py::array_t<std::int64_t> patches;
  py::array_t<double> parameters;
  py::array_t<double> points;
  py::array_t<bool> touches;

  static RayHits of_shape(const Shape& shape) {
    using Integers = py::array_t<std::int64_t>;
    using Numbers = py::array_t<double>;
    return {Integers(shape), Numbers(shape), Numbers(shape), Integers(shape), Numbers(with(shape, 2)),
            Numbers(with(shape, 3)), py::array_t<bool>(shape)};
  }

  void write(std::size_t i, std::size_t ray, const std::optional<RayHit>& hit) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    const RayHit missed{kNan, kNan, 0, kNan, kNan, glm::dvec3(kNan), false};
    const RayHit& own = hit ? *hit : missed;
    rays.mutable_data()[i] = static_cast<std::int64_t>(ray);
    along.mutable_data()[i] = own.along;
    until.mutable_data()[i] = own.until;
    patches.mutable_data()[i] = hit ? static_cast<std::int64_t>(own.patch) : -1;
    parameters.mutable_data()[2 * i] = own.u;
    parameters.mutable_data()[2 * i + 1] = own.v;
    std::copy_n(&own.point.x, 3, points.mutable_data() + 3 * i);
    touches.mutable_data()[i] = own.touches;
  }

  static Shape with(Shape shape, py::ssize_t columns) {
    shape.push_back(columns);
    return shape;
  }
};

struct GivenRays {
  std::vector<Ray> rays;
  Shape shape;  ///< without the last dimension

  GivenRays(const py::object& origins, const py::object& directions) {
    const Doubles from = three_columns(origins, "origins");
    const Doubles along = three_columns(directions, "directions");
    Doubles both[2];
    try {
      const py::list broadcast = py::module_::import("numpy").attr("broadcast_arrays")(from, along);
      for (std::size_t i = 0; i < 2; ++i) both[i] = Doubles(py::object(broadcast[i]));
    } catch (py::error_already_set& error) {
      if (!error.matches(PyExc_ValueError)) throw;
      throw InvalidShape("origins of shape " + shape_text(from) + " and directions of shape " + shape_text(along) +
                         " do not broadcast");
    }
    shape.assign(both[0].shape(), both[0].shape() + both[0].ndim() - 1);
    const auto row = [](const Doubles& of, py::ssize_t i) {
      return glm::dvec3(of.data()[i], of.data()[i + 1], of.data()[i + 2]);
    };
    for (py::ssize_t i = 0; i < both[0].size(); i += 3) rays.push_back({row(both[0], i), row(both[1], i)});
  }

 private:
  static Doubles three_columns(const py::object& value, const char* name) {
    Doubles given = real_array(value, name);
    if (given.ndim() > 0 && given.shape(given.ndim() - 1) == 3) return given;
    throw InvalidShape(std::string(name) + " has shape " + shape_text(given) + ", (..., 3) is expected");
  }
};

bool wants_all(const py::object& hits) {
  if (py::isinstance<py::str>(hits)) {
    const std::string text = py::str(hits);
    if (text == "first" || text == "all") return text == "all";
  }
  throw InvalidShape("hits = " + short_text(hits) + " is none of 'first', 'all'");
}

template <class Target>
RayHits found_on(const Target& target, const py::object& origins, const py::object& directions, const py::object& hits,
                 const py::object& limits, const py::object& threads, const py::object& cancel) {
  const bool is_all = wants_all(hits);
  const GivenRays given(origins, directions);
  splinecore::RayOptions options;
  if (!limits.is_none()) options.limits = interval_of(limits, "limits");
  options.threads = threads_of(threads);
  if (!is_all) {
    std::vector<std::optional<RayHit>> found(given.rays.size());
    unlocked([&] { splinecore::first_hits(target, given.rays, found, options); }, cancel);
    RayHits out = RayHits::of_shape(given.shape);
    for (std::size_t i = 0; i < found.size(); ++i) out.write(i, i, found[i]);
    return out;
  }
  const auto found = unlocked([&] { return splinecore::all_hits(target, given.rays, options); }, cancel);
  std::size_t count = 0;
  for (const auto& own : found) count += own.size();
  RayHits out = RayHits::of_shape({static_cast<py::ssize_t>(count)});
  std::size_t at = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    for (const RayHit& hit : found[i]) out.write(at++, i, hit);
  }
  return out;
}

void bind_hits(py::module_& module) {
  Class<RayHits> cls(module, "RayHits", py::module_local());
  seal(cls);
  pickle_members(cls, &RayHits::rays, &RayHits::along, &RayHits::until, &RayHits::patches, &RayHits::parameters,
                  &RayHits::points, &RayHits::touches);
  cls.def_property_readonly("rays", [](const RayHits& self) { return self.rays; });
  cls.def_property_readonly("along", [](const RayHits& self) { return self.along; });
  cls.def_property_readonly("until", [](const RayHits& self) { return self.until; });
  cls.def_property_readonly("patches", [](const RayHits& self) { return self.patches; });
  cls.def_property_readonly("parameters", [](const RayHits& self) { return self.parameters; });
  cls.def_property_readonly("points", [](const RayHits& self) { return self.points; });
  cls.def_property_readonly("touches", [](const RayHits& self) { return self.touches; });
  cls.def("__repr__", [](const RayHits& self) { return "RayHits(shape=" + shape_text(self.along) + ")"; });
}

}  // namespace

void bind_rays(py::module_& module) {
  bind_hits(module);
  PatchClasses(module).def(
      "rays", [](const AnyPatch& self, const py::object& origins, const py::object& directions, const py::object& hits,
                 const py::object& limits, const py::object& threads, const py::object& cancel) {
        return found_on(patch_form(self), origins, directions, hits, limits, threads, cancel);
      },
      py::arg("origins"), py::arg("directions"), py::kw_only(), py::arg("hits") = "first", py::arg("limits") = py::none(),
      py::arg("threads") = 0, py::arg("cancel") = py::none());
  class_of<PatchSet>(module, "PatchSet").def(
      "rays", [](const PatchSet& self, const py::object& origins, const py::object& directions, const py::object& hits,
                 const py::object& limits, const py::object& threads, const py::object& cancel) {
        return found_on(self, origins, directions, hits, limits, threads, cancel);
      },
      py::arg("origins"), py::arg("directions"), py::kw_only(), py::arg("hits") = "first", py::arg("limits") = py::none(),
      py::arg("threads") = 0, py::arg("cancel") = py::none());
}

}  // namespace bindings
