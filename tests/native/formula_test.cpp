#include "splinecore/formula/formula.hpp"

#include <functional>
#include <limits>
#include <numbers>

#include "splinecore/formula/evaluate.hpp"
#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;

double value_of(const std::string& text, double t = 0.0, Formula::Constants constants = {}) {
  double out = 0.0;
  evaluate(Formula::make(text, {"t"}, std::move(constants)), {&t, 1}, {&out, 1});
  return out;
}

/// "position: message" of the text that is refused.
std::string problem_of(const std::string& text) {
  try {
    Formula::make(text, {"t"});
  } catch (const FormulaError& error) {
    return std::to_string(error.position()) + ": " + error.reason();
  }
  return "not refused";
}

TEST(Formula, ComputesWithTheUsualPrecedence) {
  EXPECT_EQ(value_of("1 + 2*3 - 4/8"), 6.5);
  EXPECT_EQ(value_of("8/4/2 - 3 - 2"), -4.0);
  EXPECT_EQ(value_of("2^3^2"), 512.0);
  EXPECT_EQ(value_of("-t^2", 3.0), -9.0);
  EXPECT_EQ(value_of("2^-1*--t", 3.0), 1.5);
  EXPECT_EQ(value_of("2^-t^2", 2.0), 1.0 / 16.0);
  EXPECT_EQ(value_of(" ( t + 1 )\n*\t2 ", 3.0), 8.0);
}

TEST(Formula, ReadsNumbersAsFloat64) {
  EXPECT_EQ(value_of(".5 + 1. + 1e-3 + 2E+2"), 0.5 + 1.0 + 1e-3 + 2e2);
  EXPECT_EQ(value_of("0.1"), 0.1);
  EXPECT_EQ(value_of("1.7976931348623157e308"), std::numeric_limits<double>::max());
  EXPECT_EQ(value_of("pi"), std::numbers::pi);
  EXPECT_EQ(value_of("e"), std::numbers::e);
}

TEST(Formula, KnowsItsFunctions) {
  const double t = 0.37;
  const std::vector<std::pair<std::string, double>> cases{
      {"sin(t)", std::sin(t)},       {"cos(t)", std::cos(t)},         {"tan(t)", std::tan(t)},
      {"asin(t)", std::asin(t)},     {"acos(t)", std::acos(t)},       {"atan(t)", std::atan(t)},
      {"sinh(t)", std::sinh(t)},     {"cosh(t)", std::cosh(t)},       {"tanh(t)", std::tanh(t)},
      {"asinh(t)", std::asinh(t)},   {"acosh(1+t)", std::acosh(1+t)}, {"atanh(t)", std::atanh(t)},
      {"exp(t)", std::exp(t)},       {"log(t)", std::log(t)},         {"ln(t)", std::log(t)},
      {"log2(t)", std::log2(t)},     {"log10(t)", std::log10(t)},     {"sqrt(t)", std::sqrt(t)},
      {"cbrt(-t)", std::cbrt(-t)},   {"abs(-t)", t},                  {"sign(-t)", -1.0},
      {"floor(-t)", -1.0},           {"atan2(t, -1)", std::atan2(t, -1.0)},
      {"min(t, 1)", t},              {"max(t, 1)", 1.0},              {"sign(0*t)", 0.0},
  };
  for (const auto& [text, expected] : cases) EXPECT_DOUBLE_EQ(value_of(text, t), expected) << text;
}

TEST(Formula, TakesConstantsOfTheCaller) {
  EXPECT_EQ(value_of("radius*t + _k2", 2.0, {{"radius", 3.0}, {"_k2", 0.5}}), 6.5);
  EXPECT_EQ(refusal([] { Formula::make("t", {"t"}, {{"pi", 3.0}}); }),
            "a name in constants = 'pi' is the name of a number");
  EXPECT_EQ(refusal([] { Formula::make("t", {"t"}, {{"t", 3.0}}); }), "a name in constants = 't' is taken twice");
  EXPECT_EQ(refusal([] { Formula::make("t", {"t"}, {{"k", HUGE_VAL}}); }), "constants['k'] = inf is not finite");
  EXPECT_EQ(refusal([] { Formula::make("t", {"t", "sin"}); }), "variables[1] = 'sin' is the name of a function");
  EXPECT_EQ(refusal([] { Formula::make("t", {"2t"}); }),
            "variables[0] = '2t' is no name: a letter, then letters, digits and _ are expected");
  EXPECT_EQ(refusal([] { Formula::make("1", {}); }), "variables is empty: a formula needs one or more");
}

TEST(Formula, RefusesWhatIsNoFormulaAndNamesThePlace) {
  EXPECT_EQ(problem_of(""), "0: the formula is empty: an operand is missing");
  EXPECT_EQ(problem_of("1 + foo*2"), "4: unknown name 'foo'");
  EXPECT_EQ(problem_of("(t + 1"), "0: '(' is not closed");
  EXPECT_EQ(problem_of("t + (2*(t)"), "4: '(' is not closed");
  EXPECT_EQ(problem_of("t)"), "1: unexpected ')'");
  EXPECT_EQ(problem_of("2t"), "1: an operator, perhaps *, is missing before 't'");
  EXPECT_EQ(problem_of("t (t)"), "2: an operator, perhaps *, is missing before '('");
  EXPECT_EQ(problem_of("t**2"), "2: unexpected '*', a power is written ^,");
  EXPECT_EQ(problem_of("t +"), "3: an operand is missing");
  EXPECT_EQ(problem_of("sin t"), "0: the function 'sin' needs its argument in parentheses");
  EXPECT_EQ(problem_of("1 + max(t)"), "4: the function 'max' takes 2 arguments and is given 1");
  EXPECT_EQ(problem_of("sin()"), "0: the function 'sin' takes 1 argument and is given 0");
  EXPECT_EQ(problem_of("1..2"), "2: a number has two decimal points");
  EXPECT_EQ(problem_of("1e999"), "0: the number '1e999' is outside the range of float64");
  EXPECT_EQ(problem_of("0x10"), "1: an operator, perhaps *, is missing before 'x10'");
  EXPECT_EQ(problem_of("1 + \xC3\xA9"), "4: unexpected '\xC3\xA9'");
  EXPECT_EQ(problem_of(std::string("t\0", 2)), "1: unexpected '\\x00'");
  EXPECT_EQ(problem_of("__import__('os')"), "0: unknown name '__import__'");
  EXPECT_EQ(FormulaError("no", 5).what(), std::string("no at character 5"));
}

TEST(Formula, HasALimitOfLengthAndOfNesting) {
  const auto nested = [](int depth) { return std::string(depth, '(') + "t" + std::string(depth, ')'); };
  EXPECT_EQ(value_of(nested(kMaxFormulaNesting - 1), 3.0), 3.0);
  EXPECT_EQ(problem_of(nested(kMaxFormulaNesting)).substr(0, 18), "200: more than 200");
  EXPECT_EQ(problem_of(std::string(9'999, '-') + "1").substr(0, 18), "200: more than 200");
  EXPECT_EQ(problem_of(std::string(1'000'000, '(')).substr(0, 6), "10000:");
  std::string sum = "t";
  while (sum.size() + 2 <= kMaxFormulaLength) sum += "+t";
  EXPECT_EQ(value_of(sum, 1.0), 5000.0);
}

TEST(Formula, IsUndefinedWhereAnOperationIs) {
  for (const std::string text : {"1/t", "log(t - 1)", "sqrt(t - 1)", "1/(1/t)", "exp(-1/t^2)", "t^-1",
                                 "(t - 1)^0.5", "asin(t + 2)", "exp(1000 + t)", "(1/t)^0", "min(1, 1/t)", "log(t)",
                                 "acosh(t)", "1/0", "1e308*10 + t"}) {
    EXPECT_EQ(refusal([&] { value_of(text); }), "the formula '" + text + "' has no finite value at t = 0");
    const double t = 0.0;
    double out = 0.0;
    evaluate(Formula::make(text, {"t"}), {&t, 1}, {&out, 1}, AtUndefined::nan);
    EXPECT_TRUE(std::isnan(out)) << text;
  }
}

TEST(Formula, EvaluatesBatchesOfManyVariables) {
  const Formula formula = Formula::make("a*b - b", {"a", "b"});
  std::vector<double> a(1000);
  std::vector<double> b(1000);
  std::vector<double> out(1000);
  for (int i = 0; i < 1000; ++i) {
    a[i] = i;
    b[i] = 0.5 * i;
  }
  const std::span<const double> values[]{a, b};
  evaluate(formula, values, out);
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(out[i], a[i] * b[i] - b[i]);
  EXPECT_EQ(refusal([&] { evaluate(formula, a, out); }), "the formula 'a*b - b' has 2 variables, 1 values are given");
}

TEST(Formula, IsEqualByTextNamesAndConstants) {
  const auto make = [](const std::string& text, double k) { return Formula::make(text, {"t"}, {{"k", k}}); };
  EXPECT_EQ(make("t", 1.0), make("t", 1.0));
  EXPECT_FALSE(make("t", 1.0) == make("t", 2.0));
  EXPECT_FALSE(make("t", 1.0) == make(" t", 1.0));
  EXPECT_FALSE(Formula::make("1", {"t"}) == Formula::make("1", {"u"}));
}

/// A random expression as text, and as functions that never see the text.
struct Tree {
  std::string text;
  std::function<double(double)> value;
};

Tree random_tree(Random& random, int depth) {
  if (depth == 0 || integer(random, 0, 5) == 0) {
    if (integer(random, 0, 1) == 0) return {"t", [](double t) { return t; }};
    const double number = integer(random, 0, 40) / 8.0;
    return {text_of(number), [number](double) { return number; }};
  }
  const Tree a = random_tree(random, depth - 1);
  const Tree b = random_tree(random, depth - 1);
  const auto binary = [&](const std::string& sign, auto rule) {
    return Tree{"(" + a.text + ")" + sign + "(" + b.text + ")", [=](double t) { return rule(a.value(t), b.value(t)); }};
  };
  const auto unary = [&](const std::string& name, auto rule) {
    return Tree{name + "(" + a.text + ")", [=](double t) { return rule(a.value(t)); }};
  };
  switch (integer(random, 0, 8)) {
    case 0: return binary("+", [](double x, double y) { return x + y; });
    case 1: return binary("-", [](double x, double y) { return x - y; });
    case 2: return binary(" * ", [](double x, double y) { return x * y; });
    case 3: return binary("/", [](double x, double y) { return x / y; });
    case 4: return unary("sin", [](double x) { return std::sin(x); });
    case 5: return unary("sqrt", [](double x) { return std::sqrt(x); });
    case 6: return unary("-", [](double x) { return -x; });
    case 7: return unary("atan", [](double x) { return std::atan(x); });
    default: return unary("exp", [](double x) { return std::exp(x); });
  }
}

TEST(Formula, AgreesWithAnIndependentEvaluatorOnRandomTrees) {
  Random random(31);
  int finite = 0;
  for (int i = 0; i < 2000; ++i) {
    const Tree tree = random_tree(random, 5);
    const double t = real(random, -3.0, 3.0);
    double out = 0.0;
    evaluate(Formula::make(tree.text, {"t"}), {&t, 1}, {&out, 1}, AtUndefined::nan);
    // Undefined may also be what is finite again in the end: 1 / (1 / 0).
    if (std::isnan(out)) continue;
    EXPECT_EQ(out, tree.value(t)) << tree.text << " at " << t;
    ++finite;
  }
  EXPECT_GT(finite, 1000);
}

}  // namespace
}  // namespace splinecore
