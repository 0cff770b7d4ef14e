#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <memory>

#pragma GCC visibility push(hidden)
namespace splinecore {

/// So many numbers for each of many spans, in blocks that whoever asks first fills. No lock is held meanwhile, because
/// long work may pause; of two that fill one block at once the first to be done is taken.
class SpanBlocks {
 public:
  SpanBlocks(std::size_t spans, std::size_t size) : spans_(spans), size_(size) {
    constexpr std::size_t kBlock = std::size_t{1} << 12;  // numbers
    while ((size << shift_) < kBlock && (std::size_t{1} << shift_) < spans) ++shift_;
  }
  ~SpanBlocks() {
    std::atomic<double*>* const blocks = blocks_.load();
    for (std::size_t i = 0; blocks != nullptr && i < count(); ++i) delete[] blocks[i].load();
    delete[] blocks;
  }
  SpanBlocks(const SpanBlocks&) = delete;
  SpanBlocks& operator=(const SpanBlocks&) = delete;

  std::size_t size() const noexcept { return size_; }

  /// The numbers of all spans, one after the other, if they are few enough to lie together; or nullptr.
  template <class Fill>
  const double* together(const Fill& fill) {
    return count() == 1 ? of(0, fill) : nullptr;
  }

  /// The numbers of a span, which fill(span, out) writes if nobody has yet.
  template <class Fill>
  const double* of(std::size_t span, const Fill& fill) {
    std::atomic<double*>* blocks = blocks_.load(std::memory_order_acquire);
    if (blocks == nullptr) blocks = made();
    std::atomic<double*>& block = blocks[span >> shift_];
    const double* values = block.load(std::memory_order_acquire);
    if (values == nullptr) values = filled(block, span >> shift_ << shift_, fill);
    return values + (span & ((std::size_t{1} << shift_) - 1)) * size_;
  }

 private:
  std::size_t count() const noexcept { return (spans_ + (std::size_t{1} << shift_) - 1) >> shift_; }

  std::atomic<double*>* made() {
    auto blocks = std::make_unique<std::atomic<double*>[]>(count());
    std::atomic<double*>* known = nullptr;
    if (blocks_.compare_exchange_strong(known, blocks.get(), std::memory_order_acq_rel)) known = blocks.release();
    return known;
  }

  template <class Fill>
  const double* filled(std::atomic<double*>& block, std::size_t first, const Fill& fill) const {
    const std::size_t end = std::min(first + (std::size_t{1} << shift_), spans_);
    auto values = std::make_unique<double[]>((end - first) * size_);
    for (std::size_t span = first; span < end; ++span) fill(span, values.get() + (span - first) * size_);
    double* known = nullptr;
    if (block.compare_exchange_strong(known, values.get(), std::memory_order_acq_rel)) known = values.release();
    return known;
  }

  std::size_t spans_;
  std::size_t size_;
  int shift_ = 0;  ///< a block has 2^shift_ spans
  std::atomic<std::atomic<double*>*> blocks_{nullptr};
};

}  // namespace splinecore
#pragma GCC visibility pop
