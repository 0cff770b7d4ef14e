#include <cstddef>
#include <optional>
#include <vector>

#include "approximation.hpp"
#include "arguments.hpp"
#include "classes.hpp"
#include "every_kind.hpp"
#include "long_calls.hpp"
#include "neighbors.hpp"
#include "result_pickles.hpp"
#include "rooms.hpp"
#include "splinecore/surface/coons.hpp"
#include "splinecore/surface/network.hpp"
#include "values.hpp"

namespace bindings {

using splinecore::NetworkSurface;
using splinecore::NurbsCurve;

namespace {

/// For each side a curve or None; none where there is no list at all.
std::optional<std::vector<std::optional<NurbsCurve>>> across_of(const py::object& value) {
  if (value.is_none()) return {};
  const bool is_list = py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value);
  if (!is_list) throw py::type_error("across must be a list of curves and None, not " + type_name(value));
  std::vector<std::optional<NurbsCurve>> found;
  for (const py::handle& item : value) {
    const std::string name = "across" + splinecore::index_text(found.size());
    found.emplace_back();
    if (!item.is_none()) found.back() = any_curve(py::reinterpret_borrow<py::object>(item), name.c_str());
  }
  return found;
}

/// Neighbors; none for None.
std::vector<splinecore::LoftNeighbor> neighbors_of(const py::object& value) {
  std::vector<splinecore::LoftNeighbor> found;
  if (value.is_none()) return found;
  const bool is_list = py::isinstance<py::list>(value) || (py::isinstance<py::tuple>(value) && py::len(value) == 0);
  if (!is_list) throw py::type_error("neighbors must be a list of (patch, side, 'G1'), not " + type_name(value));
  for (const py::handle& item : value) {
    const std::string name = "neighbors" + splinecore::index_text(found.size());
    const auto neighbor = neighbor_of(py::reinterpret_borrow<py::object>(item), name.c_str());
    if (!neighbor) throw py::type_error(name + " is None");
    found.push_back(*neighbor);
  }
  return found;
}

}  // namespace

void bind_network_surface(py::module_& module) {
  Class<NetworkSurface> cls(module, "NetworkSurface", py::module_local(),
                            "The surface through a network: value, a NurbsPatch, and error, the largest distance from a curve.\n\n"
                            "Unpacks: value, error = build.network(...). paces tells, for its sides u_start, u_end, v_start and v_end, how far\n"
                            "they are from the outermost curves at the same share of their parameters, lengths, None where a direction is closed:\n"
                            "0 but for rounding where the curve keeps its pace, so that a patch whose edge it is shares that.");
  seal(cls);
  pickle_members(cls, &NetworkSurface::value, &NetworkSurface::error, &NetworkSurface::paces);
  cls.def_readonly("value", &NetworkSurface::value);
  cls.def_readonly("error", &NetworkSurface::error);
  cls.def_property_readonly("paces", [](const NetworkSurface& self) {
    py::tuple found(self.paces.size());
    for (std::size_t i = 0; i < self.paces.size(); ++i) {
      found[i] = self.paces[i] ? py::object(py::float_(*self.paces[i])) : py::none();
    }
    return found;
  });
  cls.def("__iter__", [](const NetworkSurface& self) { return py::iter(py::make_tuple(self.value, self.error)); });
  cls.def("__repr__", [](const NetworkSurface& self) { return "NetworkSurface(error=" + splinecore::text_of(self.error) + ")"; });
}

void bind_networks(py::module_& module) {
  bind_network_surface(module);
  py::module_ build = module.attr("build");
  build.def("coons", [](const py::object& sides, const py::object& across, const py::object& tolerance,
                        const py::object& cancel) {
              const std::vector<NurbsCurve> around = any_curves(sides, "sides");
              const auto leaving = across_of(across);
              const auto within = tolerance_of(tolerance);
              return wrap(unlocked([&] {
                return leaving ? splinecore::bicubic_coons(around, *leaving, within) : splinecore::coons(around, within);
              }, cancel));
            }, py::arg("sides"), py::kw_only(), py::arg("across") = py::none(), py::arg("tolerance") = py::none(),
            py::arg("cancel") = py::none(),
            "The patch between three or four curves of any kinds that go round it, in any directions: (value, error), a\n"
            "NurbsPatch and how far an end was moved. Both ruled surfaces between opposite curves, less the bilinear patch of\n"
            "the corners (Coons 1967; lecture row S21). Of three the last side is a point.\n\n"
            "u runs along the first curve, v from there to the third one. Weights of sides are multiplied so that they are 1 at\n"
            "both ends. Ends may lie apart by the tolerance, a length, by default 2^-30 of the size: both go to their middle.\n"
            "With across, for each of four sides None or a curve of vectors without weights, the patch is the bicubic one (Farin\n"
            "2002, 22.3): over [0, 1] in both directions, and its derivative across a side, into the patch, is that at the same\n"
            "place of the side. One that is None runs smoothly between those along the neighbors, with a neighbor's twists or\n"
            "those of the bilinear patch (Adini), as far as these let nothing swing out. Sides then keep their pace: weights are\n"
            "multiplied by a linear function. A derivative must be, at its ends, the one along the next side, within the tolerance;\n"
            "of two twists in a corner the mean is taken, and error is the most by which a derivative was changed.\n\n"
            "InvalidShape if there are not three or four curves, one is closed or ends at infinity, or its end weights have\n"
            "not one sign, or if a curve of vectors has weights or jumps; ToleranceNotReached says how far neighbors' ends lie\n"
            "apart, and which derivative is not that along the next side.");
  build.def("network", [](const py::object& along_u, const py::object& along_v, const py::object& neighbors,
                          const py::object& tolerance, const py::object& gap, const py::object& cancel) {
              const std::vector<NurbsCurve> u = any_curves(along_u, "along_u");
              const std::vector<NurbsCurve> v = any_curves(along_v, "along_v");
              const auto beyond = neighbors_of(neighbors);
              const auto within = tolerance_of(tolerance);
              const auto between = tolerance_of(gap, "gap");
              return unlocked([&] { return splinecore::network(u, v, within, beyond, between); }, cancel);
            }, py::arg("along_u"), py::arg("along_v"), py::kw_only(), py::arg("neighbors") = py::none(),
            py::arg("tolerance") = py::none(), py::arg("gap") = py::none(), py::arg("cancel") = py::none(),
            "The surface through a network of curves of any kinds, each of the first ones meeting each of the others once:\n"
            "(value, error), a NurbsPatch and the largest distance from a curve. The surfaces through either, less the one\n"
            "through their crossings (Gordon 1969; lecture row S21).\n\n"
            "Any order and directions; what hangs over the outermost curves by more than the gap is cut off. Outermost curves\n"
            "keep their pace, so that edges of other patches stay edges. Where others are not at the same parameters at all\n"
            "crossings, or their weights cannot be made one there, they are run through at another pace within half the tolerance,\n"
            "a length, by default 2^-20 of the size; otherwise nothing is rounded, and curves of a patch give it back where they\n"
            "are as many as its control points in one direction. Where both outermost ones of a direction are at different paces,\n"
            "that of the one given first is kept: paces of what is returned tells how far the other is off. If all curves of a\n"
            "direction are closed, the surface is, also through two or three of the others, and begins where the outermost one does.\n\n"
            "neighbors are (patch, side, 'G1'): the surface continues each, in its tangent planes to 1e-4 radians, over the\n"
            "outermost curve that lies on that side; rational curves become polynomials then, and all must leave it in these planes.\n\n"
            "gap, a length, is how far curves may pass one another, by default the tolerance; where it is given the surface may lie\n"
            "farther from them by up to 8 times the largest distance at which two do.\n\n"
            "InvalidShape names curves that do not meet once or in the order of the others, and says how near they come, that are\n"
            "a point or cross another one where a third does, fewer than four closed ones across as few, or a neighbor\n"
            "that lies along none of the outermost curves; ToleranceNotReached.");
}

}  // namespace bindings
