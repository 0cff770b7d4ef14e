#include "splinecore/tessellate/tessellation.hpp"

#include <cmath>
#include <utility>
#include <variant>

#include "arrays.hpp"
#include "classes.hpp"
#include "long_calls.hpp"
#include "output.hpp"
#include "result_pickles.hpp"
#include "rooms.hpp"
#include "values.hpp"
#include "views.hpp"

namespace bindings {

using splinecore::InvalidShape;
using splinecore::PatchSet;

namespace {

/// A mesh, and what it was made of, from which another process makes it again.
struct Tessellation : splinecore::Tessellation {
  using Resolutions = std::pair<int, int>;

  PatchSet set;
  std::variant<Resolutions, splinecore::Fineness> finely;

  static Tessellation of(const PatchSet& set, const Resolutions& resolutions) {
    return {{make(set, resolutions.first, resolutions.second)}, set, resolutions};
  }
  static Tessellation of(const PatchSet& set, const splinecore::Fineness& fineness, int threads = 0) {
    return {{adaptive(set, fineness, threads)}, set, fineness};
  }
};

py::object state_of(const Tessellation& self) {
  if (const auto* resolutions = std::get_if<Tessellation::Resolutions>(&self.finely)) {
    return py::make_tuple(self.set, resolutions->first, resolutions->second);
  }
  const auto& fineness = std::get<splinecore::Fineness>(self.finely);
  return py::make_tuple(self.set, fineness.distance, fineness.angle, fineness.smallest);
}

Tessellation made_of_state(const py::object& state) {
  const bool is_adaptive = py::isinstance<py::tuple>(state) && py::len(state) == 4;
  const py::tuple parts = state_of_size(state, is_adaptive ? 4 : 3);
  const PatchSet set = StateOf<PatchSet>::to(parts[0]);
  if (is_adaptive) {
    const splinecore::Fineness fineness{StateOf<double>::to(parts[1]), StateOf<double>::to(parts[2]),
                                        StateOf<double>::to(parts[3])};
    return unlocked([&] { return Tessellation::of(set, fineness); });
  }
  const Tessellation::Resolutions resolutions{StateOf<int>::to(parts[1]), StateOf<int>::to(parts[2])};
  return unlocked([&] { return Tessellation::of(set, resolutions); });
}

const PatchSet& set_of(const py::object& value, const char* name = "patch_set") {
  if (py::isinstance<PatchSet>(value)) return py::cast<const PatchSet&>(value);
  throw py::type_error(std::string(name) + " must be a PatchSet, not " + type_name(value));
}

/// Faces in each span along u and v: one number for both, or a pair.
std::pair<int, int> resolutions_of(const py::object& value) {
  if (!py::isinstance<py::tuple>(value) && !py::isinstance<py::list>(value)) {
    const int both = integer(value, "resolution");
    return {both, both};
  }
  const auto [u, v] = pair_argument(value, "resolution");
  return {integer(u, "resolution"), integer(v, "resolution")};
}

/// A set with the patches that the tessellation was made for. Where their sides lie is for fits() to say.
const PatchSet& set_with_patches(const Tessellation& tessellation, const py::object& value,
                                 const char* name = "patch_set") {
  const PatchSet& set = set_of(value, name);
  if (tessellation.has_patches_of(set)) return set;
  throw InvalidShape(std::string(name) + " does not fit: its patches are others than those of the mesh");
}

/// The positions of a set; where the caller's `out` has those of the set `before`, what differs.
py::array positions(const Tessellation& self, const py::object& patch_set, const py::object& before,
                    const py::object& out) {
  const PatchSet& set = set_with_patches(self, patch_set);
  const py::object single = out.is_none() ? py::object(py::dtype::of<float>()) : py::object(py::none());
  const Output result({static_cast<py::ssize_t>(self.vertex_count()), 3}, out, single);
  if (!result.single()) throw py::type_error("out has dtype float64, float32 is expected");
  const std::span<float> to = result.floats(0, 3 * self.vertex_count());
  if (before.is_none()) {
    unlocked([&] { self.evaluate_positions(set, to); });
    return result.array();
  }
  if (out.is_none()) throw InvalidShape("before is the set whose positions out has, but there is no out");
  const PatchSet& known = set_with_patches(self, before, "before");
  unlocked([&] { self.update_positions(set, known, to); });
  return result.array();
}

bool fits(const Tessellation& self, const py::object& patch_set, const py::object& before) {
  const PatchSet& set = set_of(patch_set);
  if (before.is_none()) return unlocked([&] { return self.fits(set); });
  if (!self.has_patches_of(set)) return false;
  const PatchSet& known = set_with_patches(self, before, "before");
  return unlocked([&] { return self.still_fits(set, known); });
}

}  // namespace

void bind_tessellation(py::module_& module) {
  Class<Tessellation> cls(
      module, "Tessellation", py::module_local());
  seal(cls);
  cls.def(py::pickle(&state_of, &made_of_state));
  cls.def(py::init([](const py::object& patch_set, const py::object& resolution) {
            const PatchSet& set = set_of(patch_set);
            const Tessellation::Resolutions resolutions = resolutions_of(resolution);
            return unlocked([&] { return Tessellation::of(set, resolutions); });
          }), py::arg("patch_set"), py::arg("resolution"));
  cls.def_static("adaptive", [](const py::object& patch_set, const py::object& tolerance, const py::object& angle,
                                const py::object& smallest, const py::object& threads, const py::object& cancel) {
                   require_callable(cancel);
                   const PatchSet& set = set_of(patch_set);
                   const int most = threads_of(threads);
                   const auto allowed = [](const py::object& value, const char* name) {
                     return value.is_none() ? HUGE_VAL : real(value, name);
                   };
                   const splinecore::Fineness fineness{allowed(tolerance, "tolerance"), allowed(angle, "angle"),
                                                       real(smallest, "smallest")};
                   return unlocked([&] { return Tessellation::of(set, fineness, most); }, cancel);
                 }, py::arg("patch_set"), py::kw_only(), py::arg("tolerance") = py::none(), py::arg("angle") = py::none(),
                 py::arg("smallest") = 0.0, py::arg("threads") = 0, py::arg("cancel") = py::none());
  cls.def_property_readonly("vertex_count", [](const Tessellation& self) { return self.vertex_count(); });
  cls.def_property_readonly("face_starts", [](const py::object& self) {
    return view_of_numbers(py::cast<const Tessellation&>(self).face_starts(), self);
  });
  cls.def_property_readonly("face_patches", [](const py::object& self) {
    return view_of_numbers(py::cast<const Tessellation&>(self).face_patches(), self);
  });
  cls.def_property_readonly("corner_vertices", [](const py::object& self) {
    return view_of_numbers(py::cast<const Tessellation&>(self).corner_vertices(), self);
  });
  cls.def_property_readonly("corner_uvs", [](const py::object& self) {
    const auto uvs = py::cast<const Tessellation&>(self).corner_uvs();
    return view_of_numbers(uvs, {static_cast<py::ssize_t>(uvs.size() / 2), 2}, self);
  });
  cls.def("fits", &fits, py::arg("patch_set"), py::arg("before") = py::none());
  cls.def("evaluate", [](const Tessellation& self, const py::object& patch_set) {
            const PatchSet& set = set_with_patches(self, patch_set);
            py::array_t<float> positions({static_cast<py::ssize_t>(self.vertex_count()), py::ssize_t{3}});
            py::array_t<float> normals({static_cast<py::ssize_t>(self.corner_vertices().size()), py::ssize_t{3}});
            const std::span to_positions(positions.mutable_data(), positions.size());
            const std::span to_normals(normals.mutable_data(), normals.size());
            unlocked([&] { self.evaluate(set, to_positions, to_normals); });
            return py::make_tuple(positions, normals);
          }, py::arg("patch_set"));
  cls.def("evaluate_positions", &positions, py::arg("patch_set"), py::kw_only(), py::arg("before") = py::none(),
          py::arg("out") = py::none());
  cls.def("sharp_edges", [](const Tessellation& self, const py::object& normals, const py::object& angle) {
            const py::array_t<float, py::array::c_style | py::array::forcecast> given(real_array(normals, "normals"));
            const auto corners = static_cast<py::ssize_t>(self.corner_vertices().size());
            if (given.ndim() != 2 || given.shape(0) != corners || given.shape(1) != 3) {
              throw InvalidShape("normals has shape " + shape_text(given) + ", (" +
                                 std::to_string(corners) + ", 3) is expected: one row for each corner");
            }
            const std::span rows(given.data(), static_cast<std::size_t>(given.size()));
            const double most = real(angle, "angle");
            const std::vector<std::int32_t> pairs = unlocked([&] { return self.sharp_edges(rows, most); });
            py::array_t<std::int32_t> edges({static_cast<py::ssize_t>(pairs.size() / 2), py::ssize_t{2}});
            std::ranges::copy(pairs, edges.mutable_data());
            return edges;
          }, py::arg("normals"), py::arg("angle"));
  cls.def("__repr__", [](const Tessellation& self) {
    return "Tessellation(patches=" + std::to_string(self.set.patches().size()) + ", vertices=" + std::to_string(self.vertex_count()) +
           ", faces=" + std::to_string(self.face_starts().size()) + ")";
  });
}

}  // namespace bindings
