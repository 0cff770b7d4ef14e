#include <cstddef>
#include <optional>
#include <vector>

#include "approximation.hpp"
#include "arguments.hpp"
#include "classes.hpp"
#include "every_kind.hpp"
#include "long_calls.hpp"
#include "neighbors.hpp"
#include "pairs.hpp"
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
  Class<NetworkSurface> cls(module, "NetworkSurface", py::module_local());
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
  bind_pair(cls);
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
            py::arg("cancel") = py::none());
  build.def("network", [](const py::object& along_u, const py::object& along_v, const py::object& neighbors,
                          const py::object& tolerance, const py::object& gap, const py::object& cancel) {
              const std::vector<NurbsCurve> u = any_curves(along_u, "along_u");
              const std::vector<NurbsCurve> v = any_curves(along_v, "along_v");
              const auto beyond = neighbors_of(neighbors);
              const auto within = tolerance_of(tolerance);
              const auto between = tolerance_of(gap, "gap");
              return unlocked([&] { return splinecore::network(u, v, within, beyond, between); }, cancel);
            }, py::arg("along_u"), py::arg("along_v"), py::kw_only(), py::arg("neighbors") = py::none(),
            py::arg("tolerance") = py::none(), py::arg("gap") = py::none(), py::arg("cancel") = py::none());
}

}  // namespace bindings
