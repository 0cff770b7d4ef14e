#include <algorithm>
#include <string>

#include "arrays.hpp"
#include "every_kind.hpp"
#include "long_calls.hpp"
#include "rooms.hpp"
#include "splinecore/measure/flux.hpp"
#include "splinecore/measure/moments.hpp"
#include "splinecore/patch/patch_set.hpp"

namespace bindings {

using splinecore::InvalidShape;
using splinecore::PatchSet;

namespace {

/// Calls the field with an array (n, 3) and takes its vectors, (n, 3).
splinecore::VectorField asked(const py::object& field) {
  if (PyCallable_Check(field.ptr()) == 0) {
    throw py::type_error("field = " + std::string(py::repr(field)) + " is not callable");
  }
  return [&field](std::span<const glm::dvec3> points, std::span<glm::dvec3> vectors) {
    const py::gil_scoped_acquire locked;
    const auto count = static_cast<py::ssize_t>(points.size());
    py::array_t<double> at(Shape{count, 3});
    std::copy_n(&points.front().x, 3 * points.size(), at.mutable_data());
    const Doubles given = real_array(field(at), "the values of field");
    if (given.ndim() != 2 || given.shape(0) != count || given.shape(1) != 3) {
      throw InvalidShape("the values of field have shape " + shape_text(given) + " at " + std::to_string(count) +
                         " points, (" + std::to_string(count) + ", 3) is expected");
    }
    std::copy_n(given.data(), 3 * vectors.size(), &vectors.front().x);
  };
}

const splinecore::NurbsPatch& form_of(const AnyPatch& patch) { return patch_form(patch); }
const PatchSet& form_of(const PatchSet& set) { return set; }

template <class Shaped, class Owner>
void bind_integrals(Owner cls) {
  cls.def("flux", [](const Shaped& self, const py::object& field, const py::object& tolerance,
                            const py::object& cancel) {
            const splinecore::VectorField wanted = asked(field);
            const double most = real(tolerance, "tolerance");
            return unlocked([&] { return splinecore::flux(form_of(self), wanted, most).value; }, cancel);
          }, py::arg("field"), py::kw_only(), py::arg("tolerance") = splinecore::kAreaTolerance,
          py::arg("cancel") = py::none());
  cls.def("surface_centroid", [](const Shaped& self, const py::object& tolerance, const py::object& cancel) {
            const double most = real(tolerance, "tolerance");
            const glm::dvec3 found =
                unlocked([&] { return splinecore::surface_centroid(form_of(self), most).value; }, cancel);
            py::array_t<double> out(Shape{3});
            std::copy_n(&found.x, 3, out.mutable_data());
            return out;
          }, py::kw_only(), py::arg("tolerance") = splinecore::kAreaTolerance, py::arg("cancel") = py::none());
}

}  // namespace

void bind_surface_integrals(py::module_& module) {
  bind_integrals<AnyPatch>(PatchClasses(module));
  bind_integrals<PatchSet>(class_of<PatchSet>(module, "PatchSet"));
}

}  // namespace bindings
