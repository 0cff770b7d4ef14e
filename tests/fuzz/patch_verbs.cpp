#include "finding.hpp"
#include "patch_steps.hpp"
#include "shapes.hpp"
#include "splinecore/build/drag.hpp"
#include "splinecore/convert/to_bezier.hpp"
#include "splinecore/convert/to_hermite.hpp"
#include "splinecore/patch/degree.hpp"
#include "splinecore/patch/ends.hpp"
#include "splinecore/patch/join.hpp"
#include "splinecore/patch/removal.hpp"
#include "splinecore/patch/transform.hpp"

namespace splinecore::fuzz {

namespace {

void take(NurbsPatch& patch, Approximation<NurbsPatch> found) {
  demand_error(found.error, "a patch");
  patch = std::move(found.value);
}

template <class Patch>
Patch one_of(Bytes& bytes, std::pair<Patch, Patch> parts) {
  return bytes.flag() ? std::move(parts.first) : std::move(parts.second);
}

std::optional<double> maybe_tolerance(Bytes& bytes) {
  return bytes.flag() ? std::optional(bytes.tolerance()) : std::nullopt;
}

BezierPatch bezier(Bytes& bytes, const NurbsPatch& patch) {
  const BezierGrid grid = to_bezier(patch);
  demand(!grid.patches.empty(), "a patch has no pieces");
  return grid.patches[bytes.byte() % grid.patches.size()];
}

/// A direction and a parameter of it.
struct Line {
  Line(Bytes& bytes, const NurbsPatch& patch)
      : along(axis(bytes)), at(parameter(bytes, patch.knot_vector(along))) {}
  Axis along;
  double at;
};

constexpr PatchStep kVerbs[] = {
    [](Bytes& bytes, NurbsPatch& patch) {
      const Axis along = axis(bytes);
      std::vector<double> inserted(bytes.integer(1, 4));
      for (double& u : inserted) u = parameter(bytes, patch.knot_vector(along));
      patch = refine(patch, along, inserted);
    },
    [](Bytes& bytes, NurbsPatch& patch) {
      const Line line(bytes, patch);
      patch = insert_knot(patch, line.along, line.at, bytes.integer(0, 4));
    },
    [](Bytes& bytes, NurbsPatch& patch) {
      const Line line(bytes, patch);
      patch = one_of(bytes, split(patch, line.along, line.at));
    },
    [](Bytes& bytes, NurbsPatch& patch) {
      const Line line(bytes, patch);
      patch = opened(patch, line.along, line.at);
    },
    [](Bytes& bytes, NurbsPatch& patch) { patch = reversed(patch, axis(bytes)); },
    [](Bytes&, NurbsPatch& patch) {
      demand(swapped(swapped(patch)) == patch, "a patch swapped twice is another");
      patch = swapped(patch);
    },
    [](Bytes&, NurbsPatch& patch) { patch = unrolled(patch); },
    [](Bytes& bytes, NurbsPatch& patch) {
      const Axis along = axis(bytes);
      patch = elevated(patch, along, bytes.integer(0, 3));
    },
    [](Bytes& bytes, NurbsPatch& patch) {
      const Axis along = axis(bytes);
      const int times = bytes.integer(0, 3);
      take(patch, reduced(patch, along, times, maybe_tolerance(bytes)));
    },
    [](Bytes& bytes, NurbsPatch& patch) {
      const Line line(bytes, patch);
      const int times = bytes.integer(0, 3);
      take(patch, remove_knot(patch, line.along, line.at, times, maybe_tolerance(bytes)));
    },
    [](Bytes& bytes, NurbsPatch& patch) {
      const Axis along = axis(bytes);
      take(patch, remove_knots(patch, along, bytes.tolerance()));
    },
    [](Bytes& bytes, NurbsPatch& patch) {
      const Axis along = axis(bytes);
      const double start = bytes.number();
      patch = with_domain(patch, along, {start, start + std::abs(bytes.number())});
    },
    [](Bytes& bytes, NurbsPatch& patch) { patch = clamped(patch, axis(bytes)); },
    [](Bytes& bytes, NurbsPatch& patch) { patch = unclamped(patch, axis(bytes)); },
    [](Bytes& bytes, NurbsPatch& patch) {
      const Axis along = axis(bytes);
      take(patch, made_periodic(patch, along, maybe_tolerance(bytes)));
    },
    [](Bytes& bytes, NurbsPatch& patch) { patch = transformed(patch, matrix(bytes)); },
    [](Bytes& bytes, NurbsPatch& patch) {
      const Axis along = axis(bytes);
      patch = moebius(patch, along, bytes.number());
    },
    [](Bytes& bytes, NurbsPatch& patch) { patch = patch.with_points(points(bytes, patch.points().size())); },
    [](Bytes& bytes, NurbsPatch& patch) {
      const double u = parameter(bytes, patch.knot_vector(Axis::u));
      const double v = parameter(bytes, patch.knot_vector(Axis::v));
      PatchDrag by{vector(bytes)};
      if (bytes.flag()) by.tangent_u_by = vector(bytes);
      if (bytes.flag()) by.tangent_v_by = vector(bytes);
      patch = bytes.flag() ? dragged(to_hermite(patch), u, v, by).nurbs()
                           : dragged(patch, u, v, by, {{}, bytes.flag() ? bytes.number() : 0.0});
    },
    [](Bytes& bytes, NurbsPatch& patch) {
      const Border side = border(bytes);
      const Border other_side = border(bytes);
      const auto smoothness = static_cast<PatchSmoothness>(bytes.integer(0, 4));
      const auto moves = static_cast<JoinMoves>(bytes.integer(0, 2));
      const NurbsPatch other = bytes.flag() ? nurbs_patch(bytes) : patch;
      PatchJoin join = joined_patches(patch, side, other, other_side, smoothness, moves);
      demand_error(join.first_error, "the first patch of a join");
      demand_error(join.second_error, "the second patch of a join");
      patch = bytes.flag() ? std::move(join.first) : std::move(join.second);
    },
    [](Bytes& bytes, NurbsPatch& patch) {
      const BezierPatch one = bezier(bytes, patch);
      const Axis along = axis(bytes);
      patch = one_of(bytes, split(one, along, bytes.within({}))).nurbs();
    },
    [](Bytes& bytes, NurbsPatch& patch) {
      const BezierPatch one = bezier(bytes, patch);
      const Axis along = axis(bytes);
      patch = elevated(swapped(reversed(one, along)), along, bytes.integer(0, 3)).nurbs();
    },
    [](Bytes& bytes, NurbsPatch& patch) {
      const BezierPatch one = bezier(bytes, patch);
      const Axis along = axis(bytes);
      const int times = bytes.integer(0, 3);
      const auto lower = reduced(one, along, times, maybe_tolerance(bytes));
      demand_error(lower.error, "a lower degree");
      patch = lower.value.nurbs();
    },
    [](Bytes& bytes, NurbsPatch& patch) {
      const HermitePatch grid = to_hermite(patch);
      const Axis along = axis(bytes);
      const double at = bytes.within(grid.nurbs().knot_vector(along).domain());
      patch = one_of(bytes, split(swapped(reversed(grid, along)), along, at)).nurbs();
    },
};

}  // namespace

std::span<const PatchStep> patch_verbs() { return kVerbs; }

}  // namespace splinecore::fuzz
