#include <cstdint>
#include <nlohmann/json.hpp>

#include "base/printable.hpp"
#include "splinecore/base/errors.hpp"
#include "splinecore/base/pause.hpp"
#include "splinecore/exchange/json.hpp"

namespace splinecore {

namespace {

using Json = nlohmann::json;

[[noreturn]] void refuse(const std::string& where, const std::string& why) {
  constexpr std::size_t kShown = 300;
  throw InvalidShape("JSON: " + printable(where, kShown) + " " + printable(why, kShown));
}

const Json& field(const Json& object, const char* name) {
  if (!object.is_object()) refuse("an object with \"" + std::string(name) + "\"", "is expected");
  const auto found = object.find(name);
  if (found == object.end()) refuse(name, "is missing");
  return *found;
}

double number(const Json& value, const std::string& where) {
  if (!value.is_number()) refuse(where, "is not a number");
  return value.get<double>();
}

int integer(const Json& value, const std::string& where) {
  constexpr std::int64_t kLimit = std::int64_t{1} << 31;
  if (!value.is_number_integer()) refuse(where, "is not an integer");
  if (value.is_number_unsigned() && value.get<std::uint64_t>() >= static_cast<std::uint64_t>(kLimit)) {
    refuse(where, "is too large");
  }
  const auto wide = value.get<std::int64_t>();
  if (wide <= -kLimit || wide >= kLimit) refuse(where, "is too large");
  return static_cast<int>(wide);
}

bool boolean(const Json& value, const std::string& where) {
  if (!value.is_boolean()) refuse(where, "is neither true nor false");
  return value.get<bool>();
}

const Json& array(const Json& value, const std::string& where) {
  if (!value.is_array()) refuse(where, "is not a list");
  return value;
}

const Json& element(const Json& value, std::size_t i, const std::string& where) {
  if (i >= array(value, where).size()) refuse(where, "has fewer than " + std::to_string(i + 1) + " values");
  return value[i];
}

std::vector<double> numbers(const Json& value, const std::string& where) {
  std::vector<double> values;
  for (const Json& item : array(value, where)) values.push_back(number(item, where + index_text(values.size())));
  return values;
}

glm::dvec4 read_row(const Json& value, const std::string& where, glm::dvec4*) {
  const std::vector<double> row = numbers(value, where);
  if (row.size() != 4) refuse(where, "is not [x, y, z, w]");
  return {row[0], row[1], row[2], row[3]};
}

glm::dvec3 read_row(const Json& value, const std::string& where, glm::dvec3*) {
  const std::vector<double> row = numbers(value, where);
  if (row.size() != 3) refuse(where, "is not [x, y, z]");
  return {row[0], row[1], row[2]};
}

template <class Point>
std::vector<Point> list(const Json& value, const std::string& where) {
  std::vector<Point> points;
  for (const Json& item : array(value, where)) {
    points.push_back(read_row(item, where + index_text(points.size()), static_cast<Point*>(nullptr)));
  }
  return points;
}

template <class Point>
struct JsonNet {
  int count_u = 0;
  int count_v = 0;
  std::vector<Point> points;
};

template <class Point>
JsonNet<Point> net(const Json& object, const char* name) {
  JsonNet<Point> grid;
  for (const Json& item : array(field(object, name), name)) {
    const std::string where = name + index_text(grid.count_u);
    const std::vector<Point> row = list<Point>(item, where);
    if (grid.count_u > 0 && row.size() != static_cast<std::size_t>(grid.count_v)) {
      refuse(where, "has another length than the row before");
    }
    grid.count_v = static_cast<int>(row.size());
    ++grid.count_u;
    grid.points.insert(grid.points.end(), row.begin(), row.end());
  }
  return grid;
}

KnotVector knots_of(const Json& object, std::size_t axis) {
  const std::string place = index_text(axis);
  const int degree = integer(element(field(object, "degree"), axis, "degree"), "degree" + place);
  auto knots = numbers(element(field(object, "knots"), axis, "knots"), "knots" + place);
  return KnotVector::make(degree, std::move(knots),
                          boolean(element(field(object, "periodic"), axis, "periodic"), "periodic" + place));
}

NurbsCurve nurbs_curve(const Json& object) {
  const int degree = integer(field(object, "degree"), "degree");
  auto knots = numbers(field(object, "knots"), "knots");
  auto points = list<glm::dvec4>(field(object, "points"), "points");
  return NurbsCurve::make(degree, std::move(knots), std::move(points), boolean(field(object, "periodic"), "periodic"));
}

HermiteCurve hermite_curve(const Json& object) {
  std::vector<Tangents> tangents;
  for (const Json& item : array(field(object, "tangents"), "tangents")) {
    const auto pair = list<glm::dvec3>(item, "tangents" + index_text(tangents.size()));
    if (pair.size() != 2) refuse("tangents" + index_text(tangents.size()), "is not [incoming, outgoing]");
    tangents.push_back({pair[0], pair[1]});
  }
  auto points = list<glm::dvec3>(field(object, "points"), "points");
  return HermiteCurve::make(std::move(points), std::move(tangents),
                            numbers(field(object, "parameters"), "parameters"));
}

PowerCurve power_curve(const Json& object) {
  const Json& domain = field(object, "domain");
  const double start = number(element(domain, 0, "domain"), "domain[0]");
  const Interval range{start, number(element(domain, 1, "domain"), "domain[1]")};
  auto coefficients = list<glm::dvec4>(field(object, "coefficients"), "coefficients");
  return PowerCurve::make(std::move(coefficients), number(field(object, "origin"), "origin"), range);
}

NurbsPatch nurbs_patch(const Json& object) {
  KnotVector u = knots_of(object, 0);
  KnotVector v = knots_of(object, 1);
  auto points = net<glm::dvec4>(object, "points");
  if (points.count_u != u.count() || points.count_v != v.count()) {
    refuse("points", "is " + std::to_string(points.count_u) + " x " + std::to_string(points.count_v) +
                         ", but the knots belong to " + std::to_string(u.count()) + " x " + std::to_string(v.count()));
  }
  return NurbsPatch::make(std::move(u), std::move(v), std::move(points.points));
}

/// A net of a Hermite patch, of the shape of its points.
std::vector<glm::dvec3> hermite_net(const Json& object, const char* name, const JsonNet<glm::dvec3>& points) {
  auto values = net<glm::dvec3>(object, name);
  const bool is_empty = values.count_u == 0;
  if (!is_empty && (values.count_u != points.count_u || values.count_v != points.count_v)) {
    refuse(name, "is " + std::to_string(values.count_u) + " x " + std::to_string(values.count_v) +
                     " for points of " + std::to_string(points.count_u) + " x " + std::to_string(points.count_v));
  }
  return std::move(values.points);
}

HermitePatch hermite_patch(const Json& object) {
  auto points = net<glm::dvec3>(object, "points");
  HermiteNet all;
  all.tangents_u = hermite_net(object, "tangents_u", points);
  all.tangents_v = hermite_net(object, "tangents_v", points);
  all.twists = hermite_net(object, "twists", points);
  all.points = std::move(points.points);
  auto parameters_u = numbers(field(object, "parameters_u"), "parameters_u");
  return HermitePatch::make(points.count_u, points.count_v, std::move(all), std::move(parameters_u),
                            numbers(field(object, "parameters_v"), "parameters_v"));
}

IndexedPatch indexed_patch(const Json& object) {
  IndexedPatch patch;
  const Json& kind = field(object, "kind");
  const Json& count = field(object, "count");
  patch.count_u = integer(element(count, 0, "count"), "count[0]");
  patch.count_v = integer(element(count, 1, "count"), "count[1]");
  for (const Json& item : array(field(object, "indices"), "indices")) {
    patch.indices.push_back(integer(item, "indices" + index_text(patch.indices.size())));
  }
  if (kind == "bezier") return patch;
  if (kind != "hermite" && kind != "nurbs") refuse("kind " + kind.dump(), "is not known");
  const char* name = kind == "hermite" ? "parameters" : "knots";
  patch.kind = kind == "hermite" ? PatchKind::hermite : PatchKind::nurbs;
  patch.knots_u = numbers(element(field(object, name), 0, name), std::string(name) + "[0]");
  patch.knots_v = numbers(element(field(object, name), 1, name), std::string(name) + "[1]");
  if (kind == "hermite") return patch;
  patch.degree_u = integer(element(field(object, "degree"), 0, "degree"), "degree[0]");
  patch.degree_v = integer(element(field(object, "degree"), 1, "degree"), "degree[1]");
  patch.periodic_u = boolean(element(field(object, "periodic"), 0, "periodic"), "periodic[0]");
  patch.periodic_v = boolean(element(field(object, "periodic"), 1, "periodic"), "periodic[1]");
  return patch;
}

PatchSet patch_set(const Json& object) {
  std::vector<IndexedPatch> patches;
  for (const Json& item : array(field(object, "patches"), "patches")) patches.push_back(indexed_patch(item));
  return PatchSet::make(list<glm::dvec4>(field(object, "points"), "points"), std::move(patches));
}

Region region(const Json& object) {
  const auto across = numbers(field(object, "normal"), "normal");
  if (across.size() != 3) refuse("normal", "has not 3 numbers");
  std::vector<NurbsCurve> outlines;
  for (const Json& item : array(field(object, "outlines"), "outlines")) {
    if (field(item, "kind") != "nurbs_curve") refuse("outlines" + index_text(outlines.size()), "is no nurbs_curve");
    outlines.push_back(nurbs_curve(item));
  }
  try {
    return Region::of_outlines(std::move(outlines), {across[0], across[1], across[2]});
  } catch (const PointAtInfinity& error) {
    refuse("outlines:", error.what());
  }
}

Value value_of(const Json& object) {
  const Json& kind = field(object, "kind");
  if (kind == "bezier_curve") return BezierCurve::make(list<glm::dvec4>(field(object, "points"), "points"));
  if (kind == "hermite_curve") return hermite_curve(object);
  if (kind == "nurbs_curve") return nurbs_curve(object);
  if (kind == "bezier_patch") {
    auto points = net<glm::dvec4>(object, "points");
    return BezierPatch::make(points.count_u, points.count_v, std::move(points.points));
  }
  if (kind == "hermite_patch") return hermite_patch(object);
  if (kind == "nurbs_patch") {
    return nurbs_patch(object);
  }
  if (kind == "patch_set") return patch_set(object);
  if (kind == "power_curve") return power_curve(object);
  if (kind == "region") return region(object);
  refuse("kind " + kind.dump(), "is not known");
}

/// Where the text is no JSON, and what stands there.
[[noreturn]] void refuse_damaged(std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, byte > 0 ? byte - 1 : 0);
  const auto line = 1 + std::ranges::count(before, '\n');
  const std::size_t column = before.size() - (before.rfind('\n') + 1) + 1;
  const std::string place = "the text is damaged at byte " + std::to_string(byte) + ", line " + std::to_string(line) + ", column " +
                            std::to_string(column) + ":";
  if (byte == 0 || byte > text.size()) refuse(place, "it ends before the value does");
  const auto found = static_cast<unsigned char>(text[byte - 1]);
  const bool is_printable = found > 0x20 && found < 0x7f;
  refuse(place, (is_printable ? "'" + std::string(1, text[byte - 1]) + "'" : "what stands there") + " is not expected");
}

Json parsed(std::string_view text) {
  // No value is deeper; a text that is would exhaust the stack where it is copied or printed.
  constexpr int kMaxDepth = 16;
  constexpr std::size_t kStepsOfValue = 200;
  const auto require_depth = [](int depth, Json::parse_event_t, const Json&) {
    breathe(kStepsOfValue);
    if (depth > kMaxDepth) refuse("the text", "is nested more deeply than any shape");
    return true;
  };
  try {
    return Json::parse(text, require_depth);
  } catch (const Json::parse_error& error) {
    refuse_damaged(text, error.byte);
  } catch (const Json::out_of_range&) {
    refuse("a number", "is too large for double precision");
  }
}

}  // namespace

Document from_json(std::string_view text) {
  const Json object = parsed(text);
  if (!object.is_object() || object.value("format", Json()) != "splinecore") {
    refuse("\"format\": \"splinecore\"", "is missing: this is not a splinecore file");
  }
  const int version = integer(field(object, "version"), "version");
  if (version < 1) refuse("version " + std::to_string(version), "does not exist");
  if (version > kJsonVersion) {
    refuse("version " + std::to_string(version),
           "was written by a newer splinecore; this one reads up to " + std::to_string(kJsonVersion));
  }
  if (!object.contains("items")) return value_of(object);
  std::vector<Value> items;
  for (const Json& item : array(object["items"], "items")) items.push_back(value_of(item));
  return items;
}

}  // namespace splinecore
