#include "finding.hpp"
#include "mesh_checks.hpp"
#include "shapes.hpp"
#include "splinecore/exchange/json.hpp"
#include "splinecore/patch/panels.hpp"
#include "targets.hpp"

namespace splinecore::fuzz {

namespace {

/// Numbers that agree as a rule: each is changed where a byte says so.
IndexedPatch indexed_patch(Bytes& bytes, std::size_t pool) {
  IndexedPatch patch;
  patch.kind = static_cast<PatchKind>(bytes.integer(0, 2));
  patch.count_u = bytes.integer(1, 6);
  patch.count_v = bytes.integer(1, 6);
  if (patch.kind == PatchKind::nurbs) {
    patch.degree_u = bytes.integer(1, patch.count_u);
    patch.degree_v = bytes.integer(1, patch.count_v);
    patch.periodic_u = bytes.integer(0, 3) == 0;
    patch.periodic_v = bytes.integer(0, 3) == 0;
  }
  const auto knot_count = [&](int count, int degree, bool periodic) -> std::size_t {
    if (patch.kind == PatchKind::bezier) return 0;
    if (patch.kind == PatchKind::hermite) return count;
    return periodic ? count + 1 : count + degree + 1;
  };
  patch.knots_u = increasing(bytes, knot_count(patch.count_u, patch.degree_u, patch.periodic_u));
  patch.knots_v = increasing(bytes, knot_count(patch.count_v, patch.degree_v, patch.periodic_v));
  const int nets = patch.kind == PatchKind::hermite ? 4 : 1;
  patch.indices.resize(static_cast<std::size_t>(nets * patch.count_u * patch.count_v));
  for (int& index : patch.indices) index = static_cast<int>(bytes.byte() % std::max<std::size_t>(pool, 1));
  return patch;
}

int other_number(Bytes& bytes) {
  constexpr std::array kOthers{0, -1, 1, 2, 255, 256, 257, 65535, 2147483647, -2147483647 - 1, 46341, 1 << 30};
  const std::uint8_t tag = bytes.byte();
  return tag < kOthers.size() ? kOthers[tag] : static_cast<int>(tag) - 128;
}

/// What a damaged file may say instead.
void damage(Bytes& bytes, IndexedPatch& patch) {
  int* const fields[] = {&patch.count_u, &patch.count_v, &patch.degree_u, &patch.degree_v};
  const int what = bytes.integer(0, 9);
  if (what < 4) *fields[what] = other_number(bytes);
  if (what == 4) patch.periodic_u = !patch.periodic_u;
  if (what == 5) patch.periodic_v = !patch.periodic_v;
  if (what == 6) patch.kind = static_cast<PatchKind>(bytes.integer(0, 2));
  if (what == 7) patch.knots_u = numbers(bytes, bytes.integer(0, 12));
  if (what == 8) patch.knots_v = numbers(bytes, bytes.integer(0, 12));
  if (what == 9) {
    patch.indices.resize(bytes.byte());
    if (!patch.indices.empty()) patch.indices[bytes.byte() % patch.indices.size()] = other_number(bytes);
  }
}

}  // namespace

void definition(Input data) {
  Bytes bytes(data);
  const bool is_adaptive = bytes.integer(0, 7) == 0;
  std::vector<glm::dvec4> pool = points(bytes, bytes.integer(0, 40));
  std::vector<IndexedPatch> patches;
  const int count = bytes.integer(0, 3);
  for (int i = 0; i < count; ++i) {
    patches.push_back(indexed_patch(bytes, pool.size()));
    for (int times = bytes.integer(0, 7) - 5; times > 0; --times) damage(bytes, patches.back());
  }
  attempt([&] {
    const PatchSet set = PatchSet::make(std::move(pool), std::move(patches));
    const Document document = Value(set);
    demand(from_json(to_json(document)) == document, "a set's text is read as another");
    demand(flipped(flipped(set)) == set, "a set flipped twice is another");
    check_small_meshes(set, is_adaptive);
  });
}

}  // namespace splinecore::fuzz
