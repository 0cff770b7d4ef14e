#include "parallel.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#include "breath.hpp"

namespace splinecore {

namespace {

/// The work that is worth a thread of its own: some 0.5 ms.
constexpr std::size_t kWorkOfThread = std::size_t{1} << 19;
constexpr std::chrono::milliseconds kBetweenPauses{20};

/// Thrown by the pause of a part whose outcome nobody asks for any more.
struct NotWanted {};

/// Parts that threads take one after the other, and what came of them.
class Parts {
 public:
  Parts(std::size_t count, const std::function<void(std::size_t)>& part)
      : count_(static_cast<std::ptrdiff_t>(count)), part_(part) {}

  /// Takes parts as long as there are any, and none behind one that failed.
  void work(const Pause* own) {
    for (std::ptrdiff_t i = next_++; i < count_ && i <= failed_; i = next_++) {
      attempt(i, [&] {
        const Pause pause = [&] {
          if (i > failed_) throw NotWanted{};
          if (own != nullptr && !heed(*own)) throw NotWanted{};
        };
        const Pausing pausing(pause);
        part_(static_cast<std::size_t>(i));
      });
    }
  }

  /// What another thread does; enter() is called for each.
  void work_apart() {
    work(nullptr);
    const std::lock_guard lock(mutex_);
    --inside_;
    left_.notify_one();
  }

  void enter() {
    const std::lock_guard lock(mutex_);
    ++inside_;
  }

  /// Pauses until all others have left.
  void wait(const Pause& own) {
    const Pausing not_meanwhile({});
    std::unique_lock lock(mutex_);
    while (!left_.wait_for(lock, kBetweenPauses, [&] { return inside_ == 0; })) {
      lock.unlock();
      const bool goes_on = heed(own);
      lock.lock();
      if (!goes_on) return;
    }
  }

  void rethrow() const {
    if (error_) std::rethrow_exception(error_);
  }

 private:
  /// Pauses, unless a pause has ended the work; whether it goes on.
  bool heed(const Pause& own) {
    constexpr std::ptrdiff_t kBeforeAll = -1;
    return failed_ != kBeforeAll && attempt(kBeforeAll, own);
  }

  /// Keeps what is thrown, if it comes before what was thrown so far; whether nothing was.
  template <class Work>
  bool attempt(std::ptrdiff_t number, Work&& work) {
    try {
      work();
      return true;
    } catch (const NotWanted&) {
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (number < failed_) {
        failed_ = number;
        error_ = std::current_exception();
      }
    }
    return false;
  }

  const std::ptrdiff_t count_;
  const std::function<void(std::size_t)>& part_;
  std::atomic<std::ptrdiff_t> next_{0};
  std::atomic<std::ptrdiff_t> failed_{PTRDIFF_MAX};  ///< the first part that did, of those known
  std::mutex mutex_;
  std::condition_variable left_;
  int inside_ = 0;
  std::exception_ptr error_;
};

/// Threads that are waited for; std::jthread is not everywhere yet.
struct Others {
  std::vector<std::thread> threads;

  ~Others() {
    for (std::thread& thread : threads) thread.join();
  }
};

}  // namespace

int threads_for(int asked, std::size_t work, std::size_t parts) {
  std::size_t worth = asked > 0 ? static_cast<std::size_t>(asked) : work / kWorkOfThread;
  // The system takes some µs to count the cores: longer than small batches.
  if (asked == 0 && worth > 1) worth = std::min<std::size_t>(worth, std::max(1U, std::thread::hardware_concurrency()));
  return static_cast<int>(std::clamp<std::size_t>(worth, 1, std::max<std::size_t>(parts, 1)));
}

void run_on_threads(std::size_t count, int threads, const std::function<void(std::size_t)>& part) {
  Parts parts(count, part);
  {
    Others others;
    const std::size_t wanted = std::min<std::size_t>(threads, count) - 1;
    others.threads.reserve(wanted);
    try {
      while (others.threads.size() < wanted) {
        others.threads.emplace_back([&] { parts.work_apart(); });
        parts.enter();
      }
    } catch (const std::system_error&) {
      // No more threads are to be had: those that are there do it.
    }
    const Pause* own = pause_of_thread();
    parts.work(own);
    if (own != nullptr) parts.wait(*own);
  }
  parts.rethrow();
}

}  // namespace splinecore
