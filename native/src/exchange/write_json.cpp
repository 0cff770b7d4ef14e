#include <algorithm>
#include <nlohmann/json.hpp>

#include "splinecore/base/pause.hpp"
#include "splinecore/exchange/json.hpp"

namespace splinecore {

namespace {

using OrderedJson = nlohmann::ordered_json;
constexpr std::size_t kStepsOfPoints = 500;

OrderedJson numbers(std::span<const double> values) {
  return OrderedJson(std::vector<double>(values.begin(), values.end()));
}

OrderedJson row(const glm::dvec4& p) { return {p.x, p.y, p.z, p.w}; }
OrderedJson row(const glm::dvec3& p) { return {p.x, p.y, p.z}; }

template <class Point>
OrderedJson list(std::span<const Point> points) {
  OrderedJson rows = OrderedJson::array();
  for (const Point& p : points) {
    breathe(kStepsOfPoints);
    rows.push_back(row(p));
  }
  return rows;
}

template <class Point>
OrderedJson net(std::span<const Point> points, int count_v) {
  OrderedJson rows = OrderedJson::array();
  for (std::size_t i = 0; i < points.size(); i += count_v) rows.push_back(list(points.subspan(i, count_v)));
  return rows;
}

OrderedJson content(const BezierCurve& curve) { return {{"kind", "bezier_curve"}, {"points", list(curve.points())}}; }

OrderedJson content(const HermiteCurve& curve) {
  OrderedJson tangents = OrderedJson::array();
  for (const Tangents& t : curve.tangents()) tangents.push_back({row(t.incoming), row(t.outgoing)});
  return {{"kind", "hermite_curve"}, {"points", list(curve.points())}, {"tangents", tangents},
          {"parameters", numbers(curve.parameters())}};
}

OrderedJson content(const NurbsCurve& curve) {
  return {{"kind", "nurbs_curve"}, {"degree", curve.degree()}, {"periodic", curve.periodic()},
          {"knots", numbers(curve.knot_vector().knots())}, {"points", list(curve.points())}};
}

OrderedJson content(const BezierPatch& patch) {
  return {{"kind", "bezier_patch"}, {"points", net(patch.points(), patch.count(Axis::v))}};
}

OrderedJson content(const HermitePatch& patch) {
  const int width = patch.count(Axis::v);
  const auto grid = [&](const std::vector<glm::dvec3>& values) { return net(std::span(values), width); };
  return {{"kind", "hermite_patch"}, {"points", grid(patch.net().points)},
          {"tangents_u", grid(patch.net().tangents_u)}, {"tangents_v", grid(patch.net().tangents_v)},
          {"twists", grid(patch.net().twists)}, {"parameters_u", numbers(patch.parameters(Axis::u))},
          {"parameters_v", numbers(patch.parameters(Axis::v))}};
}

OrderedJson content(const NurbsPatch& patch) {
  const KnotVector& u = patch.knot_vector(Axis::u);
  const KnotVector& v = patch.knot_vector(Axis::v);
  return {{"kind", "nurbs_patch"}, {"degree", {u.degree(), v.degree()}}, {"periodic", {u.periodic(), v.periodic()}},
          {"knots", {numbers(u.knots()), numbers(v.knots())}}, {"points", net(patch.points(), v.count())}};
}

OrderedJson content(const IndexedPatch& patch) {
  OrderedJson item{{"count", {patch.count_u, patch.count_v}}, {"indices", patch.indices}};
  switch (patch.kind) {
    case PatchKind::bezier: item["kind"] = "bezier"; break;
    case PatchKind::hermite:
      item["kind"] = "hermite";
      item["parameters"] = {patch.knots_u, patch.knots_v};
      break;
    case PatchKind::nurbs:
      item["kind"] = "nurbs";
      item["degree"] = {patch.degree_u, patch.degree_v};
      item["periodic"] = {patch.periodic_u, patch.periodic_v};
      item["knots"] = {patch.knots_u, patch.knots_v};
      break;
  }
  return item;
}

OrderedJson content(const PatchSet& set) {
  OrderedJson patches = OrderedJson::array();
  for (const IndexedPatch& patch : set.patches()) patches.push_back(content(patch));
  return {{"kind", "patch_set"}, {"points", list(set.points())}, {"patches", patches}};
}

OrderedJson content(const PowerCurve& curve) {
  return {{"kind", "power_curve"}, {"origin", curve.origin()},
          {"domain", {curve.domain().start, curve.domain().end}}, {"coefficients", list(curve.coefficients())}};
}

OrderedJson content(const Region& region) {
  OrderedJson outlines = OrderedJson::array();
  for (const NurbsCurve& outline : region.outlines()) outlines.push_back(content(outline));
  return {{"kind", "region"}, {"normal", row(region.normal())}, {"outlines", outlines}};
}

OrderedJson content(const Value& value) {
  return std::visit([](const auto& shape) { return content(shape); }, value);
}

/// The first version that knows the kind.
int version_of(const Value& value) {
  if (std::holds_alternative<Region>(value)) return 3;
  return std::holds_alternative<PowerCurve>(value) ? 2 : 1;
}

int version_of(const Document& document) {
  if (const auto* value = std::get_if<Value>(&document)) return version_of(*value);
  int version = 1;
  for (const Value& item : std::get<std::vector<Value>>(document)) version = std::max(version, version_of(item));
  return version;
}

}  // namespace

std::string to_json(const Document& document) {
  OrderedJson text{{"format", "splinecore"}, {"version", version_of(document)}};
  if (const auto* value = std::get_if<Value>(&document)) {
    text.update(content(*value));
  } else {
    OrderedJson items = OrderedJson::array();
    for (const Value& item : std::get<std::vector<Value>>(document)) items.push_back(content(item));
    text["items"] = items;
  }
  return text.dump();
}

}  // namespace splinecore
