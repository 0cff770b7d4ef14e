#include <numbers>

#include "finding.hpp"
#include "mesh_checks.hpp"
#include "patch_steps.hpp"
#include "shapes.hpp"
#include "splinecore/build/sweeps.hpp"
#include "splinecore/patch/panels.hpp"
#include "targets.hpp"

namespace splinecore::fuzz {

namespace {

/// A patch; its parts before and after a parameter, which have a side in common; a surface of revolution.
void add_some(Bytes& bytes, std::vector<AnyPatch>& patches) {
  const int kind = bytes.integer(0, 3);
  if (kind == 3) {
    const NurbsCurve profile = nurbs_curve(bytes);
    const glm::dvec3 origin = vector(bytes);
    const glm::dvec3 direction = vector(bytes);
    patches.emplace_back(revolve(profile, origin, direction));
    return;
  }
  const NurbsPatch one = nurbs_patch(bytes);
  if (kind != 2) {
    patches.emplace_back(one);
    return;
  }
  const Axis along = axis(bytes);
  const auto parts = split(one, along, parameter(bytes, one.knot_vector(along)));
  patches.emplace_back(parts.first);
  patches.emplace_back(bytes.flag() ? reversed(parts.second, axis(bytes)) : parts.second);
}

PatchSet set_of(Bytes& bytes) {
  std::vector<AnyPatch> patches;
  const int count = bytes.integer(1, 3);
  for (int i = 0; i < count; ++i) add_some(bytes, patches);
  const PatchSet set = PatchSet::of(patches, bytes.flag());
  return bytes.integer(0, 3) == 0 ? flipped(set) : set;
}

void check_edges(const PatchSet& set) {
  const std::vector<int> counts = side_counts(panels_of(set));
  for (const int count : counts) demand(count >= 1, "an edge has no side");
  for (const SharedEdge& edge : shared_edges(set)) {
    demand(edge.first_patch < set.patches().size() && edge.second_patch < set.patches().size(),
           "an edge names no patch");
  }
}

}  // namespace

void tessellation(Input data) {
  Bytes bytes(data);
  const bool is_adaptive = bytes.integer(0, 3) == 0;
  const int resolution_u = bytes.integer(0, 12);
  const int resolution_v = bytes.integer(0, 12);
  const double distance = bytes.tolerance() * 10.0;
  const double angle = bytes.within({0.0, std::numbers::pi / 2});
  attempt([&] {
    const PatchSet set = set_of(bytes);
    check_edges(set);
    const Tessellation mesh = is_adaptive ? Tessellation::adaptive(set, {distance, angle})
                                          : Tessellation::make(set, resolution_u, resolution_v);
    check_mesh(mesh, set);
    const PatchSet moved = set.with_points(points(bytes, set.points().size()));
    if (mesh.fits(moved)) check_mesh(mesh, moved);
  });
}

}  // namespace splinecore::fuzz
