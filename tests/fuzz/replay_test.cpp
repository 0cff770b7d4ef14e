#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "targets.hpp"

// Every input that is kept runs with every build, whatever the compiler.

namespace splinecore::fuzz {
namespace {

namespace files = std::filesystem;

std::vector<std::uint8_t> bytes_of(const files::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<files::path> inputs_of(const char* target) {
  std::vector<files::path> paths;
  for (const auto& entry : files::directory_iterator(files::path(FUZZ_DATA) / target)) paths.push_back(entry.path());
  std::ranges::sort(paths);
  return paths;
}

class Replay : public ::testing::TestWithParam<Target> {};

TEST_P(Replay, AllInputs) {
  const std::vector<files::path> paths = inputs_of(GetParam().name);
  EXPECT_GE(paths.size(), 3u);
  for (const files::path& path : paths) {
    SCOPED_TRACE(path.filename());
    EXPECT_NO_THROW(run_for_a_while(GetParam().run, bytes_of(path)));
  }
}

TEST_P(Replay, NothingAndEveryByte) {
  EXPECT_NO_THROW(run_for_a_while(GetParam().run, {}));
  for (int byte = 0; byte < 256; ++byte) {
    const std::vector<std::uint8_t> data(1, static_cast<std::uint8_t>(byte));
    EXPECT_NO_THROW(run_for_a_while(GetParam().run, data)) << byte;
  }
}

INSTANTIATE_TEST_SUITE_P(Targets, Replay, ::testing::ValuesIn(kTargets),
                         [](const auto& target) { return std::string(target.param.name); });

}  // namespace
}  // namespace splinecore::fuzz
