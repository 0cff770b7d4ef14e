#include "hashes.hpp"

#include <bit>
#include <cstdint>

namespace bindings {

using splinecore::Axis;

namespace {

/// Takes numbers in one after the other. The mixing is that of MurmurHash3's finaliser (A. Appleby).
class Hash {
 public:
  explicit Hash(std::uint64_t kind) { add(kind); }

  void add(std::uint64_t bits) {
    state_ = (state_ ^ bits) + 0x9E3779B97F4A7C15;
    state_ = (state_ ^ (state_ >> 33)) * 0xFF51AFD7ED558CCD;
    state_ ^= state_ >> 33;
  }
  void add(int number) { add(static_cast<std::uint64_t>(number)); }
  void add(double number) { add(std::bit_cast<std::uint64_t>(number == 0.0 ? 0.0 : number)); }
  void add(const glm::dvec3& v) {
    for (int axis = 0; axis < 3; ++axis) add(v[axis]);
  }
  void add(const glm::dvec4& p) {
    for (int axis = 0; axis < 4; ++axis) add(p[axis]);
  }
  void add(const splinecore::Tangents& tangents) {
    add(tangents.incoming);
    add(tangents.outgoing);
  }
  void add(const splinecore::KnotVector& knots) {
    add(knots.degree());
    add(static_cast<int>(knots.periodic()));
    add_all(knots.knots());
  }
  /// How many there are counts, too: two lists are not one.
  template <class Values>
  void add_all(const Values& values) {
    add(static_cast<std::uint64_t>(values.size()));
    for (const auto& value : values) add(value);
  }

  std::size_t value() const noexcept { return state_; }

 private:
  std::uint64_t state_ = 0;
};

enum Kind : std::uint64_t {
  knot_vector, bezier_curve, hermite_curve, nurbs_curve, power_curve, bezier_patch, hermite_patch, nurbs_patch, patch_set, region
};

}  // namespace

std::size_t hash_of(const splinecore::KnotVector& knots) {
  Hash hash(knot_vector);
  hash.add(knots);
  return hash.value();
}

std::size_t hash_of(const splinecore::BezierCurve& curve) {
  Hash hash(bezier_curve);
  hash.add_all(curve.points());
  return hash.value();
}

std::size_t hash_of(const splinecore::HermiteCurve& curve) {
  Hash hash(hermite_curve);
  hash.add_all(curve.points());
  hash.add_all(curve.tangents());
  hash.add_all(curve.parameters());
  return hash.value();
}

std::size_t hash_of(const splinecore::NurbsCurve& curve) {
  Hash hash(nurbs_curve);
  hash.add(curve.knot_vector());
  hash.add_all(curve.points());
  return hash.value();
}

std::size_t hash_of(const splinecore::PowerCurve& curve) {
  Hash hash(power_curve);
  hash.add_all(curve.coefficients());
  hash.add(curve.origin());
  hash.add(curve.domain().start);
  hash.add(curve.domain().end);
  return hash.value();
}

std::size_t hash_of(const splinecore::BezierPatch& patch) {
  Hash hash(bezier_patch);
  hash.add(patch.count(Axis::u));
  hash.add_all(patch.points());
  return hash.value();
}

std::size_t hash_of(const splinecore::HermitePatch& patch) {
  Hash hash(hermite_patch);
  for (const Axis axis : {Axis::u, Axis::v}) hash.add_all(patch.parameters(axis));
  const splinecore::HermiteNet& net = patch.net();
  for (const auto* list : {&net.points, &net.tangents_u, &net.tangents_v, &net.twists}) {
    hash.add_all(*list);
  }
  return hash.value();
}

std::size_t hash_of(const splinecore::NurbsPatch& patch) {
  Hash hash(nurbs_patch);
  for (const Axis axis : {Axis::u, Axis::v}) hash.add(patch.knot_vector(axis));
  hash.add_all(patch.points());
  return hash.value();
}

std::size_t hash_of(const splinecore::PatchSet& set) {
  Hash hash(patch_set);
  hash.add_all(set.points());
  for (const splinecore::IndexedPatch& patch : set.patches()) {
    hash.add(static_cast<int>(patch.kind));
    for (const int number : {patch.count_u, patch.count_v, patch.degree_u, patch.degree_v}) hash.add(number);
    for (const bool flag : {patch.periodic_u, patch.periodic_v}) hash.add(static_cast<int>(flag));
    hash.add_all(patch.indices);
    hash.add_all(patch.knots_u);
    hash.add_all(patch.knots_v);
  }
  return hash.value();
}

std::size_t hash_of(const splinecore::Region& region) {
  Hash hash(Kind::region);
  hash.add(region.normal());
  for (const splinecore::NurbsCurve& outline : region.outlines()) hash.add(static_cast<std::uint64_t>(hash_of(outline)));
  return hash.value();
}

}  // namespace bindings
