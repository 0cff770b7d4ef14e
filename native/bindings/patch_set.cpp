#include <cmath>

#include <array>

#include "arrays.hpp"
#include "long_calls.hpp"
#include "patch_evaluation.hpp"
#include "rooms.hpp"
#include "splinecore/patch/panels.hpp"
#include "splinecore/patch/patch_set.hpp"
#include "splinecore/tessellate/tessellation.hpp"
#include "values.hpp"

namespace bindings {

using splinecore::AnyPatch;
using splinecore::IndexedPatch;
using splinecore::InvalidShape;
using splinecore::PatchKind;
using splinecore::PatchSet;
using splinecore::Tessellation;

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

void bind_set(py::module_& module) {
  py::class_<PatchSet> cls(
      module, "PatchSet", py::module_local(),
      "PatchSet(points, patches, weights=None)\n\n"
      "Many patches on one pool of points (n, 2 or 3) with weights (n,), so that neighbours share them.\n"
      "A patch is an (nu, nv) array of rows of the pool (Bezier), or a dict: kind 'bezier', 'hermite' or\n"
      "'nurbs', indices, and for NURBS degree, knots and periodic (pairs), for Hermite parameters and\n"
      "indices (4, nu, nv) of points (w = 1), tangents along u, along v and twists (w = 0).");
  cls.def(py::init(&patch_set), py::arg("points"), py::arg("patches"), py::arg("weights") = py::none());
  cls.def_static("from_patches", [](const py::object& patches, const py::object& merge) {
                   std::vector<AnyPatch> all;
                   for (const py::handle& item : sequence_of(patches, "patches")) {
                     std::optional<AnyPatch> patch;
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
                 py::arg("patches"), py::arg("merge") = true,
                 "A set with the patches' own points as its pool; points equal in every bit become one.");
  bind_value(cls);
  cls.def_property_readonly("points", [](const py::object& self) {
    const auto points = py::cast<const PatchSet&>(self).points();
    return view_of_points(points, {static_cast<py::ssize_t>(points.size())}, self);
  }, "(n, 3) float64, the pool, read-only.");
  cls.def_property_readonly("weights", [](const py::object& self) {
    const auto points = py::cast<const PatchSet&>(self).points();
    return view_of_weights(points, {static_cast<py::ssize_t>(points.size())}, self);
  }, "(n,) float64, read-only.");
  cls.def_property_readonly("patches", [](const py::object& self) {
    py::list all;
    for (const IndexedPatch& patch : py::cast<const PatchSet&>(self).patches()) all.append(fields_of(patch, self));
    return all;
  }, "A dict for each patch, as the constructor takes them.");
  cls.def("__len__", [](const PatchSet& self) { return self.patches().size(); });
  cls.def("__getitem__", [](const PatchSet& self, const py::object& i) {
    const int index = integer(i, "i");
    const int count = static_cast<int>(self.patches().size());
    if (index < -count || index >= count) throw py::index_error("i = " + std::to_string(index) + " is outside the set");
    return wrap(self.patch(index < 0 ? index + count : index));
  }, py::arg("i"), "Patch i as a BezierPatch, HermitePatch or NurbsPatch.");
  cls.def("with_points", [](const PatchSet& self, const py::object& points, const py::object& weights) {
            const Doubles given = real_array(points, "points");
            auto rows = weighted_points(given, weights, 1);
            if (weights.is_none()) {
              require_net(given, "points", {static_cast<py::ssize_t>(self.points().size())});
              for (std::size_t i = 0; i < rows.size(); ++i) rows[i].w = self.points()[i].w;
            }
            return unlocked([&] { return self.with_points(std::move(rows)); });
          }, py::arg("points"), py::arg("weights") = py::none(),
          "The same patches on another pool. Weights are kept unless given; a pool of another size needs them.");
  cls.def("evaluate_grid", [](const PatchSet& self, const py::object& u, const py::object& v, const py::object& side,
                              const py::object& at_infinity, const py::object& dtype, const py::object& out,
                              const py::object& threads, const py::object& cancel) {
            return evaluate_grid(self, u, v, side, at_infinity, dtype, out, threads, cancel);
          },
          py::arg("u"), py::arg("v"), py::kw_only(), py::arg("side") = "right", py::arg("at_infinity") = "raise",
          py::arg("dtype") = py::none(), py::arg("out") = py::none(), py::arg("threads") = 0,
          py::arg("cancel") = py::none(),
          "evaluate_grid() of every patch in one call: (patches, a, b, 3). u and v lie in the domain of each.");
  cls.def("evaluate_grid_with_normals",
          [](const PatchSet& self, const py::object& u, const py::object& v, const py::object& side,
             const py::object& at_infinity, const py::object& dtype, const py::object& out, const py::object& threads,
             const py::object& cancel) {
            return evaluate_grid_with_normals(self, u, v, side, at_infinity, dtype, out, threads, cancel);
          },
          py::arg("u"), py::arg("v"), py::kw_only(), py::arg("side") = "right", py::arg("at_infinity") = "raise",
          py::arg("dtype") = py::none(), py::arg("out") = py::none(), py::arg("threads") = 0,
          py::arg("cancel") = py::none(),
          "evaluate_grid_with_normals() of every patch in one call: two arrays (patches, a, b, 3).");
  cls.def("flipped", [](const PatchSet& self) { return unlocked([&] { return splinecore::flipped(self); }); },
          "All patches seen from the other side: u and v exchanged.");
  cls.def("edge_counts", &edge_counts,
          "{'shared', 'free', 'pole'}: how the sides of the patches meet. An edge counts once, however many sides lie\n"
          "on it; a pole is a side shrunk to a point. Two sides are one edge where they are one curve at equal scaled\n"
          "parameters, to 1e-10 of the extent of all points, whatever their degrees and knots.");
  cls.def("seams", &seams,
          "[((patch, side), (patch, side)), ...]: the whole sides that are one edge, as of edge_counts(); sides are\n"
          "named as by boundary().");
  cls.def("__repr__", [](const PatchSet& self) {
    return "PatchSet(patches=" + std::to_string(self.patches().size()) + ", points=" + std::to_string(self.points().size()) + ")";
  });
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

void bind_tessellation(py::module_& module) {
  py::class_<Tessellation> cls(
      module, "Tessellation", py::module_local(),
      "Tessellation(patch_set, resolution)\n\n"
      "The mesh of a patch set, resolution (an int or a pair) faces in every span, everything but\n"
      "positions: made once, evaluated for any position of the points. Vertices are shared along common\n"
      "edges, a pole is one vertex, faces are wound along S_u x S_v. Lecture row S22.");
  seal(cls);
  cls.def(py::init([](const py::object& patch_set, const py::object& resolution) {
            const PatchSet& set = set_of(patch_set);
            const auto [u, v] = resolutions_of(resolution);
            return unlocked([&] { return Tessellation::make(set, u, v); });
          }), py::arg("patch_set"), py::arg("resolution"));
  cls.def_static("adaptive", [](const py::object& patch_set, const py::object& tolerance, const py::object& angle,
                                const py::object& threads, const py::object& cancel) {
                   require_callable(cancel);
                   const PatchSet& set = set_of(patch_set);
                   const int most = threads_of(threads);
                   const auto allowed = [](const py::object& value, const char* name) {
                     return value.is_none() ? HUGE_VAL : real(value, name);
                   };
                   const splinecore::Fineness fineness{allowed(tolerance, "tolerance"), allowed(angle, "angle")};
                   return unlocked([&] { return Tessellation::adaptive(set, fineness, most); }, cancel);
                 }, py::arg("patch_set"), py::kw_only(), py::arg("tolerance") = py::none(), py::arg("angle") = py::none(),
                 py::arg("threads") = 0, py::arg("cancel") = py::none(),
                 "As many faces as the shape asks for: no point of the surface farther from the mesh than tolerance (a\n"
                 "length), normals on a face no more than angle (radians) apart; None for any. Flat parts get few faces.\n"
                 "cancel: a callable, asked now and then, that returns true to end the call. threads: on how many, 0 for\n"
                 "all cores where that is worth it; the mesh is the same.\n"
                 "Crack-free wherever two sides are one curve, whatever their degrees and knots. Bounds of second\n"
                 "derivatives after Filip, Magedson and Markot 1986. Lecture row S22.");
  cls.def_property_readonly("vertex_count", &Tessellation::vertex_count);
  cls.def_property_readonly("face_starts", [](const py::object& self) {
    return view_of_numbers(py::cast<const Tessellation&>(self).face_starts(), self);
  },
                            "(f,) int32: where the corners of each face start, read-only.");
  cls.def_property_readonly("face_patches", [](const py::object& self) {
    return view_of_numbers(py::cast<const Tessellation&>(self).face_patches(), self);
  },
                            "(f,) int32: the patch of each face, read-only.");
  cls.def_property_readonly("corner_vertices", [](const py::object& self) {
    return view_of_numbers(py::cast<const Tessellation&>(self).corner_vertices(), self);
  },
                            "(c,) int32: the vertex of each corner, read-only.");
  cls.def_property_readonly("corner_uvs", [](const py::object& self) {
    const auto uvs = py::cast<const Tessellation&>(self).corner_uvs();
    return view_of_numbers(uvs, {static_cast<py::ssize_t>(uvs.size() / 2), 2}, self);
  }, "(c, 2) float32: u, v of each corner, scaled to [0, 1], read-only.");
  cls.def("fits", &fits, py::arg("patch_set"), py::arg("before") = py::none(),
          "Whether the set has the same patches, and the same of its sides lie on one another, or are points.\n"
          "before: a set that fits, with the same patches. Looked at is then only whether sides have come apart, or\n"
          "points opened, that are not one by having the same rows of the pool: where those did not move it costs nothing.");
  cls.def("evaluate", [](const Tessellation& self, const py::object& patch_set) {
            const PatchSet& set = set_with_patches(self, patch_set);
            py::array_t<float> positions({static_cast<py::ssize_t>(self.vertex_count()), py::ssize_t{3}});
            py::array_t<float> normals({static_cast<py::ssize_t>(self.corner_vertices().size()), py::ssize_t{3}});
            const std::span to_positions(positions.mutable_data(), positions.size());
            const std::span to_normals(normals.mutable_data(), normals.size());
            unlocked([&] { self.evaluate(set, to_positions, to_normals); });
            return py::make_tuple(positions, normals);
          }, py::arg("patch_set"),
          "(positions (vertex_count, 3), corner normals (c, 3)), float32, of a set with the same patches. Whether\n"
          "their sides lie on one another as they did is for fits() to say.");
  cls.def("evaluate_positions", &positions, py::arg("patch_set"), py::kw_only(), py::arg("before") = py::none(),
          py::arg("out") = py::none(),
          "The positions alone, (vertex_count, 3) float32: what a drag needs.\n"
          "out: an array of that shape to write them into. before: the set whose positions out has; then only what\n"
          "differs is computed, with the same result in every bit, and after an error out has the positions of neither.");
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
          }, py::arg("normals"), py::arg("angle"),
          "(k, 2) int32: vertices of edges across which the corner normals differ by more than angle (radians).");
}

}  // namespace

void bind_patch_set(py::module_& module) {
  bind_set(module);
  bind_tessellation(module);
}

}  // namespace bindings
