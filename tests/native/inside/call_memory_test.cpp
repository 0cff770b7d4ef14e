#include "base/call_memory.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <stdexcept>
#include <thread>
#include <vector>

namespace splinecore {
namespace {

using Numbers = std::pmr::vector<double>;

const double* place_of(std::size_t count) {
  CallMemory memory;
  const Numbers numbers(count, 1.0, memory.resource());
  return numbers.data();
}

TEST(CallMemory, TheNextCallHasThePlaceOfTheLastOne) {
  place_of(1000);
  const double* const place = place_of(1000);
  EXPECT_EQ(place_of(1000), place);
  const double* const fewer = place_of(10);  // libstdc++ begins at the block's start, libc++ at its end
  EXPECT_TRUE(fewer == place || fewer == place + 990) << fewer - place;
}

TEST(CallMemory, CallsWithinCallsHavePlacesOfTheirOwn) {
  const double* first = nullptr;
  const double* second = nullptr;
  for (int round = 0; round < 3; ++round) {
    CallMemory outer;
    Numbers numbers(100, 1.0, outer.resource());
    {
      CallMemory inner;
      const Numbers others(100, 2.0, inner.resource());
      if (round == 2) { EXPECT_EQ(others.data(), second); }
      second = others.data();
    }
    const Numbers more(100, 3.0, outer.resource());
    EXPECT_EQ(numbers, Numbers(100, 1.0));
    EXPECT_EQ(more, Numbers(100, 3.0));
    if (round == 2) { EXPECT_EQ(numbers.data(), first); }
    first = numbers.data();
  }
}

TEST(CallMemory, ManyCallsWithinEachOtherAreServed) {
  for (int round = 0; round < 2; ++round) {
    std::vector<std::unique_ptr<CallMemory>> calls;
    std::vector<Numbers> numbers;
    for (int i = 0; i < 9; ++i) {
      calls.push_back(std::make_unique<CallMemory>());
      numbers.emplace_back(50, i, calls.back()->resource());
    }
    for (int i = 0; i < 9; ++i) EXPECT_EQ(numbers[i], Numbers(50, i));
    numbers.clear();
    while (!calls.empty()) calls.pop_back();
  }
}

TEST(CallMemory, HugeCallsAndCallsThatThrowLeaveNothingBehind) {
  for (int round = 0; round < 2; ++round) {
    const auto fail = [] {
      CallMemory memory;
      const Numbers numbers(3'000'000, 1.0, memory.resource());
      throw std::runtime_error("in the middle");
    };
    EXPECT_THROW(fail(), std::runtime_error);
    place_of(1000);
    const double* const place = place_of(1000);
    EXPECT_EQ(place_of(1000), place);
  }
}

TEST(CallMemory, NumbersLieWhereTheirLanesWantThem) {
  struct alignas(64) Lane {
    double numbers[8];
  };
  for (int round = 0; round < 3; ++round) {
    CallMemory memory;
    const std::pmr::vector<char> before(3, memory.resource());
    const std::pmr::vector<Lane> lanes(20, memory.resource());
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(lanes.data()) % 64, 0U);
  }
}

TEST(CallMemory, ThreadsDoNotShareIt) {
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([t] {
      for (int round = 0; round < 200; ++round) {
        CallMemory memory;
        Numbers numbers(100 + 10 * round, t, memory.resource());
        numbers.resize(2 * numbers.size(), t);
        for (const double number : numbers) ASSERT_EQ(number, t);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
}

}  // namespace
}  // namespace splinecore
