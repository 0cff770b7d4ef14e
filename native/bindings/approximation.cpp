#include "approximation.hpp"

#include "classes.hpp"
#include "pairs.hpp"
#include "result_pickles.hpp"
#include "rooms.hpp"
#include "splinecore/base/errors.hpp"
#include "values.hpp"

namespace bindings {

namespace {

std::string text_of(const AnyApproximation& self) {
  return "Approximation(value=" + std::string(py::repr(self.value)) + ", error=" + splinecore::text_of(self.error) + ")";
}

}  // namespace

void bind_approximation(py::module_& module) {
  Class<AnyApproximation> cls(
      module, "Approximation", py::module_local());
  seal(cls);
  pickle_members(cls, &AnyApproximation::value, &AnyApproximation::error);
  cls.def_property_readonly("value", [](const AnyApproximation& self) { return self.value; });
  cls.def_property_readonly("error", [](const AnyApproximation& self) { return self.error; });
  bind_pair(cls);
  cls.def("__repr__", &text_of);
}

}  // namespace bindings
