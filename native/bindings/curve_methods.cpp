#include "arrays.hpp"
#include "every_kind.hpp"
#include "long_calls.hpp"
#include "output.hpp"
#include "rooms.hpp"
#include "splinecore/base/order.hpp"
#include "splinecore/convert/to_bezier.hpp"
#include "splinecore/convert/to_hermite.hpp"
#include "splinecore/curve/evaluate.hpp"
#include "splinecore/curve/nurbs_curve.hpp"
#include "splinecore/tessellate/polyline.hpp"

namespace bindings {

using splinecore::EvaluateOptions;
using splinecore::InvalidShape;
using splinecore::NurbsCurve;

namespace {

EvaluateOptions options_of(const py::object& side, const py::object& at_infinity, const py::object& threads) {
  return {side_of(side, "side"), at_infinity_of(at_infinity), threads_of(threads)};
}

/// work() without the interpreter's lock; a parameter that is refused is named by its place.
template <class Work>
void unlocked_at(const Doubles& parameters, const NurbsCurve& curve, const EvaluateOptions& options,
                 const py::object& cancel, Work work) {
  try {
    unlocked(work, cancel);
  } catch (const InvalidShape&) {
    require_inside(curve.knot_vector(), parameters, options.side, "u");
    throw;
  }
  heed(cancel);
}

py::array evaluate(const NurbsCurve& curve, const py::object& u, const py::object& side,
                   const py::object& at_infinity, const py::object& dtype, const py::object& out,
                   const py::object& threads, const py::object& cancel) {
  const Doubles at = apart_from(real_array(u, "u"), out);
  Shape shape(at.shape(), at.shape() + at.ndim());
  shape.push_back(3);
  const Output output(shape, out, dtype);
  const EvaluateOptions options = options_of(side, at_infinity, threads);
  const std::span parameters(at.data(), static_cast<std::size_t>(at.size()));
  const std::size_t count = 3 * parameters.size();
  unlocked_at(at, curve, options, cancel, [&] {
    if (output.single()) {
      splinecore::evaluate(curve, parameters, output.floats(0, count), options);
    } else {
      splinecore::evaluate(curve, parameters, output.doubles(0, count), options);
    }
  });
  return output.array();
}

py::array derivatives(const NurbsCurve& curve, const py::object& u, const py::object& order,
                      const py::object& side, const py::object& at_infinity, const py::object& out,
                      const py::object& threads, const py::object& cancel) {
  const Doubles at = apart_from(real_array(u, "u"), out);
  const int highest = integer(order, "order");
  splinecore::require_order(highest);
  Shape shape(at.shape(), at.shape() + at.ndim());
  shape.push_back(highest + 1);
  shape.push_back(3);
  const Output output(shape, out);
  const EvaluateOptions options = options_of(side, at_infinity, threads);
  const std::span parameters(at.data(), static_cast<std::size_t>(at.size()));
  const std::size_t count = 3 * (static_cast<std::size_t>(highest) + 1) * parameters.size();
  unlocked_at(at, curve, options, cancel, [&] {
    splinecore::derivatives(curve, parameters, highest, output.doubles(0, count), options);
  });
  return output.array();
}

py::list polylines(const NurbsCurve& curve, const py::object& resolution, const py::object& reach,
                   const py::object& around) {
  py::list lines;
  const int steps = integer(resolution, "resolution");
  const std::optional<double> most = optional_real(reach, "reach");
  const auto places = around.is_none() ? std::vector<glm::dvec3>{} : vectors(real_array(around, "around"), "around", 1);
  for (const auto& line : unlocked([&] { return splinecore::polylines(curve, steps, most, places); })) {
    py::array_t<double> points({static_cast<py::ssize_t>(line.points.size() / 3), py::ssize_t{3}});
    std::ranges::copy(line.points, points.mutable_data());
    lines.append(py::make_tuple(points, line.closed));
  }
  return lines;
}

py::list finite_pieces(const NurbsCurve& curve) {
  py::list intervals;
  for (const auto& piece : unlocked([&] { return splinecore::pieces(curve); })) intervals.append(pair_of(piece));
  return intervals;
}

}  // namespace

void bind_curve_methods(py::module_& module) {
  const CurveClasses cls(module);
  cls.def_property("degree", [](const AnyCurve& self) { return form(self).degree(); });
  cls.def_property("domain", [](const AnyCurve& self) { return pair_of(form(self).domain()); });
  cls.def_property("is_rational", [](const AnyCurve& self) { return form(self).rational(); });
  cls.def("evaluate", [](const AnyCurve& self, const py::object& u, const py::object& side, const py::object& at_infinity,
                         const py::object& dtype, const py::object& out, const py::object& threads,
                         const py::object& cancel) {
            return evaluate(form(self), u, side, at_infinity, dtype, out, threads, cancel);
          },
          py::arg("u"), py::kw_only(), py::arg("side") = "right", py::arg("at_infinity") = "raise",
          py::arg("dtype") = py::none(), py::arg("out") = py::none(), py::arg("threads") = 0,
          py::arg("cancel") = py::none());
  cls.def("derivatives", [](const AnyCurve& self, const py::object& u, const py::object& order, const py::object& side,
                            const py::object& at_infinity, const py::object& out, const py::object& threads,
                            const py::object& cancel) {
            return derivatives(form(self), u, order, side, at_infinity, out, threads, cancel);
          },
          py::arg("u"), py::arg("order"), py::kw_only(), py::arg("side") = "right",
          py::arg("at_infinity") = "raise", py::arg("out") = py::none(), py::arg("threads") = 0,
          py::arg("cancel") = py::none());
  cls.def("pieces", [](const AnyCurve& self) { return finite_pieces(form(self)); });
  cls.def("polylines", [](const AnyCurve& self, const py::object& resolution, const py::object& reach,
                          const py::object& around) {
            return polylines(form(self), resolution, reach, around);
          }, py::arg("resolution"), py::arg("reach") = py::none(), py::arg("around") = py::none());
  cls.def("to_bezier", [](const AnyCurve& self) { return unlocked([&] { return splinecore::to_bezier(form(self)); }); });
  cls.def("to_hermite", [](const AnyCurve& self) { return unlocked([&] { return splinecore::to_hermite(form(self)); }); });
}

}  // namespace bindings
