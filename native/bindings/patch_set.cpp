#include <cmath>

#include <array>

#include "arrays.hpp"
#include "classes.hpp"
#include "long_calls.hpp"
#include "patch_evaluation.hpp"
#include "rooms.hpp"
#include "splinecore/patch/panels.hpp"
#include "splinecore/patch/patch_set.hpp"
#include "values.hpp"
#include "views.hpp"

namespace bindings {

using splinecore::IndexedPatch;
using splinecore::InvalidShape;
using splinecore::PatchKind;
using splinecore::PatchSet;

namespace {

const char* name_of(PatchKind kind) {
  switch (kind) {
    case PatchKind::bezier: return "bezier";
    case PatchKind::hermite: return "hermite";
    default: return "nurbs";
  }
}

PatchKind kind_of(const py::object& value) {
  if (py::isinstance<py::str>(value)) {
    const std::string text = py::str(value);
    if (text == "bezier") return PatchKind::bezier;
    if (text == "hermite") return PatchKind::hermite;
    if (text == "nurbs") return PatchKind::nurbs;
  }
  throw InvalidShape("kind = " + std::string(py::repr(value)) + " is none of 'bezier', 'hermite', 'nurbs'");
}

using Indices = py::array_t<std::int32_t, py::array::c_style | py::array::forcecast>;

/// @throws InvalidShape unless every element fits the index of a row.
void require_rows(const py::array& indices) {
  const py::array_t<std::int64_t, py::array::c_style | py::array::forcecast> wide(indices);
  for (py::ssize_t i = 0; i < wide.size(); ++i) {
    const std::int64_t index = wide.data()[i];  // of an unsigned number above 2^63: negative
    if (index >= 0 && index <= 2147483647) continue;
    throw InvalidShape("indices" + place_text(indices, i) + " = " +
                       std::string(py::str(indices.attr("flat")[py::int_(i)])) + " is outside the pool");
  }
}

Indices index_array(const py::object& value, int dimensions) {
  const py::array given = array_of(value, "indices");
  const char kind = given.dtype().kind();
  if (kind != 'i' && kind != 'u') {
    throw py::type_error("indices has dtype " + std::string(py::str(given.dtype())) + ", integers are expected");
  }
  if (given.ndim() != dimensions) {
    throw InvalidShape("indices has shape " + shape_text(given) + ", " + std::to_string(dimensions) +
                       " dimensions are expected");
  }
  require_rows(given);
  return Indices(given);
}

py::object entry(const py::dict& fields, const char* name) {
  if (!fields.contains(name)) throw InvalidShape(std::string(name) + " is missing");
  return fields[name];
}

/// {"kind", "indices"} and what the kind needs more; or the indices alone, of a Bezier patch.
IndexedPatch indexed_patch(const py::object& value) {
  py::dict fields;
  if (py::isinstance<py::dict>(value)) {
    fields = value;
  } else {
    fields["kind"] = "bezier";
    fields["indices"] = value;
  }
  IndexedPatch patch;
  patch.kind = kind_of(entry(fields, "kind"));
  const bool hermite = patch.kind == PatchKind::hermite;
  const auto indices = index_array(entry(fields, "indices"), hermite ? 3 : 2);
  if (hermite && indices.shape(0) != 4) {
    throw InvalidShape("indices has shape " + shape_text(indices) +
                       ", (4, nu, nv) is expected: points, tangents u, tangents v, twists");
  }
  patch.count_u = static_cast<int>(indices.shape(hermite ? 1 : 0));
  patch.count_v = static_cast<int>(indices.shape(hermite ? 2 : 1));
  patch.indices.assign(indices.data(), indices.data() + indices.size());
  if (patch.kind == PatchKind::bezier) return patch;
  const auto pair = [&](const char* name) { return pair_argument(entry(fields, name), name); };
  const char* knots = hermite ? "parameters" : "knots";
  patch.knots_u = numbers(pair(knots).first, knots);
  patch.knots_v = numbers(pair(knots).second, knots);
  if (hermite) return patch;
  patch.degree_u = integer(pair("degree").first, "degree");
  patch.degree_v = integer(pair("degree").second, "degree");
  if (fields.contains("periodic")) {
    patch.periodic_u = boolean(pair("periodic").first, "periodic");
    patch.periodic_v = boolean(pair("periodic").second, "periodic");
  }
  return patch;
}

/// The patch as the constructor takes it; its arrays are read-only views that keep `owner` alive.
py::dict fields_of(const IndexedPatch& patch, const py::object& owner) {
  py::dict fields;
  fields["kind"] = name_of(patch.kind);
  Shape shape{patch.count_u, patch.count_v};
  if (patch.kind == PatchKind::hermite) shape.insert(shape.begin(), 4);
  fields["indices"] = view_of_numbers(std::span<const int>(patch.indices), shape, owner);
  const auto array = [&](const std::vector<double>& values) {
    return view_of_numbers(std::span<const double>(values), owner);
  };
  if (patch.kind == PatchKind::hermite) {
    fields["parameters"] = py::make_tuple(array(patch.knots_u), array(patch.knots_v));
  }
  if (patch.kind == PatchKind::nurbs) {
    fields["degree"] = py::make_tuple(patch.degree_u, patch.degree_v);
    fields["knots"] = py::make_tuple(array(patch.knots_u), array(patch.knots_v));
    fields["periodic"] = py::make_tuple(patch.periodic_u, patch.periodic_v);
  }
  return fields;
}

py::sequence sequence_of(const py::object& value, const char* name) {
  if (!py::isinstance<py::sequence>(value) || py::isinstance<py::str>(value)) {
    throw py::type_error(std::string(name) + " must be a list of patches");
  }
  return value;
}

PatchSet patch_set(const py::object& points, const py::object& patches, const py::object& weights) {
  std::vector<IndexedPatch> all;
  for (const py::handle& patch : sequence_of(patches, "patches")) {
    try {
      all.push_back(indexed_patch(py::reinterpret_borrow<py::object>(patch)));
    } catch (const InvalidShape& error) {
      throw InvalidShape("patches" + splinecore::index_text(all.size()) + ": " + error.what());
    } catch (const py::type_error& error) {
      throw py::type_error("patches" + splinecore::index_text(all.size()) + ": " + error.what());
    }
  }
  std::vector<glm::dvec4> pool = weighted_points(real_array(points, "points"), weights, 1);
  return unlocked([&] { return PatchSet::make(std::move(pool), std::move(all)); });
}

py::dict edge_counts(const PatchSet& set) {
  const std::vector<splinecore::Panel> panels = unlocked([&] { return splinecore::panels_of(set); });
  const std::vector<int> sides = splinecore::side_counts(panels);
  int poles = 0;
  for (const splinecore::Panel& panel : panels) {
    poles += static_cast<int>(std::ranges::count(panel.sides, -1, &splinecore::PanelSide::edge));
  }
  const auto free_count = std::ranges::count(sides, 1);
  py::dict counts;
  counts["shared"] = static_cast<int>(sides.size()) - free_count;
  counts["free"] = free_count;
  counts["pole"] = poles;
  return counts;
}

py::list seams(const PatchSet& set) {
  const auto side = [](std::size_t patch, splinecore::Border border) {
    constexpr std::array<const char*, 4> kNames{"u_start", "u_end", "v_start", "v_end"};
    return py::make_tuple(patch, kNames[static_cast<std::size_t>(border)]);
  };
  py::list found;
  for (const splinecore::SharedEdge& edge : unlocked([&] { return splinecore::shared_edges(set); })) {
    found.append(py::make_tuple(side(edge.first_patch, edge.first), side(edge.second_patch, edge.second)));
  }
  return found;
}

}  // namespace

void bind_patch_set(py::module_& module) {
  Class<PatchSet> cls(
      module, "PatchSet", py::module_local());
  cls.def(py::init(&patch_set), py::arg("points"), py::arg("patches"), py::arg("weights") = py::none());
  cls.def_static("from_patches", [](const py::object& patches, const py::object& merge) {
                   std::vector<splinecore::AnyPatch> all;
                   for (const py::handle& item : sequence_of(patches, "patches")) {
                     std::optional<splinecore::AnyPatch> patch;
                     if (!unwrap(item, patch)) {
                       throw py::type_error("patches" + splinecore::index_text(all.size()) +
                                            " is no BezierPatch, HermitePatch or NurbsPatch");
                     }
                     all.push_back(*patch);
                   }
                   if (all.empty()) throw InvalidShape("patches is empty: a set has one or more");
                   const bool is_merged = boolean(merge, "merge");
                   return unlocked([&] { return PatchSet::of(all, is_merged); });
                 },
                 py::arg("patches"), py::arg("merge") = true);
  bind_value(cls);
  cls.def_property_readonly("points", [](const py::object& self) {
    const auto points = py::cast<const PatchSet&>(self).points();
    return view_of_points(points, {static_cast<py::ssize_t>(points.size())}, self);
  });
  cls.def_property_readonly("weights", [](const py::object& self) {
    const auto points = py::cast<const PatchSet&>(self).points();
    return view_of_weights(points, {static_cast<py::ssize_t>(points.size())}, self);
  });
  cls.def_property_readonly("patches", [](const py::object& self) {
    py::list all;
    for (const IndexedPatch& patch : py::cast<const PatchSet&>(self).patches()) all.append(fields_of(patch, self));
    return all;
  });
  cls.def("__len__", [](const PatchSet& self) { return self.patches().size(); });
  cls.def("__getitem__", [](const PatchSet& self, const py::object& i) {
    const int index = integer(i, "i");
    const int count = static_cast<int>(self.patches().size());
    if (index < -count || index >= count) throw py::index_error("i = " + std::to_string(index) + " is outside the set");
    return wrap(self.patch(index < 0 ? index + count : index));
  }, py::arg("i"));
  cls.def("with_points", [](const PatchSet& self, const py::object& points, const py::object& weights) {
            const Doubles given = real_array(points, "points");
            auto rows = weighted_points(given, weights, 1);
            if (weights.is_none()) {
              require_net(given, "points", {static_cast<py::ssize_t>(self.points().size())});
              for (std::size_t i = 0; i < rows.size(); ++i) rows[i].w = self.points()[i].w;
            }
            return unlocked([&] { return self.with_points(std::move(rows)); });
          }, py::arg("points"), py::arg("weights") = py::none());
  cls.def("evaluate_grid", [](const PatchSet& self, const py::object& u, const py::object& v, const py::object& side,
                              const py::object& at_infinity, const py::object& dtype, const py::object& out,
                              const py::object& threads, const py::object& cancel) {
            return evaluate_grid(self, u, v, side, at_infinity, dtype, out, threads, cancel);
          },
          py::arg("u"), py::arg("v"), py::kw_only(), py::arg("side") = "right", py::arg("at_infinity") = "raise",
          py::arg("dtype") = py::none(), py::arg("out") = py::none(), py::arg("threads") = 0,
          py::arg("cancel") = py::none());
  cls.def("evaluate_grid_with_normals",
          [](const PatchSet& self, const py::object& u, const py::object& v, const py::object& side,
             const py::object& at_infinity, const py::object& dtype, const py::object& out, const py::object& threads,
             const py::object& cancel) {
            return evaluate_grid_with_normals(self, u, v, side, at_infinity, dtype, out, threads, cancel);
          },
          py::arg("u"), py::arg("v"), py::kw_only(), py::arg("side") = "right", py::arg("at_infinity") = "raise",
          py::arg("dtype") = py::none(), py::arg("out") = py::none(), py::arg("threads") = 0,
          py::arg("cancel") = py::none());
  cls.def("flipped", [](const PatchSet& self) { return unlocked([&] { return splinecore::flipped(self); }); });
  cls.def("edge_counts", &edge_counts);
  cls.def("seams", &seams);
  cls.def("__repr__", [](const PatchSet& self) {
    return "PatchSet(patches=" + std::to_string(self.patches().size()) + ", points=" + std::to_string(self.points().size()) + ")";
  });
}

}  // namespace bindings
