#include "base/parallel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "splinecore/base/pause.hpp"

namespace splinecore {

namespace {

constexpr std::size_t kMany = std::size_t{1} << 26;

struct Stopped : std::runtime_error {
  Stopped() : std::runtime_error("stopped") {}
};

template <class IsSo>
void wait_until(IsSo is_so) {
  while (!is_so()) std::this_thread::yield();
}

}  // namespace

TEST(ParallelFor, DoesEveryPartOnceWhateverTheThreads) {
  for (const int threads : {-1, 0, 1, 2, 3, 8}) {
    for (const std::size_t count : {0, 1, 2, 7, 1000}) {
      std::vector<int> times(count, 0);
      parallel_for(count, threads, [&](std::size_t i) { ++times[i]; });
      EXPECT_EQ(times, std::vector<int>(count, 1)) << threads << " threads, " << count << " parts";
    }
  }
}

TEST(ParallelFor, WorksOnSeveralThreadsAtOnce) {
  std::atomic<int> here = 0;
  // Each part waits for all others, so none would end if they came one after the other.
  parallel_for(4, 4, [&](std::size_t) {
    ++here;
    wait_until([&] { return here == 4; });
  });
  EXPECT_EQ(here, 4);
}

TEST(ParallelFor, WithOneThreadStaysOnItsOwn) {
  std::vector<std::size_t> order;
  parallel_for(5, 1, [&](std::size_t i) { order.push_back(i); });
  EXPECT_EQ(order, (std::vector<std::size_t>{0, 1, 2, 3, 4}));
}

TEST(ParallelFor, ThrowsWhatTheFirstPartThrewThatWouldAlone) {
  for (int round = 0; round < 200; ++round) {
    std::atomic<bool> has_failed = false;
    try {
      parallel_for(50, 3, [&](std::size_t i) {
        // The later part fails first.
        if (i == 20) wait_until([&] { return has_failed.load(); });
        if (i == 21) has_failed = true;
        if (i >= 20) throw std::runtime_error(std::to_string(i));
      });
      ADD_FAILURE() << "nothing was thrown";
    } catch (const std::runtime_error& error) {
      ASSERT_STREQ(error.what(), "20");
    }
  }
}

TEST(ParallelFor, EndsLaterPartsWhereAnEarlierOneFailed) {
  std::atomic<bool> is_busy = false;
  EXPECT_THROW(parallel_for(2, 2,
                            [&](std::size_t i) {
                              if (i == 0) {
                                wait_until([&] { return is_busy.load(); });
                                throw Stopped();
                              }
                              is_busy = true;
                              while (true) breathe(kMany);
                            }),
               Stopped);
}

TEST(ParallelFor, PausesOnlyOnTheThreadThatCalled) {
  std::set<std::thread::id> pausing_threads;
  std::atomic<int> pauses = 0;
  const Pause pause = [&] {
    pausing_threads.insert(std::this_thread::get_id());
    ++pauses;
    breathe(kMany);
  };
  const Pausing pausing(pause);
  parallel_for(100, 3, [](std::size_t) { breathe(kMany); });
  std::atomic<int> here = 0;
  const std::thread::id caller = std::this_thread::get_id();
  // The caller's part ends at once; it pauses while it waits for the others.
  parallel_for(2, 2, [&](std::size_t) {
    ++here;
    wait_until([&] { return here == 2; });
    if (std::this_thread::get_id() == caller) return;
    const int before = pauses;
    wait_until([&] { return pauses >= before + 2; });
  });
  EXPECT_EQ(pausing_threads, std::set{caller});
}

TEST(ParallelFor, WhatThePauseThrowsEndsAllParts) {
  for (const bool is_waiting : {false, true}) {
    std::atomic<int> here = 0;
    const std::thread::id caller = std::this_thread::get_id();
    const Pause pause = [] { throw Stopped(); };
    const Pausing pausing(pause);
    const auto part = [&](std::size_t) {
      ++here;
      wait_until([&] { return here == 2; });
      if (is_waiting && std::this_thread::get_id() == caller) return;
      while (true) breathe(kMany);
    };
    EXPECT_THROW(parallel_for(2, 2, part), Stopped);
  }
}

TEST(ParallelFor, MayBeUsedByItsParts) {
  std::vector<int> times(64, 0);
  parallel_for(8, 2, [&](std::size_t i) {
    parallel_for(8, 2, [&](std::size_t k) { ++times[8 * i + k]; });
  });
  EXPECT_EQ(times, std::vector<int>(64, 1));
}

TEST(ThreadsFor, OneWhereThereIsLittleToDoOrOneIsAskedFor) {
  EXPECT_EQ(threads_for(0, 1000, 100), 1);
  EXPECT_EQ(threads_for(1, kMany, 100), 1);
  EXPECT_EQ(threads_for(3, 1000, 100), 3);
  EXPECT_EQ(threads_for(3, 1000, 2), 2);
  EXPECT_EQ(threads_for(3, 1000, 0), 1);
  EXPECT_EQ(threads_for(0, kMany, 1000), static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1U, 128U)));
}

}  // namespace splinecore
