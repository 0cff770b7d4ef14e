#include <cmath>

#include "arrays.hpp"
#include "every_kind.hpp"
#include "long_calls.hpp"
#include "rooms.hpp"
#include "splinecore/measure/arc_length.hpp"

namespace bindings {

using splinecore::InvalidShape;
using splinecore::NurbsCurve;

namespace {

py::array_t<double> parameter_at_length(const NurbsCurve& curve, const py::object& s, const py::object& tolerance,
                                        const py::object& cancel) {
  const Doubles lengths = real_array(s, "s");
  const double most = real(tolerance, "tolerance");
  for (py::ssize_t i = 0; i < lengths.size(); ++i) {
    if (std::isfinite(lengths.data()[i])) continue;
    throw InvalidShape("s" + place_text(lengths, i) + " = " + splinecore::text_of(lengths.data()[i]) +
                       " is not finite");
  }
  const std::span given(lengths.data(), static_cast<std::size_t>(lengths.size()));
  const auto found = unlocked([&] { return splinecore::parameters_at_lengths(curve, given, most); }, cancel);
  py::array_t<double> out(Shape(lengths.shape(), lengths.shape() + lengths.ndim()));
  std::ranges::copy(found, out.mutable_data());
  return out;
}

py::array_t<double> divide(const NurbsCurve& curve, const py::object& count, const py::object& tolerance,
                           const py::object& cancel) {
  const int parts = integer(count, "count");
  const double most = real(tolerance, "tolerance");
  const auto found = unlocked([&] { return splinecore::divide(curve, parts, most); }, cancel);
  return new_numbers(std::span(found));
}

py::array_t<double> divide_by_length(const NurbsCurve& curve, const py::object& step, const py::object& tolerance,
                                     const py::object& cancel) {
  const double length = real(step, "step");
  const double most = real(tolerance, "tolerance");
  const auto found = unlocked([&] { return splinecore::divide_by_length(curve, length, most); }, cancel);
  return new_numbers(std::span(found));
}

void bind_lengths(const CurveClasses& cls) {
  cls.def("parameter_at_length", [](const AnyCurve& self, const py::object& s, const py::object& tolerance,
                                    const py::object& cancel) {
            return parameter_at_length(form(self), s, tolerance, cancel);
          },
          py::arg("s"), py::kw_only(), py::arg("tolerance") = splinecore::kPlaceTolerance,
          py::arg("cancel") = py::none());
  cls.def("divide", [](const AnyCurve& self, const py::object& count, const py::object& tolerance,
                       const py::object& cancel) { return divide(form(self), count, tolerance, cancel); },
          py::arg("count"), py::kw_only(), py::arg("tolerance") = splinecore::kPlaceTolerance,
          py::arg("cancel") = py::none());
  cls.def("divide_by_length", [](const AnyCurve& self, const py::object& step, const py::object& tolerance,
                                 const py::object& cancel) {
            return divide_by_length(form(self), step, tolerance, cancel);
          },
          py::arg("step"), py::kw_only(), py::arg("tolerance") = splinecore::kPlaceTolerance,
          py::arg("cancel") = py::none());
}

}  // namespace

void bind_arc_lengths(py::module_& module) {
  bind_lengths(CurveClasses(module));
}

}  // namespace bindings
