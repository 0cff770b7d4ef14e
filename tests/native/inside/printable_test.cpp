#include "base/printable.hpp"

#include "splinecore/exchange/json.hpp"
#include "splinecore/formula/formula.hpp"
#include "support.hpp"

namespace splinecore {
namespace {

using namespace testing;

TEST(Printable, KeepsWhatIsUtf8) {
  for (const std::string text : {"", "plain", "é ü 日本 €", "\xF0\x9F\x98\x80", "\xEF\xBF\xBF", "\xF4\x8F\xBF\xBF"}) {
    EXPECT_EQ(printable(text), text);
  }
}

TEST(Printable, WritesEveryOtherByteAsItsNumber) {
  EXPECT_EQ(printable(std::string_view("a\0b\n\x7F", 5)), "a\\x00b\\x0a\\x7f");
  EXPECT_EQ(printable("\xC3"), "\\xc3");
  EXPECT_EQ(printable("\xC3(\xA9"), "\\xc3(\\xa9");
  // Overlong forms, halves of surrogates, what lies above U+10FFFF.
  EXPECT_EQ(printable("\xC0\x80\xE0\x80\x80"), "\\xc0\\x80\\xe0\\x80\\x80");
  EXPECT_EQ(printable("\xED\xA0\x80"), "\\xed\\xa0\\x80");
  EXPECT_EQ(printable("\xF4\x90\x80\x80\xFF"), "\\xf4\\x90\\x80\\x80\\xff");
  EXPECT_EQ(printable("\xE2\x82"), "\\xe2\\x82");
}

TEST(Printable, CutsBetweenCharacters) {
  EXPECT_EQ(printable("abc", 3), "abc");
  EXPECT_EQ(printable("abcd", 3), "abc...");
  EXPECT_EQ(printable("aéé", 4), "aé...");
  EXPECT_EQ(printable("aéé", 5), "aéé");
}

TEST(Printable, IsWhatMessagesAreMadeOf) {
  for (const char* text : {"é", "{\"format\":é}", "{\"format\": \"\xFF", "[\"日"}) {
    const std::string message = refusal([&] { from_json(text); });
    EXPECT_EQ(printable(message), message);
  }
  std::string name = "a";
  for (int i = 0; i < 60; ++i) name += "é";
  const std::string message = refusal([&] { Formula::make("1", {name}); });
  EXPECT_EQ(printable(message), message);
  EXPECT_LT(message.size(), 160u);
}

TEST(Printable, KeepsMessagesShort) {
  const std::string text = "{\"format\":\"splinecore\",\"version\":1,\"kind\":\"" + std::string(100'000, 'x') + "\"}";
  EXPECT_LT(refusal([&] { from_json(text); }).size(), 700u);
}

}  // namespace
}  // namespace splinecore
