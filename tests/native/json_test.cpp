#include "splinecore/exchange/json.hpp"

#include <cstring>
#include <limits>
#include <numbers>

#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;

/// Numbers whose last bit a text may lose.
const std::vector<double> kHard{
    -0.0, 1.0 / 3,          5e-324, 2.2250738585072014e-308, 1.7976931348623157e308, -1e-310,
    0.1,  std::numbers::pi, 1e22,   -123456789.123456789};

glm::dvec3 hard_vector(Random& random) {
  const auto number = [&] { return kHard[integer(random, 0, static_cast<int>(kHard.size()) - 1)]; };
  const double x = number(), y = number();
  return {x, y, number()};
}

std::vector<glm::dvec4> hard_points(Random& random, int count) {
  std::vector<glm::dvec4> points;
  for (int i = 0; i < count; ++i)
    points.emplace_back(hard_vector(random), i % 3 == 1 ? 0.0 : i % 3 == 2 ? -1.0 / 7 : 1.0);
  return points;
}

HermiteNet hard_net(Random& random, int size, double scale) {
  HermiteNet net;
  for (auto* list : {&net.points, &net.tangents_u, &net.tangents_v, &net.twists}) {
    for (int i = 0; i < size; ++i) list->push_back(scale * random_vector(random));
  }
  net.points[0] = {-0.0, 1.0 / 3, 5e-324};
  return net;
}

std::vector<Value> hard_values() {
  Random random(170);
  const KnotVector third = KnotVector::make(2, {0, 0, 0, 1.0 / 3, 1, 1, 1});
  const KnotVector ring = KnotVector::make(3, {-0.0, 5e-324, 0.1, 1}, true);
  const HermitePatch hermite = HermitePatch::make(2, 3, hard_net(random, 6, 1), {0, 1.0 / 3}, {-1, 0.1, 0.3});
  const std::vector<AnyPatch> patches{BezierPatch::make(3, 2, hard_points(random, 6)), hermite,
                                      NurbsPatch::make(third, ring, hard_points(random, 12))};
  return {BezierCurve::make(hard_points(random, 5)),
          HermiteCurve::make({{-0.0, 1.0 / 3, 5e-324}, {1, 2, 3}},
                             {{{0.1, 0, -0.0}, {1, 2, 3}}, {{4, 5, 6}, {7, 8, 1e-320}}}, {0.1, 0.7}),
          NurbsCurve::make(third, hard_points(random, 4)),
          NurbsCurve::make(ring, hard_points(random, 3)),
          BezierPatch::make(2, 4, hard_points(random, 8)),
          hermite,
          NurbsPatch::make(ring, third, hard_points(random, 12)),
          PatchSet::of(patches, true),
          PowerCurve::make({{0.1, -0.0, 5e-324, 1}, {1.0 / 3, 2, 1e22, -0.25}}, -1.0 / 7, {-0.0, 0.7})};
}

/// Equal in every bit, which == is not: it takes -0.0 for 0.0.
template <class Item>
void expect_same_bits(std::span<const Item> a, std::span<const Item> b) {
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size_bytes()), 0);
}

TEST(Json, GivesEveryKindOfValueBack) {
  for (const Value& value : hard_values()) {
    const std::string text = to_json(value);
    const Document read = from_json(text);
    ASSERT_TRUE(std::holds_alternative<Value>(read));
    EXPECT_EQ(std::get<Value>(read), value) << text;
    EXPECT_EQ(to_json(read), text);
  }
}

TEST(Json, GivesListsOfValuesBackInOrder) {
  const std::vector<Value> values = hard_values();
  const Document read = from_json(to_json(values));
  ASSERT_TRUE(std::holds_alternative<std::vector<Value>>(read));
  EXPECT_EQ(std::get<std::vector<Value>>(read), values);
  EXPECT_TRUE(std::get<std::vector<Value>>(from_json(to_json(std::vector<Value>{}))).empty());
}

TEST(Json, KeepsEveryBitOfEveryNumber) {
  Random random(171);
  std::vector<double> knots{0, 0};
  std::vector<glm::dvec4> points{{1, 1, 1, 1}};
  for (int i = 0; i < 2000; ++i) {
    const std::uint64_t bits = random();
    double number;
    std::memcpy(&number, &bits, sizeof(number));
    if (!std::isfinite(number)) number = kHard[i % kHard.size()];
    points.emplace_back(number, kHard[i % kHard.size()], -number, 1.0 / (i + 1));
    knots.push_back(knots.back() + std::exp2(real(random, -20, 0)));
  }
  knots.push_back(knots.back());
  const NurbsCurve curve = NurbsCurve::make(1, knots, points);
  const NurbsCurve read = std::get<NurbsCurve>(std::get<Value>(from_json(to_json(Value(curve)))));
  expect_same_bits(read.points(), curve.points());
  expect_same_bits(read.knot_vector().knots(), curve.knot_vector().knots());
}

TEST(Json, KeepsTheSignOfZeroInEveryKind) {
  const HermiteCurve curve = HermiteCurve::make({{-0.0, 0, 0}, {1, 0, 0}},
                                                {{{-0.0, 0, 0}, {0, -0.0, 0}}, {{0, 0, -0.0}, {0, 0, 0}}}, {-0.0, 1});
  const auto read = std::get<HermiteCurve>(std::get<Value>(from_json(to_json(Value(curve)))));
  expect_same_bits(read.points(), curve.points());
  expect_same_bits(read.tangents(), curve.tangents());
  expect_same_bits(read.parameters(), curve.parameters());
}

TEST(Json, IsOfTheFirstVersionThatKnowsAllKinds) {
  const auto version_of = [](const Document& document) { return to_json(document).substr(23, 11); };
  for (const Value& value : hard_values()) {
    const bool is_new = std::holds_alternative<PowerCurve>(value);
    EXPECT_EQ(version_of(value), is_new ? "\"version\":2" : "\"version\":1");
  }
  std::vector<Value> values = hard_values();
  EXPECT_EQ(version_of(values), "\"version\":2");
  values.pop_back();
  EXPECT_EQ(version_of(values), "\"version\":1");
}

TEST(Json, OfATextCutAnywhereIsRefused) {
  for (const Value& value : hard_values()) {
    const std::string text = to_json(value);
    for (std::size_t length = 0; length < text.size(); length += 1 + text.size() / 97) {
      EXPECT_EQ(refusal([&] { from_json(text.substr(0, length)); }).substr(0, 33), "JSON: the text is damaged at byte")
          << length;
    }
  }
}

TEST(Json, WithAnyByteChangedIsReadOrRefusedButNothingElse) {
  Random random(172);
  for (const Value& value : hard_values()) {
    const std::string text = to_json(value);
    for (int round = 0; round < 400; ++round) {
      std::string broken = text;
      broken[integer(random, 0, static_cast<int>(text.size()) - 1)] = static_cast<char>(integer(random, 0, 255));
      try {
        from_json(broken);
      } catch (const InvalidShape& error) {
        EXPECT_STRNE(error.what(), "");
      }
    }
  }
}

constexpr const char* kHead = R"({"format":"splinecore","version":1,)";

std::string refused(const std::string& rest) {
  return refusal([&] { from_json(kHead + rest + "}"); });
}

TEST(Json, OfAnotherFormatOrANewerVersionIsRefused) {
  EXPECT_EQ(refusal([] { from_json(R"({"kind":"bezier_curve"})"); }),
            "JSON: \"format\": \"splinecore\" is missing: this is not a splinecore file");
  EXPECT_EQ(refusal([] { from_json("[1,2]"); }),
            "JSON: \"format\": \"splinecore\" is missing: this is not a splinecore file");
  EXPECT_EQ(refusal([] { from_json(R"({"format":"splinecore","version":4,"kind":"x"})"); }),
            "JSON: version 4 was written by a newer splinecore; this one reads up to 3");
  EXPECT_EQ(refusal([] { from_json(R"({"format":"splinecore","version":0})"); }), "JSON: version 0 does not exist");
  EXPECT_EQ(refusal([] { from_json(R"({"format":"splinecore","version":"1"})"); }), "JSON: version is not an integer");
  EXPECT_EQ(refusal([] { from_json(R"({"format":"splinecore"})"); }), "JSON: version is missing");
  EXPECT_EQ(refusal([] { from_json(R"({"format":"splinecore","version":18446744073709551615})"); }), "JSON: version is too large");
}

TEST(Json, NamesThePlaceThatIsWrong) {
  EXPECT_EQ(refused(R"("kind":"cone_curve")"), R"(JSON: kind "cone_curve" is not known)");
  EXPECT_EQ(refused(R"("kind":"power_curve","domain":[1])"), "JSON: domain has fewer than 2 values");
  EXPECT_EQ(refused(R"("kind":"power_curve","domain":[0,1],"coefficients":[[1,2]])"), "JSON: coefficients[0] is not [x, y, z, w]");
  EXPECT_EQ(refused(R"("kind":"power_curve","domain":[0,1],"coefficients":[])"), "JSON: origin is missing");
  EXPECT_EQ(refused(R"("kind":"bezier_curve")"), "JSON: points is missing");
  EXPECT_EQ(refused(R"("kind":"bezier_curve","points":7)"), "JSON: points is not a list");
  EXPECT_EQ(refused(R"("kind":"bezier_curve","points":[[0,0,0,1],[1,2,3]])"), "JSON: points[1] is not [x, y, z, w]");
  EXPECT_EQ(refused(R"("kind":"bezier_curve","points":[[0,0,0,1],[1,"a",3,1]])"), "JSON: points[1][1] is not a number");
  EXPECT_EQ(refused(R"("kind":"bezier_curve","points":[[0,0,0,1],[1,null,3,1]])"), "JSON: points[1][1] is not a number");
  EXPECT_EQ(refused(R"("kind":"hermite_curve","points":[],"tangents":[[[0,0,0]]])"), "JSON: tangents[0] is not [incoming, outgoing]");
  EXPECT_EQ(refused(R"("kind":"nurbs_curve","degree":1.5)"), "JSON: degree is not an integer");
  EXPECT_EQ(refused(R"("kind":"nurbs_curve","degree":99999999999)"), "JSON: degree is too large");
  EXPECT_EQ(refused(R"("kind":"nurbs_curve","degree":1,"knots":[0,0,1,1],"points":[[0,0,0,1],[0,0,0,1]],"periodic":0)"),
            "JSON: periodic is neither true nor false");
  EXPECT_EQ(refused(R"("kind":"bezier_patch","points":[[[0,0,0,1],[0,0,0,1]],[[0,0,0,1]]])"), "JSON: points[1] has another length than the row before");
  EXPECT_EQ(refused(R"("items":[{"kind":"bezier_curve","points":[[0,0,0,1]]}])"), "points has 1 rows, a Bezier curve needs 2 or more");
  EXPECT_NE(refused(R"("kind":"bezier_curve","points":[[0,0,0,1],[1e400,0,0,1]])").find("too large"), std::string::npos);
}

TEST(Json, NamesThePatchOfASetThatIsWrong) {
  const std::string pool = R"("kind":"patch_set","points":[[0,0,0,1],[1,0,0,1],[0,1,0,1],[1,1,0,1]],"patches":[)";
  EXPECT_EQ(refused(pool + R"({"kind":"bezier","count":[2,2],"indices":[0,1,2,9]}])"), "patches[0]: indices[1, 1] = 9 is outside the pool of 4 points");
  EXPECT_EQ(refused(pool + R"({"kind":"bezier","count":[2],"indices":[0,1,2,3]}])"), "JSON: count has fewer than 2 values");
  EXPECT_EQ(refused(pool + R"({"kind":"bezier","count":[2,2],"indices":[0,1,2,0.5]}])"), "JSON: indices[3] is not an integer");
  EXPECT_EQ(refused(pool + R"({"kind":"power","count":[2,2],"indices":[0,1,2,3]}])"), R"(JSON: kind "power" is not known)");
  EXPECT_EQ(refused(pool + "]"), "patches is empty: a patch set needs one or more");
}

TEST(Json, RefusesAHermitePatchWhoseNetsHaveDifferentShapes) {
  const auto rows = [](int count_u, int count_v) {
    std::string text = "[";
    for (int i = 0; i < count_u; ++i) {
      text += i > 0 ? ",[" : "[";
      for (int j = 0; j < count_v; ++j) text += j > 0 ? ",[0,0,0]" : "[0,0,0]";
      text += "]";
    }
    return text + "]";
  };
  const auto patch = [&](const std::string& twists) {
    return R"("kind":"hermite_patch","points":)" + rows(2, 3) + R"(,"tangents_u":)" + rows(2, 3) + R"(,"tangents_v":)" + rows(2, 3) +
           R"(,"twists":)" + twists + R"(,"parameters_u":[],"parameters_v":[])";
  };
  EXPECT_EQ(refused(patch(rows(2, 3))), "not refused");
  EXPECT_EQ(refused(patch("[]")), "not refused");
  EXPECT_EQ(refused(patch(rows(3, 2))), "JSON: twists is 3 x 2 for points of 2 x 3");
}

TEST(Json, SurvivesAbsurdNesting) {
  EXPECT_NE(refusal([] { from_json(std::string(1000000, '[')); }), "not refused");
  EXPECT_NE(refusal([] { from_json(std::string(1000000, '[') + std::string(1000000, ']')); }), "not refused");
}

}  // namespace
}  // namespace splinecore
