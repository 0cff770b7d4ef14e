#pragma once

#include <cstddef>

#include "splinecore/exchange/json.hpp"

namespace bindings {

// Equal values have equal hashes; zeros of both signs are equal.
std::size_t hash_of(const splinecore::KnotVector& knots);
std::size_t hash_of(const splinecore::BezierCurve& curve);
std::size_t hash_of(const splinecore::HermiteCurve& curve);
std::size_t hash_of(const splinecore::NurbsCurve& curve);
std::size_t hash_of(const splinecore::PowerCurve& curve);
std::size_t hash_of(const splinecore::BezierPatch& patch);
std::size_t hash_of(const splinecore::HermitePatch& patch);
std::size_t hash_of(const splinecore::NurbsPatch& patch);
std::size_t hash_of(const splinecore::PatchSet& set);
std::size_t hash_of(const splinecore::Region& region);

}  // namespace bindings
