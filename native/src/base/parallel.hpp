#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>

#include "splinecore/base/errors.hpp"

#pragma GCC visibility push(hidden)
namespace splinecore {

/// How many threads are worth their making: as many as are asked for, or with 0 one for each core where there is
/// this much work.
/// @param work   in steps of breathe()
/// @param parts  that it falls into
int threads_for(int asked, std::size_t work, std::size_t parts);

/// parallel_for() on more than one thread.
void run_on_threads(std::size_t count, int threads, const std::function<void(std::size_t)>& part);

/// Calls part(0), …, part(count - 1), several at once: this thread and threads - 1 others, which are gone when it
/// returns, take the next one each. With one thread they come one after the other.
///
/// What a part throws ends the work and is thrown here; of several the one of the part that comes first, as one thread
/// would have it. Only this thread pauses (breathe()), also while it waits for the others; what its pause throws
/// ends all parts within some 20 ms.
template <class Part>
void parallel_for(std::size_t count, int threads, Part&& part) {
  if (threads > 1 && count > 1) return run_on_threads(count, threads, std::ref(part));
  for (std::size_t i = 0; i < count; ++i) part(i);
}

/// Calls work(begin, end) on consecutive parts of [0, count), on as many threads as are asked for (threads_for()).
/// @param steps_of_one  steps of work for each, as those of threads_for()
template <class Work>
void in_ranges(std::size_t count, std::size_t steps_of_one, int asked, Work&& work) {
  const int threads = threads_for(asked, count * steps_of_one, count);
  if (threads == 1) return work(std::size_t{0}, count);
  constexpr std::size_t kOfThread = 4;
  const std::size_t parts = std::min(count, kOfThread * static_cast<std::size_t>(threads));
  parallel_for(parts, threads, [&](std::size_t i) { work(i * count / parts, (i + 1) * count / parts); });
}

/// Returns work(first, count), which does several at once; if that fails, they are done one after the other, so that of
/// several that fail the first is named, wherever a part begins.
template <class Work>
auto in_order_of_errors(std::size_t first, std::size_t count, Work&& work) {
  const auto singly = [&] {
    for (std::size_t i = first; i < first + count; ++i) work(i, std::size_t{1});
  };
  try {
    return work(first, count);
  } catch (const InvalidShape&) {
    singly();
    throw;
  } catch (const PointAtInfinity&) {
    singly();
    throw;
  }
}

/// Steps of a kernel, which makes so many at once.
inline constexpr std::size_t kStepsAtOnce = 8;

}  // namespace splinecore
#pragma GCC visibility pop
