#include "parser.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace splinecore {

namespace {

// The functions of <cctype> follow the locale.
bool is_digit(char c) noexcept { return c >= '0' && c <= '9'; }
bool is_letter(char c) noexcept { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_blank(char c) noexcept { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
bool starts_operand(char c) noexcept { return is_digit(c) || is_letter(c) || c == '.' || c == '('; }

/// By recursive descent; the rules call each other in the order sum, product, signed_factor, power, operand.
class Parser {
 public:
  Parser(std::string_view text, const std::vector<std::string>& variables, const Formula::Constants& constants)
      : text_(text), variables_(variables), constants_(constants) {}

  Program parse();

 private:
  void sum();
  void product();
  void signed_factor();
  void power();
  void operand();
  void number();
  void name();
  void call(std::string_view name, Operation function, std::size_t start);
  void close(std::size_t opened);

  /// The next character that is not blank, or NUL behind the last.
  char peek() noexcept;
  bool take(char wanted) noexcept;
  bool at_end() noexcept { return peek() == '\0' && place_ == text_.size(); }
  std::string_view word() const noexcept;

  /// The word, or the whole character, that lies at the current place.
  std::string shown() const;
  [[noreturn]] void refuse_here();

  std::string_view text_;
  const std::vector<std::string>& variables_;
  const Formula::Constants& constants_;
  ProgramBuilder program_;
  std::size_t place_ = 0;
  int nesting_ = 0;
};

Program Parser::parse() {
  if (text_.size() > kMaxFormulaLength) {
    throw FormulaError("the formula has " + std::to_string(text_.size()) + " characters and must end",
                       kMaxFormulaLength);
  }
  if (at_end()) throw FormulaError("the formula is empty: an operand is missing", 0);
  sum();
  if (!at_end()) refuse_here();
  return program_.take();
}

char Parser::peek() noexcept {
  while (place_ < text_.size() && is_blank(text_[place_])) ++place_;
  return place_ < text_.size() ? text_[place_] : '\0';
}

bool Parser::take(char wanted) noexcept {
  if (peek() != wanted) return false;
  ++place_;
  return true;
}

std::string_view Parser::word() const noexcept {
  std::size_t end = place_;
  while (end < text_.size() && (is_letter(text_[end]) || is_digit(text_[end]))) ++end;
  return text_.substr(place_, end - place_);
}

std::string Parser::shown() const {
  if (!word().empty()) return quoted(word());
  std::size_t end = place_ + 1;
  while (end < text_.size() && (static_cast<unsigned char>(text_[end]) & 0xC0U) == 0x80U) ++end;
  return quoted(text_.substr(place_, end - place_));
}

void Parser::refuse_here() {
  if (at_end()) throw FormulaError("an operand is missing", text_.size());
  const bool is_power = text_[place_] == '*' && place_ > 0 && text_[place_ - 1] == '*';
  throw FormulaError("unexpected " + shown() + (is_power ? ", a power is written ^," : ""), place_);
}

void Parser::sum() {
  product();
  while (true) {
    if (take('+')) {
      product();
      program_.apply(Operation::add);
    } else if (take('-')) {
      product();
      program_.apply(Operation::subtract);
    } else {
      return;
    }
  }
}

void Parser::product() {
  signed_factor();
  while (true) {
    if (take('*')) {
      signed_factor();
      program_.apply(Operation::multiply);
    } else if (take('/')) {
      signed_factor();
      program_.apply(Operation::divide);
    } else if (starts_operand(peek())) {
      throw FormulaError("an operator, perhaps *, is missing before " + shown(), place_);
    } else {
      return;
    }
  }
}

void Parser::signed_factor() {
  // Every way into another level leads through here.
  if (++nesting_ > kMaxFormulaNesting) {
    const std::string limit = std::to_string(kMaxFormulaNesting);
    throw FormulaError("more than " + limit + " parentheses, signs and powers in one another", place_);
  }
  if (take('-')) {
    signed_factor();
    program_.apply(Operation::negate);
  } else if (take('+')) {
    signed_factor();
  } else {
    power();
  }
  --nesting_;
}

void Parser::power() {
  operand();
  if (!take('^')) return;
  signed_factor();
  program_.apply(Operation::power);
}

void Parser::operand() {
  const char next = peek();
  if (is_digit(next) || next == '.') return number();
  if (is_letter(next)) return name();
  const std::size_t opened = place_;
  if (!take('(')) refuse_here();
  sum();
  close(opened);
}

void Parser::close(std::size_t opened) {
  if (take(')')) return;
  if (at_end()) throw FormulaError("'(' is not closed", opened);
  refuse_here();
}

void Parser::number() {
  double value = 0.0;
  const char* start = text_.data() + place_;
  const auto [end, problem] = std::from_chars(start, text_.data() + text_.size(), value);
  if (problem == std::errc::invalid_argument) refuse_here();
  if (problem == std::errc::result_out_of_range) {
    throw FormulaError("the number " + quoted({start, end}) + " is outside the range of float64", place_);
  }
  place_ += end - start;
  if (place_ < text_.size() && *end == '.') throw FormulaError("a number has two decimal points", place_);
  program_.push({Operation::number, value});
}

void Parser::name() {
  const std::size_t start = place_;
  const std::string_view name = word();
  place_ += name.size();
  if (const auto found = std::ranges::find(variables_, name); found != variables_.end()) {
    return program_.push({Operation::variable, 0.0, static_cast<int>(found - variables_.begin())});
  }
  if (const auto found = constants_.find(std::string(name)); found != constants_.end()) {
    return program_.push({Operation::number, found->second});
  }
  if (const auto value = number_named(name)) return program_.push({Operation::number, *value});
  if (const auto function = function_named(name)) return call(name, *function, start);
  throw FormulaError("unknown name " + quoted(name), start);
}

void Parser::call(std::string_view name, Operation function, std::size_t start) {
  if (!take('(')) throw FormulaError("the function " + quoted(name) + " needs its argument in parentheses", start);
  const std::size_t opened = place_ - 1;
  int given = 0;
  if (peek() != ')') {
    do {
      sum();
      ++given;
    } while (take(','));
  }
  close(opened);
  const int wanted = operand_count(function);
  if (given != wanted) {
    throw FormulaError("the function " + quoted(name) + " takes " + std::to_string(wanted) +
                       (wanted == 1 ? " argument" : " arguments") + " and is given " + std::to_string(given), start);
  }
  program_.apply(function);
}

}  // namespace

bool is_name(std::string_view text) noexcept {
  return !text.empty() && is_letter(text.front()) &&
         std::ranges::all_of(text, [](char c) { return is_letter(c) || is_digit(c); });
}

Program parse(std::string_view text, const std::vector<std::string>& variables, const Formula::Constants& constants) {
  return Parser(text, variables, constants).parse();
}

}  // namespace splinecore
