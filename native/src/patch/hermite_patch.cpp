#include "splinecore/patch/hermite_patch.hpp"

#include <algorithm>
#include <string>

#include "base/require.hpp"
#include "basis/selection.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/basis/hermite.hpp"
#include "splinecore/patch/evaluate.hpp"

namespace splinecore {

namespace {

/// Along a chain the Bezier points 3k - 1, 3k, 3k + 1 belong to corner k.
struct Handle {
  int corner;
  double offset;  // what a derivative is multiplied by
};

std::vector<Handle> handles_of(const std::vector<double>& parameters) {
  const int last = static_cast<int>(parameters.size()) - 1;
  std::vector<Handle> handles;
  for (int k = 0; k <= last; ++k) {
    if (k > 0) handles.push_back({k, -(parameters[k] - parameters[k - 1]) / 3.0});
    handles.push_back({k, 0.0});
    if (k < last) handles.push_back({k, (parameters[k + 1] - parameters[k]) / 3.0});
  }
  return handles;
}

/// The points of the NURBS form.
std::vector<glm::dvec4> bezier_grid(const HermiteNet& net, const std::vector<double>& parameters_u,
                                    const std::vector<double>& parameters_v) {
  const auto count_v = parameters_v.size();
  const auto handles_v = handles_of(parameters_v);
  std::vector<glm::dvec4> points;
  for (const Handle& in_u : handles_of(parameters_u)) {
    for (const Handle& in_v : handles_v) {
      const std::size_t i = in_u.corner * count_v + in_v.corner;
      points.emplace_back(net.points[i] + in_u.offset * net.tangents_u[i] + in_v.offset * net.tangents_v[i] +
                              in_u.offset * in_v.offset * net.twists[i],
                          1.0);
    }
  }
  return points;
}

void require_net(const std::vector<glm::dvec3>& values, const char* argument, std::size_t count_u,
                 std::size_t count_v) {
  if (values.size() != count_u * count_v) {
    throw InvalidShape(std::string(argument) + " has " + std::to_string(values.size()) +
                       " entries for " + std::to_string(count_u) + " x " + std::to_string(count_v) +
                       " corners");
  }
  require_finite(values, argument, count_v);
}

/// The net with twists of zero where it has none. @throws InvalidShape
HermiteNet checked(HermiteNet net, std::size_t count_u, std::size_t count_v) {
  if (net.twists.empty()) net.twists.assign(net.points.size(), glm::dvec3(0.0));
  require_net(net.points, "points", count_u, count_v);
  require_net(net.tangents_u, "tangents_u", count_u, count_v);
  require_net(net.tangents_v, "tangents_v", count_u, count_v);
  require_net(net.twists, "twists", count_u, count_v);
  return net;
}

template <class Change>
HermiteNet for_each_list(const HermiteNet& net, Change change) {
  return {change(net.points), change(net.tangents_u), change(net.tangents_v), change(net.twists)};
}

/// The patch with corners added at a parameter of direction u that is not one yet.
HermitePatch with_corners_at(const HermitePatch& patch, double u) {
  const auto parameters = patch.parameters(Axis::u);
  const int count_v = patch.count(Axis::v);
  const auto row = std::ranges::lower_bound(parameters, u) - parameters.begin();
  if (parameters[row] == u) return patch;
  HermiteNet net = patch.net();
  std::vector<double> values(12);
  for (int j = count_v - 1; j >= 0; --j) {
    const double v = patch.parameters(Axis::v)[j];
    derivatives(patch.nurbs(), {&u, 1}, {&v, 1}, 1, values);
    const auto put = [&](std::vector<glm::dvec3>& list, int k) {
      list.insert(list.begin() + row * count_v, {values[3 * k], values[3 * k + 1], values[3 * k + 2]});
    };
    put(net.points, 0);
    put(net.tangents_v, 1);
    put(net.tangents_u, 2);
    put(net.twists, 3);
  }
  std::vector<double> all(parameters.begin(), parameters.end());
  all.insert(all.begin() + row, u);
  const int count_u = static_cast<int>(all.size());
  return HermitePatch::make(count_u, count_v, std::move(net), std::move(all),
                            {patch.parameters(Axis::v).begin(), patch.parameters(Axis::v).end()});
}

HermitePatch rows(const HermitePatch& patch, int begin, int end) {
  const int count_v = patch.count(Axis::v);
  const auto part = [&](const std::vector<glm::dvec3>& list) {
    return std::vector<glm::dvec3>(list.begin() + begin * count_v, list.begin() + end * count_v);
  };
  const auto u = patch.parameters(Axis::u);
  return HermitePatch::make(end - begin, count_v, for_each_list(patch.net(), part),
                            {u.begin() + begin, u.begin() + end},
                            {patch.parameters(Axis::v).begin(), patch.parameters(Axis::v).end()});
}

}  // namespace

HermitePatch::HermitePatch(HermiteNet net, std::vector<double> parameters_u, std::vector<double> parameters_v,
                           NurbsPatch form)
    : net_(std::move(net)), parameters_u_(std::move(parameters_u)), parameters_v_(std::move(parameters_v)),
      form_(std::move(form)) {}

HermitePatch HermitePatch::make(int count_u, int count_v, HermiteNet net,
                                std::vector<double> parameters_u, std::vector<double> parameters_v) {
  if (count_u < 2 || count_v < 2) {
    throw InvalidShape("points is " + std::to_string(count_u) + " x " + std::to_string(count_v) +
                       ", a Hermite patch needs 2 x 2 or more");
  }
  net = checked(std::move(net), count_u, count_v);
  parameters_u = hermite_parameters(std::move(parameters_u), count_u, "parameters_u");
  parameters_v = hermite_parameters(std::move(parameters_v), count_v, "parameters_v");
  NurbsPatch form = NurbsPatch::make(hermite_knots(parameters_u), hermite_knots(parameters_v),
                                     bezier_grid(net, parameters_u, parameters_v));
  return {std::move(net), std::move(parameters_u), std::move(parameters_v), std::move(form)};
}

HermitePatch HermitePatch::with_net(HermiteNet net) const {
  net = checked(std::move(net), parameters_u_.size(), parameters_v_.size());
  NurbsPatch form = form_.with_points(bezier_grid(net, parameters_u_, parameters_v_));
  return {std::move(net), parameters_u_, parameters_v_, std::move(form)};
}

std::pair<HermitePatch, HermitePatch> split(const HermitePatch& patch, Axis axis, double u) {
  if (axis == Axis::v) {
    const auto [before, after] = split(swapped(patch), Axis::u, u);
    return {swapped(before), swapped(after)};
  }
  const auto parameters = patch.parameters(Axis::u);
  if (!(u > parameters.front() && u < parameters.back())) {
    throw InvalidShape("u = " + text_of(u) + " is not inside the domain (" +
                       text_of(parameters.front()) + ", " + text_of(parameters.back()) + ")");
  }
  const HermitePatch whole = with_corners_at(patch, u);
  const auto row = static_cast<int>(std::ranges::lower_bound(whole.parameters(Axis::u), u) -
                                    whole.parameters(Axis::u).begin());
  return {rows(whole, 0, row + 1), rows(whole, row, whole.count(Axis::u))};
}

HermitePatch reversed(const HermitePatch& patch, Axis axis) {
  if (axis == Axis::v) return swapped(reversed(swapped(patch), Axis::u));
  const int count_u = patch.count(Axis::u);
  const int count_v = patch.count(Axis::v);
  HermiteNet net = for_each_list(patch.net(), [&](const std::vector<glm::dvec3>& list) {
    std::vector<glm::dvec3> mirrored;
    for (int i = count_u - 1; i >= 0; --i) {
      mirrored.insert(mirrored.end(), list.begin() + i * count_v, list.begin() + (i + 1) * count_v);
    }
    return mirrored;
  });
  for (glm::dvec3& tangent : net.tangents_u) tangent = -tangent;
  for (glm::dvec3& twist : net.twists) twist = -twist;
  const auto given = patch.parameters(Axis::u);
  std::vector<double> parameters = mirrored(given, {given.front(), given.back()}, 1);
  return HermitePatch::make(count_u, count_v, std::move(net), std::move(parameters),
                            {patch.parameters(Axis::v).begin(), patch.parameters(Axis::v).end()});
}

HermitePatch swapped(const HermitePatch& patch) {
  const int count_u = patch.count(Axis::u);
  const int count_v = patch.count(Axis::v);
  HermiteNet net = for_each_list(patch.net(), [&](const std::vector<glm::dvec3>& list) {
    std::vector<glm::dvec3> turned;
    for (int j = 0; j < count_v; ++j) {
      for (int i = 0; i < count_u; ++i) turned.push_back(list[i * count_v + j]);
    }
    return turned;
  });
  std::swap(net.tangents_u, net.tangents_v);
  return HermitePatch::make(count_v, count_u, std::move(net),
                            {patch.parameters(Axis::v).begin(), patch.parameters(Axis::v).end()},
                            {patch.parameters(Axis::u).begin(), patch.parameters(Axis::u).end()});
}

}  // namespace splinecore
