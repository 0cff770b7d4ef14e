#include <cmath>

#include "arrays.hpp"
#include "every_kind.hpp"
#include "long_calls.hpp"
#include "point_arguments.hpp"
#include "rooms.hpp"
#include "splinecore/measure/moving_frame.hpp"

namespace bindings {

using splinecore::CarriedFrame;
using splinecore::InvalidShape;
using splinecore::MovingFrame;
using splinecore::NurbsCurve;
using splinecore::Side;

namespace {

enum class FrameKind { frenet, rotation_minimizing };

void require_frenet(std::span<const MovingFrame> frames, const Doubles& at) {
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (!std::isnan(frames[i].binormal.x)) continue;
    const auto flat = static_cast<py::ssize_t>(i);
    throw InvalidShape("the curve is straight or has a zero derivative at u" + place_text(at, flat) + " = " +
                       splinecore::text_of(at.data()[i]) + ": it has no Frenet frame there");
  }
}

py::array_t<double> frames(const NurbsCurve& curve, const py::object& u, const py::object& kind,
                           const py::object& start, const py::object& closed, const py::object& side,
                           const py::object& cancel) {
  const Doubles at = real_array(u, "u");
  const Side from = side_of(side, "side");
  const FrameKind chosen_kind = chosen<FrameKind>(
      kind, "kind", {{"frenet", FrameKind::frenet}, {"rotation_minimizing", FrameKind::rotation_minimizing}});
  CarriedFrame how;
  if (!start.is_none()) how.start = vector_of(start, "start");
  how.is_closed = boolean(closed, "closed");
  if (chosen_kind == FrameKind::frenet && (how.start || how.is_closed)) {
    throw InvalidShape("Frenet frames have no start, and close where the curve does: kind = 'rotation_minimizing' takes "
                       "start and closed");
  }
  require_inside(curve.knot_vector(), at, from, "u");
  Shape shape(at.shape(), at.shape() + at.ndim());
  shape.insert(shape.end(), {3, 3});
  py::array_t<double> out(shape);
  static_assert(sizeof(MovingFrame) == 9 * sizeof(double));
  const std::span parameters(at.data(), static_cast<std::size_t>(at.size()));
  const std::span found(reinterpret_cast<MovingFrame*>(out.mutable_data()), parameters.size());
  unlocked([&] {
    if (chosen_kind == FrameKind::frenet) {
      splinecore::frenet_frames(curve, parameters, found, from);
    } else {
      splinecore::rotation_minimizing_frames(curve, parameters, found, how, from);
    }
  }, cancel);
  if (chosen_kind == FrameKind::frenet) require_frenet(found, at);
  return out;
}

void bind_frame_methods(const CurveClasses& cls) {
  cls.def("frames", [](const AnyCurve& self, const py::object& u, const py::object& kind, const py::object& start,
                       const py::object& closed, const py::object& side, const py::object& cancel) {
            return frames(form(self), u, kind, start, closed, side, cancel);
          },
          py::arg("u"), py::arg("kind") = "rotation_minimizing", py::kw_only(), py::arg("start") = py::none(),
          py::arg("closed") = false, py::arg("side") = "right", py::arg("cancel") = py::none());
}

}  // namespace

void bind_frames(py::module_& module) {
  bind_frame_methods(CurveClasses(module));
}

}  // namespace bindings
